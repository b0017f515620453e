// The domain points of quad patches, u and v in 16.16 per vertex: what `tessera pattern` shows and checks.
#include "emission.h"
#include "tessellator/quad.h"

#define POINTS_KERNEL domain_points_quad
#define PATCH_TYPE QuadPatch
#define LOAD_PATCH LOAD_QUAD_PATCH
#define POINT_COUNT quad_point_count
#define POINT_AT quad_point
#include "tessellator/domain_points_kernel.h"
