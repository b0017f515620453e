// Metallic-roughness materials.
#include "raster/pbr.h"
#define SHADE_NAME raster_shade_pbr
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_VERTEX_COLOUR(p, triangle)         \
    SHADE_NORMAL(p, back)                    \
    SHADE_TANGENT(p, triangle, back)         \
    SHADE_PBR(colour, p)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
