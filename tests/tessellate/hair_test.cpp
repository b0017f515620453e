// Hair: splines through their guides, counts, places between guides, widths and facings, on every device; and the
// same bits on all of them, whatever the guides.
#include "base/error.hpp"
#include "support/devices.hpp"
#include "tessellate/scene_tessellator.hpp"
#include "verify/compare_jobs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace tessera {
namespace {

scene::Scene scene_of(const std::vector<std::vector<glm::vec3>>& curves, float width, glm::vec3 normal = glm::vec3(0)) {
    scene::Scene scene;
    scene.source = "test";
    scene.materials.resize(1);
    scene::Guides guides;
    guides.name = "hair";
    for (const auto& curve : curves) {
        guides.points.insert(guides.points.end(), curve.begin(), curve.end());
        guides.ends.push_back(static_cast<std::uint32_t>(guides.points.size()));
    }
    guides.normals.assign(guides.points.size(), normal);
    guides.widths.assign(guides.points.size(), width);
    scene.guides.push_back(guides);
    return scene;
}

glm::vec3 position(const Vertex& v) {
    return {v.position[0], v.position[1], v.position[2]};
}
glm::vec3 normal(const Vertex& v) {
    return {v.normal[0], v.normal[1], v.normal[2]};
}

class Hair : public testing::TestWithParam<gpu::DeviceInfo> {
protected:
    RefinedMesh make(const scene::Scene& scene, const HairOptions& options) const {
        return tessellate_hair(test::open_device(GetParam().id), patches::make_hair(scene), options);
    }
};

TEST_P(Hair, ASplineGoesThroughThePointsOfItsGuide) {
    const std::vector<glm::vec3> guide{
        {0.5f, 0, 0}, {0.25f, 0.75f, 0.125f}, {1, 1, -0.5f}, {1.5f, 0.3f, 0.7f}, {-0.1f, 1.1f, 0.9f}};
    const RefinedMesh mesh = make(scene_of({guide}, 0.0f), {.hairs = 16, .segments = 16});
    ASSERT_EQ(mesh.vertices.size(), 2u * 17u) << "a lone guide is one hair";
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 2) {
        EXPECT_EQ(position(mesh.vertices[i]), position(mesh.vertices[i + 1])) << "of no width";
        EXPECT_EQ(mesh.vertices[i].uv[0], 0.0f);
        EXPECT_EQ(mesh.vertices[i + 1].uv[0], 1.0f);
        EXPECT_EQ(mesh.vertices[i].uv[1], static_cast<float>(i / 2) / 16.0f);
        if (i % 8 == 0) {
            EXPECT_EQ(position(mesh.vertices[i]), guide[i / 8]);
        }
    }
    // Catmull-Rom halfway between two points: (9 (b + c) - (a + d)) / 16; beyond the root a point is reflected.
    const auto halfway = [](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        return (9.0f * (b + c) - (a + d)) / 16.0f;
    };
    EXPECT_LT(glm::distance(position(mesh.vertices[2 * 6]), halfway(guide[0], guide[1], guide[2], guide[3])), 1e-6f);
    EXPECT_LT(glm::distance(position(mesh.vertices[2 * 2]),
                            halfway(2.0f * guide[0] - guide[1], guide[0], guide[1], guide[2])),
              1e-6f);
}

TEST_P(Hair, CountsAreThoseOfHairsAndSegments) {
    const scene::Scene three = scene_of({{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 1}}, {{0, 1, 0}, {0, 1, 1}}}, 0.1f);
    for (const std::uint32_t hairs : {1u, 5u, 64u, 65u, 200u}) {
        for (const std::uint32_t segments : {1u, 7u, 64u}) {
            const RefinedMesh mesh = make(three, {.hairs = hairs, .segments = segments});
            EXPECT_EQ(mesh.vertices.size(), std::size_t{2} * hairs * (segments + 1));
            EXPECT_EQ(mesh.indices.size(), std::size_t{6} * hairs * segments);
            ASSERT_EQ(mesh.parts.size(), 1u);
            EXPECT_EQ(mesh.parts[0].vertex_count, mesh.vertices.size());
            std::set<std::uint32_t> used(mesh.indices.begin(), mesh.indices.end());
            EXPECT_EQ(used.size(), mesh.vertices.size());
            EXPECT_EQ(*used.rbegin(), mesh.vertices.size() - 1);
        }
    }
}

