// The judge judged: a stage that lies is found out, whatever it lies about.
#include "backends/registry.hpp"
#include "base/error.hpp"
#include "support/devices.hpp"
#include "verify/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace tessera::test {
namespace {

using verify::CapturedPatch;

/// Repeats what the kernels make, and lets a test change it.
class LyingStage final : public verify::FixedFunctionTessellator {
public:
    std::function<void(CapturedPatch&)> lie = [](CapturedPatch&) {};

    const gpu::DeviceInfo& info() const override { return info_; }
    std::vector<CapturedPatch> tessellate(Domain domain, Partitioning partitioning, bool clockwise,
                                          std::span<const PatchFactors> factors) override {
        std::vector<CapturedPatch> patches;
        for (const Pattern& pattern :
             make_patterns(open_device("reference"), domain, partitioning, clockwise, factors)) {
            CapturedPatch& patch = patches.emplace_back();
            for (const std::uint32_t index : pattern.indices) {
                const DomainPoint p = pattern.points[index];
                const std::uint32_t w = domain == Domain::triangle ? 65536u - p.u - p.v : 0u;
                patch.coordinates.push_back({static_cast<float>(p.u) / 65536.0f, static_cast<float>(p.v) / 65536.0f,
                                             static_cast<float>(w) / 65536.0f});
            }
            lie(patch);
        }
        return patches;
    }
    /// Flat.
    std::vector<CapturedPatch> evaluate(const verify::CapturedSurface&, Partitioning partitioning,
                                        std::span<const PatchFactors> factors,
                                        std::span<const Vertex> corners) override {
        const auto honest = std::exchange(lie, [](CapturedPatch&) {});
        std::vector<CapturedPatch> patches = tessellate(Domain::triangle, partitioning, true, factors);
        lie = honest;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            for (const verify::Triple& c : patches[i].coordinates) {
                verify::CapturedPoint& point = patches[i].points.emplace_back();
                for (std::size_t k = 0; k < 3; ++k) {
                    for (std::size_t j = 0; j < 3; ++j) {
                        point.position[k] += c[j] * corners[3 * i + j].position[k];
                        point.normal[k] += c[j] * corners[3 * i + j].normal[k];
                    }
                }
            }
            lie(patches[i]);
        }
        return patches;
    }

private:
    gpu::DeviceInfo info_;
};

const std::vector<PatchFactors> some_factors{{3, 4, 5, 6, 7, 2}, {1, 2, 3, 4, 5, 6}};

verify::DomainComparison compare(LyingStage& stage, Domain domain) {
    return verify::compare_domain(stage, open_device("reference"), domain, Partitioning::integer, true, some_factors);
}

TEST(DomainComparison, TakesAnyOrderAndAnyFirstCorner) {
    LyingStage stage;
    for (const Domain domain : {Domain::triangle, Domain::quad}) {
        stage.lie = [](CapturedPatch& patch) {
            auto& list = patch.coordinates;
            std::rotate(list.begin(), list.begin() + 3, list.end());        // triangles
            std::rotate(list.begin(), list.begin() + 1, list.begin() + 3);  // corners of the first
        };
        EXPECT_TRUE(compare(stage, domain).equal());
    }
    stage.lie = [](CapturedPatch& patch) { std::ranges::reverse(patch.coordinates); };
    EXPECT_TRUE(compare(stage, Domain::isoline).equal()) << "segments have no direction";
}

