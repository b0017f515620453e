#include "backends/vulkan/suitability.hpp"

#include <algorithm>

#include "backends/vulkan/errors.hpp"
#include "gpu/types.hpp"

namespace tessera::backends::vulkan {
namespace {

constexpr std::uint32_t workgroup_size = 64;  // of every kernel of the project

}  // namespace

std::optional<std::uint32_t> choose_queue_family(std::span<const vk::QueueFamilyProperties> families) {
    const auto with = [&](vk::QueueFlags flags) -> std::optional<std::uint32_t> {
        for (std::uint32_t i = 0; i < families.size(); ++i) {
            if (families[i].queueCount > 0 && (families[i].queueFlags & flags) == flags) return i;
        }
        return std::nullopt;
    };
    // Where a device draws at all, one family does both: kernels and rasteriser then share one order of work.
    const auto both = with(vk::QueueFlagBits::eCompute | vk::QueueFlagBits::eGraphics);
    return both ? both : with(vk::QueueFlagBits::eCompute);
}

std::vector<std::string> objections(const vk::PhysicalDeviceProperties& properties,
                                    std::span<const vk::QueueFamilyProperties> families) {
    std::vector<std::string> found;
    const auto at_least = [&](std::uint64_t value, std::uint64_t needed, std::string_view what) {
        if (value < needed) found.push_back(fmt::format("its {} is {}, and {} is needed", what, value, needed));
    };
    if (properties.apiVersion < minimum_version) {
        found.push_back(fmt::format("its driver speaks Vulkan {}.{}, and 1.1 is needed",
                                    VK_API_VERSION_MAJOR(properties.apiVersion),
                                    VK_API_VERSION_MINOR(properties.apiVersion)));
    }
    if (!choose_queue_family(families)) found.emplace_back("it has no compute queue");
    const vk::PhysicalDeviceLimits& limits = properties.limits;
    const gpu::Limits needed;
    at_least(limits.maxPerStageDescriptorStorageBuffers, needed.max_storage_buffers,
             "number of storage buffers per stage");
    at_least(limits.maxStorageBufferRange, needed.max_storage_binding_size, "largest storage binding in bytes");
    at_least(limits.maxComputeWorkGroupInvocations, workgroup_size, "number of invocations per workgroup");
    at_least(limits.maxComputeWorkGroupSize[0], workgroup_size, "width of a workgroup");
    at_least(limits.maxComputeWorkGroupCount[0], needed.max_workgroups_per_dimension, "number of workgroups in x");
    at_least(limits.maxComputeWorkGroupCount[1], needed.max_workgroups_per_dimension, "number of workgroups in y");
    return found;
}

std::vector<Candidate> candidates(const Instance& instance) {
    std::vector<Candidate> result;
    guarded("listing the Vulkan devices", [&] {
        for (vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(instance.handle)) {
            auto against = objections(physical.getProperties(), physical.getQueueFamilyProperties());
            result.push_back({std::move(physical), std::move(against)});
        }
    });
    if (result.empty()) {
        throw Error(ErrorKind::device_unavailable,
                    "The Vulkan loader is there, but no driver offers a device; on Debian, install "
                    "mesa-vulkan-drivers or the driver of your graphics card.");
    }
    std::stable_partition(result.begin(), result.end(), [](const Candidate& c) { return c.objections.empty(); });
    return result;
}

vk::raii::PhysicalDevice usable_device(const Instance& instance, std::size_t index) {
    std::vector<Candidate> found = candidates(instance);
    if (index >= found.size()) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("There is no device vulkan:{}; the last one is vulkan:{}.", index, found.size() - 1));
    }
    if (!found[index].objections.empty()) throw Error(ErrorKind::device_unavailable, refusal(found[index]));
    return std::move(found[index].physical);
}

std::string refusal(const Candidate& candidate) {
    return fmt::format("The Vulkan device '{}' cannot be used: {}.",
                       candidate.physical.getProperties().deviceName.data(), fmt::join(candidate.objections, "; "));
}

}  // namespace tessera::backends::vulkan
