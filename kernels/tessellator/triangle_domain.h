// The names by which kernel templates know the triangle domain; tessellator/end_domain.h takes them back. No include
// guard.
#include "tessellator/triangle.h"

#define PATCH_TYPE TrianglePatch
#define LOAD_PATCH LOAD_TRIANGLE_PATCH
#define PATCH_HAS_RINGS triangle_has_rings
#define RING_POINT triangle_ring_point
#define POINT_WINDOW triangle_point_window
#define PLAIN_POINT triangle_plain_point
#define OUTER_COUNT triangle_outer_count
#define OUTER_TRIANGLE triangle_outer_triangle
#define INNER_TRIANGLE triangle_inner_triangle
#define ROW_WINDOW triangle_row_window
#define PLAIN_TRIANGLE triangle_plain_triangle
