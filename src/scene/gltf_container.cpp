#include "scene/gltf_container.hpp"

#include "scene/limits.hpp"

#include <fmt/format.h>
#include <cstdint>

namespace tessera::scene {
namespace {

constexpr std::uint32_t glb_magic = 0x46546c67;   // "glTF"
constexpr std::uint32_t json_chunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t bin_chunk = 0x004e4942;   // "BIN\0"
constexpr std::size_t header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;

/// Little-endian, whatever the machine; the caller has checked the range.
std::uint32_t read_u32(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Container open_glb(std::span<const std::byte> file, const Diagnostics& diagnostics) {
    if (file.size() < header_bytes) {
        diagnostics.refuse("the GLB header", fmt::format("needs 12 bytes, but the file has {}", file.size()));
    }
    const std::uint32_t version = read_u32(file, 4);
    if (version != 2) diagnostics.refuse("the GLB header", fmt::format("has version {}, but only 2 is read", version));
    const std::uint32_t length = read_u32(file, 8);
    if (length != file.size()) {
        diagnostics.refuse("the GLB header",
                           fmt::format("gives a length of {} bytes, but the file has {}", length, file.size()));
    }
    Container container;
    std::size_t at = header_bytes;
    for (std::size_t chunk = 0; at < file.size(); ++chunk) {
        const std::string element = fmt::format("GLB chunk {}", chunk);
        const std::size_t left = file.size() - at;
        if (left < chunk_header_bytes) {
            diagnostics.refuse(element, fmt::format("needs a header of 8 bytes, but {} are left", left));
        }
        const std::uint32_t size = read_u32(file, at);
        const std::uint32_t type = read_u32(file, at + 4);
        if (size > left - chunk_header_bytes) {
            diagnostics.refuse(
                element, fmt::format("gives a length of {} bytes, but {} are left", size, left - chunk_header_bytes));
        }
        const auto data = file.subspan(at + chunk_header_bytes, size);
        if ((chunk == 0) != (type == json_chunk)) {
            diagnostics.refuse(element, fmt::format("has type {:#010x}, but JSON must be the first chunk and the "
                                                    "first only",
                                                    type));
        }
        if (chunk == 0) container.json = as_text(data);
        if (chunk == 1 && type == bin_chunk) container.binary = data;
        at += chunk_header_bytes + size;
    }
    if (container.json.empty()) diagnostics.refuse("the GLB file", "has no JSON in it");
    return container;
}

}  // namespace

Container open_container(std::span<const std::byte> file, const Diagnostics& diagnostics) {
    if (file.empty()) diagnostics.refuse("the file", "is empty");
    Container container;
    if (file.size() >= 4 && read_u32(file, 0) == glb_magic) {
        container = open_glb(file, diagnostics);
    } else {
        container.json = as_text(file);
        const std::size_t first = container.json.find_first_not_of(" \t\r\n\xef\xbb\xbf");
        if (first == std::string_view::npos || container.json[first] != '{') {
            diagnostics.refuse("the file", "starts neither with the GLB magic number nor with a JSON object");
        }
    }
    if (container.json.size() > max_json_bytes) {
        diagnostics.refuse("the JSON text", fmt::format("has {} bytes, more than the {} supported",
                                                        container.json.size(), max_json_bytes));
    }
    return container;
}

}  // namespace tessera::scene
