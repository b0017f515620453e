// Computed tangents: planes, seams, mirrors, quads and what is degenerate.
#include "patches/mikktspace.hpp"

#include "scene/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace tessera::patches {
namespace {

using glm::vec2;
using glm::vec3;
using glm::vec4;

Vertex vertex(const vec3& p, const vec3& n, const vec2& t) {
    return {{p.x, p.y, p.z}, {n.x, n.y, n.z}, {t.x, t.y}};
}

/// A point of the plane z = 0 whose texture coordinates are `placed` of it.
Vertex flat(float x, float y, const glm::mat3& placed = glm::mat3(1.0f)) {
    return vertex({x, y, 0}, {0, 0, 1}, vec2(placed * vec3(x, y, 1)));
}

void expect_near(const vec4& a, const vec4& b, float tolerance = 1e-6f) {
    EXPECT_LE(glm::distance(vec3(a), vec3(b)), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
    EXPECT_EQ(a.w, b.w);
}

/// Two triangles and a quad beside them.
const std::vector<PatchCorners> strip{{0, 1, 2, no_corner}, {0, 2, 3, no_corner}, {1, 4, 5, 2}};

std::vector<Vertex> strip_vertices(const glm::mat3& placed = glm::mat3(1.0f)) {
    return {flat(0, 0, placed), flat(1, 0, placed), flat(1, 1, placed),
            flat(0, 1, placed), flat(2, 0, placed), flat(2, 1, placed)};
}

// In glTF v grows downwards in the picture: green points against it.
TEST(Mikktspace, OfAPlaneFollowsTheCoordinates) {
    const auto expect_all = [](const glm::mat3& placed, const vec4& expected, const glm::mat3& placement) {
        const auto tangents = corner_tangents(strip_vertices(placed), strip, placement);
        for (std::size_t f = 0; f < strip.size(); ++f) {
            for (std::size_t c = 0; c < (is_quad(strip[f]) ? 4u : 3u); ++c)
                expect_near(tangents[f][c], expected);
        }
    };
    const glm::mat3 same(1.0f);
    glm::mat3 down(1.0f), turned(0.0f), sheared(1.0f);
    down[1][1] = -1.0f;  // v grows towards -y: as pictures lie
    turned[1][0] = turned[2][2] = 1.0f;
    turned[0][1] = -1.0f;  // u grows with y, v with -x
    sheared[1][0] = 5.0f;
    sheared[0][0] = 3.0f;
    expect_all(same, {1, 0, 0, -1}, same);
    expect_all(down, {1, 0, 0, 1}, same);
    expect_all(turned, {0, 1, 0, -1}, same);
    expect_all(sheared, {1, 0, 0, -1}, same);
    expect_all(same, {0, 1, 0, -1}, turned);  // what the map does to them counts too
    expect_all(down, {-1, 0, 0, -1}, glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
}

// Over a mirror axis positions, normals and coordinates are the same, and yet tangents are not shared.
TEST(Mikktspace, MirroredTexturesStayApart) {
    const std::vector<Vertex> vertices{vertex({-1, 0, 0}, {0, 0, 1}, {1, 0}), vertex({0, 0, 0}, {0, 0, 1}, {0, 0}),
                                       vertex({0, 1, 0}, {0, 0, 1}, {0, 1}), vertex({1, 0, 0}, {0, 0, 1}, {1, 0})};
    const std::vector<PatchCorners> faces{{0, 1, 2, no_corner}, {1, 3, 2, no_corner}};
    const auto tangents = corner_tangents(vertices, faces);
    for (std::size_t c = 0; c < 3; ++c) {
        expect_near(tangents[0][c], {-1, 0, 0, 1});
        expect_near(tangents[1][c], {1, 0, 0, -1});
    }
}

/// A sphere of latitude and longitude, its first and last column at one place: triangles, or quads but for the poles.
struct Globe {
    std::vector<Vertex> vertices;
    std::vector<PatchCorners> faces;

    Globe(std::uint32_t columns, std::uint32_t rows, bool quads) {
        for (std::uint32_t r = 0; r <= rows; ++r) {
            for (std::uint32_t c = 0; c <= columns; ++c) {
                const double a = 2 * M_PI * (c % columns) / columns;
                const double b = M_PI * r / rows;
                const vec3 p(std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a));
                vertices.push_back(vertex(p, p, {float(c) / float(columns), float(r) / float(rows)}));
            }
        }
        const std::uint32_t step = columns + 1;
        for (std::uint32_t r = 0; r < rows; ++r) {
            for (std::uint32_t c = 0; c < columns; ++c) {
                const std::uint32_t at = r * step + c;
                if (quads && r > 0 && r + 1 < rows) {
                    faces.push_back({at, at + step, at + step + 1, at + 1});
                    continue;
                }
                if (r + 1 < rows) faces.push_back({at, at + step, at + step + 1, no_corner});
                if (r > 0) faces.push_back({at, at + step + 1, at + 1, no_corner});
            }
        }
    }
};

TEST(Mikktspace, OfASphereRunsAlongTheParallels) {
    for (const bool quads : {false, true}) {
        const Globe globe(48, 24, quads);
        const auto tangents = corner_tangents(globe.vertices, globe.faces);
        for (std::size_t f = 0; f < globe.faces.size(); ++f) {
            for (std::size_t c = 0; c < (is_quad(globe.faces[f]) ? 4u : 3u); ++c) {
                const Vertex& v = globe.vertices[globe.faces[f][c]];
                const vec3 p(v.position[0], v.position[1], v.position[2]);
                const vec3 t(tangents[f][c]);
                ASSERT_EQ(tangents[f][c].w, 1.0f);
                ASSERT_NEAR(glm::length(t), 1.0f, 1e-6f);
                ASSERT_NEAR(glm::dot(t, p), 0.0f, 1e-6f);
                if (std::fabs(p.y) > 0.98f) continue;  // the fans of the poles
                // At the seam one side alone counts, half a column off.
                const vec3 east = glm::normalize(vec3(p.z, 0, -p.x));
                ASSERT_LT(std::acos(std::min(1.0f, glm::dot(t, east))), 0.12f) << f << ' ' << c;
            }
        }
    }
}

TEST(Mikktspace, TheSeamOfASphereSplitsTangentsAndNothingElseDoes) {
    const Globe globe(16, 8, false);
    const auto tangents = corner_tangents(globe.vertices, globe.faces);
    std::vector<std::vector<vec4>> at(globe.vertices.size());
    for (std::size_t f = 0; f < globe.faces.size(); ++f) {
        for (std::size_t c = 0; c < 3; ++c)
            at[globe.faces[f][c]].push_back(tangents[f][c]);
    }
    for (const auto& of_vertex : at) {
        for (const vec4& t : of_vertex)
            EXPECT_EQ(t, of_vertex.front());
    }
    EXPECT_NE(at[3 * 17].front(), at[3 * 17 + 16].front());
}

TEST(Mikktspace, DoesNotDependOnTheOrderOfVerticesOrOnSplitsWithoutReason) {
    const Globe globe(12, 8, true);
    const auto expected = corner_tangents(globe.vertices, globe.faces);
    // Every corner gets a vertex of its own, in random order.
    std::vector<std::uint32_t> order(4 * globe.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, std::mt19937(5));
    std::vector<Vertex> vertices(order.size());
    std::vector<PatchCorners> faces = globe.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t c = 0; c < (is_quad(globe.faces[f]) ? 4u : 3u); ++c) {
            faces[f][c] = order[4 * f + c];
            vertices[faces[f][c]] = globe.vertices[globe.faces[f][c]];
        }
    }
    EXPECT_EQ(corner_tangents(vertices, faces), expected);
}

