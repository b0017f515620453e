// Quads of quad patches, written and read back by the project's own reader.
#include "export/sample_mesh.hpp"
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/tessellate.hpp"

#include "base/error.hpp"
#include "export/mesh_readers.hpp"

#include <gtest/gtest.h>
#include <glm/glm.hpp>
#include <map>

namespace tessera::test {
namespace {

/// A closed mesh of quads and triangles: a box around a ring of triangles.
scene::Scene prism() {
    scene::Scene scene;
    scene.materials.resize(1);
    scene::Mesh& mesh = scene.meshes.emplace_back();
    constexpr std::uint32_t sides = 7;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const float a = 6.2831853f * static_cast<float>(i) / sides;
        mesh.positions.push_back({std::cos(a), std::sin(a), -0.75f});
        mesh.positions.push_back({std::cos(a), std::sin(a), 0.75f});
    }
    mesh.positions.push_back({0, 0, -1.25f});
    mesh.positions.push_back({0, 0, 1.25f});
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.quads.insert(mesh.quads.end(), {a, b, b + 1, a + 1});
        mesh.triangles.insert(mesh.triangles.end(), {b, a, 2 * sides, a + 1, b + 1, 2 * sides + 1});
    }
    for (const glm::vec3& p : mesh.positions)
        mesh.normals.push_back(glm::normalize(p));
    mesh.uvs.assign(mesh.positions.size(), glm::vec2(0.0f));
    return scene;
}

double area(const scene::Scene& scene) {
    double sum = 0.0;
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const glm::dvec3 p = mesh.positions[a];
            sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[b]) - p, glm::dvec3(mesh.positions[c]) - p));
        };
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            add(mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]);
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
            add(mesh.quads[i], mesh.quads[i + 1], mesh.quads[i + 2]);
            add(mesh.quads[i], mesh.quads[i + 2], mesh.quads[i + 3]);
        }
    }
    return sum;
}

/// Edges between positions that are not used once each way.
std::size_t open_edges(const scene::Scene& scene) {
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> uses;
    for (const scene::Mesh& mesh : scene.meshes) {
        const auto face = [&](const std::uint32_t* corners, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) {
                const glm::vec3 p = mesh.positions[corners[k]];
                const glm::vec3 q = mesh.positions[corners[(k + 1) % count]];
                const Point a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
                uses[a < b ? std::pair{a, b} : std::pair{b, a}] += a < b ? 1 : -1;
            }
        };
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            face(&mesh.triangles[i], 3);
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4)
            face(&mesh.quads[i], 4);
    }
    return static_cast<std::size_t>(std::ranges::count_if(uses, [](const auto& use) { return use.second != 0; }));
}

scene::Scene written_and_read(const std::string& extension, const patches::PatchSet& set, const scene::Scene& materials,
                              TessellationOptions options, Topology topology) {
    const TemporaryFolder folder;
    options.topology = topology;
    Tessellator tessellator(test::open_device("reference"), set, options);
    const auto path = folder / ("mesh" + extension);
    const auto writer = exporting::create_mesh_writer(path, tessellator.totals(), materials);
    tessellator.run(*writer);
    writer->finish();
    return scene::load_scene(path.string());
}

class Quads : public testing::TestWithParam<const char*> {};

TEST_P(Quads, ComeBackAsQuads) {
    const scene::Scene source = prism();
    const patches::PatchSet set = patches::make_patches(source);
    for (const Partitioning partitioning :
         {Partitioning::integer, Partitioning::fractional_odd, Partitioning::fractional_even}) {
        TessellationOptions options;
        options.partitioning = partitioning;
        options.factors = random_edge_factors(set, 2.0f, 9.0f, 3);
        const scene::Scene quads = written_and_read(GetParam(), set, source, options, Topology::quads);
        const scene::Scene plain = written_and_read(GetParam(), set, source, options, Topology::triangles);
        ASSERT_EQ(quads.meshes.size(), 1u);
        const std::size_t quad_count = quads.meshes[0].quads.size() / 4;
        EXPECT_GT(quad_count, 7u * 4u);
        EXPECT_EQ(plain.meshes.at(0).quads.size(), 0u);
        EXPECT_EQ(quads.meshes[0].triangles.size() / 3 + 2 * quad_count, plain.meshes[0].triangles.size() / 3);
        EXPECT_EQ(open_edges(quads), 0u);
        EXPECT_EQ(open_edges(plain), 0u);
        EXPECT_NEAR(area(quads), area(plain), 1e-9 * area(plain));
    }
}

TEST_P(Quads, EqualFactorsLeaveNoTriangleOfAQuadPatch) {
    scene::Scene source = prism();
    source.meshes[0].triangles.clear();
    const patches::PatchSet set = patches::make_patches(source);
    TessellationOptions options;
    options.factors = PatchFactors{5, 5, 5, 5, 5, 5};
    const scene::Scene quads = written_and_read(GetParam(), set, source, options, Topology::quads);
    EXPECT_EQ(quads.meshes.at(0).quads.size() / 4, 7u * 25u);
    EXPECT_TRUE(quads.meshes[0].triangles.empty());
}

INSTANTIATE_TEST_SUITE_P(In, Quads, testing::Values(".obj", ".glb"),
                         [](const auto& info) { return std::string(info.param + 1); });

TEST(Quads, AreRefusedInPly) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(3);
    mesh.totals.has_quads = true;
    EXPECT_THROW(exporting::create_mesh_writer(folder / "mesh.ply", mesh.totals, mesh.scene), Error);
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Quads, MarksMustNameHalvesOfOne) {
    const TemporaryFolder folder;
    SampleMesh mesh = sample_mesh(3);
    mesh.totals.has_quads = true;
    // 0 1 2 and 2 1 3 become 2 0 1 and 2 1 3 in each patch.
    for (std::size_t i = 0; i < mesh.indices.size(); i += 6)
        std::rotate(&mesh.indices[i], &mesh.indices[i] + 2, &mesh.indices[i] + 3);
    const auto write = [&](const std::vector<std::uint8_t>& quads) {
        const auto writer = exporting::create_mesh_writer(folder / "mesh.obj", mesh.totals, mesh.scene);
        writer->append({0, 0, mesh.vertices, mesh.indices, quads});
        writer->finish();
    };
    EXPECT_NO_THROW(write({1, 0, 0, 0, 1, 0}));
    const std::string text = read_bytes(folder / "mesh.obj");
    EXPECT_NE(text.find("f 3/3/3 1/1/1 2/2/2 4/4/4\n"), std::string::npos) << text;
    EXPECT_NE(text.find("f 7/7/7 5/5/5 6/6/6\nf 7/7/7 6/6/6 8/8/8\n"), std::string::npos) << text;
    EXPECT_THROW(write({}), std::logic_error);
    EXPECT_THROW(write({0, 1, 0, 0, 0, 0}), std::logic_error) << "not halves of one quad, and of two parts";
    EXPECT_THROW(write({0, 0, 0, 0, 0, 1}), std::logic_error) << "no other half";
    EXPECT_THROW(write({1, 1, 0, 0, 0, 0}), std::logic_error);
    mesh.totals.has_quads = false;
    EXPECT_THROW(write({1, 0, 0, 0, 1, 0}), std::logic_error);
}

}  // namespace
}  // namespace tessera::test
