// compare_jobs finds what is wrong: a reference that spoils one stage's results on purpose.
#include "verify/compare_jobs.hpp"
#include "layout.h"
#include "support/devices.hpp"
#include "support/wrapped_backend.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/tessellate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tessera {
namespace {

using verify::DeviceComparison;

/// After each submission that ran a kernel whose name begins so, one word of its output is changed.
struct Spoiler {
    std::string kernel;
    std::uint64_t word = 0;
    std::function<std::uint32_t(std::uint32_t)> change;
};

class SpoilingBackend : public test::WrappedBackend {
public:
    explicit SpoilingBackend(Spoiler spoiler) : spoiler_(std::move(spoiler)) { changeable_info().id = "spoilt"; }

    void submit(std::span<const gpu::Command> commands) override {
        inner().submit(commands);
        for (const gpu::Command& command : commands) {
            const auto* dispatch = std::get_if<gpu::Dispatch>(&command);
            if (dispatch != nullptr && kernel_of(*dispatch).name.starts_with(spoiler_.kernel)) {
                spoil(*dispatch);
            }
        }
    }

private:
    void spoil(const gpu::Dispatch& dispatch) {
        for (const gpu::KernelBinding& binding : kernel_of(dispatch).bindings) {
            if (binding.kind == gpu::BindingKind::write_storage) {
                const gpu::BoundBuffer& bound = buffers_of(dispatch)[binding.slot];
                std::uint32_t word = 0;
                const auto bytes = std::as_writable_bytes(std::span(&word, 1));
                inner().read_buffer(*bound.buffer, bound.offset + spoiler_.word * 4, bytes);
                word = spoiler_.change(word);
                inner().write_buffer(*bound.buffer, bound.offset + spoiler_.word * 4, bytes);
            }
        }
    }

    Spoiler spoiler_;
};

/// Leaves out every dispatch of one kernel.
class ForgetfulBackend : public test::WrappedBackend {
public:
    explicit ForgetfulBackend(std::string kernel) : kernel_(std::move(kernel)) {}

    void submit(std::span<const gpu::Command> commands) override {
        std::vector<gpu::Command> kept;
        std::ranges::copy_if(commands, std::back_inserter(kept), [&](const gpu::Command& command) {
            const auto* dispatch = std::get_if<gpu::Dispatch>(&command);
            return dispatch == nullptr || !kernel_of(*dispatch).name.starts_with(kernel_);
        });
        inner().submit(kept);
    }

private:
    std::string kernel_;
};

std::uint32_t flip_lowest_bit(std::uint32_t word) {
    return word ^ 1u;
}

gpu::Device spoilt(const std::string& kernel, std::uint64_t word,
                   std::function<std::uint32_t(std::uint32_t)> change = flip_lowest_bit) {
    return gpu::Device(std::make_unique<SpoilingBackend>(Spoiler{kernel, word, std::move(change)}));
}

std::vector<DeviceComparison> compare_with(std::vector<gpu::Device> devices) {
    static const patches::PatchSet set = [] {
        patches::PatchSet torus = test::load_patches("shape:torus");
        torus.corner_attributes.resize(torus.corners.size());
        return torus;
    }();
    TessellationOptions options;
    options.factors = random_edge_factors(set, 1.0f, 6.0f, 1);
    options.tangents = Tangents::uv;
    return verify::compare_jobs(std::move(devices), set, options);
}

std::vector<DeviceComparison> compare_with(gpu::Device device) {
    return compare_with({test::open_device("reference"), std::move(device)});
}

struct Case {
    const char* kernel;
    StageId stage;
};

class SpoiltStage : public testing::TestWithParam<Case> {};

TEST_P(SpoiltStage, IsFoundInItsStageAndElement) {
    constexpr std::uint64_t word = 101;
    const std::vector<DeviceComparison> results = compare_with(spoilt(GetParam().kernel, word));
    ASSERT_EQ(results.size(), 2u);
    EXPECT_TRUE(results[0].equal());
    EXPECT_FALSE(results[1].equal());
    EXPECT_EQ(results[1].device.id, "spoilt");
    const verify::StageComparison& stage = results[1].stages[static_cast<std::size_t>(GetParam().stage)];
    ASSERT_TRUE(stage.first.has_value());
    EXPECT_EQ(stage.first->element, word);
    EXPECT_EQ(stage.first->expected ^ stage.first->found, 1u);
    EXPECT_EQ(stage.differing, 1u);
    EXPECT_GT(stage.words, word);
    const bool floats = GetParam().stage == StageId::control_nets || GetParam().stage == StageId::vertices ||
                        GetParam().stage == StageId::tangents || GetParam().stage == StageId::attributes;
    EXPECT_EQ(stage.first->is_float, floats);
    // What is spoilt after its submission spoils nothing else.
    for (std::size_t s = 0; s < stage_count; ++s) {
        EXPECT_EQ(results[1].stages[s].differing, s == static_cast<std::size_t>(GetParam().stage) ? 1u : 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, SpoiltStage,
                         testing::Values(Case{"factors", StageId::factors}, Case{"control_net", StageId::control_nets},
                                         Case{"counts", StageId::counts}, Case{"scan_offsets", StageId::scan},
                                         Case{"vertices", StageId::vertices}, Case{"indices", StageId::indices},
                                         Case{"tangents", StageId::tangents}, Case{"attributes", StageId::attributes}),
                         [](const auto& info) { return std::string(info.param.kernel); });

class ForgottenStage : public testing::TestWithParam<Case> {};

// A stage that never runs leaves what its buffer was filled with, another word on each device.
TEST_P(ForgottenStage, IsFound) {
    const std::string kernel = GetParam().kernel;
    const std::vector<DeviceComparison> results = compare_with(gpu::Device(std::make_unique<ForgetfulBackend>(kernel)));
    const verify::StageComparison& stage = results[1].stages[static_cast<std::size_t>(GetParam().stage)];
    EXPECT_GT(stage.words, 0u);
    EXPECT_EQ(stage.differing, stage.words);
    ASSERT_TRUE(stage.first.has_value());
    EXPECT_EQ(stage.first->element, 0u);
}

INSTANTIATE_TEST_SUITE_P(Of, ForgottenStage,
                         testing::Values(Case{"control_net", StageId::control_nets},
                                         Case{"vertices", StageId::vertices}, Case{"indices", StageId::indices},
                                         Case{"tangents", StageId::tangents}, Case{"attributes", StageId::attributes}),
                         [](const auto& info) { return std::string(info.param.kernel); });

// Both devices give the same NaN: the bits agree and it is wrong all the same.
TEST(CompareJobs, AnEqualNaNOrInfinityDoesNotPass) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()}) {
        for (const char* kernel : {"vertices", "control_net"}) {
            const auto change = [=](std::uint32_t) { return std::bit_cast<std::uint32_t>(value); };
            const auto results = compare_with({spoilt(kernel, 40, change), spoilt(kernel, 40, change)});
            for (const DeviceComparison& result : results) {
                EXPECT_FALSE(result.equal()) << kernel << " " << value;
                const std::size_t stage = kernel == std::string("vertices") ? 4 : 1;
                EXPECT_EQ(result.stages[stage].differing, 1u);
                EXPECT_EQ(result.stages[stage].first->element, 40u);
            }
        }
    }
}

