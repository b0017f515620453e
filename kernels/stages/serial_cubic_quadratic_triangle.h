// A peer for measurements, not a stage of the pipeline: vertices and triangles of a cubic surface in one kernel, one
// work item per patch, which walks the tessellator of the D3D11.3 functional specification (11.7) from the first point
// to the last triangle and appends as it goes. That is how drivers do it that run the tessellator in a kernel (Mesa's
// Asahi driver among them). It writes what the stages "vertices" and "indices" write, to the bit.
#include "emission.h"
#include "schemes/basis.h"
#include "schemes/surface_vertex.h"
#include "tessellator/serial_triangle.h"

/// Writes the point indices of a triangle; `flip` turns its winding round.
#define STORE_TRIANGLE(buffer, at, base, flip, corners)                \
    buffer[at] = (base) + (corners).a;                                 \
    buffer[(at) + 1u] = (base) + ((flip) ? (corners).c : (corners).b); \
    buffer[(at) + 2u] = (base) + ((flip) ? (corners).b : (corners).c)

KERNELS_BEGIN

STRUCT(SerialNet) {
    Vector c0;
    Vector c1;
    Vector c2;
    Vector c01;
    Vector c10;
    Vector c12;
    Vector c21;
    Vector c20;
    Vector c02;
    Vector centre;
    Vector n0;
    Vector n1;
    Vector n2;
    Vector n01;
    Vector n12;
    Vector n20;
    float s0;
    float t0;
    float s1;
    float t1;
    float s2;
    float t2;
};

FUNCTION SurfaceVertex serial_vertex(SerialNet net, DomainPoint point) {
    const Barycentric b = make_barycentric(point.u, point.v);
    const Vector position = evaluate_cubic(cubic_weights(b), net.c0, net.c1, net.c2, net.c01, net.c10, net.c12, net.c21,
                                           net.c20, net.c02, net.centre);
    const Vector normal = blended_normal(
        evaluate_quadratic(quadratic_weights(b, 1.0f), net.n0, net.n1, net.n2, net.n01, net.n12, net.n20));
    return make_surface_vertex(position, normal, blend_linear(b, net.s0, net.s1, net.s2),
                               blend_linear(b, net.t0, net.t1, net.t2));
}

// Appends one triangle of a row between two rings and moves the cursor.
#define SERIAL_APPEND(a, b, c)                                                                                         \
    {                                                                                                                  \
        const Triangle placed = place_row(make_triangle(a, b, c), outer_ring, outer_offset, inner_ring, inner_offset); \
        STORE_TRIANGLE(index_buffer, index_at, base, flip, placed);                                                    \
        index_at = index_at + 3u;                                                                                      \
    }

