// Which handle keeps what alive, and what a submit refuses after a destroy.
#include "gpu/null_device.hpp"

namespace tessera::gpu {
namespace {

class LifetimeTest : public NullDeviceTest {
protected:
    /// Commands that use each kind of object; all handles but the command buffer's are gone on return.
    CommandBuffer record() {
        const ComputePipeline pipeline = device.create_compute_pipeline(scale_kernel());
        const BindGroup group =
            device.create_bind_group(pipeline, {{storage("in")}, {storage("out")}, {uniform("parameters")}});
        const QuerySet queries = device.create_query_set(1);
        CommandEncoder encoder = device.create_command_encoder();
        ComputePass pass = encoder.begin_compute_pass();
        pass.set_pipeline(pipeline);
        pass.set_bind_group(group);
        pass.dispatch_workgroups(1);
        pass.dispatch_workgroups_indirect(buffer("counts", 12, BufferUsage::indirect), 0);
        pass.end();
        encoder.copy_buffer_to_buffer(storage("from"), 0, storage("to"), 0, 4);
        encoder.fill_buffer(storage("filled"), 0, 4, 0);
        encoder.write_timestamp(queries, 0);
        encoder.resolve_query_set(queries, 0, 1, buffer("times", 8, BufferUsage::query_resolve), 0);
        return encoder.finish();
    }
    static constexpr int recorded_objects = 11;  // pipeline, bind group, query set and eight buffers
};

TEST_F(LifetimeTest, ACommandBufferHoldsWhatItUsesUntilSubmitted) {
    const CommandBuffer commands = record();
    EXPECT_EQ(log.objects, recorded_objects);
    device.queue().submit(commands);
    EXPECT_EQ(log.commands.size(), 6u);
    EXPECT_EQ(log.objects, 1) << "only the cached pipeline stays";
}

TEST_F(LifetimeTest, ADroppedCommandBufferLetsGo) {
    record();
    EXPECT_EQ(log.objects, 1);
}

TEST_F(LifetimeTest, ObjectsKeepTheDevice) {
    const Buffer last_buffer = storage("last");
    const ComputePipeline last_pipeline = device.create_compute_pipeline(scale_kernel());
    CommandBuffer commands = record();
    device = Device();
    EXPECT_TRUE(log.backend_alive);
    EXPECT_EQ(last_pipeline.kernel().name, "scale");
    commands = CommandBuffer();
    EXPECT_TRUE(log.backend_alive);
}

TEST_F(LifetimeTest, TheBackendGoesLast) {
    for (int last = 0; last < 4; ++last) {
        Device dying(std::make_unique<NullBackend>(log, null_info()));
        ComputePipeline pipeline = dying.create_compute_pipeline(kernel_of("one", {{0, BindingKind::read_storage, 4}}));
        Buffer made = dying.create_buffer({"made", 4, BufferUsage::storage});
        BindGroup group = dying.create_bind_group(pipeline, {{made}});
        QuerySet queries = dying.create_query_set(1);
        dying = Device();
        if (last != 0) made = Buffer();
        if (last != 1) group = BindGroup();
        if (last != 2) queries = QuerySet();
        if (last != 3) pipeline = ComputePipeline();
        EXPECT_TRUE(log.backend_alive) << last;
    }
    EXPECT_FALSE(log.backend_alive);
    EXPECT_FALSE(log.object_outlived_backend);
    EXPECT_EQ(log.objects, 0);
}

TEST_F(LifetimeTest, SubmitRefusesWhatWasDestroyedSince) {
    Buffer in = storage("in");
    Buffer plain = storage("plain");
    const ComputePipeline pipeline =
        device.create_compute_pipeline(kernel_of("one", {{0, BindingKind::read_storage, 4}}));
    const BindGroup group = device.create_bind_group(pipeline, {{in}});

    CommandEncoder dispatching = device.create_command_encoder();
    ComputePass pass = dispatching.begin_compute_pass();
    pass.set_pipeline(pipeline);
    pass.set_bind_group(group);
    pass.dispatch_workgroups(1);
    pass.end();
    const CommandBuffer dispatch = dispatching.finish();
    CommandEncoder filling = device.create_command_encoder();
    filling.fill_buffer(plain, 0, 4, 0);
    const CommandBuffer fill = filling.finish();

    in.destroy();
    plain.destroy();
    expect_refused([&] { device.queue().submit(dispatch); }, {"submit", "'in'", "destroyed"});
    expect_refused([&] { device.queue().submit(fill); }, {"submit", "'plain'", "destroyed"});
    EXPECT_TRUE(log.commands.empty());
}

TEST_F(LifetimeTest, ARecordingHoldsEachObjectOnce) {
    const Buffer filled = storage("filled");
    const long before = filled.state_.use_count();
    CommandEncoder encoder = device.create_command_encoder();
    for (int i = 0; i < 100; ++i) {
        encoder.fill_buffer(filled, 0, 4, 0);
    }
    EXPECT_EQ(filled.state_.use_count(), before + 1);
}

}  // namespace
}  // namespace tessera::gpu
