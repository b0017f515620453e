// The project's own models are what assets/README.md says: closed, consistently wound, outward, smooth where they
// should be; the furball has its hair, and the parrot its colours.
#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace tessera::test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(TESSERA_SOURCE_DIR) / "assets";

/// Corners of a model's triangles, as numbers of distinct positions.
struct Corners {
    std::vector<glm::vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

Corners corners_by_position(const scene::Mesh& mesh) {
    Corners corners;
    std::map<std::array<float, 3>, std::uint32_t> numbers;
    const auto number = [&](std::uint32_t vertex) {
        const glm::vec3 p = mesh.positions[vertex];
        const auto [found, added] =
            numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(corners.positions.size()));
        if (added) corners.positions.push_back(p);
        return found->second;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        corners.triangles.push_back(
            {number(mesh.triangles[i]), number(mesh.triangles[i + 1]), number(mesh.triangles[i + 2])});
    }
    return corners;
}

class Asset : public testing::TestWithParam<std::string> {
protected:
    scene::Scene scene_ = scene::load_scene((folder / GetParam()).string());
    const bool hairy_ = GetParam() == "furball.glb";
};

TEST_P(Asset, IsSmallAndOnePrimitive) {
    EXPECT_LT(fs::file_size(folder / GetParam()), hairy_ ? 200'000u : 100'000u);
    EXPECT_EQ(hairy_ ? 7u : 1u, scene_.meshes.size());
    EXPECT_EQ(hairy_ ? 1u : 0u, scene_.guides.size());
    EXPECT_TRUE(scene_.messages.empty()) << scene_.messages.front();
    for (const scene::Mesh& mesh : scene_.meshes)
        EXPECT_LT(mesh.triangles.size() / 3, 700u);
}

void expect_closed_and_consistently_wound(const scene::Mesh& mesh) {
    const Corners corners = corners_by_position(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : corners.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(1, count) << edge.first << " " << edge.second << " is an edge of several triangles on one side";
        ASSERT_EQ(1u, edges.count({edge.second, edge.first})) << edge.first << " " << edge.second << " is a border";
    }
    // One sphere: no vertex where two sheets touch, no second piece, no handle.
    const auto characteristic = static_cast<std::int64_t>(corners.positions.size()) -
                                static_cast<std::int64_t>(edges.size() / 2) +
                                static_cast<std::int64_t>(corners.triangles.size());
    EXPECT_EQ(2, characteristic);
}

TEST_P(Asset, IsClosedAndConsistentlyWound) {
    for (const scene::Mesh& mesh : scene_.meshes)
        expect_closed_and_consistently_wound(mesh);
}

void expect_to_face_outward(const scene::Mesh& mesh, double least_volume) {
    const Corners corners = corners_by_position(mesh);
    double volume = 0.0;
    for (const auto& t : corners.triangles) {
        const glm::dvec3 a = corners.positions[t[0]];
        const glm::dvec3 b = corners.positions[t[1]];
        const glm::dvec3 c = corners.positions[t[2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        EXPECT_GT(glm::length(glm::cross(b - a, c - a)), 1e-6) << "a triangle without area";
    }
    EXPECT_GT(volume, least_volume);
}

TEST_P(Asset, FacesOutward) {
    for (const scene::Mesh& mesh : scene_.meshes)
        expect_to_face_outward(mesh, mesh.name == scene_.meshes.front().name ? 0.1 : 0.001);
}

void expect_normals_to_follow_the_triangles(const scene::Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const std::uint32_t* t = &mesh.triangles[i];
        const glm::vec3 face =
            glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 normal = mesh.normals[t[corner]];
            EXPECT_NEAR(1.0f, glm::length(normal), 1e-5f);
            EXPECT_GT(glm::dot(face, normal), 0.0f) << "triangle " << i / 3 << " corner " << corner;
        }
    }
}

TEST_P(Asset, NormalsFollowTheTriangles) {
    for (const scene::Mesh& mesh : scene_.meshes)
        expect_normals_to_follow_the_triangles(mesh);
}

std::vector<std::string> asset_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".glb") names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Files, Asset, testing::ValuesIn(asset_names()),
                         [](const auto& info) { return fs::path(info.param).stem().string(); });

TEST(Assets, HardEdgesAreSplitOnlyInThePawn) {
    for (const std::string& name : asset_names()) {
        const scene::Scene scene = scene::load_scene((folder / name).string());
        const scene::Mesh& mesh = scene.meshes.front();
        std::map<std::array<float, 3>, glm::vec3> normals;
        bool split = false;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            const auto found = normals.try_emplace({p.x, p.y, p.z}, mesh.normals[i]).first;
            split = split || found->second != mesh.normals[i];
        }
        EXPECT_EQ(name == "pawn.glb", split) << name;
    }
}

TEST(Assets, TheFurballsHairGrowsFromItsSkinOutward) {
    const scene::Scene scene = scene::load_scene((folder / "furball.glb").string());
    const scene::Guides& guides = scene.guides.at(0);
    EXPECT_GE(guides.ends.size(), 400u);
    ASSERT_TRUE(scene.materials.at(guides.material).base_color_image.has_value());
    EXPECT_TRUE(scene.materials.at(guides.material).double_sided);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : guides.ends) {
        EXPECT_EQ(end - begin, 6u);
        const glm::vec3 root = guides.points[begin];
        EXPECT_NEAR(glm::length(root), 0.97f * 0.85f, 1e-4f);
        EXPECT_GT(glm::length(guides.points[end - 1]), 0.9f) << "the tip of the hair at " << root.x << " " << root.y;
        for (std::uint32_t i = begin; i < end; ++i) {
            EXPECT_GE(glm::length(guides.points[i]), glm::length(root) - 1e-4f);
            EXPECT_NEAR(glm::dot(guides.normals[i], root) / glm::length(root), 1.0f, 1e-4f);
            EXPECT_GT(guides.widths[i], 0.0f);
        }
        begin = end;
    }
}

TEST(Assets, OnlyTheParrotIsPaintedAndOnBothSidesAlike) {
    for (const std::string& name : asset_names()) {
        const scene::Scene scene = scene::load_scene((folder / name).string());
        for (const scene::Mesh& mesh : scene.meshes)
            EXPECT_EQ(name == "parrot.glb" ? mesh.positions.size() : 0, mesh.colors.size()) << name;
    }
    const scene::Scene scene = scene::load_scene((folder / "parrot.glb").string());
    const scene::Mesh& mesh = scene.meshes.at(0);
    std::map<std::array<float, 3>, glm::vec4> colours;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        colours[{mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z}] = mesh.colors[i];
    std::set<std::array<float, 3>> different;
    glm::vec4 least(1.0f), most(0.0f);
    for (const auto& [p, colour] : colours) {
        ASSERT_EQ(1u, colours.count({-p[0], p[1], p[2]})) << p[0] << " " << p[1] << " " << p[2];
        EXPECT_EQ(colour, (colours[{-p[0], p[1], p[2]}])) << p[0] << " " << p[1] << " " << p[2];
        different.insert({colour.r, colour.g, colour.b});
        least = glm::min(least, colour);
        most = glm::max(most, colour);
    }
    EXPECT_GT(different.size(), colours.size() / 3) << "the colours vary from vertex to vertex";
    EXPECT_EQ(least.a, 1.0f);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LT(least[channel], 0.1f);
        EXPECT_GT(most[channel], 0.5f);
    }
}

}  // namespace
}  // namespace tessera::test
