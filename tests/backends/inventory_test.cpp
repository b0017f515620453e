// What list_devices says, for every device and for what is missing.
#include "backends/device_suite.hpp"
#include "support/environment.hpp"

namespace tessera::backends {
namespace {

class InventoryTest : public DeviceTest {};

TEST_P(InventoryTest, TellsWhatADeviceIs) {
    const gpu::DeviceInfo& info = GetParam();
    EXPECT_EQ(device.info().id, info.id);
    EXPECT_EQ(device.info().name, info.name);
    EXPECT_TRUE(info.id == info.backend || info.id.starts_with(info.backend + ":")) << info.id;
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.driver.empty());
    EXPECT_FALSE(info.version.empty());
}

TEST_P(InventoryTest, MeetsTheLimitsOfWebGpu) {
    const gpu::Limits& limits = device.limits();
    const gpu::Limits promised;
    EXPECT_GE(limits.max_storage_buffers, promised.max_storage_buffers);
    EXPECT_GE(limits.max_storage_binding_size, promised.max_storage_binding_size);
    EXPECT_GE(limits.max_buffer_size, promised.max_storage_binding_size);
    EXPECT_GE(limits.max_workgroup_invocations, gpu::workgroup_size);
    EXPECT_GE(limits.max_workgroups_per_dimension, promised.max_workgroups_per_dimension);
    EXPECT_LE(limits.storage_offset_alignment, promised.storage_offset_alignment);
    EXPECT_LE(limits.uniform_offset_alignment, promised.uniform_offset_alignment);
}

TESSERA_ON_EVERY_DEVICE(InventoryTest);

TEST(Machine, ListsReferenceFirstAndBackendsInOrder) {
    const std::vector<gpu::DeviceInfo>& devices = machine().devices;
    ASSERT_FALSE(devices.empty());
    EXPECT_EQ(devices[0].id, "reference");
    const auto rank = [](const gpu::DeviceInfo& info) {
        return info.backend == "reference" ? 0 : info.backend == "vulkan" ? 1 : info.backend == "opencl" ? 2 : 3;
    };
    EXPECT_TRUE(std::ranges::is_sorted(devices, {}, rank));
    EXPECT_LT(rank(devices.back()), 3);
}

TEST(Machine, SaysWhyADeviceIsNotUsable) {
    for (const gpu::UnusableDevice& device : machine().unusable) {
        EXPECT_FALSE(device.id.empty());
        EXPECT_TRUE(device.reason.ends_with('.')) << device.id << ": " << device.reason;
    }
}

/// Skips, or fails where everything is required, when no device's name has `part` in it.
void expect_device(const std::string& backend, const std::string& part) {
    const bool there = std::ranges::any_of(machine().devices, [&](const gpu::DeviceInfo& info) {
        return info.backend == backend && info.name.find(part) != std::string::npos;
    });
    if (!there && test::everything_required()) {
        FAIL() << backend << " device '" << part << "' is required but missing";
    }
    if (!there) {
        GTEST_SKIP() << backend << " device '" << part << "' is missing: its tests did not run";
    }
}

TEST(Machine, HasLavapipe) {
    expect_device("vulkan", "llvmpipe");
}
TEST(Machine, HasSwiftShader) {
    expect_device("vulkan", "SwiftShader");
}
TEST(Machine, HasOpenCl) {
    expect_device("opencl", "");
}

}  // namespace
}  // namespace tessera::backends
