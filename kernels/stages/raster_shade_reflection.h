// Base colour and texture under Phong's or Blinn's light with constants of the look.
#define SHADE_NAME raster_shade_reflection
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_BASE(p, triangle)                  \
    SHADE_NORMAL(p, back)                    \
    SHADE_REFLECTION(colour, p)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
