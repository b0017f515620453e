// Stage 2 of hair: guide points -> a Bezier curve per segment, with widths and normals.
#include "hair/guide_curve.h"

KERNELS_BEGIN

KERNEL4(guide_curves, READ(0, float, points), READ(1, uint, segments), WRITE(2, float, curves),
        UNIFORM(3, GuideCurvesParams, params)) {
    const GuideCurvesParams p = LOAD_UNIFORM(params);
    const uint item = ITEM;
    if (item >= p.count) {
        return;
    }
    const uint word = segments[item];
    const bool is_first = (word & SEGMENT_IS_FIRST) != 0u;
    const bool is_last = (word & SEGMENT_IS_LAST) != 0u;
    const uint from = (word & SEGMENT_POINT_MASK) * GUIDE_POINT_FLOATS;
    const uint to = from + GUIDE_POINT_FLOATS;
    const Vector a = LOAD_VECTOR(points, from);
    const Vector b = LOAD_VECTOR(points, to);
    // At an end the neighbour is not there; any address of the guide will do, for the value is not used.
    const uint before_at = is_first ? from : from - GUIDE_POINT_FLOATS;
    const uint after_at = is_last ? to : to + GUIDE_POINT_FLOATS;
    const Vector before = LOAD_VECTOR(points, before_at);
    const Vector after = LOAD_VECTOR(points, after_at);
    const Vector before_root = beyond_guide_end(a, b);
    const Vector after_tip = beyond_guide_end(b, a);
    const Vector ab =
        guide_bezier_point(a,
                           make_vector(is_first ? before_root.x : before.x, is_first ? before_root.y : before.y,
                                       is_first ? before_root.z : before.z),
                           b);
    const Vector ba = guide_bezier_point(
        b,
        make_vector(is_last ? after_tip.x : after.x, is_last ? after_tip.y : after.y, is_last ? after_tip.z : after.z),
        a);
    const uint at = item * GUIDE_CURVE_FLOATS;
    STORE_VECTOR(curves, at, a);
    STORE_VECTOR(curves, at + 3u, ab);
    STORE_VECTOR(curves, at + 6u, ba);
    STORE_VECTOR(curves, at + 9u, b);
    curves[at + 12u] = points[from + 3u];
    curves[at + 13u] = points[to + 3u];
    curves[at + 14u] = points[from + 4u];
    curves[at + 15u] = points[from + 5u];
    curves[at + 16u] = points[from + 6u];
    curves[at + 17u] = points[to + 4u];
    curves[at + 18u] = points[to + 5u];
    curves[at + 19u] = points[to + 6u];
}

KERNELS_END
