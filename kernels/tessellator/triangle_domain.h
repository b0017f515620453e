// The names by which kernel templates know the triangle domain; tessellator/end_domain.h takes them back. No include
// guard.
#include "tessellator/ring_table.h"

#define PATCH_TYPE TrianglePatch
#define LOAD_PATCH LOAD_TRIANGLE_PATCH
#define PATCH_HAS_RINGS triangle_has_rings
#define RING_TABLE 1  // kernels bind one
#define RING_RUN_POINTS TABLE_RUN_POINTS
#define PLAIN_POINT triangle_plain_point
#define OUTER_COUNT triangle_outer_count
#define OUTER_TRIANGLE triangle_outer_triangle
#define PLAIN_TRIANGLE triangle_plain_triangle
