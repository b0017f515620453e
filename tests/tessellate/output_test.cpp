// The whole pipeline against the papers: every output vertex of every scheme is where the formulas put its domain
// point.
#include "kernels/corners_gen.hpp"
#include "kernels/paper.hpp"
#include "support/devices.hpp"
#include "tessellate/models.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/tessellate.hpp"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace tessera {
namespace {

using glm::dvec3;

test::PaperPatch corners_of(const patches::PatchSet& set, std::size_t patch) {
    test::PaperPatch result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& v = set.control_vertices[set.corners[patch][k]];
        result.p[k] = {v.position[0], v.position[1], v.position[2]};
        result.n[k] = {v.normal[0], v.normal[1], v.normal[2]};
    }
    return result;
}

dvec3 expected_position(const test::PaperPatch& patch, const TessellationOptions& options, dvec3 uvw) {
    switch (options.scheme) {
        case Scheme::linear:
            return test::paper_linear(patch.p, uvw);
        case Scheme::phong:
            return test::paper_phong_position(patch, options.alpha, uvw);
        default:
            return test::paper_pn_position(patch, uvw);
    }
}

dvec3 expected_normal(const test::PaperPatch& patch, const TessellationOptions& options, dvec3 uvw) {
    return glm::normalize(options.normals == Normals::linear ? test::paper_linear(patch.n, uvw)
                                                             : test::paper_quadratic_normal(patch, uvw));
}

struct Case {
    Scheme scheme;
    Normals normals;
};

class Output : public testing::TestWithParam<Case> {};

TEST_P(Output, IsThatOfThePapers) {
    // A set of unrelated patches, so that no symmetry hides a corner in the wrong place.
    patches::PatchSet set;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const kernels::Corners c = test::random_corners(i);
        const auto add = [&](const kernels::Vector& p, const kernels::Vector& n, float u, float v) {
            set.control_vertices.push_back({{p.x, p.y, p.z}, {n.x, n.y, n.z}, {u, v}});
        };
        const auto first = static_cast<std::uint32_t>(set.control_vertices.size());
        set.corners.push_back({first, first + 1, first + 2, patches::no_corner});
        add(c.p0, c.n0, 0.1f, 0.2f);
        add(c.p1, c.n1, 0.9f, 0.3f);
        add(c.p2, c.n2, 0.4f, 0.8f);
    }
    set.ranges.push_back({"patches", 0, 0, set.patch_count()});
    TessellationOptions options;
    options.scheme = GetParam().scheme;
    options.normals = GetParam().normals;
    options.alpha = 0.6f;
    const PatchFactors factors{3.0f, 4.5f, 5.0f, 6.25f, 0, 0};
    options.factors = factors;
    gpu::Device device = test::open_device("reference");
    const RefinedMesh mesh = tessellate(device, set, options);
    const Pattern pattern =
        make_patterns(device, Domain::triangle, options.partitioning, true, std::span(&factors, 1)).front();
    ASSERT_EQ(mesh.vertices.size(), set.patch_count() * pattern.points.size());
    ASSERT_EQ(mesh.indices.size(), set.patch_count() * pattern.indices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const test::PaperPatch patch = corners_of(set, i / pattern.points.size());
        const DomainPoint& point = pattern.points[i % pattern.points.size()];
        const double u = point.u / 65536.0;
        const double v = point.v / 65536.0;
        const dvec3 uvw(u, v, 1.0 - u - v);
        const Vertex& found = mesh.vertices[i];
        const dvec3 position(found.position[0], found.position[1], found.position[2]);
        const dvec3 normal(found.normal[0], found.normal[1], found.normal[2]);
        ASSERT_LT(glm::length(position - expected_position(patch, options, uvw)), 1e-5) << "vertex " << i;
        ASSERT_LT(glm::length(normal - expected_normal(patch, options, uvw)), 1e-5) << "vertex " << i;
        ASSERT_NEAR(found.uv[0], 0.1 * uvw[0] + 0.9 * uvw[1] + 0.4 * uvw[2], 1e-6);
        ASSERT_NEAR(found.uv[1], 0.2 * uvw[0] + 0.3 * uvw[1] + 0.8 * uvw[2], 1e-6);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t base = i / pattern.indices.size() * pattern.points.size();
        ASSERT_EQ(mesh.indices[i], base + pattern.indices[i % pattern.indices.size()]);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Output,
                         testing::Values(Case{Scheme::linear, Normals::linear},
                                         Case{Scheme::linear, Normals::quadratic}, Case{Scheme::phong, Normals::linear},
                                         Case{Scheme::phong, Normals::quadratic}, Case{Scheme::pn, Normals::linear},
                                         Case{Scheme::pn, Normals::quadratic}),
                         [](const auto& info) {
                             return std::string(name(info.param.scheme)) + "_" + std::string(name(info.param.normals));
                         });

// Some devices flush denormals, so none may arise, nor a zero of either sign from two patches.
TEST(Output, TinyMagnitudesAreZero) {
    patches::PatchSet set;
    set.control_vertices = {{{0x1p-59f, -0x1p-59f, 1.0f}, {0, 0, 1}, {-0x1p-60f, 0x1p-60f}},
                            {{0.0f, 0.0f, 1.0f}, {0, 0, 1}, {0, 0}},
                            {{0.0f, -0x1p-60f, 0.5f}, {0, 0, 1}, {0, 0}}};
    set.corners = {{0, 1, 2, patches::no_corner}};
    set.ranges.push_back({"patch", 0, 0, 1});
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        TessellationOptions options;
        options.scheme = scheme;
        options.factors = PatchFactors{9, 9, 9, 9, 0, 0};
        for (const Vertex& vertex : tessellate(test::open_device("reference"), set, options).vertices) {
            for (const float x : {vertex.position[0], vertex.position[1], vertex.uv[0], vertex.uv[1]}) {
                EXPECT_TRUE(std::bit_cast<std::uint32_t>(x) == 0 || std::fabs(x) >= 0x1p-60f)
                    << name(scheme) << " " << x;
            }
        }
    }
}

TEST(Output, PartsFollowTheMeshes) {
    patches::PatchSet set = test::load_patches("shape:torus");
    set.ranges = {{"first", 1, 0, 100}, {"empty", 0, 100, 0}, {"second", 2, 100, 92}};
    TessellationOptions options;
    options.factors = PatchFactors{3, 3, 3, 3, 0, 0};
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    ASSERT_EQ(mesh.parts.size(), 3u);
    const std::size_t per_patch = mesh.vertices.size() / set.patch_count();
    EXPECT_EQ(mesh.parts[0].vertex_count, 100 * per_patch);
    EXPECT_EQ(mesh.parts[1].vertex_count, 0u);
    EXPECT_EQ(mesh.parts[2].first_vertex, 100 * per_patch);
    EXPECT_EQ(mesh.parts[2].vertex_count, 92 * per_patch);
    EXPECT_EQ(mesh.parts[2].name, "second");
    EXPECT_EQ(mesh.parts[2].material, 2u);
    EXPECT_EQ(mesh.parts[2].first_index + mesh.parts[2].index_count, mesh.indices.size());
}

TEST(Output, AllCulledIsEmpty) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    TessellationOptions options;
    options.factors = PatchFactors{0, 3, 3, 3, 0, 0};
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    EXPECT_TRUE(mesh.vertices.empty() && mesh.indices.empty());
}

}  // namespace
}  // namespace tessera
