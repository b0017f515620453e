#include "backends/vulkan/instance.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <string_view>

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/validation.hpp"

namespace tessera::backends::vulkan {

// Defined in validation.cpp.
vk::DebugUtilsMessengerCreateInfoEXT message_collector();
void count_validating_instance(int change);

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

Library open_library() {
    const char* set = std::getenv("TESSERA_VULKAN_LOADER");
    Library library(::dlopen(set != nullptr ? set : "libvulkan.so.1", RTLD_NOW | RTLD_LOCAL));
    if (library == nullptr) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The Vulkan loader cannot be opened ({}); on Debian, install libvulkan1 and a driver "
                                "such as mesa-vulkan-drivers.",
                                ::dlerror()));
    }
    return library;
}

PFN_vkGetInstanceProcAddr entry_point(const Library& library) {
    void* found = ::dlsym(library.get(), "vkGetInstanceProcAddr");
    if (found == nullptr) {
        throw Error(ErrorKind::device_unavailable,
                    "The library opened as the Vulkan loader has no vkGetInstanceProcAddr; is it another library, or "
                    "is TESSERA_VULKAN_LOADER wrong?");
    }
    return reinterpret_cast<PFN_vkGetInstanceProcAddr>(found);
}

void require_validation_layer(const vk::raii::Context& loader) {
    const auto layers = loader.enumerateInstanceLayerProperties();
    const bool found = std::any_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
        return std::string_view(layer.layerName) == validation_layer;
    });
    if (!found) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("TESSERA_VALIDATION is set, but the layer {} is not installed; on Debian, install "
                                "vulkan-validationlayers, or unset the variable.",
                                validation_layer));
    }
}

vk::raii::Instance create_instance(const vk::raii::Context& loader, bool validate) {
    // A loader of version 1.0 does not have the call.
    const bool can_tell = loader.getDispatcher()->vkEnumerateInstanceVersion != nullptr;
    const std::uint32_t version = can_tell ? loader.enumerateInstanceVersion() : VK_API_VERSION_1_0;
    if (version < minimum_version) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The Vulkan loader speaks version {}.{}, and 1.1 is needed; update libvulkan1.",
                                VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version)));
    }
    const vk::ApplicationInfo application("Tessera", 1, "Tessera", 1, requested_version);
    vk::InstanceCreateInfo info({}, &application);

    std::vector<const char*> layers, extensions;
    const std::array enabled = {vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    vk::ValidationFeaturesEXT features(enabled);
    vk::DebugUtilsMessengerCreateInfoEXT collector = message_collector();
    if (validate) {
        require_validation_layer(loader);
        layers = {validation_layer};
        extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
        features.pNext = &collector;  // hears the creation and destruction of the instance as well
        info.pNext = &features;
    }
    info.setPEnabledLayerNames(layers).setPEnabledExtensionNames(extensions);
    return vk::raii::Instance(loader, info);
}

}  // namespace

void CloseLibrary::operator()(void* library) const {
    ::dlclose(library);
}

Instance::Instance() : library(open_library()), loader(entry_point(library)) {
    const bool validate = validation_wanted();
    guarded("creating the Vulkan instance", [&] {
        handle = create_instance(loader, validate);
        if (validate) messenger = vk::raii::DebugUtilsMessengerEXT(handle, message_collector());
    });
    if (validate) count_validating_instance(+1);
}

Instance::~Instance() {
    if (*messenger) count_validating_instance(-1);
}

std::shared_ptr<const Instance> shared_instance() {
    static std::mutex mutex;
    static std::weak_ptr<const Instance> current;
    const std::lock_guard lock(mutex);
    std::shared_ptr<const Instance> instance = current.lock();
    if (!instance) {
        instance = std::make_shared<const Instance>();
        current = instance;
    }
    return instance;
}

}  // namespace tessera::backends::vulkan
