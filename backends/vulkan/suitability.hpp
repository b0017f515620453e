// Which physical devices can be used, and every reason against those that cannot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "backends/vulkan/instance.hpp"

namespace tessera::backends::vulkan {

/// The queue family that both computes and draws, else the first that computes, else nothing.
std::optional<std::uint32_t> choose_queue_family(std::span<const vk::QueueFamilyProperties> families);

/// Everything that stands against a device, a clause each ("it has no compute queue"); empty where it is fine.
std::vector<std::string> objections(const vk::PhysicalDeviceProperties& properties,
                                    std::span<const vk::QueueFamilyProperties> families);

/// A physical device and what stands against it.
struct Candidate {
    vk::raii::PhysicalDevice physical;
    std::vector<std::string> objections;
};

/// The devices of the machine, usable ones first and otherwise in the loader's order; the place in this list is the
/// number in an id such as "vulkan:1". Throws Error(device_unavailable) where the loader finds no driver.
std::vector<Candidate> candidates(const Instance& instance);

/// Device `index` of candidates(). Throws Error(device_unavailable) where there is none such, or it cannot be used.
vk::raii::PhysicalDevice usable_device(const Instance& instance, std::size_t index);

/// The sentence that names every objection.
std::string refusal(const Candidate& candidate);

}  // namespace tessera::backends::vulkan
