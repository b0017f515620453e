// Colours and tangents of vertices: blended linearly, the same from both sides of an edge, on every device and in any
// batches.
#include "base/error.hpp"
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/tessellate.hpp"
#include "verify/compare_jobs.hpp"

#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>

namespace tessera {
namespace {

using glm::dvec4;

/// One flat patch of three or four corners; attributes of the corners as given.
patches::PatchSet one_patch(bool quad, const std::array<VertexAttributes, 4>& attributes) {
    patches::PatchSet set;
    for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}})
        set.control_vertices.push_back({{x, y, 0}, {0, 0, 1}, {x, y}});
    set.corners = {{0, 1, 2, quad ? 3 : patches::no_corner}};
    set.has_quads = quad;
    set.corner_attributes = {attributes};
    set.ranges.push_back({"patch", 0, 0, 1});
    return set;
}

TessellationOptions with_factor(float factor) {
    TessellationOptions options;
    options.partitioning = Partitioning::fractional_even;
    options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
    return options;
}

dvec4 as_vector(const float (&v)[4]) {
    return {v[0], v[1], v[2], v[3]};
}

const std::array<VertexAttributes, 4> painted{{{{1, 0, 0, 0.5f}, {0.8f, 0.6f, 0, 1}},
                                               {{0, 1, 0, 1}, {0.8f, 0, 0.6f, 1}},
                                               {{0, 0, 1, 0.25f}, {0, 0.6f, 0.8f, 1}},
                                               {{0.3f, 0.7f, 0.9f, 0}, {0, 1, 0, 1}}}};

TEST(Attributes, AreBlendedLinearlyAndTangentsMadeUnit) {
    for (const bool quad : {false, true}) {
        for (const float factor : {1.0f, 5.5f, 17.0f}) {
            const TessellationOptions options = with_factor(factor);
            const RefinedMesh mesh = tessellate(test::open_device("reference"), one_patch(quad, painted), options);
            ASSERT_EQ(mesh.attributes.size(), mesh.vertices.size());
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                // The patch is the unit square, or its half: u of the texture coordinates is x.
                const double x = mesh.vertices[i].uv[0], y = mesh.vertices[i].uv[1];
                const std::array<double, 4> weights =
                    quad ? std::array{(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y}
                         : std::array{1 - x, x - y, y, 0.0};
                dvec4 colour(0.0), tangent(0.0);
                for (std::size_t c = 0; c < 4; ++c) {
                    colour += weights[c] * as_vector(painted[c].color);
                    tangent += weights[c] * as_vector(painted[c].tangent);
                }
                const double length = glm::length(glm::dvec3(tangent));
                const dvec4 unit = dvec4(glm::dvec3(tangent) / length, 1.0);
                for (int k = 0; k < 4; ++k) {
                    ASSERT_NEAR(mesh.attributes[i].color[k], colour[k], 1e-6) << i;
                    ASSERT_NEAR(mesh.attributes[i].tangent[k], unit[k], 1e-6) << i;
                }
            }
        }
    }
}

TEST(Attributes, ThatAreEqualAtTheCornersStayExactly) {
    for (const bool quad : {false, true}) {
        std::array<VertexAttributes, 4> mirrored{};
        for (VertexAttributes& a : mirrored)
            a.tangent[0] = a.tangent[3] = -1.0f;
        for (const auto& attributes : {std::array<VertexAttributes, 4>{}, mirrored}) {
            const RefinedMesh mesh =
                tessellate(test::open_device("reference"), one_patch(quad, attributes), with_factor(9.3f));
            for (const VertexAttributes& a : mesh.attributes)
                ASSERT_EQ(std::memcmp(&a, &attributes[0], sizeof a), 0);
        }
    }
}

TEST(Attributes, OppositeTangentsCancelToZero) {
    std::array<VertexAttributes, 4> attributes{};
    attributes[0].tangent[0] = 1.0f;
    attributes[1].tangent[0] = -1.0f;
    attributes[0].tangent[3] = 1.0f;
    attributes[1].tangent[3] = -1.0f;
    const RefinedMesh mesh =
        tessellate(test::open_device("reference"), one_patch(false, attributes), with_factor(2.0f));
    std::size_t cancelled = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float(&t)[4] = mesh.attributes[i].tangent;
        const float along = mesh.vertices[i].uv[0];  // 0 at the first corner, 1 at the second
        if (mesh.vertices[i].uv[1] != 0.0f) continue;
        EXPECT_EQ(t[0], along < 0.5f ? 1.0f : along > 0.5f ? -1.0f : 0.0f);
        EXPECT_EQ(t[3], t[0]);
        cancelled += t[3] == 0.0f ? 1 : 0;
    }
    EXPECT_EQ(cancelled, 1u);
}

/// Attributes that depend on the control vertex's position alone.
VertexAttributes attributes_at(const Vertex& vertex) {
    std::uint32_t seed = 1;
    for (const float x : vertex.position) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        seed = (seed ^ bits) * 2654435761u;
    }
    std::mt19937 random(seed);
    const auto any = [&] { return static_cast<float>(random() % 100001) * 1e-5f; };
    VertexAttributes a{{any(), any(), any(), any()}, {any() - 0.5f, any() - 0.5f, any() + 0.1f, 0}};
    const float length = std::hypot(a.tangent[0], a.tangent[1], a.tangent[2]);
    for (int k = 0; k < 3; ++k)
        a.tangent[k] /= length;
    a.tangent[3] = random() % 2 == 0 ? 1.0f : -1.0f;
    return a;
}

