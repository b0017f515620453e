// Tangent frames against derivatives in double precision, taken as differences of the surface that the papers define;
// handedness, degenerate patches and texture coordinates; devices and batches.
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/tessellate.hpp"
#include "verify/compare_jobs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace tessera {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::array schemes{Scheme::linear, Scheme::phong, Scheme::pn};

dvec3 vector(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

using Uvs = std::array<dvec2, 4>;
constexpr Uvs plain{dvec2{0.1, 0.2}, dvec2{0.9, 0.1}, dvec2{0.8, 0.95}, dvec2{0.15, 0.7}};

// One patch, bent and twisted; three or four corners.
patches::PatchSet one_patch(bool quad, const Uvs& uvs = plain) {
    patches::PatchSet set;
    const double corners[4][6] = {{0, 0, 0.1, -0.3, -0.2, 1},
                                  {1, 0.1, -0.2, 0.4, -0.1, 1},
                                  {1.2, 0.9, 0.4, 0.3, 0.5, 1},
                                  {-0.1, 1, 0, -0.2, 0.3, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& c = corners[i];
        const dvec3 n = glm::normalize(dvec3{c[3], c[4], c[5]});
        set.control_vertices.push_back({{float(c[0]), float(c[1]), float(c[2])},
                                        {float(n.x), float(n.y), float(n.z)},
                                        {float(uvs[i].x), float(uvs[i].y)}});
    }
    set.corners = {{0, 1, 2, quad ? 3 : patches::no_corner}};
    set.has_quads = quad;
    set.ranges.push_back({"patch", 0, 0, 1});
    return set;
}

TessellationOptions options_for(Scheme scheme, Tangents tangents, float factor = 7) {
    TessellationOptions options;
    options.scheme = scheme;
    options.tangents = tangents;
    options.alpha = 0.6f;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{factor, factor, factor, factor, factor, factor};
    return options;
}

RefinedMesh refine(const patches::PatchSet& set, const TessellationOptions& options) {
    return tessellate(test::open_device("reference"), set, options);
}

std::vector<DomainPoint> domain_points(bool quad, const TessellationOptions& options) {
    const auto factors = std::get<PatchFactors>(options.factors);
    return make_patterns(test::open_device("reference"), quad ? Domain::quad : Domain::triangle, options.partitioning,
                         true, std::vector<PatchFactors>{factors})
        .front()
        .points;
}

// The surfaces of the papers in double precision, at any point of the plane.
struct Exact {
    std::array<dvec3, 4> p, n;
    Uvs uv{};
    bool quad = false;
    Scheme scheme{};
    double alpha = 0.0;

    Exact(const patches::PatchSet& set, const TessellationOptions& options)
        : quad(set.has_quads), scheme(options.scheme), alpha(options.alpha) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vertex& v = set.control_vertices[i];
            p[i] = vector(v.position);
            n[i] = vector(v.normal);
            uv[i] = {v.uv[0], v.uv[1]};
        }
    }

    // Triangles have their corners 0, 1, 2 at u, v, w = 1.
    std::array<double, 4> weights(double u, double v) const {
        if (quad) return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
        return {u, v, 1 - u - v, 0};
    }

    dvec2 texture(double u, double v) const {
        dvec2 sum(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            sum += weights(u, v)[i] * uv[i];
        return sum;
    }

    // The Bezier point of PN triangles next to a, towards b.
    dvec3 next_to(std::size_t a, std::size_t b) const {
        return (2.0 * p[a] + p[b] - glm::dot(p[b] - p[a], n[a]) * n[a]) / 3.0;
    }

    dvec3 edge(std::size_t a, std::size_t b, double t) const {
        const double s = 1 - t;
        return s * s * s * p[a] + 3 * s * s * t * next_to(a, b) + 3 * s * t * t * next_to(b, a) + t * t * t * p[b];
    }

    dvec3 pn(double u, double v) const {
        if (quad) {
            const auto w = weights(u, v);
            const dvec3 corners = w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] * p[3];
            return (1 - v) * edge(0, 1, u) + v * edge(3, 2, u) + (1 - u) * edge(0, 3, v) + u * edge(1, 2, v) - corners;
        }
        const double c[] = {u, v, 1 - u - v};
        dvec3 sum(0.0);
        dvec3 mean(0.0);
        for (std::size_t a = 0; a < 3; ++a) {
            sum += c[a] * c[a] * c[a] * p[a];
            for (const std::size_t b : {(a + 1) % 3, (a + 2) % 3}) {
                sum += 3 * c[a] * c[a] * c[b] * next_to(a, b);
                mean += next_to(a, b) / 6.0;
            }
        }
        return sum + 6 * c[0] * c[1] * c[2] * (mean + (mean - (p[0] + p[1] + p[2]) / 3.0) / 2.0);
    }

    dvec3 position(double u, double v) const {
        if (scheme == Scheme::pn) return pn(u, v);
        const auto w = weights(u, v);
        dvec3 flat(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            flat += w[i] * p[i];
        dvec3 bent(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            bent += w[i] * (flat - glm::dot(flat - p[i], n[i]) * n[i]);
        return scheme == Scheme::linear ? flat : (1 - alpha) * flat + alpha * bent;
    }

    template <typename Function>
    static auto slope(Function f, double u, double v, double du, double dv) {
        constexpr double h = 1e-4;
        return (f(u + h * du, v + h * dv) - f(u - h * du, v - h * dv)) / (2 * h);
    }
    dvec3 by(double u, double v, double du, double dv) const {
        return slope([this](double a, double b) { return position(a, b); }, u, v, du, dv);
    }
    dvec2 texture_by(double u, double v, double du, double dv) const {
        return slope([this](double a, double b) { return texture(a, b); }, u, v, du, dv);
    }
};

void expect_frame(const Tangent& found, const dvec3& tangent, const dvec3& bitangent, double tolerance) {
    EXPECT_LT(glm::length(vector(found.tangent) - glm::normalize(tangent)), tolerance);
    EXPECT_LT(glm::length(vector(found.bitangent) - glm::normalize(bitangent)), tolerance);
    EXPECT_EQ(found.unused, 0.0f);
}

// Unit, handed as the bitangent says, nothing that could be a denormal, no negative zero.
void expect_sound(const RefinedMesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        const Tangent& t = mesh.tangents[i];
        ASSERT_NEAR(glm::length(vector(t.tangent)), 1.0, 1e-6);
        ASSERT_NEAR(glm::length(vector(t.bitangent)), 1.0, 1e-6);
        const double volume =
            glm::dot(glm::cross(vector(mesh.vertices[i].normal), vector(t.tangent)), vector(t.bitangent));
        ASSERT_EQ(std::abs(t.handedness), 1.0f);
        if (std::abs(volume) > 1e-6) {
            ASSERT_EQ(t.handedness, volume < 0 ? -1.0f : 1.0f);
        }
        for (const auto* v : {&t.tangent, &t.bitangent}) {
            for (const float x : *v) {
                ASSERT_TRUE((x == 0.0f && !std::signbit(x)) || std::abs(x) >= 0x1p-40f) << x;
            }
        }
    }
}

template <typename Body>
void for_every_patch(Body&& body) {
    for (const bool quad : {false, true}) {
        for (const Scheme scheme : schemes) {
            SCOPED_TRACE(fmt::format("{} {}", name(scheme), quad ? "quad" : "triangle"));
            body(quad, scheme);
        }
    }
}

TEST(Tangents, OfTheSurfaceAreItsDerivatives) {
    for_every_patch([](bool quad, Scheme scheme) {
        const patches::PatchSet set = one_patch(quad);
        const TessellationOptions options = options_for(scheme, Tangents::surface);
        const Exact exact(set, options);
        const RefinedMesh mesh = refine(set, options);
        expect_sound(mesh);
        const auto points = domain_points(quad, options);
        ASSERT_EQ(points.size(), mesh.tangents.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double u = points[i].u / 65536.0;
            const double v = points[i].v / 65536.0;
            ASSERT_LT(glm::length(exact.position(u, v) - vector(mesh.vertices[i].position)), 2e-6);
            expect_frame(mesh.tangents[i], exact.by(u, v, 1, 0), exact.by(u, v, 0, 1), 5e-6);
            EXPECT_EQ(mesh.tangents[i].handedness, 1.0f);
        }
    });
}

// The direction of the domain along which one texture coordinate grows and the other stays, solved for; on the surface
// it is the derivative along that direction.
void expect_texture_frames(const Uvs& uvs, float handedness) {
    for_every_patch([&](bool quad, Scheme scheme) {
        const patches::PatchSet set = one_patch(quad, uvs);
        for (const Normals normals : {Normals::linear, Normals::quadratic, Normals::surface}) {
            TessellationOptions options = options_for(scheme, Tangents::uv);
            options.normals = normals;
            const Exact exact(set, options);
            const RefinedMesh mesh = refine(set, options);
            expect_sound(mesh);
            const auto points = domain_points(quad, options);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double u = points[i].u / 65536.0;
                const double v = points[i].v / 65536.0;
                // Columns: how s and t grow along the domain's u, then v.
                const glm::dmat2 growth(exact.texture_by(u, v, 1, 0), exact.texture_by(u, v, 0, 1));
                const dvec2 along_s = glm::inverse(growth) * dvec2{1, 0};
                const dvec2 along_t = glm::inverse(growth) * dvec2{0, 1};
                expect_frame(mesh.tangents[i], exact.by(u, v, along_s.x, along_s.y),
                             exact.by(u, v, along_t.x, along_t.y), 5e-6);
                EXPECT_EQ(mesh.tangents[i].handedness, handedness);
            }
        }
    });
}

