// Base colour and texture under Phong's light.
#define SHADE_NAME raster_shade_textured
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_TEXTURE(p)                         \
    SHADE_NORMAL(p, back)                    \
    SHADE_PHONG(colour, p)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