// A triangle without area in space takes what lies beside it; one without area in the texture goes along.
TEST(Mikktspace, DegenerateTrianglesTakeTheirNeighbours) {
    std::vector<Vertex> vertices = strip_vertices();
    vertices.push_back(vertices[1]);  // 6, in the place of 1
    std::vector<PatchCorners> faces{{0, 1, 2, no_corner}, {1, 6, 2, no_corner}};
    auto tangents = corner_tangents(vertices, faces);
    for (std::size_t c = 0; c < 3; ++c)
        expect_near(tangents[1][c], {1, 0, 0, -1});
    vertices[3].uv[0] = vertices[2].uv[0];  // the second triangle's texture is a line
    vertices[3].uv[1] = vertices[2].uv[1];
    faces = {{0, 1, 2, no_corner}, {0, 2, 3, no_corner}};
    tangents = corner_tangents(vertices, faces);
    expect_near(tangents[1][0], {1, 0, 0, -1});
    expect_near(tangents[1][1], {1, 0, 0, -1});
    expect_near(tangents[1][2], {1, 0, 0, 1});  // nothing says anything
    faces = {{1, 6, 4, 2}};                     // a quad with two corners in one place
    tangents = corner_tangents(vertices, faces);
    for (std::size_t c = 0; c < 4; ++c)
        expect_near(tangents[0][c], {1, 0, 0, -1});
}

// Half of the texture lies the other way round: all of the quad goes with the larger half.
TEST(Mikktspace, AQuadHasOneHandedness) {
    for (const bool larger_first : {false, true}) {
        const float first = larger_first ? 3.0f : 1.0f, second = larger_first ? 1.0f : 3.0f;
        // The diagonal from corner 0 to corner 2 is the shorter one in the texture.
        const std::vector<Vertex> vertices{
            vertex({0, 0, 0}, {0, 0, 1}, {0, 0}), vertex({1, 0, 0}, {0, 0, 1}, {first, -first}),
            vertex({1, 1, 0}, {0, 0, 1}, {0, 0.5f}), vertex({0, 1, 0}, {0, 0, 1}, {second, second})};
        const auto tangents = corner_tangents(vertices, std::vector<PatchCorners>{{0, 1, 2, 3}});
        for (const vec4& t : tangents[0])
            EXPECT_EQ(t.w, larger_first ? -1.0f : 1.0f);
    }
}

