// A device that leaves something out, or gets something wrong, is found out before it is timed.
#include "bench/job_run.hpp"
#include "bench/run_bench.hpp"
#include "bench/sanity.hpp"
#include "bench/small_workload.hpp"
#include "support/devices.hpp"
#include "support/wrapped_backend.hpp"
#include "tessellate/tessellate.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace tessera::bench {
namespace {

// Leaves out dispatches of kernels whose name begins so.
class ForgetfulBackend : public test::WrappedBackend {
public:
    explicit ForgetfulBackend(std::string kernel) : kernel_(std::move(kernel)) { changeable_info().id = "forgetful"; }

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

gpu::Device forgetful(const std::string& kernel) {
    return gpu::Device(std::make_unique<ForgetfulBackend>(kernel));
}

class EveryDevice : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(EveryDevice, WritesEverythingAndTheSame) {
    const gpu::Device device = test::open_device(GetParam().id);
    for (const Workload& workload : {test::small_workload(), test::uneven_workload()}) {
        const OutputCheck expected = check_output(test::open_device("reference"), workload);
        const OutputCheck found = check_output(device, workload);
        EXPECT_EQ(found.unwritten, 0u);
        EXPECT_EQ(found.vertex_hash, expected.vertex_hash);
        EXPECT_EQ(found.index_hash, expected.index_hash);
    }
}

TEST_P(EveryDevice, ARunTellsWhatItMadeAndSent) {
    const gpu::Device device = test::open_device(GetParam().id);
    const Workload workload = test::small_workload();
    JobRun run(device, workload);
    run.run();
    run.run();
    const RefinedMesh mesh = tessellate(device, workload.patches, workload.options);
    EXPECT_EQ(run.size().vertices, mesh.vertices.size());
    EXPECT_EQ(run.size().triangles, mesh.indices.size() / 3);
    EXPECT_GE(run.traffic().dispatches, 6u);
    EXPECT_GT(run.traffic().uploaded, workload.patches.patch_count() * 16);
    EXPECT_LT(run.traffic().uploaded, run.size().bytes());
}

TESSERA_ON_EVERY_DEVICE(EveryDevice);

TEST(Soundness, VerticesThatAreNotWrittenAreCounted) {
    const Workload workload = test::small_workload();
    const std::uint64_t vertices =
        tessellate(test::open_device("reference"), workload.patches, workload.options).vertices.size();
    EXPECT_EQ(check_output(forgetful("vertices"), workload).unwritten, vertices * 8);
}

TEST(Soundness, ADeviceThatWritesNothingIsRejected) {
    Settings settings;
    settings.workloads = {"W1"};
    settings.source.quick = true;
    settings.effort = {1, 0, 1.0};
    settings.devices = {test::open_device("reference"), forgetful("vertices")};
    const Report report = run_bench(settings, [](const std::string&) {});
    ASSERT_EQ(report.figures.size(), 2u);
    EXPECT_EQ(report.figures[0].rejected, "");
    EXPECT_TRUE(report.figures[1].unsound);
    EXPECT_NE(report.figures[1].rejected.find("not written"), std::string::npos) << report.figures[1].rejected;
    EXPECT_NE(report.find_figure("W1", "reference"), nullptr);
    EXPECT_EQ(report.find_figure("W1", "forgetful"), nullptr);
}

}  // namespace
}  // namespace tessera::bench
