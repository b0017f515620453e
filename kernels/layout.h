// Strides, limits and parameter structs shared by kernels and host. All members are 32-bit scalars, so that std140,
// OpenCL C and C++ agree on every offset.
#ifndef TESSERA_LAYOUT_H
#define TESSERA_LAYOUT_H

#include "dialect.h"

// A control vertex and an output vertex alike: position x y z, normal x y z, texture coordinates u v.
#define VERTEX_FLOATS 8u

// A vertex's tangent frame, in a buffer of its own: tangent x y z, handedness, bitangent x y z, and a zero: as long as
// a vertex, so that the same code streams both.
#define TANGENT_FLOATS VERTEX_FLOATS

// What a vertex or a patch's corner may carry besides (base/vertex_attributes.hpp): red, green, blue, alpha, tangent x
// y z, handedness; as long as a vertex too.
#define ATTRIBUTE_FLOATS VERTEX_FLOATS

// What shapes the surface at a control vertex, read by the schemes phong and stpn only: sharpness, bias, tension,
// alpha, the direction of a crease that runs through it, the normal of a crease's smooth share (schemes/tags.h).
#define VERTEX_TAG_FLOATS 10u

// Four per patch, one per corner, read by the scheme stpn only: the corner's normal x y z, and the sharpness of the
// edge from this corner to the next.
#define CORNER_TAG_FLOATS 4u

// Partitionings, as stored in a patch record. The first four are those of the fixed-function tessellator; UNIFORM is
// the even triangular grid of Vlachos et al. 2001.
#define PARTITIONING_INTEGER 0u
#define PARTITIONING_POW2 1u
#define PARTITIONING_FRACTIONAL_ODD 2u
#define PARTITIONING_FRACTIONAL_EVEN 3u
#define PARTITIONING_UNIFORM 4u

// Domains, as stored in a patch record.
#define DOMAIN_TRIANGLE 0u
#define DOMAIN_QUAD 1u
#define DOMAIN_ISOLINE 2u
// In FactorsParams only: the patch indices tell, for their fourth entry is NO_CORNER in triangles.
#define DOMAIN_PER_PATCH 3u

// Patch indices: four per patch, the fourth NO_CORNER for triangles.
#define PATCH_CORNERS 4u
#define NO_CORNER 0xffffffffu

// Factors per patch in the factor buffer, for every domain: outer factors first, then inner; unused ones are ignored.
#define PATCH_FACTORS 6u

// A patch record is made by the factors stage and read by every later one:
//   word 0: flags (below); words 1..6: the factors in 16.16 fixed point, clamped and rounded; word 7: unused, zero.
#define RECORD_WORDS 8u
#define RECORD_DOMAIN_MASK 3u
#define RECORD_CULLED 4u     // no points, no triangles
#define RECORD_SINGLE 8u     // all factors are one: corners only
#define RECORD_UNIFORM 16u   // even triangular grid; word 1 holds the level as an integer
#define RECORD_FLIP 32u      // triangles are emitted with the opposite winding
#define RECORD_ODD_SHIFT 8u  // bit 8 + i: factor i splits its edge into an odd number of segments

// Counts and offsets hold two words per patch: vertices, indices.
#define COUNT_WORDS 2u

// Control nets, one per patch, floats: control points of degree d (3 each), normals of degree n (3 each), then the
// three texture coordinates (2 each). Order of control points, with corners 0, 1, 2 at u = 1, v = 1, w = 1:
//   degree 1: 0 1 2;  degree 2: 0 1 2 01 12 20;  degree 3: 0 1 2 01 10 12 21 20 02 centre (ij: next to i, towards j).
// Quads, with corners 0 1 2 3 around the face and four texture coordinates:
//   degree 1: 0 1 2 3;  degree 2: 0 1 2 3 01 12 23 30 centre;  degree 3: 0 1 2 3 01 10 12 21 23 32 30 03 and the inner
//   points next to 0 1 2 3.
// A job has one stride for all its nets, that of quads where there are any.
#define NET_POINTS(degree) ((degree) == 1u ? 3u : ((degree) == 2u ? 6u : 10u))
#define NET_FLOATS(degree, normal_degree) (3u * NET_POINTS(degree) + 3u * NET_POINTS(normal_degree) + 6u)
#define QUAD_NET_POINTS(degree) (((degree) + 1u) * ((degree) + 1u))
#define QUAD_NET_FLOATS(degree, normal_degree) (3u * QUAD_NET_POINTS(degree) + 3u * QUAD_NET_POINTS(normal_degree) + 8u)

