// The net under all other tests: that the validation layer is there, and that it reports what it should.
#include "backends/vulkan/validation.hpp"

#include "backends/vulkan/memory.hpp"
#include "vulkan/each_device.hpp"
#include "vulkan/scoped_variable.hpp"

namespace tessera::test {
namespace {

TEST(VulkanValidation, IsOnlyOnWhenAskedFor) {
    if (vulkan::list().devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const auto active = [] {
        const auto instance = vulkan::shared_instance();
        return vulkan::validation_active();
    };
    EXPECT_TRUE(active()) << "the tests run with TESSERA_VALIDATION=1";
    for (const auto& value : {std::optional<std::string>(), std::optional<std::string>("0")}) {
        const ScopedVariable off("TESSERA_VALIDATION", value);
        EXPECT_FALSE(active());
    }
    EXPECT_FALSE(vulkan::validation_active()) << "no instance lives";
}

TEST(VulkanValidation, AMissingBarrierIsReported) {
    const auto devices = vulkan::list().devices;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        SCOPED_TRACE(devices[i].name);
        const vulkan::Context context = vulkan::create_context(i);
        const auto usage = vk::BufferUsageFlagBits::eTransferDst;
        const auto made = vulkan::create_buffer(context, 256, usage, vulkan::MemoryUse::device, "twice filled");
        vulkan::submit_and_wait(context, [&](const vk::raii::CommandBuffer& commands) {
            commands.fillBuffer(*made.buffer, 0, 256, 1);
            commands.fillBuffer(*made.buffer, 0, 256, 2);
        });
        const auto messages = vulkan::take_validation_messages();
        ASSERT_EQ(messages.size(), 1u);
        EXPECT_NE(messages[0].find("SYNC-HAZARD-WRITE-AFTER-WRITE"), std::string::npos) << messages[0];
        EXPECT_NE(messages[0].find("twice filled"), std::string::npos) << "objects go by their labels: " << messages[0];
    }
}

TEST(VulkanValidation, AMissingBarrierBetweenSubmissionsIsReported) {
    const auto devices = vulkan::list().devices;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        SCOPED_TRACE(devices[i].name);
        const vulkan::Context context = vulkan::create_context(i);
        const auto usage = vk::BufferUsageFlagBits::eTransferDst;
        const auto made = vulkan::create_buffer(context, 256, usage, vulkan::MemoryUse::device, "twice filled");
        const vk::raii::CommandPool pool(context.device, vk::CommandPoolCreateInfo({}, context.queue_family));
        const vk::raii::CommandBuffers commands(
            context.device, vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 2));
        for (const vk::raii::CommandBuffer& one : commands) {
            one.begin(vk::CommandBufferBeginInfo());
            one.fillBuffer(*made.buffer, 0, 256, 1);
            one.end();
            context.queue.submit(vk::SubmitInfo({}, {}, *one));
        }
        context.queue.waitIdle();
        const auto messages = vulkan::take_validation_messages();
        ASSERT_EQ(messages.size(), 1u);
        EXPECT_NE(messages[0].find("SYNC-HAZARD-WRITE-AFTER-WRITE"), std::string::npos) << messages[0];
    }
}

TEST(VulkanValidation, AWrongCallIsReported) {
    if (vulkan::list().devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const vulkan::Context context = vulkan::create_context(0);
    const auto usage = vk::BufferUsageFlagBits::eTransferSrc;
    const auto made = vulkan::create_buffer(context, 256, usage, vulkan::MemoryUse::device, "not a destination");
    vulkan::submit_and_wait(
        context, [&](const vk::raii::CommandBuffer& commands) { commands.fillBuffer(*made.buffer, 0, 256, 1); });
    EXPECT_FALSE(vulkan::take_validation_messages().empty());
    EXPECT_TRUE(vulkan::take_validation_messages().empty()) << "taken once";
}

}  // namespace
}  // namespace tessera::test