TEST(Tangents, OfTextureCoordinatesFollowThem) {
    expect_texture_frames(plain, 1.0f);
}

TEST(Tangents, OfMirroredTextureCoordinatesAreLeftHanded) {
    Uvs mirrored = plain;
    for (dvec2& uv : mirrored)
        uv.x = 1.0 - uv.x;
    expect_texture_frames(mirrored, -1.0f);
}

TEST(Tangents, OfHugeAndTinyTextureCoordinatesAreThoseOfPlainOnes) {
    for_every_patch([](bool quad, Scheme scheme) {
        const TessellationOptions options = options_for(scheme, Tangents::uv);
        const RefinedMesh expected = refine(one_patch(quad), options);
        for (const double size : {0x1p-40, 0x1p127}) {
            Uvs uvs = plain;
            for (dvec2& uv : uvs)
                uv *= size;
            const RefinedMesh found = refine(one_patch(quad, uvs), options);
            expect_sound(found);
            for (std::size_t i = 0; i < found.tangents.size(); ++i) {
                expect_frame(found.tangents[i], vector(expected.tangents[i].tangent),
                             vector(expected.tangents[i].bitangent), 1e-6);
            }
        }
    });
}

TEST(Tangents, OfDegenerateTextureCoordinatesAreTheSurface) {
    const Uvs one_place{dvec2{0.3, 0.4}, dvec2{0.3, 0.4}, dvec2{0.3, 0.4}, dvec2{0.3, 0.4}};
    const Uvs one_line{dvec2{0.1, 0.1}, dvec2{0.3, 0.3}, dvec2{0.7, 0.7}, dvec2{0.2, 0.2}};
    const Uvs no_t{dvec2{0.1, 0.5}, dvec2{0.3, 0.5}, dvec2{0.7, 0.5}, dvec2{0.2, 0.5}};
    // On a line too, but for the rounding of floats.
    const Uvs rounded{dvec2{0.1, 0.3}, dvec2{0.23, 0.69}, dvec2{0.7, 2.1}, dvec2{0.41, 1.23}};
    for_every_patch([&](bool quad, Scheme scheme) {
        const RefinedMesh expected = refine(one_patch(quad), options_for(scheme, Tangents::surface));
        for (const Uvs& uvs : {one_place, one_line, no_t, rounded}) {
            const RefinedMesh found = refine(one_patch(quad, uvs), options_for(scheme, Tangents::uv));
            ASSERT_EQ(found.tangents.size(), expected.tangents.size());
            EXPECT_EQ(
                std::memcmp(found.tangents.data(), expected.tangents.data(), found.tangents.size() * sizeof(Tangent)),
                0);
        }
    });
}

