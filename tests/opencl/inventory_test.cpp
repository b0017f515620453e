// Which devices are found, which are refused and why, and how a missing loader or driver is told.
#include "backends/opencl/opencl_inventory.hpp"

#include "backends/opencl/opencl_backend.hpp"
#include "base/error.hpp"

#include "opencl/opencl_fixture.hpp"

#include <cstdlib>
#include <iostream>

namespace tessera::test {
namespace {

using namespace backends::opencl;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(OpenClInventory, AMissingLoaderIsTold) {
    const Findings found = find_devices("libtessera-no-such-opencl.so.1");
    EXPECT_TRUE(found.devices.empty());
    ASSERT_EQ(found.unusable.size(), 1u);
    EXPECT_EQ(found.unusable[0].id, "opencl");
    EXPECT_TRUE(contains(found.unusable[0].reason, "libtessera-no-such-opencl.so.1")) << found.unusable[0].reason;
    EXPECT_TRUE(contains(found.unusable[0].reason, "install")) << found.unusable[0].reason;
}

TEST(OpenClInventory, ALibraryThatIsNoLoaderIsTold) {
    const Findings found = find_devices("libm.so.6");
    EXPECT_TRUE(found.devices.empty());
    ASSERT_EQ(found.unusable.size(), 1u);
    EXPECT_TRUE(contains(found.unusable[0].reason, "clGetPlatformIDs")) << found.unusable[0].reason;
}

TEST(OpenClInventoryDeathTest, NoDriverIsTold) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // a fresh process: a loader looks for drivers once
    const auto without_drivers = [] {
        setenv("OCL_ICD_VENDORS", "/nonexistent", 1);
        const Findings found = find_devices();
        for (const gpu::UnusableDevice& unusable : found.unusable) {
            std::cerr << unusable.reason << '\n';
        }
        std::exit(found.devices.empty() ? 0 : 1);
    };
    EXPECT_EXIT(without_drivers(), testing::ExitedWithCode(0), "install");
}

TEST(OpenClInventory, ADeviceNumberThatIsNotThereIsRefused) {
    try {
        open(1000);
        FAIL() << "opened device 1000";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
        EXPECT_TRUE(contains(error.what(), "1000")) << error.what();
    }
}

DeviceFacts good_device() {
    DeviceFacts facts;
    facts.name = "Good";
    facts.platform = "Platform";
    facts.driver_version = "7.1";
    facts.version = "OpenCL 1.2 text";
    facts.type = CL_DEVICE_TYPE_GPU;
    facts.available = facts.compiler = facts.little_endian = true;
    facts.single_fp = CL_FP_ROUND_TO_NEAREST | CL_FP_INF_NAN;
    facts.queue_properties = CL_QUEUE_PROFILING_ENABLE;
    facts.max_group_size = facts.max_items_x = 256;
    facts.max_allocation = 1ull << 30;
    facts.base_alignment = 512;
    facts.max_parameters = 1024;
    facts.address_bits = 64;
    facts.compute_units = 3;
    return facts;
}

TEST(OpenClInventory, EveryReasonAgainstADeviceIsNamed) {
    EXPECT_TRUE(refusals(good_device()).empty());
    DeviceFacts facts = good_device();
    facts.version = "OpenCL 1.1 text";
    facts.available = facts.compiler = facts.little_endian = false;
    facts.single_fp = CL_FP_ROUND_TO_ZERO;
    facts.max_items_x = 32;
    facts.max_allocation = 64u << 20;
    facts.max_parameters = 64;
    const std::vector<std::string> reasons = refusals(facts);
    const char* parts[] = {"1.2",     "not available", "compiler", "big-endian",
                           "nearest", "32 items",      "67108864", "64 bytes of arguments"};
    ASSERT_EQ(reasons.size(), std::size(parts));
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        EXPECT_TRUE(contains(reasons[i], parts[i])) << reasons[i];
    }
    facts = good_device();
    facts.version = "OpenCL 3.0 text";
    EXPECT_TRUE(refusals(facts).empty());
    facts.version = "nonsense";
    EXPECT_EQ(refusals(facts).size(), 1u);
}

TEST(OpenClInventory, ADeviceIsDescribedAsItIs) {
    const gpu::DeviceInfo gpu_info = describe(good_device(), "opencl:4");
    EXPECT_EQ(gpu_info.id, "opencl:4");
    EXPECT_EQ(gpu_info.backend, "opencl");
    EXPECT_EQ(gpu_info.name, "Good");
    EXPECT_EQ(gpu_info.driver, "Platform 7.1");
    EXPECT_FALSE(gpu_info.software);
    EXPECT_FALSE(gpu_info.rasteriser);
    EXPECT_TRUE(gpu_info.timestamps);
    EXPECT_EQ(gpu_info.compute_units, 3u);
    EXPECT_EQ(gpu_info.limits.max_buffer_size, 1ull << 30);
    EXPECT_EQ(gpu_info.limits.storage_offset_alignment, 512u);
    EXPECT_EQ(gpu_info.float_controls.preserves_denormals, false);
    EXPECT_EQ(gpu_info.float_controls.flushes_denormals, std::nullopt);

    DeviceFacts cpu = good_device();
    cpu.type = CL_DEVICE_TYPE_CPU;
    cpu.base_alignment = 128;
    cpu.max_allocation = 1ull << 40;
    cpu.queue_properties = 0;
    cpu.single_fp |= CL_FP_DENORM;
    const gpu::DeviceInfo cpu_info = describe(cpu, "opencl:0");
    EXPECT_TRUE(cpu_info.software);
    EXPECT_FALSE(cpu_info.timestamps);
    EXPECT_EQ(cpu_info.limits.storage_offset_alignment, 256u);
    EXPECT_EQ(cpu_info.limits.max_buffer_size, 1ull << 40);
    EXPECT_LT(cpu_info.limits.max_storage_binding_size, 1ull << 32);
    EXPECT_EQ(cpu_info.float_controls.preserves_denormals, true);
    EXPECT_EQ(cpu_info.float_controls.flushes_denormals, false);
}

TEST_F(OpenClTest, OpensWhatItLists) {
    const auto found = list();
    for (std::size_t i = 0; i < found.devices.size(); ++i) {
        EXPECT_EQ(found.devices[i].id, "opencl:" + std::to_string(i));
        EXPECT_EQ(open(i)->info().name, found.devices[i].name);
        EXPECT_GE(found.devices[i].limits.max_storage_buffers, gpu::Limits().max_storage_buffers);
        EXPECT_GT(found.devices[i].compute_units, 0u);
    }
}

}  // namespace
}  // namespace tessera::test
