// Distance from the camera's plane as a grey.
#define SHADE_NAME raster_shade_depth
#define SHADE_SURFACE(colour, p, back, x, y) \
    SHADE_INSIDE                             \
    SHADE_DEPTH_AS_COLOUR(colour)
#include "raster/shade_kernel.h"
#undef SHADE_NAME
#undef SHADE_SURFACE
