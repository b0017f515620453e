#include "backends/vulkan/pipeline_cache.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

namespace fs = std::filesystem;

struct Header {
    char mark[8] = {'T', 'E', 'S', 'S', 'V', 'K', 'P', '1'};
    std::uint64_t length = 0;
    std::uint64_t hash = 0;
};

std::uint64_t fnv1a(std::span<const std::byte> data) {
    std::uint64_t hash = 14695981039346656037ull;
    for (const std::byte b : data)
        hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 1099511628211ull;
    return hash;
}

std::optional<fs::path> cache_folder() {
    const char* set = std::getenv("XDG_CACHE_HOME");
    if (set != nullptr && fs::path(set).is_absolute()) return fs::path(set) / "tessera";
    const char* home = std::getenv("HOME");
    if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".cache" / "tessera";
    return std::nullopt;
}

std::vector<std::byte> load(const fs::path& path) {
    constexpr std::size_t most = 256u << 20;  // far above any cache of ours: such a file is not one
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed || size < sizeof(Header) || size > most) return {};
    std::vector<std::byte> bytes(size);
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    return in ? bytes : std::vector<std::byte>();
}

/// Another process sees the old file or the new one, never a part.
void store(const fs::path& path, std::span<const std::byte> bytes) {
    std::error_code failed;
    fs::create_directories(path.parent_path(), failed);
    if (failed) return;
    const fs::path temporary = path.string() + fmt::format(".{}.tmp", ::getpid());
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) fs::rename(temporary, path, failed);
    if (!out || failed) fs::remove(temporary, failed);
}

}  // namespace

std::vector<std::byte> seal(std::span<const std::byte> data) {
    Header header;
    header.length = data.size();
    header.hash = fnv1a(data);
    std::vector<std::byte> file(sizeof header + data.size());
    std::memcpy(file.data(), &header, sizeof header);
    std::copy(data.begin(), data.end(), file.begin() + sizeof header);
    return file;
}

std::optional<std::vector<std::byte>> unseal(std::span<const std::byte> file) {
    const Header expected;
    Header header;
    if (file.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, file.data(), sizeof header);
    const auto data = file.subspan(sizeof header);
    if (std::memcmp(header.mark, expected.mark, sizeof header.mark) != 0 || header.length != data.size() ||
        header.hash != fnv1a(data)) {
        return std::nullopt;
    }
    return std::vector<std::byte>(data.begin(), data.end());
}

bool made_by(std::span<const std::byte> data, const vk::PhysicalDeviceProperties& properties) {
    VkPipelineCacheHeaderVersionOne header{};
    if (data.size() < sizeof header) return false;
    std::memcpy(&header, data.data(), sizeof header);
    return header.headerSize >= sizeof header && header.headerSize <= data.size() &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendorID == properties.vendorID &&
           header.deviceID == properties.deviceID &&
           std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID.data(), VK_UUID_SIZE) == 0;
}

std::optional<fs::path> cache_file(const Context& context) {
    const auto folder = cache_folder();
    if (!folder) return std::nullopt;
    const auto chain = context.physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceIDProperties>();
    const auto& uuid = chain.get<vk::PhysicalDeviceIDProperties>().deviceUUID;
    return *folder / fmt::format("vulkan-{:02x}-{:08x}.bin", fmt::join(uuid.begin(), uuid.end(), ""),
                                 context.properties.driverVersion);
}

PipelineCache::PipelineCache(const Context& context) : file_(cache_file(context)) {
    if (file_) {
        if (auto data = unseal(load(*file_)); data && made_by(*data, context.properties)) loaded_ = std::move(*data);
    }
    guarded("creating the pipeline cache", [&] {
        handle_ =
            vk::raii::PipelineCache(context.device, vk::PipelineCacheCreateInfo({}, loaded_.size(), loaded_.data()));
    });
}

PipelineCache::~PipelineCache() {
    if (!file_) return;
    try {
        const std::vector<std::uint8_t> data = handle_.getData();
        const auto bytes = std::as_bytes(std::span(data));
        if (!std::equal(bytes.begin(), bytes.end(), loaded_.begin(), loaded_.end())) store(*file_, seal(bytes));
    } catch (const std::exception&) {
        // A cache that cannot be saved costs the next run some time, nothing else.
    }
}

}  // namespace tessera::backends::vulkan