KERNEL6(serial_cubic_quadratic_triangle, READ(0, float, nets), READ(1, uint, records), READ(2, uint, offsets),
        WRITE(3, float, vertex_buffer), WRITE(4, uint, index_buffer), UNIFORM(5, EmitParams, params)) {
    const EmitParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if (item >= p.count) {
        return;
    }
    const uint patch_index = p.first + item;
    const TrianglePatch t = LOAD_TRIANGLE_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    uint vertex_at = VERTEX_START(p, offsets, patch_index) * VERTEX_FLOATS;
    uint index_at = INDEX_START(p, offsets, patch_index);

    const uint at = patch_index * p.net_stride;
    SerialNet net;
    net.c0 = LOAD_VECTOR(nets, at);
    net.c1 = LOAD_VECTOR(nets, at + 3u);
    net.c2 = LOAD_VECTOR(nets, at + 6u);
    net.c01 = LOAD_VECTOR(nets, at + 9u);
    net.c10 = LOAD_VECTOR(nets, at + 12u);
    net.c12 = LOAD_VECTOR(nets, at + 15u);
    net.c21 = LOAD_VECTOR(nets, at + 18u);
    net.c20 = LOAD_VECTOR(nets, at + 21u);
    net.c02 = LOAD_VECTOR(nets, at + 24u);
    net.centre = LOAD_VECTOR(nets, at + 27u);
    net.n0 = LOAD_VECTOR(nets, at + 30u);
    net.n1 = LOAD_VECTOR(nets, at + 33u);
    net.n2 = LOAD_VECTOR(nets, at + 36u);
    net.n01 = LOAD_VECTOR(nets, at + 39u);
    net.n12 = LOAD_VECTOR(nets, at + 42u);
    net.n20 = LOAD_VECTOR(nets, at + 45u);
    net.s0 = nets[at + 48u];
    net.t0 = nets[at + 49u];
    net.s1 = nets[at + 50u];
    net.t1 = nets[at + 51u];
    net.s2 = nets[at + 52u];
    net.t2 = nets[at + 53u];

    if (!triangle_has_rings(t)) {
        const uint points = triangle_point_count(t);
        for (uint i = 0u; i < points; ++i) {
            const SurfaceVertex vertex = serial_vertex(net, triangle_plain_point(t, i));
            STORE_SURFACE_VERTEX(vertex_buffer, vertex_at, vertex);
            vertex_at = vertex_at + VERTEX_FLOATS;
        }
        const uint triangles = triangle_triangle_count(t);
        for (uint i = 0u; i < triangles; ++i) {
            const Triangle corners = triangle_plain_triangle(t, i);
            STORE_TRIANGLE(index_buffer, index_at, base, flip, corners);
            index_at = index_at + 3u;
        }
        return;
    }

    // Points, ring after ring.
    for (uint r = 0u; r <= t.rings; ++r) {
        for (uint number = 0u; number < 3u; ++number) {
            const RingSide side = triangle_ring_side(t, r, number);
            for (uint k = 0u; k < side.segments; ++k) {
                const SurfaceVertex vertex = serial_vertex(net, ring_side_point(side, k));
                STORE_SURFACE_VERTEX(vertex_buffer, vertex_at, vertex);
                vertex_at = vertex_at + VERTEX_FLOATS;
            }
        }
    }
    if (t.inside.odd == 0u) {
        const SurfaceVertex vertex = serial_vertex(net, triangle_centre());
        STORE_SURFACE_VERTEX(vertex_buffer, vertex_at, vertex);
    }

    // Triangles of the outermost row, stitched in the 31 steps of each half.
    const uint inner_half = t.inside.half_points - t.inside.odd;
    const uint inner_odd = t.inside.odd;
    const uint inner_steps = inner_half == 0u ? 0u : inner_half - 1u;
    const uint inner_segments = 2u * inner_steps + inner_odd;
    const Ring outer_ring = make_ring(0u, t.outer_points);
    const Ring inner_ring = make_ring(t.outer_points, 3u * inner_segments);
    uint outer_offset = 0u;
    for (uint number = 0u; number < 3u; ++number) {
        const Edge edge = choose_edge(number == 2u, choose_edge(number == 1u, t.edge0, t.edge1), t.edge2);
        const uint inner_offset = number * inner_segments;
        const uint outer_half = edge.half_points - edge.odd;
        const uint outer_segments = 2u * outer_half + edge.odd;
        uint o = 0u;
        uint i = 0u;
        if (outer_half > 0u) {
            SERIAL_APPEND(0u, 1u, ON_INSIDE)
            o = 1u;
        }
        for (uint m = 1u; m < 32u; ++m) {
            const uint node = transition_node(m);
            if (node < inner_half) {
                SERIAL_APPEND(ON_INSIDE + i, o, ON_INSIDE + i + 1u)
                i = i + 1u;
            }
            if (node < outer_half) {
                SERIAL_APPEND(o, o + 1u, ON_INSIDE + i)
                o = o + 1u;
            }
        }
        if (inner_odd != 0u) {
            SERIAL_APPEND(ON_INSIDE + i, o, ON_INSIDE + i + 1u)
        }
        if (edge.odd != 0u) {
            SERIAL_APPEND(ON_INSIDE + i + inner_odd, o, o + 1u)
        }
        for (uint m = 31u; m > 0u; --m) {
            const uint node = transition_node(m);
            if (node < outer_half) {
                o = o - 1u;
                SERIAL_APPEND(outer_segments - o - 1u, outer_segments - o, ON_INSIDE + inner_segments - i)
            }
            if (node < inner_half) {
                i = i - 1u;
                SERIAL_APPEND(ON_INSIDE + inner_segments - i - 1u, outer_segments - o, ON_INSIDE + inner_segments - i)
            }
        }
        if (outer_half > 0u) {
            SERIAL_APPEND(outer_segments - 1u, outer_segments, ON_INSIDE + inner_segments)
        }
        outer_offset = outer_offset + outer_segments;
    }

    // The regular rows inside.
    const uint last = triangle_last_row(t);
    for (uint j = 2u; j <= last; ++j) {
        for (uint number = 0u; number < 3u; ++number) {
            const RowSide side = triangle_row_side(t, j, number);
            for (uint s = 0u; s < side.triangles; ++s) {
                const Triangle corners = row_side_triangle(side, s);
                STORE_TRIANGLE(index_buffer, index_at, base, flip, corners);
                index_at = index_at + 3u;
            }
        }
    }
    if (inner_odd != 0u) {
        const Triangle corners = triangle_odd_centre(t);
        STORE_TRIANGLE(index_buffer, index_at, base, flip, corners);
    }
}

#undef SERIAL_APPEND

KERNELS_END
