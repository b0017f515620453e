// Stage 2 for triangles, the kernel of every scheme: corners -> control net. An including file names the kernel and its
// scheme by NET_KERNEL, NET_SCHEME (1 linear, 2 phong, 3 pn, 4 stpn) and NET_NORMALS (1 linear, 2 quadratic). No
// include guard: every variant includes it once.
#if NET_SCHEME == 4
#define NET_DEGREE 3
#else
#define NET_DEGREE NET_SCHEME
#endif

KERNELS_BEGIN

#if NET_SCHEME == 2
KERNEL6(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list),
        READ(3, float, vertex_tags), WRITE(4, float, nets), UNIFORM(5, ControlNetsParams, params)) {
#elif NET_SCHEME == 4
KERNEL7(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list),
        READ(3, float, vertex_tags), READ(4, float, corner_tags), WRITE(5, float, nets),
        UNIFORM(6, ControlNetsParams, params)) {
#else
KERNEL5(NET_KERNEL, READ(0, float, control_vertices), READ(1, uint, patch_indices), READ(2, uint, patch_list),
        WRITE(3, float, nets), UNIFORM(4, ControlNetsParams, params)) {
#endif
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
#if NET_SCHEME == 4
    VertexTags t0;
    LOAD_VERTEX_TAGS(t0, vertex_tags, i0 * p.tag_stride);
    VertexTags t1;
    LOAD_VERTEX_TAGS(t1, vertex_tags, i1 * p.tag_stride);
    VertexTags t2;
    LOAD_VERTEX_TAGS(t2, vertex_tags, i2 * p.tag_stride);
    CornerTags k0;
    LOAD_CORNER_TAGS(k0, corner_tags, (PATCH_CORNERS * patch_index + 0u) * CORNER_TAG_FLOATS);
    CornerTags k1;
    LOAD_CORNER_TAGS(k1, corner_tags, (PATCH_CORNERS * patch_index + 1u) * CORNER_TAG_FLOATS);
    CornerTags k2;
    LOAD_CORNER_TAGS(k2, corner_tags, (PATCH_CORNERS * patch_index + 2u) * CORNER_TAG_FLOATS);
    corners.n0 = k0.normal;
    corners.n1 = k1.normal;
    corners.n2 = k2.normal;
#endif
    const uint at = patch_index * p.net_stride;
#if NET_SCHEME == 1
    const LinearNet net = linear_net(corners);
#elif NET_SCHEME == 2
    const PhongNet net = phong_net(corners, vertex_tags[i0 * p.tag_stride + 3u], vertex_tags[i1 * p.tag_stride + 3u],
                                   vertex_tags[i2 * p.tag_stride + 3u]);
#elif NET_SCHEME == 4
    const PnNet net = stpn_net(corners, k0, k1, k2, t0, t1, t2);
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
#elif NET_DEGREE == 3
    STORE_VECTOR(nets, at + 9u, net.c01);
    STORE_VECTOR(nets, at + 12u, net.c10);
    STORE_VECTOR(nets, at + 15u, net.c12);
    STORE_VECTOR(nets, at + 18u, net.c21);
    STORE_VECTOR(nets, at + 21u, net.c20);
    STORE_VECTOR(nets, at + 24u, net.c02);
    STORE_VECTOR(nets, at + 27u, net.centre);
#endif
    const uint normals = at + 3u * NET_POINTS(NET_DEGREE);
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
    for (uint rest = NET_FLOATS(NET_DEGREE, NET_NORMALS); rest < p.net_stride; ++rest) {
        nets[at + rest] = 0.0f;
    }
}

KERNELS_END

#undef NET_KERNEL
#undef NET_SCHEME
#undef NET_DEGREE
#undef NET_NORMALS
