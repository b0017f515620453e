// The scheme stpn: creases and tags leave closed models closed, and sharp edges straight.
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/tessellate.hpp"
#include "tessellate/welded.hpp"
#include "verify/compare_jobs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <map>
#include <random>

namespace tessera {
namespace {

/// A closed torus of triangles and quads, `around` x 8, with smooth normals.
scene::Scene torus() {
    constexpr std::uint32_t around = 12;
    constexpr std::uint32_t along = 8;
    scene::Scene scene;
    scene.materials.resize(1);
    scene::Mesh& mesh = scene.meshes.emplace_back();
    for (std::uint32_t i = 0; i < around * along; ++i) {
        const double a = 6.283185307179586 * (i / along) / around;
        const double b = 6.283185307179586 * (i % along) / along;
        const glm::dvec3 n{std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a)};
        mesh.normals.emplace_back(n);
        mesh.positions.emplace_back(glm::dvec3{std::cos(a), 0, std::sin(a)} + 0.4 * n);
        mesh.uvs.emplace_back(0.0f);
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < along; ++k) {
            const auto at = [&](std::uint32_t x, std::uint32_t y) { return x % around * along + y % along; };
            const std::uint32_t a = at(i, k), b = at(i, k + 1), c = at(i + 1, k + 1), d = at(i + 1, k);
            if ((i + k) % 3 == 0) {
                mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
            } else {
                mesh.quads.insert(mesh.quads.end(), {a, b, c, d});
            }
        }
    }
    return scene;
}

/// Tags of every kind on random edges and vertices.
void add_random_tags(scene::Scene& scene, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    scene::Mesh& mesh = scene.meshes[0];
    for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
        const std::size_t k = random() % 4;
        if (random() % 2 == 0) continue;
        const float sharpness = random() % 3 == 0 ? 10.0f : 4.0f * share(random);
        mesh.tags.creases.push_back({mesh.quads[i + k], mesh.quads[i + (k + 1) % 4], sharpness});
    }
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 7)
        mesh.tags.corners.push_back({v, 3.0f * share(random)});
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.stpn.emplace_back(random() % 2 == 0 ? 0.0f : share(random), share(random) - 0.5f, share(random) - 0.5f);
        mesh.alphas.push_back(share(random));
    }
}

TEST(Creases, TaggedMixedMeshesAreWatertight) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        scene::Scene scene = torus();
        add_random_tags(scene, seed);
        const patches::PatchSet set = patches::make_patches(scene);
        for (const Scheme scheme : {Scheme::phong, Scheme::stpn}) {
            for (const Partitioning partitioning :
                 {Partitioning::integer, Partitioning::fractional_odd, Partitioning::fractional_even}) {
                TessellationOptions options;
                options.scheme = scheme;
                options.partitioning = partitioning;
                options.factors = random_edge_factors(set, 1.0f, 9.0f, seed);
                const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
                const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, test::WeldBy::position);
                EXPECT_EQ(test::find_crack(welded, welded.collapsed == 0), "")
                    << name(scheme) << " " << name(partitioning) << " seed " << seed;
                EXPECT_LT(welded.collapsed, mesh.indices.size() / 30);
            }
        }
    }
}

// Where no crease is near, normals are shared too.
TEST(Creases, ScalarTagsKeepNormalsTogether) {
    scene::Scene scene = torus();
    add_random_tags(scene, 5);
    scene.meshes[0].tags = {};
    const patches::PatchSet set = patches::make_patches(scene);
    TessellationOptions options;
    options.scheme = Scheme::stpn;
    options.factors = random_edge_factors(set, 1.0f, 9.0f, 5);
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, test::WeldBy::position_and_normal);
    EXPECT_EQ(test::find_crack(welded, welded.collapsed == 0), "");
}

TEST(Creases, EveryDeviceGivesTheSameBits) {
    scene::Scene scene = torus();
    add_random_tags(scene, 9);
    const patches::PatchSet set = patches::make_patches(scene);
    for (const Scheme scheme : {Scheme::phong, Scheme::stpn}) {
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            TessellationOptions options;
            options.scheme = scheme;
            options.normals = normals;
            options.factors = random_edge_factors(set, 0.5f, 7.0f, 2);
            for (const verify::DeviceComparison& result :
                 verify::compare_jobs(test::open_every_device(), set, options)) {
                EXPECT_TRUE(result.equal()) << result.device.id << " " << name(scheme) << " " << name(normals);
            }
        }
    }
}

TEST(Creases, BatchesDoNotChangeTaggedModels) {
    scene::Scene scene = torus();
    add_random_tags(scene, 9);
    const patches::PatchSet set = patches::make_patches(scene);
    TessellationOptions options;
    options.scheme = Scheme::stpn;
    options.factors = random_edge_factors(set, 10.0f, 40.0f, 2);
    const RefinedMesh whole = tessellate(test::open_device("reference"), set, options);
    options.memory_budget = 640'000;
    Tessellator tessellator(test::open_device("reference"), set, options);
    RefinedMesh pieces;
    tessellator.run(pieces);
    EXPECT_LE(tessellator.device_bytes(), options.memory_budget);
    EXPECT_EQ(whole.indices, pieces.indices);
    ASSERT_EQ(whole.vertices.size(), pieces.vertices.size());
    EXPECT_EQ(std::memcmp(whole.vertices.data(), pieces.vertices.data(), whole.vertices.size() * sizeof(Vertex)), 0);
}

