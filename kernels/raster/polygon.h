// The planes that triangles are clipped at, and how an edge is cut.
//
// An edge is always cut from its inner end to its outer one, plane after plane in one order, so that two triangles cut
// their common edge at the same bits.
#ifndef TESSERA_RASTER_POLYGON_H
#define TESSERA_RASTER_POLYGON_H

#include "raster/screen.h"

#define CLIP_PLANES 5u

KERNELS_BEGIN

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

FUNCTION float cut_at(float inner, float outer, float t) {
    return flush_tiny(inner + flush_tiny(t * flush_tiny(outer - inner)));
}

/// Where the way from `inner` (distance >= 0) to `outer` (distance < 0) meets the plane.
FUNCTION ClipPoint cut_edge(ClipPoint inner, float inner_distance, ClipPoint outer, float outer_distance) {
    const float t = exact_divide(inner_distance, inner_distance - outer_distance);
    ClipPoint c;
    c.x = cut_at(inner.x, outer.x, t);
    c.y = cut_at(inner.y, outer.y, t);
    c.z = cut_at(inner.z, outer.z, t);
    c.w = cut_at(inner.w, outer.w, t);
    return c;
}

KERNELS_END

#endif
