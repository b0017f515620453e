// Texture coordinates as colours.
#define SHADE_NAME raster_shade_uv
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_UV_AS_COLOUR(colour)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