TEST(Creases, WithoutTagsTheSurfaceIsThatOfPn) {
    const patches::PatchSet set = patches::make_patches(torus());
    TessellationOptions options;
    options.factors = random_edge_factors(set, 1.0f, 9.0f, 2);
    const RefinedMesh plain = tessellate(test::open_device("reference"), set, options);
    options.scheme = Scheme::stpn;
    const RefinedMesh tagged = tessellate(test::open_device("reference"), set, options);
    ASSERT_EQ(plain.vertices.size(), tagged.vertices.size());
    EXPECT_EQ(std::memcmp(plain.vertices.data(), tagged.vertices.data(), plain.vertices.size() * sizeof(Vertex)), 0);
}

scene::Scene creased_cube(bool triangles) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                      {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    for (const glm::vec3& p : mesh.positions)
        mesh.normals.push_back(glm::normalize(p));
    mesh.uvs.assign(8, glm::vec2(0.0f));
    const std::vector<std::uint32_t> quads{3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    for (std::size_t i = 0; i < quads.size(); i += 4) {
        if (triangles) {
            mesh.triangles.insert(mesh.triangles.end(), {quads[i], quads[i + 1], quads[i + 2]});
            mesh.triangles.insert(mesh.triangles.end(), {quads[i], quads[i + 2], quads[i + 3]});
        } else {
            mesh.quads.insert(mesh.quads.end(), quads.begin() + std::ptrdiff_t(i),
                              quads.begin() + std::ptrdiff_t(i) + 4);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            if (quads[i + k] < quads[i + (k + 1) % 4])
                mesh.tags.creases.push_back({quads[i + k], quads[i + (k + 1) % 4], 10.0f});
        }
    }
    return scene;
}

TEST(Creases, ACreasedCubeStaysACube) {
    for (const bool triangles : {false, true}) {
        const patches::PatchSet set = patches::make_patches(creased_cube(triangles));
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            TessellationOptions options;
            options.scheme = Scheme::stpn;
            options.normals = normals;
            options.factors = random_edge_factors(set, 3.0f, 13.0f, 6);
            const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
            for (const Vertex& v : mesh.vertices) {
                // On the face that the normal belongs to, but for rounding, and within the square.
                int axis = 0;
                for (int i = 1; i < 3; ++i)
                    axis = std::fabs(v.normal[i]) > std::fabs(v.normal[axis]) ? i : axis;
                EXPECT_NEAR(std::fabs(v.normal[axis]), 1.0f, 3e-7f);
                EXPECT_NEAR(v.position[axis], v.normal[axis], 3e-7f);
                for (int i = 0; i < 3; ++i)
                    EXPECT_LE(std::fabs(v.position[i]), 1.0f + 3e-7f);
            }
            const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, test::WeldBy::position);
            EXPECT_EQ(test::find_crack(welded, welded.collapsed == 0), "");
            // PN, for comparison, leaves the cube.
            options.scheme = Scheme::pn;
            float farthest = 0.0f;
            for (const Vertex& v : tessellate(test::open_device("reference"), set, options).vertices)
                farthest = std::max(farthest, std::fabs(v.position[0]));
            EXPECT_GT(farthest, 1.1f);
        }
    }
}

// A ring of sharp creases around the top: the top stays flat, its rim becomes round.
TEST(Creases, ARingOfCreasesIsRound) {
    scene::Scene scene = creased_cube(false);
    std::erase_if(scene.meshes[0].tags.creases, [](const scene::Crease& c) { return c.a < 4 || c.b < 4; });
    const patches::PatchSet set = patches::make_patches(scene);
    TessellationOptions options;
    options.scheme = Scheme::stpn;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{8, 8, 8, 8, 8, 8};
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    std::size_t rim = 0;
    for (const Vertex& v : mesh.vertices) {
        if (v.normal[2] < 0.999f) continue;
        EXPECT_NEAR(v.position[2], 1.0f, 3e-7f);
        // Middles of the rim's four curves: further out than the chord, as a circle through the corners would be.
        if (std::fabs(v.position[0]) < 1e-6f && std::fabs(v.position[1]) > 1.2f) {
            EXPECT_NEAR(std::fabs(v.position[1]), std::sqrt(2.0f), 0.2f);
            ++rim;
        }
    }
    EXPECT_EQ(rim, 2u);
}

TEST(Creases, TaggedModelsOfOthers) {
    TESSERA_SHARED_OR_SKIP(shared);
    for (const char* file : {"catmark_cube_creases1.obj", "catmark_torus_creases0.obj", "catmark_car.obj"}) {
        const patches::PatchSet set = test::load_patches((shared / "models/opensubdiv" / file).string());
        TessellationOptions options;
        options.scheme = Scheme::stpn;
        options.factors = random_edge_factors(set, 1.0f, 6.0f, 2);
        for (const verify::DeviceComparison& result : verify::compare_jobs(test::open_every_device(), set, options)) {
            EXPECT_TRUE(result.equal()) << file << " " << result.device.id;
        }
    }
    // Its file splits all normals, and all its edges are creases, the last but a faint one.
    const patches::PatchSet cube =
        test::load_patches((shared / "models/opensubdiv/catmark_cube_creases1.obj").string());
    TessellationOptions options;
    options.factors = random_edge_factors(cube, 1.0f, 6.0f, 2);
    const auto crack = [&](Scheme scheme) {
        options.scheme = scheme;
        const RefinedMesh mesh = tessellate(test::open_device("reference"), cube, options);
        const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, test::WeldBy::position);
        return test::find_crack(welded, welded.collapsed == 0);
    };
    EXPECT_EQ(crack(Scheme::stpn), "");
    EXPECT_EQ(crack(Scheme::linear), "");
}

}  // namespace
}  // namespace tessera
