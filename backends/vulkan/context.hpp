// One logical device with its queue: what the compute backend, the rasteriser on it, and what captures and times the
// tessellation stage are built on.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "backends/vulkan/instance.hpp"

namespace tessera::backends::vulkan {

struct Context {
    std::shared_ptr<const Instance> instance;
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    vk::raii::Queue queue{nullptr};
    std::uint32_t queue_family = 0;
    vk::QueueFamilyProperties queue_properties;  ///< graphics is among its flags wherever the device can draw
    vk::PhysicalDeviceProperties properties;
    vk::PhysicalDeviceMemoryProperties memory;
    vk::PhysicalDeviceFeatures features;  ///< those that were enabled
};

/// Makes a device on `physical`. Of the `wanted` features those that the device has are enabled; `context.features`
/// says which. `extensions` must be offered by the device, and `chain` is their list of feature structures.
/// Throws Error(device_unavailable).
Context create_context(std::shared_ptr<const Instance> instance, vk::raii::PhysicalDevice physical,
                       const vk::PhysicalDeviceFeatures& wanted = {}, std::span<const char* const> extensions = {},
                       const void* chain = nullptr);

/// Same, on device `index` of list(). Throws Error(device_unavailable) where there is none such.
Context create_context(std::size_t index, const vk::PhysicalDeviceFeatures& wanted = {});

/// Names an object in the messages of the validation layer; does nothing without it.
template <typename Handle>
void set_name(const Context& context, const Handle& handle, std::string_view label) {
    if (!*context.instance->messenger) return;
    const std::string name(label);
    const auto number = reinterpret_cast<std::uint64_t>(static_cast<typename Handle::CType>(*handle));
    context.device.setDebugUtilsObjectNameEXT({Handle::objectType, number, name.c_str()});
}

/// Records with `record`, submits, and waits until the device is done. For set-up and pictures, not for steady state.
/// Throws Error(device_unavailable) when the device fails.
void submit_and_wait(const Context& context, const std::function<void(const vk::raii::CommandBuffer&)>& record);

}  // namespace tessera::backends::vulkan
