// The two kinds of URI that glTF uses: data in place, and a file beside the document.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tessera::scene {

bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI (RFC 2397), or nothing if it is not one or not well formed.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// Where a relative URI points (percent-decoded, RFC 3986): a path inside `folder`, or the reason why it is not
/// taken. Absolute paths, schemes and paths that leave the folder are refused: a model may not name any other file
/// of the machine. Symbolic links inside the folder are followed.
struct LocalPath {
    std::filesystem::path path;
    std::optional<std::string> problem;
};
LocalPath resolve_uri(std::string_view uri, const std::filesystem::path& folder);

/// The same for a plain path, in which a percent sign is nothing special.
LocalPath resolve_path(const std::string& name, const std::filesystem::path& folder);

}  // namespace tessera::scene
