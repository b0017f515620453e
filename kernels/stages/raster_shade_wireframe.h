// Edges of triangles.
#define SHADE_NAME raster_shade_wireframe
#define SHADE_SURFACE(colour, p, back, x, y) colour = wire_colour(weights, across, down, base.alpha);
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
