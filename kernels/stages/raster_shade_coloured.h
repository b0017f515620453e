// Base colour, colours of vertices and texture, where there is one, under Phong's light.
#define SHADE_NAME raster_shade_coloured
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_BASE(p, triangle)                  \
    SHADE_NORMAL(p, back)                    \
    SHADE_PHONG(colour, p)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
