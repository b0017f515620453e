// A glTF document on its way in: what the JSON text says, checked, and the bytes it refers to.
#pragma once

#include "scene/diagnostics.hpp"

#include <tiny_gltf.h>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera::scene {

struct BufferSource {
    std::string uri;  ///< empty for the BIN chunk of a GLB
    std::uint64_t byte_length = 0;
};

struct ImageSource {
    std::string name;
    std::string uri;  ///< empty if the image is in a buffer view
    std::optional<std::int64_t> buffer_view;
};

/// A camera as the JSON text has it; nothing but types is checked.
struct CameraSource {
    std::string name;
    bool orthographic = false;
    std::optional<double> field_of_view, aspect, half_width, half_height, near_plane, far_plane;
};

/// The members of the JSON text that this library reads, with types, ranges and references checked. Buffers and
/// images, whose bytes come from outside the JSON, are kept apart, and cameras, about which tinygltf is strict.
struct CheckedJson {
    nlohmann::json json;
    std::vector<BufferSource> buffers;
    std::vector<ImageSource> images;
    std::vector<CameraSource> cameras;
};

struct Document {
    tinygltf::Model model;                            ///< without its buffers and images
    std::vector<std::span<const std::byte>> buffers;  ///< as long as each buffer's byteLength
    std::vector<ImageSource> images;
    std::vector<CameraSource> cameras;
    std::filesystem::path folder;
    Diagnostics& diagnostics;
    bool all_maps = false;  ///< LoadOptions::all_maps
};

/// Checks everything that can be checked in the JSON text alone, and the extensions. What only `all_maps` wants is not
/// looked at without it. Throws Error(usage).
CheckedJson check_json(const nlohmann::json& document, Diagnostics& diagnostics, bool all_maps = false);

/// Lets tinygltf make its typed model of checked JSON. Throws Error(usage) if it will not.
tinygltf::Model parse_model(const nlohmann::json& checked, const Diagnostics& diagnostics);

/// The bytes of every buffer. `storage` owns those that are not in the file itself. Throws Error(usage).
std::vector<std::span<const std::byte>> load_buffers(const std::vector<BufferSource>& sources,
                                                     std::optional<std::span<const std::byte>> binary,
                                                     const std::filesystem::path& folder,
                                                     std::vector<std::vector<std::byte>>& storage,
                                                     const Diagnostics& diagnostics);

/// Checks what needs the bytes or looks across elements: ranges of views and accessors, formats and counts of
/// attributes, the node hierarchy, skins. After it every accessor can be read. Throws Error(usage).
void check_model(const Document& document);

}  // namespace tessera::scene
