// Normals as colours.
#define SHADE_NAME raster_shade_normals
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_NORMAL(p, back)                    \
    SHADE_NORMAL_AS_COLOUR(colour)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
