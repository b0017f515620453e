// True normals: across the surface's derivatives, held against the triangles around each vertex of a fine tessellation.
#include "models.hpp"
#include "support/devices.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <cmath>

namespace tessera {
namespace {

using glm::dvec3;

dvec3 vector(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

// One patch, bent and twisted; three or four corners.
patches::PatchSet one_patch(bool quad) {
    patches::PatchSet set;
    const double corners[4][6] = {{0, 0, 0.1, -0.3, -0.2, 1},
                                  {1, 0.1, -0.2, 0.4, -0.1, 1},
                                  {1.2, 0.9, 0.4, 0.3, 0.5, 1},
                                  {-0.1, 1, 0, -0.2, 0.3, 1}};
    for (const auto& c : corners) {
        const dvec3 n = glm::normalize(dvec3{c[3], c[4], c[5]});
        set.control_vertices.push_back(
            {{float(c[0]), float(c[1]), float(c[2])}, {float(n.x), float(n.y), float(n.z)}, {0, 0}});
    }
    set.corners = {{0, 1, 2, quad ? 3 : patches::no_corner}};
    set.has_quads = quad;
    set.ranges.push_back({"patch", 0, 0, 1});
    return set;
}

RefinedMesh refine(const patches::PatchSet& set, Scheme scheme, float factor) {
    TessellationOptions options;
    options.scheme = scheme;
    options.normals = Normals::surface;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
    return tessellate(test::open_device("reference"), set, options);
}

TEST(TrueNormals, ArePerpendicularToTheSurface) {
    for (const bool quad : {false, true}) {
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn}) {
            SCOPED_TRACE(fmt::format("{} {}", name(scheme), quad ? "quad" : "triangle"));
            const RefinedMesh mesh = refine(one_patch(quad), scheme, 64);
            std::vector<dvec3> around(mesh.vertices.size(), dvec3(0.0));
            std::vector<int> triangles(mesh.vertices.size(), 0);
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const std::uint32_t* t = &mesh.indices[i];
                const dvec3 a = vector(mesh.vertices[t[0]].position);
                const dvec3 across =
                    glm::cross(vector(mesh.vertices[t[1]].position) - a, vector(mesh.vertices[t[2]].position) - a);
                for (int k = 0; k < 3; ++k) {
                    around[t[k]] += across;
                    ++triangles[t[k]];
                }
            }
            double worst = 0.0;
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                const dvec3 n = vector(mesh.vertices[i].normal);
                EXPECT_NEAR(glm::length(n), 1.0, 1e-6);
                if (triangles[i] < 5) continue;  // on the boundary the triangles lie on one side only
                worst = std::max(worst, std::acos(std::min(1.0, glm::dot(n, glm::normalize(around[i])))));
            }
            // The mean of the triangles around a vertex is off by the bend of a segment, 1/64 of the patch.
            EXPECT_LT(worst, 0.02) << "radians";
        }
    }
}

TEST(TrueNormals, AreSafeWhereTheSurfaceIsDegenerate) {
    for (const bool quad : {false, true}) {
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn}) {
            patches::PatchSet set = one_patch(quad);
            for (Vertex& vertex : set.control_vertices) {  // all corners in one place
                for (int k = 0; k < 3; ++k)
                    vertex.position[k] = 0.5f;
            }
            for (const Vertex& vertex : refine(set, scheme, 5).vertices) {
                EXPECT_NEAR(glm::length(vector(vertex.normal)), 1.0, 1e-6);
                EXPECT_GT(vertex.normal[2], 0.5f) << "the corners' own normals stand in";
            }
        }
    }
}

}  // namespace
}  // namespace tessera
