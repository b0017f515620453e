// Stage 2 for triangles, the kernel of every scheme: corners -> control net. An including file names the kernel and its
// scheme by NET_KERNEL, NET_SCHEME (1 linear, 2 phong, 3 pn, 4 stpn) and NET_NORMALS (1 linear, 2 quadratic). No
// include guard: every variant includes it once.
#include "schemes/net_run.h"
#include "schemes/net_signature.h"

KERNELS_BEGIN

NET_SIGNATURE {
    const ControlNetsParams p = LOAD_UNIFORM(params);
    const uint first = ITEM;
    if (first >= p.count || (first & (RUN - 1u)) != 0u) {
        return;
    }
    const uint valid = run_length(first, p.count);
    uint patches[RUN];
    LOAD_NET_PATCHES(patches, patch_list, p.first + first, valid)
    float run[RUN * NET_FLOATS(NET_DEGREE, NET_NORMALS)];
    FOR_RUN(k) {
        const uint patch_index = patches[k];
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
#if NET_SCHEME == 1
        const LinearNet net = linear_net(corners);
#elif NET_SCHEME == 2
        const PhongNet net = phong_net(corners, vertex_tags[i0 * p.tag_stride + 3u],
                                       vertex_tags[i1 * p.tag_stride + 3u], vertex_tags[i2 * p.tag_stride + 3u]);
#elif NET_SCHEME == 4
        const PnNet net = stpn_net(corners, k0, k1, k2, t0, t1, t2);
#else
        const PnNet net = pn_net(corners);
#endif
        PUT_NET_VECTOR(run, 0u, k, net.c0);
        PUT_NET_VECTOR(run, 3u, k, net.c1);
        PUT_NET_VECTOR(run, 6u, k, net.c2);
#if NET_SCHEME == 2
        PUT_NET_VECTOR(run, 9u, k, net.c01);
        PUT_NET_VECTOR(run, 12u, k, net.c12);
        PUT_NET_VECTOR(run, 15u, k, net.c20);
#elif NET_DEGREE == 3
        PUT_NET_VECTOR(run, 9u, k, net.c01);
        PUT_NET_VECTOR(run, 12u, k, net.c10);
        PUT_NET_VECTOR(run, 15u, k, net.c12);
        PUT_NET_VECTOR(run, 18u, k, net.c21);
        PUT_NET_VECTOR(run, 21u, k, net.c20);
        PUT_NET_VECTOR(run, 24u, k, net.c02);
        PUT_NET_VECTOR(run, 27u, k, net.centre);
#endif
        const uint normals = 3u * NET_POINTS(NET_DEGREE);
        PUT_NET_VECTOR(run, normals, k, corners.n0);
        PUT_NET_VECTOR(run, normals + 3u, k, corners.n1);
        PUT_NET_VECTOR(run, normals + 6u, k, corners.n2);
#if NET_NORMALS == 2
        const Vector n01 = edge_normal(corners.p0, corners.n0, corners.p1, corners.n1);
        const Vector n12 = edge_normal(corners.p1, corners.n1, corners.p2, corners.n2);
        const Vector n20 = edge_normal(corners.p2, corners.n2, corners.p0, corners.n0);
        PUT_NET_VECTOR(run, normals + 9u, k, n01);
        PUT_NET_VECTOR(run, normals + 12u, k, n12);
        PUT_NET_VECTOR(run, normals + 15u, k, n20);
#endif
        const uint uvs = normals + 3u * NET_POINTS(NET_NORMALS);
        PUT_NET(run, uvs, k, control_vertices[i0 * VERTEX_FLOATS + 6u]);
        PUT_NET(run, uvs + 1u, k, control_vertices[i0 * VERTEX_FLOATS + 7u]);
        PUT_NET(run, uvs + 2u, k, control_vertices[i1 * VERTEX_FLOATS + 6u]);
        PUT_NET(run, uvs + 3u, k, control_vertices[i1 * VERTEX_FLOATS + 7u]);
        PUT_NET(run, uvs + 4u, k, control_vertices[i2 * VERTEX_FLOATS + 6u]);
        PUT_NET(run, uvs + 5u, k, control_vertices[i2 * VERTEX_FLOATS + 7u]);
    }
    STORE_NETS(nets, p.net_stride, run, NET_FLOATS(NET_DEGREE, NET_NORMALS), patches, valid)
}

KERNELS_END

#undef NET_KERNEL
#undef NET_SCHEME
#undef NET_DEGREE
#undef NET_SIGNATURE
#undef NET_NORMALS
