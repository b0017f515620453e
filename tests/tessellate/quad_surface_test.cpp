// Quad patches: alone, beside triangles in one mesh, and against the papers' formulas in double precision.
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/tessellate.hpp"
#include "tessellate/welded.hpp"
#include "verify/compare_jobs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <numbers>

namespace tessera {
namespace {

using glm::dvec3;

// A closed torus of quads; where `mixed`, every third one is cut into two triangles.
patches::PatchSet quad_torus(bool mixed) {
    constexpr std::uint32_t around = 9;
    constexpr std::uint32_t along = 6;
    patches::PatchSet set;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < along; ++k) {
            const double a = 2.0 * std::numbers::pi * i / around;
            const double b = 2.0 * std::numbers::pi * k / along;
            const dvec3 n{std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a)};
            const dvec3 p = dvec3{std::cos(a), 0, std::sin(a)} + 0.4 * n;
            set.control_vertices.push_back(
                {{float(p.x), float(p.y), float(p.z)}, {float(n.x), float(n.y), float(n.z)}, {float(i), float(k)}});
        }
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < along; ++k) {
            const auto at = [&](std::uint32_t x, std::uint32_t y) { return x % around * along + y % along; };
            const std::uint32_t a = at(i, k);
            const std::uint32_t b = at(i, k + 1);
            const std::uint32_t c = at(i + 1, k + 1);
            const std::uint32_t d = at(i + 1, k);
            if (mixed && (i + k) % 3 == 0) {
                set.corners.push_back({a, b, c, patches::no_corner});
                set.corners.push_back({a, c, d, patches::no_corner});
            } else {
                set.corners.push_back({a, b, c, d});
            }
        }
    }
    set.has_quads = true;
    set.ranges.push_back({"torus", 0, 0, set.patch_count()});
    return set;
}

template <typename Body>
void for_every_variant(Body&& body) {
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        for (const Normals normals : {Normals::linear, Normals::quadratic, Normals::surface}) {
            for (const Partitioning partitioning : {Partitioning::integer, Partitioning::fractional_odd,
                                                    Partitioning::fractional_even, Partitioning::uniform}) {
                TessellationOptions options;
                options.scheme = scheme;
                options.normals = normals;
                options.partitioning = partitioning;
                SCOPED_TRACE(fmt::format("{} {} {}", name(scheme), name(normals), name(partitioning)));
                body(options);
            }
        }
    }
}

TEST(QuadSurface, MixedMeshesAreWatertight) {
    for (const bool mixed : {false, true}) {
        const patches::PatchSet set = quad_torus(mixed);
        ASSERT_TRUE(test::closed_and_smooth(set));
        for_every_variant([&](TessellationOptions& options) {
            options.factors = PatchFactors{5, 5, 5, 5, 5, 5};
            if (options.partitioning != Partitioning::uniform) {
                options.factors = random_edge_factors(set, 1.0f, 9.0f, 3);
            }
            const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
            // Only the surfaces meet in their true normals where they are smooth.
            const auto by =
                options.normals == Normals::surface ? test::WeldBy::position : test::WeldBy::position_and_normal;
            const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, by);
            EXPECT_EQ(test::find_crack(welded, welded.collapsed == 0), "");
        });
    }
}

TEST(QuadSurface, EveryDeviceGivesTheSameBits) {
    const patches::PatchSet set = quad_torus(true);
    const std::vector<gpu::Device> devices = test::open_every_device();
    for_every_variant([&](TessellationOptions& options) {
        options.factors = random_edge_factors(set, 0.5f, 7.0f, 11);
        for (const verify::DeviceComparison& result : verify::compare_jobs(devices, set, options)) {
            EXPECT_TRUE(result.equal()) << result.device.id;
        }
    });
}

TEST(QuadSurface, BatchesDoNotChangeMixedMeshes) {
    const patches::PatchSet set = quad_torus(true);
    TessellationOptions options;
    options.partitioning = Partitioning::integer;
    options.factors = random_edge_factors(set, 20.0f, 60.0f, 4);
    const RefinedMesh whole = tessellate(test::open_device("reference"), set, options);
    options.memory_budget = 700'000;
    const RefinedMesh pieces = tessellate(test::open_device("reference"), set, options);
    ASSERT_EQ(whole.vertices.size(), pieces.vertices.size());
    EXPECT_EQ(whole.indices, pieces.indices);
    EXPECT_EQ(std::memcmp(whole.vertices.data(), pieces.vertices.data(), whole.vertices.size() * sizeof(Vertex)), 0);
}

// One quad with random corners; its output beside the domain points it was made at.
struct OneQuad {
    std::array<dvec3, 4> p, n;
    std::vector<Vertex> vertices;
    std::vector<DomainPoint> points;
};