TEST_P(Hair, HairsBetweenThreeGuidesFillTheirTriangle) {
    const scene::Scene three = scene_of({{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 1}}, {{0, 1, 0}, {0, 1, 1}}}, 0.0f);
    const RefinedMesh mesh = make(three, {.hairs = 100, .segments = 1});
    ASSERT_EQ(mesh.vertices.size(), 400u);
    glm::vec3 sum(0.0f);
    std::set<std::pair<float, float>> roots;
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 4) {
        const glm::vec3 root = position(mesh.vertices[i]);
        const glm::vec3 tip = position(mesh.vertices[i + 2]);
        EXPECT_EQ(root.z, 0.0f);
        EXPECT_EQ(tip.z, 1.0f);
        EXPECT_TRUE(root.x >= 0.0f && root.y >= 0.0f && root.x + root.y <= 1.0f) << root.x << " " << root.y;
        EXPECT_EQ(root.x, tip.x);
        sum += root;
        roots.emplace(root.x, root.y);
    }
    EXPECT_EQ(roots.size(), 100u) << "no two alike";
    EXPECT_NEAR(sum.x / 100.0f, 1.0f / 3.0f, 0.02f) << "spread evenly";
    EXPECT_NEAR(sum.y / 100.0f, 1.0f / 3.0f, 0.02f);
}

TEST_P(Hair, HairsBetweenTwoGuidesLieEvenlyFromTheFirstOn) {
    for (const std::uint32_t hairs : {4u, 128u}) {
        const RefinedMesh mesh = make(scene_of({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1.5f, 1, 0}, {1, 1.5f, 0}}}, 0.0f),
                                      {.hairs = hairs, .segments = 2});
        ASSERT_EQ(mesh.vertices.size(), std::size_t{6} * hairs);
        for (std::uint32_t hair = 0; hair < hairs; ++hair) {
            const float v = static_cast<float>(hair) / static_cast<float>(hairs);
            EXPECT_EQ(position(mesh.vertices[6 * hair]), glm::vec3(v, 0, 0));
            EXPECT_EQ(position(mesh.vertices[6 * hair + 2]), glm::vec3(1.5f * v, 0.5f + 0.5f * v, 0));
            EXPECT_EQ(position(mesh.vertices[6 * hair + 4]), glm::vec3(v, 1.0f + 0.5f * v, 0));
        }
    }
}

TEST_P(Hair, HairsOfVariedLengthEndBeforeTheirGuides) {
    const scene::Scene three = scene_of({{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 1}}, {{0, 1, 0}, {0, 1, 1}}}, 0.0f);
    const RefinedMesh mesh = make(three, {.hairs = 200, .segments = 1, .variation = 0.5f});
    ASSERT_EQ(mesh.vertices.size(), 800u);
    float shortest = 1.0f, longest = 0.0f, sum = 0.0f;
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 4) {
        EXPECT_EQ(position(mesh.vertices[i]).z, 0.0f);
        EXPECT_EQ(mesh.vertices[i + 2].uv[1], 1.0f);
        const float length = position(mesh.vertices[i + 2]).z;
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        sum += length;
    }
    EXPECT_NEAR(shortest, 0.5f, 0.02f);
    EXPECT_NEAR(longest, 1.0f, 0.02f);
    EXPECT_LE(longest, 1.0f);
    EXPECT_NEAR(sum / 200.0f, 0.75f, 0.03f);
}

TEST_P(Hair, RibbonsFaceTheCameraAndTaper) {
    const scene::Scene upright = scene_of({{{0, 0, 0}, {0, 0.5f, 0}, {0, 1, 0}}}, 0.25f);
    const RefinedMesh mesh =
        make(upright, {.segments = 4, .taper = 0.5f, .ribbons = Ribbons::camera, .eye = {0, 0.5f, 8}});
    ASSERT_EQ(mesh.vertices.size(), 10u);
    for (std::size_t i = 0; i < 5; ++i) {
        const float along = static_cast<float>(i) / 4.0f;
        const float reach = 0.125f * (1.0f - 0.5f * along);
        EXPECT_NEAR(mesh.vertices[2 * i].position[0], -reach, 1e-6f) << "left";
        EXPECT_NEAR(mesh.vertices[2 * i + 1].position[0], reach, 1e-6f) << "right";
        EXPECT_NEAR(mesh.vertices[2 * i].position[1], along, 1e-6f);
        // Without normals of the guides those of half a cylinder towards the eye.
        EXPECT_NEAR(normal(mesh.vertices[2 * i]).x, -std::sqrt(0.5f), 1e-5f);
        EXPECT_NEAR(normal(mesh.vertices[2 * i + 1]).z, std::sqrt(0.5f), 1e-5f);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return position(mesh.vertices[mesh.indices[i + c]]); };
        EXPECT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0.0f) << "seen from the front";
    }
}

