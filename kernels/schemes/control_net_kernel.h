// Stage 2 for triangles, the kernel of every scheme: corners -> control net. An including file names the kernel and its
// scheme by NET_KERNEL, NET_SCHEME (1 linear, 2 phong, 3 pn: the degree) and NET_NORMALS (1 linear, 2 quadratic). No
// include guard: every variant includes it once.
KERNELS_BEGIN

KERNEL5(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list),
        WRITE(3, float, nets), UNIFORM(4, ControlNetsParams, params)) {
    const ControlNetsParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if (item >= p.count) {
        return;
    }
    const uint patch_index = patch_list[p.first + item];
    const uint i0 = patch_indices[PATCH_CORNERS * patch_index];
    const uint i1 = patch_indices[PATCH_CORNERS * patch_index + 1u];
    const uint i2 = patch_indices[PATCH_CORNERS * patch_index + 2u];
    Corners corners;
    LOAD_CORNERS(corners, control_vertices, i0, i1, i2);
    const uint at = patch_index * p.net_stride;
#if NET_SCHEME == 1
    const LinearNet net = linear_net(corners);
#elif NET_SCHEME == 2
    const PhongNet net = phong_net(corners, p.alpha);
#else
    const PnNet net = pn_net(corners);
#endif
    STORE_VECTOR(nets, at, net.c0);
    STORE_VECTOR(nets, at + 3u, net.c1);
    STORE_VECTOR(nets, at + 6u, net.c2);
#if NET_SCHEME == 2
    STORE_VECTOR(nets, at + 9u, net.c01);
    STORE_VECTOR(nets, at + 12u, net.c12);
    STORE_VECTOR(nets, at + 15u, net.c20);
#elif NET_SCHEME == 3
    STORE_VECTOR(nets, at + 9u, net.c01);
    STORE_VECTOR(nets, at + 12u, net.c10);
    STORE_VECTOR(nets, at + 15u, net.c12);
    STORE_VECTOR(nets, at + 18u, net.c21);
    STORE_VECTOR(nets, at + 21u, net.c20);
    STORE_VECTOR(nets, at + 24u, net.c02);
    STORE_VECTOR(nets, at + 27u, net.centre);
#endif
    const uint normals = at + 3u * NET_POINTS(NET_SCHEME);
    STORE_VECTOR(nets, normals, corners.n0);
    STORE_VECTOR(nets, normals + 3u, corners.n1);
    STORE_VECTOR(nets, normals + 6u, corners.n2);
#if NET_NORMALS == 2
    const Vector n01 = edge_normal(corners.p0, corners.n0, corners.p1, corners.n1);
    const Vector n12 = edge_normal(corners.p1, corners.n1, corners.p2, corners.n2);
    const Vector n20 = edge_normal(corners.p2, corners.n2, corners.p0, corners.n0);
    STORE_VECTOR(nets, normals + 9u, n01);
    STORE_VECTOR(nets, normals + 12u, n12);
    STORE_VECTOR(nets, normals + 15u, n20);
#endif
    const uint uvs = normals + 3u * NET_POINTS(NET_NORMALS);
    nets[uvs] = control_vertices[i0 * VERTEX_FLOATS + 6u];
    nets[uvs + 1u] = control_vertices[i0 * VERTEX_FLOATS + 7u];
    nets[uvs + 2u] = control_vertices[i1 * VERTEX_FLOATS + 6u];
    nets[uvs + 3u] = control_vertices[i1 * VERTEX_FLOATS + 7u];
    nets[uvs + 4u] = control_vertices[i2 * VERTEX_FLOATS + 6u];
    nets[uvs + 5u] = control_vertices[i2 * VERTEX_FLOATS + 7u];
    for (uint rest = NET_FLOATS(NET_SCHEME, NET_NORMALS); rest < p.net_stride; ++rest) {
        nets[at + rest] = 0.0f;
    }
}

KERNELS_END

#undef NET_KERNEL
#undef NET_SCHEME
#undef NET_NORMALS
