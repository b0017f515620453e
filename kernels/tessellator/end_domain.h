// Takes back the names of triangle_domain.h and quad_domain.h. No include guard.
#undef PATCH_TYPE
#undef LOAD_PATCH
#undef PATCH_HAS_RINGS
#undef RING_TABLE
#undef RING_RUN_POINTS
#undef RING_POINT
#undef POINT_WINDOW
#undef PLAIN_POINT
#undef OUTER_COUNT
#undef OUTER_TRIANGLE
#undef INNER_TRIANGLE
#undef ROW_WINDOW
#undef PLAIN_TRIANGLE