TEST_P(Hair, TheEyeIsInTheModelsUnits) {
    // The same scene in metres and in a thousand times as many millimetres.
    for (const float unit : {1.0f, 1000.0f}) {
        const scene::Scene scene = scene_of({{{0, 0, 0}, {0, unit, 0}}}, 0.1f * unit);
        const RefinedMesh mesh =
            make(scene, {.segments = 1, .ribbons = Ribbons::camera, .eye = glm::vec3(3, 0.5f, 0) * unit});
        EXPECT_NEAR(mesh.vertices[0].position[2] / unit, 0.05f, 1e-6f) << "seen from +x, the left is +z";
    }
}

TEST_P(Hair, FlatRibbonsKeepTheirDirection) {
    const scene::Scene leaning = scene_of({{{0, 0, 0}, {0.5f, 0.5f, 0}}, {{0, 0, 1}, {0, 1, 1}}}, 0.2f, {0, 0, 1});
    const RefinedMesh mesh =
        make(leaning, {.hairs = 2, .segments = 1, .taper = 0.0f, .ribbons = Ribbons::flat, .direction = {5, 0, 0}});
    const glm::vec3 across = position(mesh.vertices[1]) - position(mesh.vertices[0]);
    EXPECT_NEAR(glm::length(across), 0.2f, 1e-6f);
    EXPECT_NEAR(across.x, 0.2f * std::sqrt(0.5f), 1e-6f) << "at right angles to the hair, as near to +x as that allows";
    EXPECT_NEAR(across.y, -0.2f * std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(normal(mesh.vertices[0]).z, std::sqrt(0.5f), 1e-5f) << "around the normal of the guides";
}

TEST_P(Hair, HairSeenEndOnKeepsItsWidth) {
    for (const glm::vec3 along :
         {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0.6f, 0, 0.8f)}) {
        const scene::Scene scene = scene_of({{glm::vec3(0), along}}, 0.2f);
        for (const Ribbons ribbons : {Ribbons::camera, Ribbons::flat}) {
            const RefinedMesh mesh = make(
                scene,
                {.segments = 3, .taper = 0.0f, .ribbons = ribbons, .eye = 9.0f * along + 1e-5f, .direction = along});
            for (std::size_t i = 0; i < mesh.vertices.size(); i += 2) {
                const glm::vec3 across = position(mesh.vertices[i + 1]) - position(mesh.vertices[i]);
                EXPECT_NEAR(glm::length(across), 0.2f, 1e-6f);
                EXPECT_NEAR(glm::dot(across, along), 0.0f, 1e-6f);
                EXPECT_NEAR(glm::distance(across, position(mesh.vertices[1]) - position(mesh.vertices[0])), 0.0f, 1e-6f)
                    << "it does not turn on the way";
            }
        }
    }
}

TEST_P(Hair, BatchesDoNotChangeTheOutput) {
    std::vector<std::vector<glm::vec3>> curves;
    for (int i = 0; i < 25; ++i)
        curves.push_back({glm::vec3(i % 5, i / 5, 0), glm::vec3(i % 5, i / 5, 1), glm::vec3(i % 5 + 1, i / 5, 2)});
    const scene::Scene scene = scene_of(curves, 0.1f);
    HairOptions options{.hairs = 100, .segments = 64};
    const RefinedMesh whole = make(scene, options);
    options.memory_budget = 900'000;
    const RefinedMesh pieces = make(scene, options);
    ASSERT_EQ(whole.vertices.size(), pieces.vertices.size());
    EXPECT_EQ(std::memcmp(whole.vertices.data(), pieces.vertices.data(), whole.vertices.size() * sizeof(Vertex)), 0);
    EXPECT_EQ(whole.indices, pieces.indices);
}

TEST_P(Hair, SurfaceAndHairAreOneOutput) {
    scene::Scene scene = scene_of({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}}, 0.1f);
    scene::Mesh mesh;
    mesh.name = "skin";
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.uvs.assign(3, {0, 0});
    mesh.triangles = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.meshes.back().colors.assign(3, {0.5f, 0.25f, 0.0f, 1.0f});
    const patches::PatchSet patches = patches::make_patches(scene);
    const patches::HairSet hair = patches::make_hair(scene);
    SceneTessellator tessellator(test::open_device(GetParam().id), patches, {}, hair, {.hairs = 3, .segments = 2});
    const MeshTotals& totals = tessellator.totals();
    RefinedMesh both;
    tessellator.run(both);
    ASSERT_EQ(totals.parts.size(), 2u);
    EXPECT_EQ(both.vertices.size(), totals.vertex_count);
    EXPECT_EQ(both.indices.size(), totals.index_count);
    EXPECT_EQ(totals.parts[1].first_vertex, totals.parts[0].vertex_count);
    EXPECT_EQ(totals.parts[1].vertex_count, 18u);
    for (std::uint64_t i = 0; i < totals.index_count; ++i) {
        const MeshPart& part = totals.parts[i < totals.parts[1].first_index ? 0 : 1];
        ASSERT_GE(both.indices[i], part.first_vertex);
        ASSERT_LT(both.indices[i], part.first_vertex + part.vertex_count);
    }
    EXPECT_EQ(position(both.vertices[totals.parts[1].first_vertex + 6]).y, 0.0f);
    // The hair of a coloured model is white: as its material says.
    ASSERT_EQ(both.attributes.size(), totals.vertex_count);
    EXPECT_EQ(both.attributes.front().color[1], 0.25f);
    EXPECT_EQ(both.attributes.back().color[1], 1.0f);
}

