// Triangles that reach behind the eye or out of the guard band, cut into convex polygons.
//
// An edge is always cut from its inner end to its outer one, plane after plane in one order, so that two triangles cut
// their common edge at the same bits.
#ifndef TESSERA_RASTER_POLYGON_H
#define TESSERA_RASTER_POLYGON_H

#include "raster/screen.h"

// Three corners, and one more for each of the five planes.
#define POLYGON_CORNERS 8u
#define CLIP_PLANES 5u

KERNELS_BEGIN

STRUCT(Polygon) {
    float x[8];
    float y[8];
    float z[8];
    float w[8];
    uint count;
};

/// At least zero inside plane `plane`: near, right, left, bottom, top of the guard band.
FUNCTION float plane_distance(DrawParams p, uint plane, ClipPoint c) {
    // A little within the band, so that rounding does not lead out of it.
    const float inner = 0.99f;
    const float gx = (inner * p.guard_x) * c.w;
    const float gy = (inner * p.guard_y) * c.w;
    float d = c.z;
    d = plane == 1u ? gx - c.x : d;
    d = plane == 2u ? gx + c.x : d;
    d = plane == 3u ? gy - c.y : d;
    d = plane == 4u ? gy + c.y : d;
    return flush_tiny(d);
}

FUNCTION ClipPoint polygon_corner(Polygon polygon, uint i) {
    ClipPoint c;
    c.x = polygon.x[i];
    c.y = polygon.y[i];
    c.z = polygon.z[i];
    c.w = polygon.w[i];
    return c;
}

/// Where the way from `inner` (distance >= 0) to `outer` (distance < 0) meets the plane.
FUNCTION ClipPoint cut_edge(ClipPoint inner, float inner_distance, ClipPoint outer, float outer_distance) {
    const float t = exact_divide(inner_distance, inner_distance - outer_distance);
    ClipPoint c;
    c.x = flush_tiny(inner.x + flush_tiny(t * flush_tiny(outer.x - inner.x)));
    c.y = flush_tiny(inner.y + flush_tiny(t * flush_tiny(outer.y - inner.y)));
    c.z = flush_tiny(inner.z + flush_tiny(t * flush_tiny(outer.z - inner.z)));
    c.w = flush_tiny(inner.w + flush_tiny(t * flush_tiny(outer.w - inner.w)));
    return c;
}

FUNCTION Polygon make_triangle_polygon(ClipPoint a, ClipPoint b, ClipPoint c) {
    Polygon polygon;
    for (uint i = 0u; i < POLYGON_CORNERS; ++i) {
        polygon.x[i] = i == 0u ? a.x : (i == 1u ? b.x : c.x);
        polygon.y[i] = i == 0u ? a.y : (i == 1u ? b.y : c.y);
        polygon.z[i] = i == 0u ? a.z : (i == 1u ? b.z : c.z);
        polygon.w[i] = i == 0u ? a.w : (i == 1u ? b.w : c.w);
    }
    polygon.count = 3u;
    return polygon;
}

/// The part of a convex polygon inside one plane (Sutherland and Hodgman, "Reentrant polygon clipping", 1974).
FUNCTION Polygon cut_polygon(DrawParams p, uint plane, Polygon from) {
    Polygon to = from;
    to.count = 0u;
    for (uint i = 0u; i < from.count; ++i) {
        const ClipPoint a = polygon_corner(from, i);
        const ClipPoint b = polygon_corner(from, i + 1u < from.count ? i + 1u : 0u);
        const float da = plane_distance(p, plane, a);
        const float db = plane_distance(p, plane, b);
        if (da >= 0.0f && to.count < POLYGON_CORNERS) {
            to.x[to.count] = a.x;
            to.y[to.count] = a.y;
            to.z[to.count] = a.z;
            to.w[to.count] = a.w;
            to.count = to.count + 1u;
        }
        if ((da >= 0.0f) != (db >= 0.0f) && to.count < POLYGON_CORNERS) {
            ClipPoint c;
            if (da >= 0.0f) {
                c = cut_edge(a, da, b, db);
            } else {
                c = cut_edge(b, db, a, da);
            }
            to.x[to.count] = c.x;
            to.y[to.count] = c.y;
            to.z[to.count] = c.z;
            to.w[to.count] = c.w;
            to.count = to.count + 1u;
        }
    }
    return to;
}

/// The part of a triangle that can be drawn; the triangle itself where it needs no clipping. No corners where nothing
/// is left, or something that has no place on the screen.
FUNCTION Polygon clip_triangle(DrawParams p, ClipPoint a, ClipPoint b, ClipPoint c) {
    const uint codes = (to_screen(p, a).code | to_screen(p, b).code) | to_screen(p, c).code;
    Polygon polygon = make_triangle_polygon(a, b, c);
    if ((codes & OUT_INVALID) != 0u) {
        polygon.count = 0u;
    }
    if ((codes & OUT_CLIP) != 0u) {
        for (uint plane = 0u; plane < CLIP_PLANES; ++plane) {
            polygon = cut_polygon(p, plane, polygon);
        }
        for (uint i = 0u; i < polygon.count; ++i) {
            if ((to_screen(p, polygon_corner(polygon, i)).code & (OUT_CLIP | OUT_INVALID)) != 0u) {
                polygon.count = 0u;
            }
        }
    }
    return polygon;
}

KERNELS_END

#endif
