// Turns what Vulkan-Hpp throws into the project's errors.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "backends/vulkan/vk.hpp"
#include "base/error.hpp"

namespace tessera::backends::vulkan {

/// The Error for a failed call: what was being done ("submitting work to llvmpipe"), and what to do about it.
Error translate(const vk::SystemError& failure, std::string_view doing);

/// Runs `action`; a Vulkan failure leaves as Error(device_unavailable) that says what was being done.
template <typename Action>
decltype(auto) guarded(std::string_view doing, Action&& action) {
    try {
        return action();
    } catch (const vk::SystemError& failure) {
        throw translate(failure, doing);
    }
}

}  // namespace tessera::backends::vulkan
