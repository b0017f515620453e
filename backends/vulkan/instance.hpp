// The Vulkan loader and one instance, shared by every context of the process that lives at the same time.
#pragma once

#include <memory>

#include "backends/vulkan/vk.hpp"

namespace tessera::backends::vulkan {

/// Version of Vulkan that the project asks for. Devices may be older, down to `minimum_version`.
constexpr std::uint32_t requested_version = VK_API_VERSION_1_2;
constexpr std::uint32_t minimum_version = VK_API_VERSION_1_1;

/// An open shared library.
struct CloseLibrary {
    void operator()(void* library) const;
};
using Library = std::unique_ptr<void, CloseLibrary>;

struct Instance {
    Library library;
    vk::raii::Context loader;
    vk::raii::Instance handle{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};  ///< null without validation

    Instance();
    ~Instance();
};

/// The instance of this process, made when nobody holds one. The loader is libvulkan.so.1, or the library that the
/// environment variable TESSERA_VULKAN_LOADER names. Throws Error(device_unavailable) with the reason: no
/// loader, a loader that is too old, no driver, or a validation layer that was asked for and is not installed.
std::shared_ptr<const Instance> shared_instance();

}  // namespace tessera::backends::vulkan