TEST(DomainComparison, FindsWhatDiffers) {
    const std::vector<std::function<void(CapturedPatch&)>> lies{
        [](CapturedPatch& patch) { std::swap(patch.coordinates[0], patch.coordinates[1]); },
        [](CapturedPatch& patch) { patch.coordinates.resize(patch.coordinates.size() - 3); },
        [](CapturedPatch& patch) { patch.coordinates.insert(patch.coordinates.end(), 3, patch.coordinates[0]); },
        [](CapturedPatch& patch) { std::copy_n(patch.coordinates.begin(), 3, patch.coordinates.begin() + 3); },
        [](CapturedPatch& patch) { patch.coordinates[4][2] = std::nextafter(patch.coordinates[4][2], 2.0f); },
        [](CapturedPatch& patch) {
            patch.coordinates[0] = {0.3f, 0.3f, 0.4f};
        },
        [](CapturedPatch& patch) { patch.coordinates[0][0] = std::nanf(""); },
        [](CapturedPatch& patch) { patch.coordinates[0][1] = -1.0f; },
        [](CapturedPatch& patch) { patch.coordinates.clear(); },
    };
    for (std::size_t i = 0; i < lies.size(); ++i) {
        SCOPED_TRACE(i);
        LyingStage stage;
        stage.lie = lies[i];
        const auto result = compare(stage, Domain::triangle);
        EXPECT_EQ(result.differing, some_factors.size());
        ASSERT_TRUE(result.first);
        EXPECT_NE(result.first->find("3,4,5,6"), std::string::npos) << *result.first;
    }
}

TEST(DomainComparison, NamesTheTriangles) {
    LyingStage stage;
    stage.lie = [](CapturedPatch& patch) { patch.coordinates[0] = {1.0f / 65536.0f, 0.0f, 65535.0f / 65536.0f}; };
    const std::string text = compare(stage, Domain::triangle).first.value_or("");
    EXPECT_NE(text.find("only by the stage 1: ("), std::string::npos) << text;
    EXPECT_NE(text.find("(1,0)"), std::string::npos) << text;
}

patches::PatchSet one_patch() {
    patches::PatchSet set;
    set.control_vertices = {{{1.5f, 0, 0}, {0, 0, 1}, {}}, {{0, 1, 0}, {0, 0, 1}, {}}, {{0, 0, 1}, {0, 0, 1}, {}}};
    set.corners = {{0, 1, 2, patches::no_corner}};
    set.ranges.push_back({"one", 0, 0, 1});
    return set;
}

TEST(SurfaceComparison, FindsWhatDiffers) {
    TessellationOptions options;
    options.scheme = Scheme::linear;
    options.normals = Normals::linear;
    options.factors = some_factors[0];
    const auto compare = [&](std::function<void(CapturedPatch&)> lie) {
        LyingStage stage;
        stage.lie = std::move(lie);
        return verify::compare_surface(stage, open_device("reference"), one_patch(), options);
    };
    const auto honest = compare([](CapturedPatch&) {});
    EXPECT_TRUE(honest.equal()) << honest.first.value_or("");
    EXPECT_LT(honest.position_error, verify::position_error_bound);
    const std::vector<std::function<void(CapturedPatch&)>> lies{
        [](CapturedPatch& patch) { patch.points[5].position[0] += 3e-6f; },
        [](CapturedPatch& patch) { patch.points[5].position[1] = std::nanf(""); },
        [](CapturedPatch& patch) { patch.points[7].normal[0] += 3e-6f; },
        [](CapturedPatch& patch) { patch.points[7].normal[2] = std::nanf(""); },
        [](CapturedPatch& patch) {
            patch.coordinates[7] = {0.3f, 0.3f, 0.4f};
        },
        [](CapturedPatch& patch) { patch.coordinates.resize(3); },
    };
    for (std::size_t i = 0; i < lies.size(); ++i) {
        const auto result = compare(lies[i]);
        EXPECT_EQ(result.differing, 1u) << i;
        EXPECT_TRUE(result.first) << i;
    }
}

TEST(Registry, SaysWhyADeviceCannotJudge) {
    try {
        backends::open_fixed_function("reference");
        ADD_FAILURE() << "the reference has no tessellation stage";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
        EXPECT_NE(std::string(error.what()).find("reference"), std::string::npos) << error.what();
    }
    for (const gpu::DeviceInfo& info : machine().devices) {
        if (info.backend == "vulkan" && (!info.tessellation_stage || !info.transform_feedback)) {
            EXPECT_THROW(backends::open_fixed_function(info.id), Error) << info.name;
        }
    }
}

}  // namespace
}  // namespace tessera::test