patches::PatchSet painted_model(const std::string& name) {
    patches::PatchSet set = test::load_patches(name);
    set.corner_attributes.resize(set.corners.size());
    for (std::size_t p = 0; p < set.corners.size(); ++p) {
        for (std::size_t c = 0; c < (patches::is_quad(set.corners[p]) ? 4u : 3u); ++c)
            set.corner_attributes[p][c] = attributes_at(set.control_vertices[set.corners[p][c]]);
    }
    return set;
}

/// A closed box: quads, and one side of triangles. It ends at odd offsets.
patches::PatchSet painted_box() {
    scene::Scene scene;
    scene.source = "box";
    scene.materials.resize(1);
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < 8; ++i) {
        mesh.positions.emplace_back(i & 1u ? 1.0f : -0.7f, i & 2u ? 0.9f : -1.0f, i & 4u ? 1.3f : -1.0f);
        mesh.normals.push_back(glm::normalize(mesh.positions.back()));
        mesh.uvs.emplace_back(0.0f);
    }
    mesh.quads = {0, 2, 3, 1, 0, 1, 5, 4, 1, 3, 7, 5, 3, 2, 6, 7, 2, 0, 4, 6};
    mesh.triangles = {4, 5, 7, 4, 7, 6};
    scene.meshes.push_back(mesh);
    patches::PatchSet set = patches::make_patches(scene);
    set.corner_attributes.resize(set.corners.size());
    for (std::size_t p = 0; p < set.corners.size(); ++p) {
        for (std::size_t c = 0; c < (patches::is_quad(set.corners[p]) ? 4u : 3u); ++c)
            set.corner_attributes[p][c] = attributes_at(set.control_vertices[set.corners[p][c]]);
    }
    return set;
}

TEST(Attributes, HaveTheSameBitsFromBothSidesOfAnEdge) {
    for (const patches::PatchSet& set :
         {painted_model("shape:sphere:5"), painted_model("shape:torus"), painted_box()}) {
        TessellationOptions options;
        options.factors = random_edge_factors(set, 1.0f, 14.0f, 3);
        const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
        std::map<std::array<float, 3>, std::size_t> first;
        std::size_t shared = 0;
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const float(&p)[3] = mesh.vertices[i].position;
            const auto [found, is_new] = first.try_emplace({p[0], p[1], p[2]}, i);
            if (is_new) continue;
            ++shared;
            ASSERT_EQ(std::memcmp(&mesh.attributes[i], &mesh.attributes[found->second], sizeof(VertexAttributes)), 0)
                << "vertices " << i << " and " << found->second;
        }
        EXPECT_GT(shared, 20u);
    }
}

class AttributesOn : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(AttributesOn, AreTheSameBits) {
    const std::vector<gpu::Device> devices{test::open_device("reference"), test::open_device(GetParam().id)};
    for (const patches::PatchSet& set : {painted_model("shape:sphere:4"), painted_box()}) {
        for (const Partitioning partitioning : {Partitioning::fractional_odd, Partitioning::uniform}) {
            if (partitioning == Partitioning::uniform && set.has_quads) continue;
            TessellationOptions options;
            options.partitioning = partitioning;
            options.tangents = Tangents::uv;
            options.factors = random_edge_factors(set, 0.5f, 11.0f, 7);
            auto& factors = std::get<std::vector<PatchFactors>>(options.factors);
            for (std::size_t i = 0; i < factors.size(); i += 5)
                factors[i][0] = 0.0f;  // culled
            factors.back()[0] = 0.0f;  // nothing lies behind the last vertex
            for (const verify::DeviceComparison& result : verify::compare_jobs(devices, set, options)) {
                EXPECT_TRUE(result.equal()) << result.device.id;
                EXPECT_GT(result.stages[static_cast<std::size_t>(StageId::attributes)].words, 500u);
            }
            // All patches with one pattern.
            options.factors = PatchFactors{6, 6, 6, 6, 6, 6};
            for (const verify::DeviceComparison& result : verify::compare_jobs(devices, set, options))
                EXPECT_TRUE(result.equal()) << result.device.id;
        }
    }
}

TESSERA_ON_EVERY_DEVICE(AttributesOn);

TEST(Attributes, AreUnchangedByBatchesAndKeepTheBudget) {
    const patches::PatchSet set = painted_model("shape:sphere:10");
    TessellationOptions options;
    options.factors = random_edge_factors(set, 0.5f, 24.0f, 3);
    const RefinedMesh whole = tessellate(test::open_device("reference"), set, options);
    ASSERT_EQ(whole.attributes.size(), whole.vertices.size());
    options.memory_budget = 800'000;
    Tessellator tessellator(test::open_device("reference"), set, options);
    RefinedMesh pieces;
    tessellator.run(pieces);
    EXPECT_LE(tessellator.device_bytes(), options.memory_budget);
    ASSERT_EQ(whole.attributes.size(), pieces.attributes.size());
    EXPECT_EQ(std::memcmp(whole.attributes.data(), pieces.attributes.data(),
                          whole.attributes.size() * sizeof(VertexAttributes)),
              0);
    // And they change nothing else; patches without have no such stage.
    patches::PatchSet plain = set;
    plain.corner_attributes.clear();
    options.memory_budget = 512ull << 20;
    const RefinedMesh without = tessellate(test::open_device("reference"), plain, options);
    EXPECT_TRUE(without.attributes.empty());
    EXPECT_EQ(std::memcmp(without.vertices.data(), whole.vertices.data(), whole.vertices.size() * sizeof(Vertex)), 0);
}

TEST(Attributes, OfTooFewPatchesAreRefused) {
    patches::PatchSet set = painted_model("shape:icosahedron");
    set.corner_attributes.pop_back();
    try {
        Tessellator tessellator(test::open_device("reference"), set, {});
        ADD_FAILURE() << "19 sets of attributes were taken for 20 patches";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("19 patches for 20"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace tessera
