#include "gpu/null_device.hpp"

#include <array>

namespace tessera::gpu {
namespace {

class ComputePassTest : public NullDeviceTest {
protected:
    void submit() {
        pass.end();
        device.queue().submit(encoder.finish());
    }

    ComputePipeline pipeline = device.create_compute_pipeline(scale_kernel());
    Buffer in = storage("in");
    Buffer out = buffer("out", 1024, BufferUsage::storage | BufferUsage::indirect);
    Buffer parameters = uniform("parameters");
    Buffer counts = buffer("counts", 64, BufferUsage::indirect);
    BindGroup group = device.create_bind_group(pipeline, {{in}, {out}, {parameters}});
    CommandEncoder encoder = device.create_command_encoder();
    ComputePass pass = encoder.begin_compute_pass();
};

TEST_F(ComputePassTest, RecordsDispatches) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    pass.dispatch_workgroups(3);
    pass.set_bind_group(group, 512);
    pass.dispatch_workgroups(4, 5);
    pass.dispatch_workgroups_indirect(counts, 52);
    submit();
    ASSERT_EQ(log.commands.size(), 3u);
    const auto first = command<Dispatch>(0);
    EXPECT_EQ(first.uniform_offset, 0u);
    EXPECT_EQ(first.groups_x, 3u);
    EXPECT_EQ(first.groups_y, 1u);
    const auto second = command<Dispatch>(1);
    EXPECT_EQ(second.pipeline, first.pipeline);
    EXPECT_EQ(second.bind_group, first.bind_group);
    EXPECT_EQ(second.uniform_offset, 512u);
    EXPECT_EQ(second.groups_x, 4u);
    EXPECT_EQ(second.groups_y, 5u);
    const auto third = command<DispatchIndirect>(2);
    EXPECT_EQ(third.pipeline, first.pipeline);
    EXPECT_EQ(third.bind_group, first.bind_group);
    EXPECT_EQ(third.uniform_offset, 512u);
    EXPECT_EQ(third.arguments_offset, 52u);
    EXPECT_NE(third.arguments, nullptr);
}

TEST_F(ComputePassTest, DropsDispatchesOfNoGroups) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    pass.dispatch_workgroups(0);
    pass.dispatch_workgroups(7, 0);
    submit();
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(ComputePassTest, RefusesGroupCountsOverTheLimits) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    expect_refused([&] { pass.dispatch_workgroups(1001); }, {"'scale'", "1001 x 1", "1000"});
    expect_refused([&] { pass.dispatch_workgroups(1, 1001); }, {"'scale'", "1 x 1001", "1000"});
    EXPECT_NO_THROW(pass.dispatch_workgroups(1000, 1000));
}

TEST_F(ComputePassTest, RefusesMoreItemsThanAnIndexCanCount) {
    DeviceInfo info = null_info();
    info.limits.max_workgroups_per_dimension = 65535;
    NullLog wide_log;
    Device wide(std::make_unique<NullBackend>(wide_log, info));
    const ComputePipeline empty = wide.create_compute_pipeline(kernel_of("empty", {}));
    CommandEncoder recorder = wide.create_command_encoder();
    ComputePass wide_pass = recorder.begin_compute_pass();
    wide_pass.set_pipeline(empty);
    wide_pass.set_bind_group(wide.create_bind_group(empty, {}));
    expect_refused([&] { wide_pass.dispatch_workgroups(65535, 1025); }, {"'empty'", "65535 x 1025", "32-bit"});
    EXPECT_NO_THROW(wide_pass.dispatch_workgroups(65535, 1024));
}

TEST_F(ComputePassTest, RefusesADispatchWithoutPipelineOrBindGroup) {
    pass.set_bind_group(group);
    expect_refused([&] { pass.dispatch_workgroups(1); }, {"dispatch_workgroups", "before set_pipeline"});
    expect_refused([&] { pass.dispatch_workgroups_indirect(counts, 0); }, {"before set_pipeline"});
    pass.end();
    pass = encoder.begin_compute_pass();
    pass.set_pipeline(pipeline);
    expect_refused([&] { pass.dispatch_workgroups(1); }, {"'scale'", "before set_bind_group", "pass 2"});
}

