// Quads among the triangles: the same triangles in another order, in pairs that are cells of the grid.
#include "tessellate/quad_faces.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "tessellate/factor_generators.hpp"
#include "tessellate/models.hpp"
#include "tessellate/quad_checks.hpp"
#include "tessellate/tessellate.hpp"
#include "tessellator/factors.h"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace tessera {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::array<std::uint32_t, 8> record_of(Partitioning partitioning, const PatchFactors& factors, Domain domain) {
    std::uint32_t raw[6];
    std::ranges::transform(factors, raw, [](float f) { return std::bit_cast<std::uint32_t>(f); });
    const auto record = kernels::make_patch_record(raw, static_cast<std::uint32_t>(partitioning),
                                                   static_cast<std::uint32_t>(domain), 0);
    std::array<std::uint32_t, 8> words{record.flags};
    std::ranges::copy(record.factor, words.begin() + 1);
    return words;
}

std::multiset<Triangle> triangle_set(const std::vector<std::uint32_t>& indices) {
    std::multiset<Triangle> set;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        Triangle t{indices[i], indices[i + 1], indices[i + 2]};
        std::rotate(t.begin(), std::ranges::min_element(t), t.end());
        set.insert(t);
    }
    return set;
}

struct Marked {
    Pattern pattern;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint8_t> quads;
    std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(quads, 1)); }
};

Marked mark(Partitioning partitioning, const PatchFactors& factors, Domain domain = Domain::quad,
            std::uint32_t first_vertex = 0) {
    Marked marked;
    marked.pattern =
        make_patterns(test::open_device("reference"), domain, partitioning, true, std::vector<PatchFactors>{factors})
            .front();
    for (const std::uint32_t index : marked.pattern.indices)
        marked.indices.push_back(index + first_vertex);
    marked.quads.assign(marked.indices.size() / 3, 7);
    mark_quads(RecordView(record_of(partitioning, factors, domain)), first_vertex, marked.indices, marked.quads);
    for (std::uint32_t& index : marked.indices)
        index -= first_vertex;
    return marked;
}

/// Empty, or what is wrong.
std::string check(const Marked& m) {
    if (triangle_set(m.indices) != triangle_set(m.pattern.indices)) return "the triangles are not those of the pattern";
    std::uint32_t last = 0xffffffffu;
    for (std::size_t t = 0; t < m.quads.size(); ++t) {
        if (m.quads[t] > 1) return "a triangle is not marked";
        const std::uint32_t* c = &m.indices[3 * t];
        if (c[0] == last) return "a face begins like the one before";
        last = c[0];
        if (m.quads[t] == 0) continue;
        if (++t == m.quads.size() || m.quads[t] != 0 || c[3] != c[0] || c[4] != c[2]) return "half a quad is missing";
    }
    return {};
}

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even, Partitioning::uniform};

TEST(QuadFaces, AreTheSameTrianglesInPairs) {
    std::mt19937 random(4);
    for (const Partitioning partitioning : partitionings) {
        for (int i = 0; i < 150; ++i) {
            PatchFactors f{};
            std::ranges::generate(f, [&] { return test::random_factor(random); });
            const Marked m = mark(partitioning, f, Domain::quad, i % 2 == 0 ? 0 : 1000);
            EXPECT_EQ(check(m), "") << test::describe_quad(partitioning, f);
            if (partitioning == Partitioning::uniform) {
                EXPECT_EQ(2 * m.count(), m.quads.size());
            } else {
                EXPECT_GE(2 * m.count(), test::quad_shape(partitioning, f).inner_triangles())
                    << test::describe_quad(partitioning, f);
            }
        }
    }
}

TEST(QuadFaces, EqualFactorsMakeNothingButQuads) {
    for (const Partitioning partitioning : partitionings) {
        for (const float n : {1.0f, 2.0f, 3.0f, 4.0f, 5.5f, 8.0f, 63.0f, 64.0f}) {
            const Marked m = mark(partitioning, {n, n, n, n, n, n});
            EXPECT_EQ(check(m), "");
            EXPECT_EQ(2 * m.count(), m.quads.size()) << name(partitioning) << " " << n;
        }
        // Two different axes.
        const Marked m = mark(partitioning, {6, 9, 6, 9, 9, 6});
        EXPECT_EQ(2 * m.count(), m.quads.size()) << name(partitioning);
    }
}

TEST(QuadFaces, OuterRowsThatDoNotFitStayTriangles) {
    // 5 x 5 cells inside, of which 3 x 3 touch no edge; the edges V=0 and U=1 fit, and the corner between them.
    const Marked m = mark(Partitioning::integer, {7, 5, 5, 2, 5, 5});
    EXPECT_EQ(check(m), "");
    EXPECT_EQ(m.count(), 3u * 3u + 3u + 3u + 1u);
}

TEST(QuadFaces, CellsAreConvexWhereFactorsAreIntegers) {
    const Marked m = mark(Partitioning::integer, {8, 8, 3, 8, 8, 6});
    const auto at = [&](std::uint32_t index) { return m.pattern.points[index]; };
    for (std::size_t t = 0; t < m.quads.size(); ++t) {
        if (m.quads[t] == 0) continue;
        const std::uint32_t corners[4] = {m.indices[3 * t], m.indices[3 * t + 1], m.indices[3 * t + 2],
                                          m.indices[3 * t + 5]};
        for (int k = 0; k < 4; ++k) {
            const DomainPoint a = at(corners[k]), b = at(corners[(k + 1) % 4]), c = at(corners[(k + 2) % 4]);
            const std::int64_t turn = (std::int64_t{b.u} - a.u) * (std::int64_t{c.v} - a.v) -
                                      (std::int64_t{c.u} - a.u) * (std::int64_t{b.v} - a.v);
            EXPECT_GT(turn, 0);
        }
    }
}

TEST(QuadFaces, TrianglePatchesAreOnlyTurned) {
    for (const Partitioning partitioning : partitionings) {
        const Marked m = mark(partitioning, {3, 4.5f, 6, 5, 0, 0}, Domain::triangle);
        EXPECT_EQ(check(m), "");
        EXPECT_EQ(m.count(), 0u);
    }
}

TEST(QuadFaces, BatchesAndChunksDoNotChangeThem) {
    struct Quads : RefinedMesh {
        std::vector<std::uint8_t> quads;
        void append(const MeshBatch& batch) override {
            quads.insert(quads.end(), batch.quads.begin(), batch.quads.end());
            RefinedMesh::append(batch);
        }
    };
    TESSERA_SHARED_OR_SKIP(shared);
    const patches::PatchSet set = test::load_patches((shared / "models/opensubdiv/catmark_rook.obj").string());
    ASSERT_TRUE(set.has_quads);
    TessellationOptions options;
    options.topology = Topology::quads;
    options.factors = PatchFactors{9, 9, 7, 9, 9, 9};
    Quads whole;
    Tessellator(test::open_device("reference"), set, options).run(whole);
    options.memory_budget = 1 << 20;
    Quads pieces;
    Tessellator(test::open_device("reference"), set, options).run(pieces);
    EXPECT_EQ(whole.indices, pieces.indices);
    EXPECT_EQ(whole.quads, pieces.quads);
    EXPECT_GT(std::ranges::count(whole.quads, 1), 0);
    options.topology = Topology::triangles;
    options.memory_budget = 512 << 20;
    const RefinedMesh plain = tessellate(test::open_device("reference"), set, options);
    EXPECT_EQ(triangle_set(plain.indices), triangle_set(whole.indices));
}

}  // namespace
}  // namespace tessera
