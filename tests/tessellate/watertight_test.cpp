// Watertightness, bit for bit: a closed model stays closed when only vertices of equal bits count as one.
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/tessellate.hpp"
#include "tessellate/welded.hpp"

#include <fmt/format.h>

#include <bit>

namespace tessera {
namespace {

using test::WeldBy;

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even, Partitioning::uniform};

// The positions and normals of neighbouring patches must both agree. Slivers of the fractional modes may collapse,
// after which an edge may come several times each way; where nothing collapsed every edge comes once.
void expect_closed(const patches::PatchSet& set, const TessellationOptions& options, const std::string& what) {
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    ASSERT_FALSE(mesh.indices.empty()) << what;
    const test::WeldedMesh welded = test::weld(mesh.vertices, mesh.indices, WeldBy::position_and_normal);
    EXPECT_EQ(test::find_crack(welded, welded.collapsed == 0), "") << what;
    EXPECT_LT(welded.collapsed, mesh.indices.size() / 3 / 10) << what;
}

void expect_watertight(const std::string& model, float greatest, bool every_variant) {
    SCOPED_TRACE(model);
    const patches::PatchSet set = test::load_patches(model);
    ASSERT_TRUE(test::closed_and_smooth(set));
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        for (const Normals normals : {Normals::linear, Normals::quadratic}) {
            for (const Partitioning partitioning : partitionings) {
                if (!every_variant && (scheme == Scheme::linear || normals == Normals::linear)) {
                    continue;
                }
                TessellationOptions options;
                options.scheme = scheme;
                options.normals = normals;
                options.partitioning = partitioning;
                const std::string what = fmt::format("{} {} {}", name(scheme), name(normals), name(partitioning));
                const float factor = 1.0f + greatest / 3.0f;
                options.factors = PatchFactors{factor, factor, factor, factor, 0, 0};
                expect_closed(set, options, what + " equal factors");
                // The even grid has one level per patch: neighbours with different factors do not match by design.
                if (partitioning != Partitioning::uniform) {
                    options.factors = random_edge_factors(set, 1.0f, greatest, 77);
                    expect_closed(set, options, what + " random factors");
                }
            }
        }
    }
}

class Watertight : public testing::TestWithParam<std::string> {};

TEST_P(Watertight, ClosedModelsStayClosed) {
    expect_watertight(GetParam(), 13.0f, true);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Watertight,
                         testing::Values("shape:icosahedron", "shape:cube", "shape:torus", "shape:sphere:3"),
                         [](const auto& info) {
                             std::string word = info.param.substr(6);
                             std::erase(word, ':');
                             return word;
                         });

TEST(Watertight, LargeFactors) {
    const patches::PatchSet set = test::load_patches("shape:icosahedron");
    for (const Partitioning partitioning :
         {Partitioning::integer, Partitioning::fractional_odd, Partitioning::fractional_even}) {
        TessellationOptions options;
        options.partitioning = partitioning;
        options.factors = random_edge_factors(set, 1.0f, 70.0f, 5);
        expect_closed(set, options, std::string(name(partitioning)));
    }
}

// The pawn has hard edges, where the schemes open cracks; with smooth normals it has none.
TEST(Watertight, SmoothNormalsCloseHardEdges) {
    const std::string pawn = std::string(TESSERA_SOURCE_DIR) + "/assets/pawn.glb";
    EXPECT_FALSE(test::closed_and_smooth(patches::make_patches(scene::load_scene(pawn))));
    const patches::PatchSet set = patches::make_patches(scene::load_scene(pawn, {.smooth_normals = true}));
    ASSERT_TRUE(test::closed_and_smooth(set));
    TessellationOptions options;
    options.factors = random_edge_factors(set, 1.0f, 9.0f, 8);
    expect_closed(set, options, "pawn");
}

