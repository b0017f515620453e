// What is listed as a device, and what is said about what cannot be used.
#include <set>

#include "backends/vulkan/suitability.hpp"
#include "base/error.hpp"
#include "vulkan/each_device.hpp"
#include "vulkan/scoped_variable.hpp"

namespace tessera::test {
namespace {

/// The one reason that list() gives when there is no device at all.
std::string only_reason() {
    const backends::Inventory found = vulkan::list();
    EXPECT_TRUE(found.devices.empty());
    EXPECT_EQ(found.unusable.size(), 1u);
    return found.unusable.empty() ? "" : found.unusable.front().reason;
}

TEST(VulkanDeviceList, DevicesAreDescribed) {
    const auto devices = vulkan::list().devices;
    if (devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const gpu::Limits webgpu;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const gpu::DeviceInfo& info = devices[i];
        SCOPED_TRACE(info.name);
        EXPECT_EQ(info.id, "vulkan:" + std::to_string(i));
        EXPECT_EQ(info.backend, "vulkan");
        EXPECT_FALSE(info.name.empty());
        EXPECT_FALSE(info.driver.empty());
        EXPECT_EQ(info.version.rfind("1.", 0), 0u);
        EXPECT_GE(info.limits.max_storage_binding_size, webgpu.max_storage_binding_size);
        EXPECT_GE(info.limits.max_storage_buffers, webgpu.max_storage_buffers);
        EXPECT_GE(info.limits.max_workgroups_per_dimension, webgpu.max_workgroups_per_dimension);
        EXPECT_TRUE(info.float_controls.rounds_to_nearest_even.has_value());
        if (contains(info.name, "SwiftShader")) {
            EXPECT_TRUE(info.software);
            EXPECT_FALSE(info.tessellation_stage);
            EXPECT_FALSE(info.transform_feedback);
        }
        if (contains(info.name, "llvmpipe")) {
            EXPECT_TRUE(info.software && info.tessellation_stage && info.transform_feedback && info.rasteriser);
        }
        EXPECT_EQ(vulkan::open(i)->info().name, info.name);
    }
}

TEST(VulkanDeviceList, BothSoftwareDriversAreThereInCi) {
    if (!everything_required()) GTEST_SKIP() << "asked only where everything is required";
    std::string names;
    for (const gpu::DeviceInfo& info : vulkan::list().devices)
        names += info.name;
    EXPECT_TRUE(contains(names, "llvmpipe") && contains(names, "SwiftShader")) << names;
}

TEST(VulkanDeviceList, NoLoader) {
    const ScopedVariable loader("TESSERA_VULKAN_LOADER", "libvulkan-not-there.so");
    EXPECT_TRUE(contains(only_reason(), "libvulkan-not-there.so")) << only_reason();
    EXPECT_TRUE(contains(only_reason(), "install libvulkan1"));
    EXPECT_THROW(vulkan::open(0), Error);
}

TEST(VulkanDeviceList, ALibraryThatIsNoLoader) {
    const ScopedVariable loader("TESSERA_VULKAN_LOADER", "libm.so.6");
    EXPECT_TRUE(contains(only_reason(), "vkGetInstanceProcAddr")) << only_reason();
}

TEST(VulkanDeviceList, NoDriver) {
    const ScopedVariable drivers("VK_DRIVER_FILES", "/nonexistent/driver.json");
    const ScopedVariable more("VK_ADD_DRIVER_FILES", std::nullopt);
    EXPECT_TRUE(contains(only_reason(), "driver")) << only_reason();
}

TEST(VulkanDeviceList, NoValidationLayerThoughAskedFor) {
    const ScopedVariable wanted("TESSERA_VALIDATION", "1");
    const ScopedVariable layers("VK_LAYER_PATH", "/nonexistent");
    EXPECT_TRUE(contains(only_reason(), "VK_LAYER_KHRONOS_validation")) << only_reason();
    EXPECT_TRUE(contains(only_reason(), "vulkan-validationlayers"));
}

TEST(VulkanDeviceList, ADeviceThatIsNotThere) {
    try {
        vulkan::open(999);
        FAIL() << "opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
        EXPECT_TRUE(contains(error.what(), "999") || vulkan::list().devices.empty()) << error.what();
    }
}

TEST(VulkanDeviceList, EveryObjectionIsNamed) {
    vk::PhysicalDeviceProperties poor;
    poor.apiVersion = VK_API_VERSION_1_0;
    poor.limits.maxPerStageDescriptorStorageBuffers = 4;
    poor.limits.maxStorageBufferRange = 1u << 27;
    poor.limits.maxComputeWorkGroupInvocations = 32;
    poor.limits.maxComputeWorkGroupSize[0] = 64;
    poor.limits.maxComputeWorkGroupCount[0] = poor.limits.maxComputeWorkGroupCount[1] = 65535;
    const auto found = vulkan::objections(poor, {});
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0], "its driver speaks Vulkan 1.0, and 1.1 is needed");
    EXPECT_EQ(found[1], "it has no compute queue");
    EXPECT_EQ(found[2], "its number of storage buffers per stage is 4, and 8 is needed");
    EXPECT_EQ(found[3], "its number of invocations per workgroup is 32, and 64 is needed");
}

TEST(VulkanDeviceList, TheQueueThatAlsoDrawsIsPreferred) {
    const auto family = [](vk::QueueFlags flags) { return vk::QueueFamilyProperties(flags, 1); };
    const auto graphics = vk::QueueFlagBits::eGraphics;
    const auto compute = vk::QueueFlagBits::eCompute;
    const auto transfer = vk::QueueFlagBits::eTransfer;
    EXPECT_EQ(vulkan::choose_queue_family(std::array{family(transfer), family(compute), family(graphics | compute)}),
              2u);
    EXPECT_EQ(vulkan::choose_queue_family(std::array{family(transfer), family(compute)}), 1u);
    EXPECT_EQ(vulkan::choose_queue_family(std::array{family(transfer), family(graphics)}), std::nullopt);
}

}  // namespace
}  // namespace tessera::test
