// Every loadable model, every scheme and every partitioning gives the same bits on every device of this machine.
#include "tessellate/models.hpp"
#include "scene/scene.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"
#include "support/manifest.hpp"
#include "tessellate/edge_factors.hpp"
#include "verify/compare_jobs.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera {
namespace {

constexpr Partitioning partitionings[] = {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd,
                                          Partitioning::fractional_even, Partitioning::uniform};

void expect_equal(const patches::PatchSet& set, const TessellationOptions& options) {
    const auto results = verify::compare_jobs(test::open_every_device(), set, options);
    for (const verify::DeviceComparison& result : results) {
        for (std::size_t s = 0; s < stage_count; ++s) {
            const verify::StageComparison& stage = result.stages[s];
            const auto id = static_cast<StageId>(s);
            const bool made = id == StageId::tangents     ? options.tangents != Tangents::none
                              : id == StageId::attributes ? !set.corner_attributes.empty()
                                                          : true;
            EXPECT_EQ(stage.words > 0u, made) << name(static_cast<StageId>(s));
            EXPECT_EQ(stage.differing, 0u) << result.device.id << ", " << name(static_cast<StageId>(s)) << ", "
                                           << (stage.first ? verify::describe(*stage.first) : "");
        }
    }
}

/// The glTF files among the loadable models.
std::vector<std::string> gltf_models() {
    std::vector<std::string> files = test::loadable_models();
    std::erase_if(files, [](const std::string& file) { return !test::is_gltf(file); });
    return files;
}

bool is_large(const patches::PatchSet& set) {
    return set.patch_count() > 100'000;
}

class Model : public testing::TestWithParam<std::string> {};

TEST_P(Model, HasTheSameBitsOnEveryDevice) {
    TESSERA_SHARED_OR_SKIP(shared);
    const patches::PatchSet set = test::load_patches((shared / "models" / GetParam()).string());
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        for (const Partitioning partitioning : partitionings) {
            if (is_large(set) && (scheme != Scheme::pn || partitioning != Partitioning::fractional_odd)) {
                continue;
            }
            SCOPED_TRACE(fmt::format("{} {}", name(scheme), name(partitioning)));
            TessellationOptions options;
            options.scheme = scheme;
            options.partitioning = partitioning;
            // Both kinds of normals, in turn.
            options.normals = (static_cast<int>(scheme) + static_cast<int>(partitioning)) % 2 == 0 ? Normals::quadratic
                                                                                                   : Normals::linear;
            // Large models once, with few triangles each; mid-sized ones with smaller factors than small ones.
            const float greatest = is_large(set) ? 1.2f : (set.patch_count() > 3000 ? 2.0f : 4.0f);
            options.factors = random_edge_factors(set, 1.0f, greatest, 9);
            expect_equal(set, options);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, Model, testing::ValuesIn(gltf_models()),
                         [](const auto& info) { return test::file_test_name(info.param); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Model);

// Tangents of the file, and computed ones.
TEST(Models, WithNormalMapsHaveTheSameAttributesOnEveryDevice) {
    TESSERA_SHARED_OR_SKIP(shared);
    for (const char* file : {"Avocado/Avocado_quantized.gltf", "NegativeScale/Node_NegativeScale_05.gltf",
                             "SuzanneBlender/02_suzanne.gltf"}) {
        SCOPED_TRACE(file);
        const patches::PatchSet set =
            patches::make_patches(scene::load_scene((shared / "models" / file).string(), {.all_maps = true}));
        ASSERT_FALSE(set.corner_attributes.empty());
        TessellationOptions options;
        options.factors = random_edge_factors(set, 1.0f, 4.0f, 9);
        expect_equal(set, options);
    }
}

TEST(Models, AreThere) {
    TESSERA_SHARED_OR_SKIP(shared);
    EXPECT_GE(gltf_models().size(), 20u) << "the MANIFEST was not understood";
}

// Without any file: shapes with large factors and every combination of scheme, normals and partitioning.
TEST(Shapes, HaveTheSameBitsOnEveryDevice) {
    const patches::PatchSet set = test::load_patches("shape:icosahedron");
    for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
        for (const Normals normals : {Normals::linear, Normals::quadratic, Normals::surface}) {
            for (const Partitioning partitioning : partitionings) {
                SCOPED_TRACE(fmt::format("{} {} {}", name(scheme), name(normals), name(partitioning)));
                TessellationOptions options;
                options.scheme = scheme;
                options.normals = normals;
                options.partitioning = partitioning;
                options.factors = random_edge_factors(set, 0.5f, 66.0f, 4);
                expect_equal(set, options);
            }
        }
    }
}

TEST(Shapes, BatchesHaveTheSameBitsOnEveryDevice) {
    const patches::PatchSet set = test::load_patches("shape:sphere:12");
    TessellationOptions options;
    options.factors = random_edge_factors(set, 1.0f, 12.0f, 4);
    options.memory_budget = 1 << 20;
    expect_equal(set, options);
}

}  // namespace
}  // namespace tessera
