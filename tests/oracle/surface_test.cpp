// Surfaces of the kernels against shaders written from the papers alone.
#include "base/error.hpp"
#include "oracle/factor_sets.hpp"
#include "oracle/oracle_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tessera::test {
namespace {

using SurfaceOracle = OracleSuite;

/// Triangles with corners in [-2, 2] and unit normals within about 80 degrees of one another, as after make_patches().
patches::PatchSet random_patches(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> side(-1.0f, 1.0f);
    patches::PatchSet set;
    for (std::size_t i = 0; i < 3 * count; ++i) {
        Vertex vertex{{2 * side(random), 2 * side(random), 2 * side(random)}, {}, {}};
        const float x = side(random), y = side(random);
        const float size = std::sqrt(x * x + y * y + 1.0f);
        vertex.normal[0] = x / size;
        vertex.normal[1] = y / size;
        vertex.normal[2] = 1.0f / size;
        set.control_vertices.push_back(vertex);
        if (const auto last = static_cast<std::uint32_t>(i); last % 3 == 2) {
            set.corners.push_back({last - 2, last - 1, last, patches::no_corner});
        }
    }
    set.ranges.push_back({"random", 0, 0, count});
    return set;
}

void expect_equal(const verify::SurfaceComparison& result, const TessellationOptions& options) {
    EXPECT_EQ(result.differing, 0u) << result.first.value_or("");
    EXPECT_GT(result.vertices, 1000u);
    fmt::print("{}, {} normals, {}: {} vertices, error of position {:.3g}, of normal {:.3g}\n", name(options.scheme),
               name(options.normals), name(options.partitioning), result.vertices, result.position_error,
               result.normal_error);
}

TEST_F(SurfaceOracle, AgreesOnRandomPatches) {
    const std::size_t count = std::max<std::size_t>(random_set_count() / 2, 1);
    const patches::PatchSet patches = random_patches(count, 7);
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn}) {
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            for (const auto partitioning :
                 {Partitioning::integer, Partitioning::fractional_odd, Partitioning::fractional_even}) {
                TessellationOptions options;
                options.scheme = scheme;
                options.normals = normals;
                options.partitioning = partitioning;
                options.factors = random_factor_sets(count, 11);
                options.alpha = 0.6f;
                expect_equal(verify::compare_surface(stage(), open_device("reference"), patches, options), options);
            }
        }
    }
}

TEST_F(SurfaceOracle, TakesOneSetOfFactorsForAllPatches) {
    TessellationOptions options;
    options.factors = PatchFactors{3, 4, 5, 6, 0, 0};
    const auto result = verify::compare_surface(stage(), open_device("reference"), random_patches(70, 3), options);
    EXPECT_EQ(result.patches, 70u);
    expect_equal(result, options);
}

TEST_F(SurfaceOracle, RefusesTrueNormals) {
    TessellationOptions options;
    options.normals = Normals::surface;
    EXPECT_THROW(verify::compare_surface(stage(), open_device("reference"), random_patches(3, 3), options), Error);
}

TEST_F(SurfaceOracle, RefusesAnotherNumberOfFactors) {
    TessellationOptions options;
    options.factors = std::vector<PatchFactors>(2);
    EXPECT_THROW(verify::compare_surface(stage(), open_device("reference"), random_patches(3, 3), options), Error);
}

// What the stage cannot do is said before anything is drawn.
TEST_F(SurfaceOracle, RefusesPartitioningsWithoutSpacing) {
    for (const Partitioning partitioning : {Partitioning::pow2, Partitioning::uniform}) {
        TessellationOptions options;
        options.partitioning = partitioning;
        try {
            verify::compare_surface(stage(), open_device("reference"), random_patches(1, 3), options);
            ADD_FAILURE() << name(partitioning) << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_NE(std::string(error.what()).find(name(partitioning)), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace tessera::test