TEST_F(ComputePassTest, RefusesABindGroupOfAnotherKernel) {
    const ComputePipeline other = device.create_compute_pipeline(scale_kernel("other"));
    pass.set_pipeline(other);
    pass.set_bind_group(group);
    expect_refused([&] { pass.dispatch_workgroups(1); }, {"'other'", "made for kernel 'scale'"});
    expect_refused([&] { pass.dispatch_workgroups_indirect(counts, 0); }, {"'other'", "made for kernel 'scale'"});
}

TEST_F(ComputePassTest, RefusesNullsAndStrangers) {
    expect_refused([&] { pass.set_pipeline(ComputePipeline()); }, {"set_pipeline", "null"});
    expect_refused([&] { pass.set_bind_group(BindGroup()); }, {"set_bind_group", "null"});
    const ComputePipeline foreign = other_device.create_compute_pipeline(kernel_of("empty", {}));
    expect_refused([&] { pass.set_pipeline(foreign); }, {"'empty'", "another device"});
    expect_refused([&] { pass.set_bind_group(other_device.create_bind_group(foreign, {})); },
                   {"'empty'", "another device"});
    expect_refused([] { ComputePass().dispatch_workgroups(1); }, {"dispatch_workgroups", "null"});
}

TEST_F(ComputePassTest, RefusesBadUniformOffsets) {
    expect_refused([&] { pass.set_bind_group(group, 8); }, {"uniform offset 8", "'scale'", "256"});
    expect_refused([&] { pass.set_bind_group(group, 1024); }, {"uniform offset 1024", "'parameters'", "1016"});
    EXPECT_NO_THROW(pass.set_bind_group(group, 768));
    const ComputePipeline copy = device.create_compute_pipeline(
        kernel_of("copy", {{0, BindingKind::read_storage, 4}, {1, BindingKind::write_storage, 4}}));
    const BindGroup plain = device.create_bind_group(copy, {{in}, {out}});
    expect_refused([&] { pass.set_bind_group(plain, 256); }, {"uniform offset 256", "'copy'", "no uniform"});
}

TEST_F(ComputePassTest, RefusesBadIndirectArguments) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    const auto refused = [&](const Buffer& arguments, std::uint64_t offset,
                             std::initializer_list<std::string_view> parts) {
        expect_refused([&] { pass.dispatch_workgroups_indirect(arguments, offset); }, parts);
    };
    refused(Buffer(), 0, {"dispatch_workgroups_indirect", "null"});
    refused(in, 0, {"usage indirect", "'in'"});
    refused(counts, 2, {"'counts'", "offset 2", "multiple of 4"});
    refused(counts, 56, {"'counts'", "12 bytes", "offset 56", "64"});
    refused(counts, ~std::uint64_t{3}, {"'counts'"});
    refused(out, 0, {"'out'", "writes in slot 1"});
    counts.destroy();
    refused(counts, 0, {"'counts'", "destroyed"});
    submit();
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(ComputePassTest, RefusesABindGroupOfADestroyedBuffer) {
    in.destroy();
    expect_refused([&] { pass.set_bind_group(group); }, {"'scale'", "'in'", "destroyed"});
}

TEST_F(ComputePassTest, RefusesUseAfterEnd) {
    pass.end();
    expect_refused([&] { pass.set_pipeline(pipeline); }, {"set_pipeline", "end of compute pass 1"});
    expect_refused([&] { pass.set_bind_group(group); }, {"set_bind_group", "end of compute pass 1"});
    expect_refused([&] { pass.dispatch_workgroups(1); }, {"dispatch_workgroups", "end of compute pass 1"});
    expect_refused([&] { pass.dispatch_workgroups_indirect(counts, 0); }, {"end of compute pass 1"});
    expect_refused([&] { pass.end(); }, {"end", "end of compute pass 1"});
    ComputePass next = encoder.begin_compute_pass();
    expect_refused([&] { pass.set_pipeline(pipeline); }, {"end of compute pass 1"});
    next.end();
}

TEST_F(ComputePassTest, StartsWithNothingSet) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    pass.end();
    ComputePass next = encoder.begin_compute_pass();
    expect_refused([&] { next.dispatch_workgroups(1); }, {"before set_pipeline"});
}

}  // namespace
}  // namespace tessera::gpu