TEST(Tangents, AreFramesWhereTheSurfaceIsDegenerate) {
    for_every_patch([](bool quad, Scheme scheme) {
        for (const Tangents tangents : {Tangents::surface, Tangents::uv}) {
            for (const bool line : {false, true}) {
                patches::PatchSet set = one_patch(quad);
                for (std::size_t i = 0; i < 4; ++i) {  // all corners in one place, or on one line
                    for (float& x : set.control_vertices[i].position)
                        x = line ? 0.25f * float(i) : 0.5f;
                }
                const RefinedMesh mesh = refine(set, options_for(scheme, tangents));
                expect_sound(mesh);
                for (std::size_t i = 0; i < mesh.tangents.size() && !line; ++i) {
                    const dvec3 n = vector(mesh.vertices[i].normal);
                    EXPECT_NEAR(glm::dot(n, vector(mesh.tangents[i].tangent)), 0.0, 1e-6);
                    EXPECT_NEAR(glm::dot(n, vector(mesh.tangents[i].bitangent)), 0.0, 1e-6);
                    EXPECT_EQ(mesh.tangents[i].handedness, 1.0f);
                }
            }
        }
    });
}

TEST(Tangents, OfMirroredTexturesStayLeftHandedWhereADerivativeVanishes) {
    Uvs mirrored = plain;
    for (dvec2& uv : mirrored)
        uv.x = 1.0 - uv.x;
    patches::PatchSet set = one_patch(true, mirrored);
    std::ranges::copy(set.control_vertices[0].position, set.control_vertices[1].position);  // no growth along v = 0
    const RefinedMesh mesh = refine(set, options_for(Scheme::linear, Tangents::uv));
    expect_sound(mesh);
    for (const Tangent& t : mesh.tangents)
        EXPECT_EQ(t.handedness, -1.0f);
}

