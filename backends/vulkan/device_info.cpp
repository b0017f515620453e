#include "backends/vulkan/device_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace tessera::backends::vulkan {
namespace {

/// Filled where the device is of version 1.2 or offers `extension`, which brought the structure; else nothing.
template <typename Structure>
std::optional<Structure> query(const vk::raii::PhysicalDevice& physical, std::uint32_t version,
                               std::string_view extension) {
    if (version < VK_API_VERSION_1_2 && !offers(physical, extension)) return std::nullopt;
    return physical.getProperties2<vk::PhysicalDeviceProperties2, Structure>().template get<Structure>();
}

gpu::Limits limits_of(const vk::raii::PhysicalDevice& physical, const vk::PhysicalDeviceLimits& from) {
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties>();
    gpu::Limits limits;
    limits.max_storage_buffers =
        std::min(from.maxPerStageDescriptorStorageBuffers, from.maxDescriptorSetStorageBuffers);
    limits.max_storage_binding_size = from.maxStorageBufferRange;
    limits.max_uniform_binding_size = from.maxUniformBufferRange;
    limits.max_buffer_size = chain.get<vk::PhysicalDeviceMaintenance3Properties>().maxMemoryAllocationSize;
    limits.max_workgroup_invocations = std::min(from.maxComputeWorkGroupInvocations, from.maxComputeWorkGroupSize[0]);
    limits.max_workgroups_per_dimension = std::min(from.maxComputeWorkGroupCount[0], from.maxComputeWorkGroupCount[1]);
    limits.storage_offset_alignment = static_cast<std::uint32_t>(from.minStorageBufferOffsetAlignment);
    limits.uniform_offset_alignment = static_cast<std::uint32_t>(from.minUniformBufferOffsetAlignment);
    return limits;
}

gpu::FloatControls float_controls_of(const vk::raii::PhysicalDevice& physical, std::uint32_t version) {
    const auto found = query<vk::PhysicalDeviceFloatControlsProperties>(physical, version,
                                                                        VK_KHR_SHADER_FLOAT_CONTROLS_EXTENSION_NAME);
    if (!found) return {};
    return {found->shaderDenormPreserveFloat32 == VK_TRUE, found->shaderDenormFlushToZeroFloat32 == VK_TRUE,
            found->shaderSignedZeroInfNanPreserveFloat32 == VK_TRUE, found->shaderRoundingModeRTEFloat32 == VK_TRUE};
}

std::string driver_of(const vk::raii::PhysicalDevice& physical, const vk::PhysicalDeviceProperties& properties) {
    const auto driver = query<vk::PhysicalDeviceDriverProperties>(physical, properties.apiVersion,
                                                                  VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME);
    if (!driver) return fmt::format("driver {:#x}", properties.driverVersion);
    const std::string_view name(driver->driverName), information(driver->driverInfo);
    return information.empty() ? std::string(name) : fmt::format("{}, {}", name, information);
}

}  // namespace

bool offers(const vk::raii::PhysicalDevice& physical, std::string_view extension) {
    const auto all = physical.enumerateDeviceExtensionProperties();
    return std::any_of(all.begin(), all.end(), [&](const vk::ExtensionProperties& one) {
        return std::string_view(one.extensionName) == extension;
    });
}

gpu::DeviceInfo describe(const vk::raii::PhysicalDevice& physical, std::size_t index) {
    const vk::PhysicalDeviceProperties properties = physical.getProperties();
    const std::uint32_t version = properties.apiVersion;
    gpu::DeviceInfo info;
    info.id = fmt::format("vulkan:{}", index);
    info.backend = "vulkan";
    info.name = properties.deviceName.data();
    info.driver = driver_of(physical, properties);
    info.version = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                               VK_API_VERSION_PATCH(version));
    info.software = properties.deviceType == vk::PhysicalDeviceType::eCpu;
    info.tessellation_stage = physical.getFeatures().tessellationShader == VK_TRUE;
    info.transform_feedback = offers(physical, VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME);
    // Vulkan does not tell the number of compute units; a software device has the threads of the machine.
    info.compute_units = info.software ? std::thread::hardware_concurrency() : 0;
    info.limits = limits_of(physical, properties.limits);
    info.float_controls = float_controls_of(physical, version);

    const auto families = physical.getQueueFamilyProperties();
    if (const auto family = choose_queue_family(families)) {
        info.rasteriser = static_cast<bool>(families[*family].queueFlags & vk::QueueFlagBits::eGraphics);
        info.timestamps = families[*family].timestampValidBits > 0 && properties.limits.timestampPeriod > 0.0f;
    }
    return info;
}

}  // namespace tessera::backends::vulkan
