// Recording a dispatch allocates nothing but room in the list of commands.
#include "gpu/null_device.hpp"

#include <cstdlib>
#include <new>

namespace {
std::size_t allocations = 0;
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace tessera::gpu {
namespace {

using AllocationTest = NullDeviceTest;

TEST_F(AllocationTest, DispatchesGrowOnlyTheListOfCommands) {
    const ComputePipeline pipeline = device.create_compute_pipeline(scale_kernel());
    const Buffer counts = buffer("counts", 12, BufferUsage::indirect);
    const BindGroup group =
        device.create_bind_group(pipeline, {{storage("in")}, {storage("out")}, {uniform("parameters")}});
    CommandEncoder encoder = device.create_command_encoder();
    ComputePass pass = encoder.begin_compute_pass();
    const auto record = [&](int dispatches) {
        const std::size_t before = allocations;
        for (int i = 0; i < dispatches; ++i) {
            pass.set_pipeline(device.create_compute_pipeline(pipeline.kernel()));
            pass.set_bind_group(group, i % 4 * 256);
            pass.dispatch_workgroups(1);
            pass.dispatch_workgroups_indirect(counts, 0);
        }
        return allocations - before;
    };
    record(8);                     // holds the objects
    EXPECT_LE(record(4096), 12u);  // the list doubles: 16 commands to 8208 take ten steps
}

}  // namespace
}  // namespace tessera::gpu