TEST(Watertight, ModelsOfOthers) {
    TESSERA_SHARED_OR_SKIP(shared);
    std::size_t closed = 0;
    for (const char* file : {"Fox/Fox.glb", "RiggedFigure/RiggedFigure.glb", "SuzanneBlender/02_suzanne.gltf",
                             "Avocado/Avocado.gltf", "SimpleSparseAccessor/SimpleSparseAccessor.gltf"}) {
        const std::string model = (shared / "models" / file).string();
        if (test::closed_and_smooth(test::load_patches(model))) {
            expect_watertight(model, 5.0f, false);
            ++closed;
        } else {
            fmt::print("{} is open or has split normals: left out\n", file);
        }
    }
    EXPECT_GE(closed, 1u);
}

// Quads, and n-gons that became quads: every scheme, between random factors.
TEST(Watertight, ModelsOfQuads) {
    TESSERA_SHARED_OR_SKIP(shared);
    std::size_t closed = 0;
    for (const char* file : {"spot/spot_control_mesh.obj", "spot/spot_quadrangulated.obj",
                             "opensubdiv/catmark_rook.obj", "opensubdiv/catmark_car.obj",
                             "opensubdiv/catmark_nonquads.obj", "obj/max6_teapot.obj", "obj/blender_282_suzanne.obj"}) {
        const patches::PatchSet set =
            patches::make_patches(scene::load_scene((shared / "models" / file).string(), {.smooth_normals = true}));
        if (!test::closed_and_smooth(set)) {
            fmt::print("{} is open: left out\n", file);
            continue;
        }
        ++closed;
        fmt::print("{}: {} patches{}\n", file, set.patch_count(), set.has_quads ? ", some are quads" : "");
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
            TessellationOptions options;
            options.scheme = scheme;
            options.factors = random_edge_factors(set, 1.0f, 7.0f, 21);
            expect_closed(set, options, fmt::format("{} {}", file, name(scheme)));
        }
    }
    EXPECT_GE(closed, 2u);
}

TEST(Watertight, OwnAssets) {
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(TESSERA_SOURCE_DIR) / "assets")) {
        if (entry.path().extension() != ".glb") {
            continue;
        }
        ++files;
        if (test::closed_and_smooth(test::load_patches(entry.path().string()))) {
            expect_watertight(entry.path().string(), 5.0f, false);
        } else {
            fmt::print("{} is open or has split normals: left out\n", entry.path().filename().string());
        }
    }
    if (files == 0) {
        GTEST_SKIP() << "there are no assets";
    }
}

// 374,784 patches: one job.
TEST(Watertight, ALargeModel) {
    TESSERA_SHARED_OR_SKIP(shared);
    const patches::PatchSet set = test::load_patches((shared / "models/HugeSpot/spot_cc5.glb").string());
    ASSERT_TRUE(test::closed_and_smooth(set));
    TessellationOptions options;
    options.factors = random_edge_factors(set, 1.0f, 2.0f, 5);
    expect_closed(set, options, "pn");
}

// The search itself finds what it is there for.
TEST(Watertight, ASpoiltBitIsFound) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    TessellationOptions options;
    RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    EXPECT_EQ(test::find_crack(test::weld(mesh.vertices, mesh.indices, WeldBy::position), true), "");
    float& x = mesh.vertices[0].position[0];
    x = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) ^ 1u);
    EXPECT_NE(test::find_crack(test::weld(mesh.vertices, mesh.indices, WeldBy::position), false), "");
}

TEST(Watertight, FactorsThatDoNotAgreeAreFound) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    TessellationOptions options;
    std::vector<PatchFactors> factors = random_edge_factors(set, 3.0f, 9.0f, 5);
    factors[10][1] += 0.5f;
    options.factors = factors;
    const RefinedMesh mesh = tessellate(test::open_device("reference"), set, options);
    EXPECT_NE(test::find_crack(test::weld(mesh.vertices, mesh.indices, WeldBy::position), false), "");
}

}  // namespace
}  // namespace tessera