// A triangle and a quad whose offsets are odd, culled patches among them.
class TangentsOn : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(TangentsOn, AreTheSameBits) {
    const std::vector<gpu::Device> devices{test::open_device("reference"), test::open_device(GetParam().id)};
    for (const bool quad : {false, true}) {
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
            for (const Tangents tangents : {Tangents::surface, Tangents::uv}) {
                SCOPED_TRACE(fmt::format("{} {} {}", name(scheme), name(tangents), quad ? "quads" : "triangles"));
                patches::PatchSet set = one_patch(quad);
                set.corners.resize(40, set.corners[0]);
                for (std::size_t i = 0; i < 4; ++i) {  // another one, flat and turned over
                    set.control_vertices.push_back(set.control_vertices[3 - i]);
                    set.control_vertices.back().position[2] = 0.0f;
                }
                for (std::size_t i = 0; i < set.corners.size(); i += 3) {
                    for (std::size_t k = 0; k < (quad ? 4u : 3u); ++k)
                        set.corners[i][k] += 4;
                }
                set.ranges[0].patch_count = set.corners.size();
                TessellationOptions options = options_for(scheme, tangents);
                options.normals = scheme == Scheme::phong ? Normals::surface : Normals::quadratic;
                options.partitioning = Partitioning::fractional_even;
                options.factors = random_edge_factors(set, 0.5f, 9.0f, 7);
                auto& factors = std::get<std::vector<PatchFactors>>(options.factors);
                for (std::size_t i = 0; i < factors.size(); i += 7)
                    factors[i][0] = 0.0f;
                factors.back()[0] = 0.0f;  // nothing lies behind the last vertex
                for (const verify::DeviceComparison& result : verify::compare_jobs(devices, set, options)) {
                    EXPECT_TRUE(result.equal()) << result.device.id;
                    EXPECT_GT(result.stages[static_cast<std::size_t>(StageId::tangents)].words, 1000u);
                }
            }
        }
    }
}

TESSERA_ON_EVERY_DEVICE(TangentsOn);

TEST(Tangents, AreUnchangedByBatchesAndKeepTheBudget) {
    const patches::PatchSet set = test::load_patches("shape:sphere:10");
    TessellationOptions options = options_for(Scheme::pn, Tangents::uv);
    options.factors = random_edge_factors(set, 0.5f, 24.0f, 3);
    const RefinedMesh whole = refine(set, options);
    expect_sound(whole);
    options.memory_budget = 700'000;
    Tessellator tessellator(test::open_device("reference"), set, options);
    RefinedMesh pieces;
    tessellator.run(pieces);
    EXPECT_LE(tessellator.device_bytes(), options.memory_budget);
    ASSERT_EQ(whole.tangents.size(), pieces.tangents.size());
    EXPECT_EQ(std::memcmp(whole.tangents.data(), pieces.tangents.data(), whole.tangents.size() * sizeof(Tangent)), 0);
    // And they change nothing else.
    options.tangents = Tangents::none;
    const RefinedMesh without = refine(set, options);
    EXPECT_TRUE(without.tangents.empty());
    EXPECT_EQ(without.indices, whole.indices);
    EXPECT_EQ(std::memcmp(without.vertices.data(), whole.vertices.data(), whole.vertices.size() * sizeof(Vertex)), 0);
}

TEST(Tangents, HaveNames) {
    for (const Tangents t : {Tangents::none, Tangents::surface, Tangents::uv})
        EXPECT_EQ(tangents_from_name(name(t)), t);
}

}  // namespace
}  // namespace tessera