OneQuad evaluate(const std::array<dvec3, 4>& p, const std::array<dvec3, 4>& n, Scheme scheme) {
    patches::PatchSet set;
    OneQuad quad;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 normal = glm::normalize(n[i]);
        set.control_vertices.push_back({{float(p[i].x), float(p[i].y), float(p[i].z)},
                                        {float(normal.x), float(normal.y), float(normal.z)},
                                        {float(i), 1.0f}});
        const Vertex& v = set.control_vertices.back();
        quad.p[i] = {v.position[0], v.position[1], v.position[2]};
        quad.n[i] = {v.normal[0], v.normal[1], v.normal[2]};
    }
    set.corners = {{0, 1, 2, 3}};
    set.has_quads = true;
    set.ranges.push_back({"quad", 0, 0, 1});
    TessellationOptions options;
    options.scheme = scheme;
    options.alpha = 1.0f;
    const PatchFactors factors{3, 4, 5, 6.5f, 5, 4};
    options.factors = factors;
    quad.vertices = tessellate(test::open_device("reference"), set, options).vertices;
    quad.points = make_patterns(test::open_device("reference"), Domain::quad, options.partitioning, true,
                                std::vector<PatchFactors>{factors})
                      .front()
                      .points;
    return quad;
}

const std::array<dvec3, 4> bent{dvec3{0, 0, 0.1}, dvec3{1, 0.1, -0.2}, dvec3{1.2, 0.9, 0.4}, dvec3{-0.1, 1, 0}};
const std::array<dvec3, 4> leaning{dvec3{-0.3, -0.2, 1}, dvec3{0.4, -0.1, 1}, dvec3{0.3, 0.5, 1}, dvec3{-0.2, 0.3, 1}};

TEST(QuadSurface, PhongIsTheProjectionOfTheBilinearPoint) {
    const OneQuad quad = evaluate(bent, leaning, Scheme::phong);
    ASSERT_EQ(quad.points.size(), quad.vertices.size());
    for (std::size_t i = 0; i < quad.points.size(); ++i) {
        const double u = quad.points[i].u / 65536.0;
        const double v = quad.points[i].v / 65536.0;
        const double weights[] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
        dvec3 q(0.0);
        for (std::size_t k = 0; k < 4; ++k)
            q += weights[k] * quad.p[k];
        dvec3 expected(0.0);
        for (std::size_t k = 0; k < 4; ++k) {
            expected += weights[k] * (q - glm::dot(q - quad.p[k], quad.n[k]) * quad.n[k]);
        }
        const float* found = quad.vertices[i].position;
        EXPECT_LT(glm::length(expected - dvec3{found[0], found[1], found[2]}), 1e-6) << "u " << u << " v " << v;
    }
}

// The edge from corner a to corner b as the cubic of PN triangles.
dvec3 pn_edge(const OneQuad& quad, std::size_t a, std::size_t b, double t) {
    const dvec3 d = quad.p[b] - quad.p[a];
    const dvec3 near_a = quad.p[a] + (d - glm::dot(d, quad.n[a]) * quad.n[a]) / 3.0;
    const dvec3 near_b = quad.p[b] + (-d - glm::dot(-d, quad.n[b]) * quad.n[b]) / 3.0;
    const double s = 1 - t;
    return s * s * s * quad.p[a] + 3 * s * s * t * near_a + 3 * s * t * t * near_b + t * t * t * quad.p[b];
}

TEST(QuadSurface, PnIsTheCoonsPatchOfItsEdges) {
    const OneQuad quad = evaluate(bent, leaning, Scheme::pn);
    for (std::size_t i = 0; i < quad.points.size(); ++i) {
        const double u = quad.points[i].u / 65536.0;
        const double v = quad.points[i].v / 65536.0;
        const dvec3 ruled_u = (1 - v) * pn_edge(quad, 0, 1, u) + v * pn_edge(quad, 3, 2, u);
        const dvec3 ruled_v = (1 - u) * pn_edge(quad, 0, 3, v) + u * pn_edge(quad, 1, 2, v);
        const dvec3 corners =
            (1 - v) * ((1 - u) * quad.p[0] + u * quad.p[1]) + v * ((1 - u) * quad.p[3] + u * quad.p[2]);
        const dvec3 expected = ruled_u + ruled_v - corners;
        const float* found = quad.vertices[i].position;
        EXPECT_LT(glm::length(expected - dvec3{found[0], found[1], found[2]}), 2e-6) << "u " << u << " v " << v;
        EXPECT_NEAR(std::hypot(quad.vertices[i].normal[0], quad.vertices[i].normal[1], quad.vertices[i].normal[2]), 1.0,
                    1e-6);
    }
}

TEST(QuadSurface, CornersAreKeptExactly) {
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        const OneQuad quad = evaluate(bent, leaning, scheme);
        std::size_t corners = 0;
        for (std::size_t i = 0; i < quad.points.size(); ++i) {
            const bool u_end = quad.points[i].u == 0 || quad.points[i].u == 65536;
            const bool v_end = quad.points[i].v == 0 || quad.points[i].v == 65536;
            if (!u_end || !v_end) continue;
            const std::size_t corner =
                quad.points[i].v == 0 ? (quad.points[i].u == 0 ? 0 : 1) : (quad.points[i].u == 0 ? 3 : 2);
            const float* found = quad.vertices[i].position;
            EXPECT_EQ((dvec3{found[0], found[1], found[2]}), quad.p[corner]);
            EXPECT_EQ(quad.vertices[i].uv[0], float(corner));
            ++corners;
        }
        EXPECT_EQ(corners, 4u);
    }
}

}  // namespace
}  // namespace tessera
