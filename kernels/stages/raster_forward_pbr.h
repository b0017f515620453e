// raster_forward for metallic-roughness materials.
#include "raster/pbr.h"
#define FORWARD_NAME raster_forward_pbr
#define FORWARD_SHADE SHADE_PBR_IN_ORDER
#include "stages/raster_forward.h"
