// What the kernels of control nets of triangles and of quads have in common besides their loops: the degree of a net,
// and the buffers that a scheme reads. An including file takes both names back at its end. No include guard.
#if NET_SCHEME == 4
#define NET_DEGREE 3
#else
#define NET_DEGREE NET_SCHEME
#endif

#if NET_SCHEME == 2
#define NET_SIGNATURE                                                                                              \
    KERNEL6(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list), \
            READ(3, float, vertex_tags), WRITE(4, float, nets), UNIFORM(5, ControlNetsParams, params))
#elif NET_SCHEME == 4
#define NET_SIGNATURE                                                                                              \
    KERNEL7(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list), \
            READ(3, float, vertex_tags), READ(4, float, corner_tags), WRITE(5, float, nets),                       \
            UNIFORM(6, ControlNetsParams, params))
#else
#define NET_SIGNATURE                                                                                              \
    KERNEL5(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list), \
            WRITE(3, float, nets), UNIFORM(4, ControlNetsParams, params))
#endif
