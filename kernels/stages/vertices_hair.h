// Stage 5 of hair: guide curves and isoline points -> ribbons, two vertices of 32 bytes per point of a hair.
#include "hair/emission.h"
#include "hair/interpolation.h"
#include "hair/ribbon.h"
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
    const uint guides = hair_patches[words + 6u];
    const uint first_hair = hair_patches[words + 7u];
    const uint hairs = hair_patches[words + 8u];
    const uint seed = hair_patches[words + 9u];
    const Vector target = make_vector(p.x, p.y, p.z);

    for (uint i = e.lane; i < count; i = i + e.lanes) {
        const uint u = isoline_point(t, i).u;
        const uint number = first_hair + i / t.detail.points;
        const HairWeights weights = hair_weights(guides, number, hairs, seed);
        const uint on_guides = u - ((u * hair_cut(number, seed, p.shorter)) >> 16u);
        HairPoint hair = no_hair_point();
        for (uint guide = 0u; guide < guides; ++guide) {
            const uint segments = hair_patches[words + 2u * guide + 1u];
            const GuidePlace place = guide_place(segments, on_guides);
            GuideCurve curve;
            LOAD_GUIDE_CURVE(curve, curves, (hair_patches[words + 2u * guide] + place.segment) * GUIDE_CURVE_FLOATS);
            const uint weight = guide == 0u ? weights.a : (guide == 1u ? weights.b : weights.c);
            hair = add_guide(hair, guide_point(curve, segments, place.t), weight);
        }
        const Ribbon ribbon = make_ribbon(hair.position, hair.tangent, p.ribbons, target);
        const Vector normal = hair_normal(hair.normal, ribbon.facing);
        const Vector reach = flush_hair_vector(scale(ribbon.side, ribbon_half_width(hair.width, p.taper, u)));
        const float along = to_float(u) * 0.0000152587890625f;
        for (uint right = 0u; right < RIBBON_VERTICES; ++right) {
            const SurfaceVertex vertex =
                ribbon_vertex(hair.position, reach, normal, ribbon.side, right == 0u ? -1.0f : 1.0f, along);
            STORE_SURFACE_VERTEX(vertex_buffer, (start + RIBBON_VERTICES * i + right) * VERTEX_FLOATS, vertex);
        }
    }
}

KERNELS_END
