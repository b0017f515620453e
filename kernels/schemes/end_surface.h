// Takes back the names of triangle_surface.h and quad_surface.h and those that chose their variant. No include guard.
#undef VERTICES_DEGREE
#undef VERTICES_NORMALS
#undef SURFACE_TANGENTS
#undef SURFACE
#undef SURFACE_POINT
#undef SURFACE_VERTEX
#undef SURFACE_WEIGHTED
#undef SURFACE_HAS_WEIGHTS
#undef SURFACE_FRAME
#undef LOAD_SURFACE
#undef LOAD_POINTS
#undef LOAD_UVS
#undef LOAD_MIXED_POINTS
#undef LOAD_MIXED_NORMALS
#undef NET_NORMAL_POINTS
#undef NET_NORMALS_AT
#undef NET_UVS_AT
