// Bounds of the triangles that need clipping: those of the polygons that are left of them.
#include "raster/polygon.h"
#include "raster/triangle_setup.h"

KERNELS_BEGIN

KERNEL4(raster_clip, READ(0, float, vertices), READ(1, uint, indices), WRITE(2, uint, bounds),
        UNIFORM(3, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint i = ITEM;
    if (i >= p.triangle_count || bounds[i * BOUNDS_WORDS] != BOUNDS_UNKNOWN) {
        return;
    }
    const uint a = indices[i * 3u] * 8u;
    const uint b = indices[i * 3u + 1u] * 8u;
    const uint c = indices[i * 3u + 2u] * 8u;
    const Polygon polygon = clip_triangle(p, to_clip_space(p, vertices[a], vertices[a + 1u], vertices[a + 2u]),
                                          to_clip_space(p, vertices[b], vertices[b + 1u], vertices[b + 2u]),
                                          to_clip_space(p, vertices[c], vertices[c + 1u], vertices[c + 2u]));
    int left = RASTER_GUARD;
    int right = -RASTER_GUARD;
    int top = RASTER_GUARD;
    int bottom = -RASTER_GUARD;
    for (uint corner = 0u; corner < polygon.count; ++corner) {
        const ScreenPoint s = to_screen(p, polygon_corner(polygon, corner));
        left = smaller(left, s.x);
        right = larger(right, s.x);
        top = smaller(top, s.y);
        bottom = larger(bottom, s.y);
    }
    const RasterBounds box = make_bounds(p, left, right, top, bottom);
    bounds[i * BOUNDS_WORDS] = polygon.count < 3u ? BOUNDS_EMPTY : box.columns;
    bounds[i * BOUNDS_WORDS + 1u] = polygon.count < 3u ? BOUNDS_EMPTY : box.rows;
}

KERNELS_END
