// Compiled pipelines kept on disk between runs, one file per device and driver version, in $XDG_CACHE_HOME/tessera or
// ~/.cache/tessera. Where the folder cannot be read or written there is no cache, and nothing is said.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "backends/vulkan/context.hpp"

namespace tessera::backends::vulkan {

class PipelineCache {
public:
    explicit PipelineCache(const Context& context);
    ~PipelineCache();  ///< writes the file where its content is new
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    const vk::raii::PipelineCache& handle() const { return handle_; }

private:
    std::optional<std::filesystem::path> file_;
    std::vector<std::byte> loaded_;
    vk::raii::PipelineCache handle_{nullptr};
};

/// Where the cache of this device lies; nothing where the environment names no folder.
std::optional<std::filesystem::path> cache_file(const Context& context);

/// `data` with the header that guards it: mark, length and hash. Drivers trust what they are handed.
std::vector<std::byte> seal(std::span<const std::byte> data);

/// What seal() was given, or nothing where the file was cut, altered, or is of another kind.
std::optional<std::vector<std::byte>> unseal(std::span<const std::byte> file);

/// True where Vulkan's own header in `data` names this device and driver.
bool made_by(std::span<const std::byte> data, const vk::PhysicalDeviceProperties& properties);

}  // namespace tessera::backends::vulkan
