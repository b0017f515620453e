// The names by which kernel templates know the quad domain; tessellator/end_domain.h takes them back. No include guard.
#include "tessellator/quad.h"

#define PATCH_TYPE QuadPatch
#define LOAD_PATCH LOAD_QUAD_PATCH
#define PATCH_HAS_RINGS quad_has_rings
#define RING_TABLE 0
#define RING_RUN_POINTS WINDOW_RUN_POINTS
#define RING_POINT quad_ring_point
#define POINT_WINDOW quad_point_window
#define PLAIN_POINT quad_plain_point
#define OUTER_COUNT quad_outer_count
#define OUTER_TRIANGLE quad_outer_triangle
#define INNER_TRIANGLE quad_inner_triangle
#define ROW_WINDOW quad_row_window
#define PLAIN_TRIANGLE quad_plain_triangle