// A pattern that patches share: words before its first u and its first v, so that whole runs may begin and end outside
// it.
#define PATTERN_MARGIN 16u
// After them, on a multiple of PATTERN_RUN words, the weights of triangle patterns (schemes/pattern_weights.h) for
// kernels that work in runs of so many points: for patches whose first run begins with the first point, then for those
// whose first run has a point of another patch before it; run after run, weight after weight.
#define PATTERN_RUN 16u
#define PATTERN_WEIGHTS 19u
#define PATTERN_RUNS(points) (((points) + PATTERN_RUN) / PATTERN_RUN)
#define PATTERN_WEIGHTS_AT(stride) ((2u * (stride) + PATTERN_MARGIN + PATTERN_RUN - 1u) / PATTERN_RUN * PATTERN_RUN)

// Hair. A guide point: position x y z, width, normal x y z (zero: none), and one unused.
#define GUIDE_POINT_FLOATS 8u
// A guide segment leads from a guide point to the next: the number of that point, and flags.
#define SEGMENT_POINT_MASK 0x3fffffffu
#define SEGMENT_IS_FIRST 0x80000000u  // of its guide: the root
#define SEGMENT_IS_LAST 0x40000000u   // the tip
// Its curve, floats: four Bezier points, widths at both ends, normals at both ends.
#define GUIDE_CURVE_FLOATS 20u
// A hair patch, words: first segment and number of segments of three guides (0..5); how many of them count, 1 to 3 (6);
// the number of its first hair (7) among all hairs between these guides (8); where their sequence begins (9).
#define HAIR_PATCH_WORDS 10u
// A hair has one line of isoline points; its ribbon two vertices per point and two triangles per segment.
#define RIBBON_VERTICES 2u
#define RIBBON_INDICES 6u

// Ribbons: perpendicular to the view from a place, or as near as possible to a direction.
#define RIBBONS_CAMERA 0u
#define RIBBONS_FLAT 1u

// Items of one block of the scan.
#define SCAN_BLOCK 256u

KERNELS_BEGIN

STRUCT(ScaleProbeParams) {
    uint count;
    float factor;
};

STRUCT(FactorsParams) {
    uint patch_count;
    uint partitioning;
    uint domain;     // of all patches, or DOMAIN_PER_PATCH
    uint flip;       // 1: reverse the winding
    uint per_patch;  // 0: factors 0..5 hold for every patch; 1: PATCH_FACTORS per patch
};

STRUCT(CountsParams) {
    uint patch_count;
};

STRUCT(ScanParams) {
    uint count;  // pairs to scan
};

// Kernels that are made for one domain find their patches in a list: entries [first, first + count).
STRUCT(ControlNetsParams) {
    uint first;
    uint count;
    uint net_stride;  // floats
    uint tag_stride;  // floats from one vertex's tags to the next; 0: the first tags hold for every vertex
};

// Emission into buffers that begin with the first vertex and index of a batch.
STRUCT(EmitParams) {
    uint first;
    uint count;
    uint lanes_log2;    // 2^lanes_log2 items share a patch: item = entry << lanes_log2 | lane
    uint first_vertex;  // subtracted from every vertex position
    uint first_index;   // subtracted from every index position
    uint vertex_base;   // added to every index value
    uint net_stride;    // floats
    uint pattern;       // where every patch has the same points: words from the pattern's u to its v, else 0
    uint uvs;           // tangents only: floats from a net's beginning to its texture coordinates
};

STRUCT(GuideCurvesParams) {
    uint count;  // segments
};

// Like EmitParams, for patches [first, first + count) without a list.
STRUCT(RibbonParams) {
    uint first;
    uint count;
    uint lanes_log2;
    uint first_vertex;
    uint first_index;
    uint vertex_base;
    uint ribbons;  // RIBBONS_...
    float taper;   // share of the width that is lost at the tip
    uint shorter;  // 16.16, up to 1: share of the length that the shortest hair lacks
    float x;       // the eye, or the direction
    float y;
    float z;
};

KERNELS_END

#endif