TESSERA_ON_EVERY_DEVICE(Hair);

// Guides of every kind: straight, folded back onto themselves, hardly there, of one and of many segments.
scene::Scene random_scene(std::uint32_t seed, float size) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() % 2001) / 1000.0f - 1.0f; };
    std::vector<std::vector<glm::vec3>> curves;
    for (int i = 0; i < 40; ++i) {
        std::vector<glm::vec3> curve{glm::vec3(number(), number(), 0.05f * number())};
        const std::size_t points = 2 + random() % 9;
        while (curve.size() < points) {
            const float step = random() % 5 == 0 ? 1e-9f : 0.3f;
            const bool back = curve.size() > 2 && random() % 4 == 0;
            curve.push_back(back ? curve[curve.size() - 2]
                                 : curve.back() + step * glm::vec3(number(), number(), number()));
        }
        for (glm::vec3& p : curve)
            p *= size;
        curves.push_back(curve);
    }
    scene::Scene scene = scene_of(curves, 0.02f * size);
    for (std::size_t i = 0; i < scene.guides[0].points.size(); i += 3)
        scene.guides[0].normals[i] = glm::normalize(glm::vec3(number(), number(), 1.5f));
    return scene;
}

TEST(HairParity, EveryDeviceMakesTheSameBits) {
    const std::vector<gpu::Device> devices = test::open_every_device();
    std::uint32_t seed = 1;
    for (const float size : {1.0f, 1e-30f, 1e30f}) {
        for (const Ribbons ribbons : {Ribbons::camera, Ribbons::flat}) {
            for (const Partitioning partitioning : {Partitioning::integer, Partitioning::fractional_odd}) {
                const patches::HairSet hair = patches::make_hair(random_scene(seed++, size));
                HairOptions options{
                    .hairs = 70, .segments = 11, .partitioning = partitioning, .variation = 0.4f, .ribbons = ribbons};
                // From outside, and from a root: the eye in the middle of the hair.
                options.eye = seed % 2 == 0
                                  ? glm::vec3(0.3f, -0.4f, 2.5f) * size
                                  : glm::vec3(patches::to_model_space(hair.points[0].position[0], hair.exponent),
                                              patches::to_model_space(hair.points[0].position[1], hair.exponent),
                                              patches::to_model_space(hair.points[0].position[2], hair.exponent));
                options.direction = {0.6f, 0.0f, 0.8f};
                for (const verify::DeviceComparison& result : verify::compare_hair_jobs(devices, hair, options)) {
                    for (std::size_t s = 0; s < stage_count; ++s) {
                        const bool made = static_cast<StageId>(s) < StageId::tangents;
                        EXPECT_EQ(result.stages[s].words > 0u, made);
                        EXPECT_EQ(result.stages[s].differing, 0u)
                            << result.device.id << " " << name(static_cast<StageId>(s)) << " size " << size << ": "
                            << (result.stages[s].first ? verify::describe(*result.stages[s].first) : "");
                    }
                }
            }
        }
    }
}

void expect_refused(const HairOptions& options) {
    const patches::HairSet hair = patches::make_hair(scene_of({{{0, 0, 0}, {0, 1, 0}}}, 0.1f));
    try {
        tessellate_hair(test::open_device("reference"), hair, options);
        ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

TEST(HairOptionsOutOfRange, AreRefused) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    expect_refused({.hairs = 0});
    expect_refused({.hairs = 4097});
    expect_refused({.segments = 0});
    expect_refused({.segments = 65});
    expect_refused({.taper = -0.1f});
    expect_refused({.taper = nan});
    expect_refused({.variation = 1.1f});
    expect_refused({.eye = {nan, 0, 0}});
    expect_refused({.direction = {0, 0, 0}});
    expect_refused({.memory_budget = 100'000});
    EXPECT_EQ(ribbons_from_name("camera"), Ribbons::camera);
    EXPECT_EQ(ribbons_from_name(name(Ribbons::flat)), Ribbons::flat);
    EXPECT_THROW(ribbons_from_name("round"), Error);
}

}  // namespace
}  // namespace tessera
