#include "backends/vulkan/context.hpp"

#include <array>
#include <bit>
#include <limits>

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/suitability.hpp"

namespace tessera::backends::vulkan {
namespace {

/// Both structures are plain rows of VkBool32.
vk::PhysicalDeviceFeatures both(const vk::PhysicalDeviceFeatures& wanted, const vk::PhysicalDeviceFeatures& offered) {
    constexpr std::size_t count = sizeof(VkPhysicalDeviceFeatures) / sizeof(VkBool32);
    static_assert(count * sizeof(VkBool32) == sizeof(VkPhysicalDeviceFeatures));
    const auto a = std::bit_cast<std::array<VkBool32, count>>(static_cast<const VkPhysicalDeviceFeatures&>(wanted));
    auto b = std::bit_cast<std::array<VkBool32, count>>(static_cast<const VkPhysicalDeviceFeatures&>(offered));
    for (std::size_t i = 0; i < count; ++i)
        b[i] = a[i] != VK_FALSE && b[i] != VK_FALSE ? VK_TRUE : VK_FALSE;
    return std::bit_cast<VkPhysicalDeviceFeatures>(b);
}

}  // namespace

Context create_context(std::shared_ptr<const Instance> instance, vk::raii::PhysicalDevice physical,
                       const vk::PhysicalDeviceFeatures& wanted, std::span<const char* const> extensions,
                       const void* chain) {
    Context context;
    context.instance = std::move(instance);
    context.physical = std::move(physical);
    context.properties = context.physical.getProperties();
    context.memory = context.physical.getMemoryProperties();
    context.features = both(wanted, context.physical.getFeatures());
    const auto families = context.physical.getQueueFamilyProperties();
    context.queue_family = choose_queue_family(families).value();
    context.queue_properties = families[context.queue_family];

    guarded(fmt::format("opening '{}'", context.properties.deviceName.data()), [&] {
        const float priority = 1.0f;
        const vk::DeviceQueueCreateInfo queue({}, context.queue_family, 1, &priority);
        vk::DeviceCreateInfo info;
        info.setQueueCreateInfos(queue).setPEnabledFeatures(&context.features).setPNext(chain);
        info.setEnabledExtensionCount(static_cast<std::uint32_t>(extensions.size()));
        info.setPpEnabledExtensionNames(extensions.data());
        context.device = vk::raii::Device(context.physical, info);
        context.queue = context.device.getQueue(context.queue_family, 0);
    });
    return context;
}

Context create_context(std::size_t index, const vk::PhysicalDeviceFeatures& wanted) {
    std::shared_ptr<const Instance> instance = shared_instance();
    vk::raii::PhysicalDevice physical = usable_device(*instance, index);
    return create_context(std::move(instance), std::move(physical), wanted);
}

void submit_and_wait(const Context& context, const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    guarded(fmt::format("submitting work to '{}'", context.properties.deviceName.data()), [&] {
        const vk::raii::CommandPool pool(
            context.device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, context.queue_family));
        vk::raii::CommandBuffers buffers(context.device,
                                         vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1));
        const vk::raii::CommandBuffer& commands = buffers.front();
        commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
        record(commands);
        commands.end();
        const vk::raii::Fence done(context.device, vk::FenceCreateInfo());
        context.queue.submit(vk::SubmitInfo({}, {}, *commands), *done);
        // An infinite wait returns success or throws; a hung device is lost by its driver.
        const vk::Result result =
            context.device.waitForFences(*done, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
        if (result != vk::Result::eSuccess) throw vk::SystemError(vk::make_error_code(result));
    });
}

}  // namespace tessera::backends::vulkan
