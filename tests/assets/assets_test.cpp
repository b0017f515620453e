// The project's own models are what assets/README.md says: closed, consistently wound, outward, smooth where they
// should be.
#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

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
};

TEST_P(Asset, IsSmallAndOnePrimitive) {
    EXPECT_LT(fs::file_size(folder / GetParam()), 100'000u);
    EXPECT_EQ(1u, scene_.meshes.size());
    EXPECT_TRUE(scene_.messages.empty()) << scene_.messages.front();
    EXPECT_LT(scene_.meshes.front().triangles.size() / 3, 700u);
}

TEST_P(Asset, IsClosedAndConsistentlyWound) {
    const Corners corners = corners_by_position(scene_.meshes.front());
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

TEST_P(Asset, FacesOutward) {
    const Corners corners = corners_by_position(scene_.meshes.front());
    double volume = 0.0;
    for (const auto& t : corners.triangles) {
        const glm::dvec3 a = corners.positions[t[0]];
        const glm::dvec3 b = corners.positions[t[1]];
        const glm::dvec3 c = corners.positions[t[2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        EXPECT_GT(glm::length(glm::cross(b - a, c - a)), 1e-6) << "a triangle without area";
    }
    EXPECT_GT(volume, 0.1);
}

TEST_P(Asset, NormalsFollowTheTriangles) {
    const scene::Mesh& mesh = scene_.meshes.front();
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

}  // namespace
}  // namespace tessera::test
