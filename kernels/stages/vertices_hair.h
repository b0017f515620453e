// Stage 5 of hair: guide curves and isoline points -> ribbons, two vertices of 32 bytes per point of a hair.
#include "hair/emission.h"
#include "hair/interpolation.h"
#include "hair/ribbon.h"
#include "schemes/surface_vertex.h"
#include "tessellator/isoline.h"

KERNELS_BEGIN

KERNEL6(vertices_hair, READ(0, float, curves), READ(1, uint, hair_patches), READ(2, uint, records),
        READ(3, uint, offsets), WRITE(4, float, vertex_buffer), UNIFORM(5, RibbonParams, params)) {
    const RibbonParams p = LOAD_UNIFORM(params);
    const RibbonItem e = make_ribbon_item(p, ITEM);
    if (e.has_patch == 0u) {
        return;
    }
    const IsolinePatch t = LOAD_ISOLINE_PATCH(records, e.patch_index);
    const uint start = RIBBON_VERTEX_START(p, offsets, e.patch_index);
    const uint count = isoline_point_count(t);
    const uint words = e.patch_index * HAIR_PATCH_WORDS;
    const uint segment_a = hair_patches[words];
    const uint segments_a = hair_patches[words + 1u];
    const uint segment_b = hair_patches[words + 2u];
    const uint segments_b = hair_patches[words + 3u];
    const uint segment_c = hair_patches[words + 4u];
    const uint segments_c = hair_patches[words + 5u];
    const uint guides = hair_patches[words + 6u];
    const uint first_hair = hair_patches[words + 7u];
    const uint hairs = hair_patches[words + 8u];
    const uint seed = hair_patches[words + 9u];
    const Vector target = make_vector(p.x, p.y, p.z);

    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const uint u = isoline_point(t, i).u;
        const HairWeights weights = hair_weights(guides, first_hair + i / t.detail.points, hairs, seed);
        const GuidePlace place_a = guide_place(segments_a, u);
        const GuidePlace place_b = guide_place(segments_b, u);
        const GuidePlace place_c = guide_place(segments_c, u);
        GuideCurve a;
        GuideCurve b;
        GuideCurve c;
        LOAD_GUIDE_CURVE(a, curves, (segment_a + place_a.segment) * GUIDE_CURVE_FLOATS);
        LOAD_GUIDE_CURVE(b, curves, (segment_b + place_b.segment) * GUIDE_CURVE_FLOATS);
        LOAD_GUIDE_CURVE(c, curves, (segment_c + place_c.segment) * GUIDE_CURVE_FLOATS);
        const HairPoint hair = blend_hair(weights, guide_point(a, segments_a, place_a.t),
                                          guide_point(b, segments_b, place_b.t), guide_point(c, segments_c, place_c.t));
        const Ribbon ribbon = make_ribbon(hair.position, hair.tangent, p.ribbons, target);
        const Vector normal = hair_unit(hair.normal, ribbon.facing);
        const Vector reach = flush_hair_vector(scale(ribbon.side, ribbon_half_width(hair.width, p.taper, u)));
        const Vector left = make_vector(-ribbon.side.x, -ribbon.side.y, -ribbon.side.z);
        const float along = to_float(u) * 0.0000152587890625f;
        const uint at = (start + RIBBON_VERTICES * i) * VERTEX_FLOATS;
        const SurfaceVertex on_left = make_surface_vertex(subtract(hair.position, reach),
                                                          ribbon_normal(normal, left, ribbon.facing), 0.0f, along);
        STORE_SURFACE_VERTEX(vertex_buffer, at, on_left);
        const SurfaceVertex on_right = make_surface_vertex(
            add(hair.position, reach), ribbon_normal(normal, ribbon.side, ribbon.facing), 1.0f, along);
        STORE_SURFACE_VERTEX(vertex_buffer, at + VERTEX_FLOATS, on_right);
    }
}

KERNELS_END
