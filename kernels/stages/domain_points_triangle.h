// The domain points of triangle patches, u and v in 16.16 per vertex: what `tessera pattern` shows and checks.
#include "emission.h"
#include "tessellator/triangle.h"

#define POINTS_KERNEL domain_points_triangle
#define PATCH_TYPE TrianglePatch
#define LOAD_PATCH LOAD_TRIANGLE_PATCH
#define POINT_COUNT triangle_point_count
#define POINT_AT triangle_point
#include "tessellator/domain_points_kernel.h"
