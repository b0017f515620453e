#include "backends/vulkan/validation.hpp"

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <utility>

#include "backends/vulkan/vk.hpp"

namespace tessera::backends::vulkan {
namespace {

std::mutex messages_mutex;
std::vector<std::string> messages;
std::atomic<int> validating_instances = 0;

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT types,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    // "General" messages come from the loader (a driver file it cannot read) and speak of the machine, not of us.
    if ((types & ~static_cast<VkFlags>(VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT)) == 0) return VK_FALSE;
    const std::lock_guard lock(messages_mutex);
    messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

}  // namespace

vk::DebugUtilsMessengerCreateInfoEXT message_collector() {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return vk::DebugUtilsMessengerCreateInfoEXT({}, Severity::eWarning | Severity::eError,
                                                Type::eGeneral | Type::eValidation | Type::ePerformance, collect);
}

void count_validating_instance(int change) {
    validating_instances += change;
}

bool validation_wanted() {
    const char* set = std::getenv("TESSERA_VALIDATION");
    return set != nullptr && *set != '\0' && std::string_view(set) != "0";
}

bool validation_active() {
    return validating_instances > 0;
}

std::vector<std::string> take_validation_messages() {
    const std::lock_guard lock(messages_mutex);
    return std::exchange(messages, {});
}

}  // namespace tessera::backends::vulkan
