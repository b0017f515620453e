// Which memory serves which use on devices of several kinds, most of which no test machine has.
#include "backends/vulkan/memory.hpp"

#include <initializer_list>

#include "base/error.hpp"
#include "vulkan/each_device.hpp"

namespace tessera::test {
namespace {

using Property = vk::MemoryPropertyFlagBits;
using vulkan::MemoryUse;

constexpr std::uint32_t every_type = ~0u;

vk::PhysicalDeviceMemoryProperties table(std::initializer_list<vk::MemoryPropertyFlags> types) {
    vk::PhysicalDeviceMemoryProperties properties;
    for (const vk::MemoryPropertyFlags flags : types) {
        properties.memoryTypes[properties.memoryTypeCount++] = vk::MemoryType(flags, 0);
    }
    return properties;
}

void expect_types(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t device, std::uint32_t unmapped,
                  std::uint32_t upload, std::uint32_t readback) {
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::device), device);
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::unmapped), unmapped);
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::upload), upload);
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::readback), readback);
}

const vk::MemoryPropertyFlags local = Property::eDeviceLocal;
const vk::MemoryPropertyFlags shared = Property::eHostVisible | Property::eHostCoherent;
const vk::MemoryPropertyFlags cached = Property::eHostCached;

TEST(VulkanMemory, ACardOfItsOwn) {
    expect_types(table({{}, local, shared, shared | cached, local | shared}), 1, 1, 2, 3);
}

TEST(VulkanMemory, AChipThatSharesMemory) {
    expect_types(table({local | shared, local | shared | cached}), 1, 0, 0, 1);
    expect_types(table({local, local | shared, local | Property::eHostVisible | cached}), 2, 0, 1, 2);
}

TEST(VulkanMemory, ASoftwareDevice) {
    expect_types(table({local | shared | cached}), 0, 0, 0, 0);
}

TEST(VulkanMemory, DeviceMemoryGoesBeforeOtherMemory) {
    expect_types(table({shared, local | shared}), 1, 1, 0, 0);
}

TEST(VulkanMemory, SpecialMemoryIsLeftAlone) {
    const auto memory = table({local | Property::eProtected, local | Property::eLazilyAllocated, local});
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::device), 2u);
    EXPECT_EQ(vulkan::choose_memory_type(memory, 0b011, MemoryUse::device), std::nullopt);
    EXPECT_EQ(vulkan::choose_memory_type(memory, every_type, MemoryUse::upload), std::nullopt);
}

TEST(VulkanMemory, OutOfMemoryNamesSizeAndLabel) {
    if (vulkan::list().devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const vulkan::Context context = vulkan::create_context(0);
    try {
        vulkan::allocate(context, vk::MemoryRequirements(1ull << 50, 256, ~0u), vulkan::MemoryUse::device, "huge one");
        FAIL() << "allocated";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::device_unavailable);
        EXPECT_TRUE(contains(error.what(), "huge one") && contains(error.what(), "1125899906842624")) << error.what();
    }
    expect_no_messages();
}

}  // namespace
}  // namespace tessera::test