TEST(Mikktspace, HugeAndInfiniteCoordinatesGiveFiniteTangents) {
    for (const float huge : {1e30f, 3e38f, INFINITY, NAN, 1e-38f}) {
        std::vector<Vertex> vertices = strip_vertices();
        std::mt19937 random(7);
        for (Vertex& v : vertices) {
            for (float& x : v.position)
                x += static_cast<float>(random() % 1000) * 1e-3f;
        }
        vertices[2].uv[0] = huge;
        vertices[5].uv[1] = -huge;
        for (const auto& face : corner_tangents(vertices, strip)) {
            for (const vec4& t : face) {
                for (int i = 0; i < 4; ++i)
                    EXPECT_TRUE(std::isfinite(t[i])) << huge;
            }
        }
    }
}

TEST(Mikktspace, TakesAFanOfManyTriangles) {
    constexpr std::uint32_t count = 20000;
    std::vector<Vertex> vertices{flat(0, 0)};
    std::vector<PatchCorners> faces;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count;
        vertices.push_back(flat(float(std::cos(a)), float(std::sin(a))));
        faces.push_back({0, 1 + i, 1 + (i + 1) % count, no_corner});
    }
    expect_near(corner_tangents(vertices, faces)[0][0], {1, 0, 0, -1}, 1e-3f);
}

scene::Scene mapped_scene(bool normal_map) {
    scene::Scene scene;
    scene.source = "test";
    scene.materials.resize(1);
    if (normal_map) scene.materials[0].maps.normal = scene::Map{};
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.meshes.push_back(mesh);
    scene.meshes[1].triangles.clear();
    scene.meshes[1].quads = {0, 1, 2, 3};
    return scene;
}

TEST(CornerAttributes, AreThereWhereColoursOrNormalMapsAre) {
    EXPECT_TRUE(make_patches(mapped_scene(false)).corner_attributes.empty());
    const PatchSet mapped = make_patches(mapped_scene(true));
    EXPECT_FALSE(mapped.has_colors);
    ASSERT_EQ(mapped.corner_attributes.size(), 2u);
    for (std::size_t patch = 0; patch < 2; ++patch) {
        for (std::size_t c = 0; c < 3 + patch; ++c) {
            const VertexAttributes& a = mapped.corner_attributes[patch][c];
            EXPECT_EQ(a.color[2], 1.0f);
            EXPECT_EQ(a.tangent[0], 1.0f);
            EXPECT_EQ(a.tangent[3], -1.0f);
        }
    }
    scene::Scene coloured = mapped_scene(false);
    coloured.meshes[1].colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 1e-30f}, {0.25f, 0.25f, 0.25f, 1}};
    const PatchSet set = make_patches(coloured);
    EXPECT_TRUE(set.has_colors);
    ASSERT_EQ(set.corner_attributes.size(), 2u);
    EXPECT_EQ(set.corner_attributes[0][1].color[0], 1.0f);  // white
    EXPECT_EQ(set.corner_attributes[1][1].color[1], 1.0f);
    EXPECT_EQ(set.corner_attributes[1][1].color[3], 0.5f);
    EXPECT_EQ(set.corner_attributes[1][2].color[3], 0.0f);  // no denormal may arise
    EXPECT_EQ(set.corner_attributes[1][3].color[0], 0.25f);
    EXPECT_EQ(set.corner_attributes[1][3].tangent[3], 0.0f);
}

TEST(CornerAttributes, TakeTheTangentsOfTheFileWhereThereAreAny) {
    scene::Scene scene = mapped_scene(true);
    scene.meshes[1].tangents.assign(4, {0, 1, 0, 1});
    const PatchSet set = make_patches(scene);
    EXPECT_EQ(set.corner_attributes.at(0)[0].tangent[0], 1.0f);
    EXPECT_EQ(set.corner_attributes[1][2].tangent[1], 1.0f);
    EXPECT_EQ(set.corner_attributes[1][2].tangent[3], 1.0f);
    // Computed ones are for the coordinates of the map.
    scene.materials[0].maps.normal->transform[0][0] = -1.0f;
    const PatchSet mirrored = make_patches(scene);
    EXPECT_EQ(mirrored.corner_attributes.at(0)[0].tangent[0], -1.0f);
    EXPECT_EQ(mirrored.corner_attributes[0][0].tangent[3], 1.0f);
    EXPECT_EQ(mirrored.corner_attributes[1][2].tangent[1], 1.0f);
    // What no normal map needs costs nothing.
    scene.materials[0].maps.normal.reset();
    EXPECT_TRUE(make_patches(scene).corner_attributes.empty());
}

}  // namespace
}  // namespace tessera::patches