TEST(CompareJobs, ZerosOfDifferentSignDiffer) {
    const auto negate = [](std::uint32_t) { return 0x80000000u; };
    const auto zero = [](std::uint32_t) { return 0u; };
    EXPECT_FALSE(compare_with({spoilt("vertices", 9, zero), spoilt("vertices", 9, negate)})[1].equal());
    EXPECT_TRUE(compare_with({spoilt("vertices", 9, zero), spoilt("vertices", 9, zero)})[1].equal());
}

TEST(CompareJobs, ElementsAreCountedOverTheWholeJob) {
    const patches::PatchSet set = test::load_patches("shape:sphere:10");
    TessellationOptions options;
    options.memory_budget = 512 << 10;
    // The word is spoilt in every batch; the first of them is told, and how many there are.
    const auto results = verify::compare_jobs({test::open_device("reference"), spoilt("vertices", 3)}, set, options);
    const verify::StageComparison& stage = results[1].stages[static_cast<std::size_t>(StageId::vertices)];
    EXPECT_EQ(stage.first->element, 3u);
    EXPECT_GT(stage.differing, 1u);
    const Tessellator whole(test::open_device("reference"), set, options);
    EXPECT_EQ(stage.words, whole.totals().vertex_count * VERTEX_FLOATS);
}

TEST(CompareJobs, TellsProgress) {
    const patches::PatchSet set = test::load_patches("shape:sphere:10");
    TessellationOptions options;
    options.memory_budget = 512 << 10;
    std::vector<double> seen;
    verify::compare_jobs({test::open_device("reference")}, set, options, [&](double f) { seen.push_back(f); });
    EXPECT_GT(seen.size(), 2u);
    EXPECT_TRUE(std::ranges::is_sorted(seen));
    EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}

TEST(CompareJobs, DescribesADifference) {
    EXPECT_EQ(verify::describe(verify::Difference{12, 0x3f800000u, 0x3f800001u, true}),
              "element 12: 3f800000 (1) expected, 3f800001 (1.0000001) found");
    EXPECT_EQ(verify::describe(verify::Difference{0, 7u, 8u, false}), "element 0: 00000007 expected, 00000008 found");
}

}  // namespace
}  // namespace tessera
