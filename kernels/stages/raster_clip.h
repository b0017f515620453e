// Polygons of the triangles that are not small, and bounds of those that need clipping (Sutherland and Hodgman,
// "Reentrant polygon clipping", 1974). A corner that has no place on the screen all the same, at the eye itself or out
// of all measure, takes the triangle with it.
#include "raster/polygon.h"
#include "raster/triangle_setup.h"

KERNELS_BEGIN

KERNEL4(raster_clip, READ(0, float, vertices), READ(1, uint, indices), WRITE(2, uint, triangles),
        UNIFORM(3, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.entry_count;
    const uint end = begin + p.entry_count < p.triangle_count ? begin + p.entry_count : p.triangle_count;
    for (uint triangle = begin; triangle < end; ++triangle) {
        if (triangles[triangle * BOUNDS_WORDS] != BOUNDS_UNKNOWN) {
            continue;
        }
        const bool clipped = (triangles[p.records_at + triangle * TRIANGLE_WORDS + 7u] & TRIANGLE_CLIPPED) != 0u;
        // Two polygons: corners from `from` on are read, those from `to` on are written.
        ClipPoint corners[16];
        uint from = 0u;
        uint count = 3u;
        for (uint i = 0u; i < 3u; ++i) {
            const uint at = DRAW_VERTEX(p, triangle * 3u + i) * 8u;
            corners[i] = to_clip_space(p, vertices[at], vertices[at + 1u], vertices[at + 2u]);
        }
        for (uint plane = 0u; plane < (clipped ? CLIP_PLANES : 0u); ++plane) {
            const uint to = POLYGON_CORNERS - from;
            uint kept = 0u;
            for (uint i = 0u; i < count; ++i) {
                const ClipPoint a = corners[from + i];
                const ClipPoint b = corners[from + (i + 1u < count ? i + 1u : 0u)];
                const float da = plane_distance(p, plane, a);
                const float db = plane_distance(p, plane, b);
                const bool a_inside = da >= 0.0f;
                const bool b_inside = db >= 0.0f;
                if (a_inside && kept < POLYGON_CORNERS) {
                    corners[to + kept] = a;
                    kept = kept + 1u;
                }
                if (a_inside != b_inside && kept < POLYGON_CORNERS) {
                    ClipPoint inner = a;
                    ClipPoint outer = b;
                    if (b_inside) {
                        inner = b;
                        outer = a;
                    }
                    corners[to + kept] = cut_edge(inner, a_inside ? da : db, outer, a_inside ? db : da);
                    kept = kept + 1u;
                }
            }
            from = to;
            count = kept;
        }
        int left = RASTER_GUARD;
        int right = -RASTER_GUARD;
        int top = RASTER_GUARD;
        int bottom = -RASTER_GUARD;
        const uint at = p.polygons_at + triangle * POLYGON_WORDS;
        uint codes = 0u;
        for (uint i = 0u; i < count; ++i) {
            const ScreenPoint s = to_screen(p, corners[from + i]);
            codes = codes | s.code;
            left = smaller(left, s.x);
            right = larger(right, s.x);
            top = smaller(top, s.y);
            bottom = larger(bottom, s.y);
            triangles[at + 1u + 3u * i] = to_uint(s.x);
            triangles[at + 2u + 3u * i] = to_uint(s.y);
            triangles[at + 3u + 3u * i] = float_bits(s.z);
        }
        const bool gone = count < 3u || (codes & (OUT_CLIP | OUT_INVALID)) != 0u;
        triangles[at] = gone ? 0u : count;
        const RasterBounds box = make_bounds(p, left, right, top, bottom);
        triangles[triangle * BOUNDS_WORDS] = gone ? BOUNDS_EMPTY : box.columns;
        triangles[triangle * BOUNDS_WORDS + 1u] = gone ? BOUNDS_EMPTY : box.rows;
    }
}

KERNELS_END
