#include "scene/file_bytes.hpp"
#include "scene/gltf_document.hpp"
#include "scene/limits.hpp"
#include "scene/uri.hpp"

#include <fmt/format.h>

namespace tessera::scene {
namespace {

std::vector<std::byte> load_outside(const BufferSource& source, const std::string& element,
                                    const std::filesystem::path& folder, const Diagnostics& diagnostics) {
    if (is_data_uri(source.uri)) {
        auto bytes = decode_data_uri(source.uri);
        if (!bytes) diagnostics.refuse(element + ".uri", "is not well-formed base64 data: " + in_quotes(source.uri));
        return std::move(*bytes);
    }
    const LocalPath local = resolve_uri(source.uri, folder);
    if (local.problem) diagnostics.refuse(element + ".uri " + in_quotes(source.uri), *local.problem);
    FileBytes file = read_file(local.path, source.byte_length, true);
    if (file.problem) diagnostics.refuse(element + ".uri: the file " + in_quotes(source.uri), *file.problem);
    return std::move(file.bytes);
}

}  // namespace

std::vector<std::span<const std::byte>> load_buffers(const std::vector<BufferSource>& sources,
                                                     std::optional<std::span<const std::byte>> binary,
                                                     const std::filesystem::path& folder,
                                                     std::vector<std::vector<std::byte>>& storage,
                                                     const Diagnostics& diagnostics) {
    std::vector<std::span<const std::byte>> buffers;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string element = fmt::format("buffers[{}]", i);
        total += sources[i].byte_length;
        if (total > max_buffer_bytes) {
            diagnostics.refuse(element, fmt::format("brings the buffers to {} bytes, more than the {} supported", total,
                                                    max_buffer_bytes));
        }
        std::span<const std::byte> bytes;
        if (sources[i].uri.empty()) {
            if (i != 0 || !binary) {
                diagnostics.refuse(element,
                                   "has no uri, and only the first buffer of a .glb may take its BIN chunk; "
                                   "data that an extension would decompress are not supported");
            }
            bytes = *binary;
        } else {
            storage.push_back(load_outside(sources[i], element, folder, diagnostics));
            bytes = storage.back();
        }
        if (bytes.size() < sources[i].byte_length) {
            diagnostics.refuse(element + ".byteLength",
                               fmt::format("is {}, but there are only {} bytes", sources[i].byte_length, bytes.size()));
        }
        buffers.push_back(bytes.first(sources[i].byte_length));
    }
    return buffers;
}

}  // namespace tessera::scene
