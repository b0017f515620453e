// Checks that every call shares. Each throws Error(usage) with one sentence that begins with the refused call.
#pragma once

#include "base/error.hpp"
#include "gpu/state.hpp"

#include <fmt/format.h>

namespace tessera::gpu::detail {

/// Throws Error(usage) with the formatted sentence.
template <typename... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> sentence, Args&&... args) {
    throw Error(ErrorKind::usage, fmt::format(sentence, std::forward<Args>(args)...));
}

/// The usage flag as it is written in code, such as "copy_source".
std::string_view usage_name(BufferUsage flag);

/// The state behind a handle that must not be null. `call` and `what` name the refused call and the kind of object.
template <typename State>
State& not_null(const std::shared_ptr<State>& state, std::string_view call, std::string_view what) {
    if (state == nullptr) {
        refuse("{} needs a {}, but the handle is null; make one with its Device first.", call, what);
    }
    return *state;
}

/// The state of a buffer that is there, belongs to `device`, is not destroyed and has the usage `flag`.
BufferState& require_buffer(const Buffer& buffer, const DeviceState& device, std::string_view call, BufferUsage flag);

/// The state of a query set that is there and belongs to `device`.
QuerySetState& require_query_set(const QuerySet& queries, const DeviceState& device, std::string_view call);

/// Refuses a range that leaves the buffer, or whose offset or size is not a multiple of `alignment` (bytes).
void require_range(const BufferState& buffer, std::string_view call, std::uint64_t offset, std::uint64_t size,
                   std::uint64_t alignment = 4);

/// Refuses group counts over the device's limits, and more items than a 32-bit index can name.
void require_groups(const DeviceState& device, const Kernel& kernel, std::uint32_t groups_x, std::uint32_t groups_y);

}  // namespace tessera::gpu::detail
