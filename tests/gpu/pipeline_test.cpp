#include "gpu/null_device.hpp"

#include <array>

namespace tessera::gpu {
namespace {

using PipelineTest = NullDeviceTest;

constexpr KernelBinding read(std::uint32_t slot) {
    return {slot, BindingKind::read_storage, 4};
}
constexpr KernelBinding uniform_of(std::uint32_t slot, std::uint32_t size) {
    return {slot, BindingKind::uniform, size};
}

TEST_F(PipelineTest, IsMadeOncePerKernel) {
    const ComputePipeline first = device.create_compute_pipeline(scale_kernel());
    const ComputePipeline second = device.create_compute_pipeline(scale_kernel());
    EXPECT_EQ(first.state_, second.state_);
    EXPECT_EQ(first.kernel().name, "scale");
    EXPECT_EQ(log.calls, std::vector<std::string>{"pipeline scale"});
    EXPECT_NE(device.create_compute_pipeline(scale_kernel("other")).state_, first.state_);
}

TEST_F(PipelineTest, RefusesAnotherKernelOfTheSameName) {
    device.create_compute_pipeline(scale_kernel());
    Kernel other = scale_kernel();
    other.bindings[2].size = 12;
    expect_refused([&] { device.create_compute_pipeline(other); }, {"'scale'", "differs"});
    Kernel translated = scale_kernel();
    static constexpr std::array<std::uint32_t, 1> words{7};
    translated.spirv = words;
    expect_refused([&] { device.create_compute_pipeline(translated); }, {"'scale'", "differs"});
}

TEST_F(PipelineTest, RefusesNullHandles) {
    expect_refused([] { ComputePipeline().kernel(); }, {"ComputePipeline::kernel", "null"});
    expect_refused([] { Device().create_compute_pipeline(scale_kernel()); }, {"create_compute_pipeline", "null"});
}

TEST_F(PipelineTest, RefusesKernelsThatAreWrongOrTooLarge) {
    const auto refused = [&](const Kernel& kernel, std::initializer_list<std::string_view> parts) {
        expect_refused([&] { device.create_compute_pipeline(kernel); }, parts);
    };
    refused(kernel_of("", {}), {"without a name"});
    refused(kernel_of("gap", {read(0), read(2)}), {"'gap'", "slot 2", "place 1"});
    refused(kernel_of("empty", {{0, BindingKind::read_storage, 0}}), {"'empty'", "0 bytes", "slot 0"});
    refused(kernel_of("wide", {uniform_of(0, 1028)}), {"'wide'", "1028", "1024"});
    refused(kernel_of("two", {uniform_of(0, 8), uniform_of(1, 8)}), {"'two'", "2 uniform"});
    std::vector<KernelBinding> nine;
    for (std::uint32_t slot = 0; slot < 9; ++slot) {
        nine.push_back(read(slot));
    }
    refused(kernel_of("many", nine), {"'many'", "9 storage", "8"});
    nine.back() = uniform_of(8, 8);
    EXPECT_NO_THROW(device.create_compute_pipeline(kernel_of("full", nine)));
}

TEST_F(PipelineTest, RefusesDevicesWithSmallGroups) {
    DeviceInfo info = null_info();
    info.limits.max_workgroup_invocations = 32;
    NullLog small_log;
    Device small(std::make_unique<NullBackend>(small_log, info));
    expect_refused([&] { small.create_compute_pipeline(scale_kernel()); }, {"'scale'", "64", "32"});
}

}  // namespace
}  // namespace tessera::gpu
