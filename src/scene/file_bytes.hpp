// Whole files into memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tessera::scene {

/// The bytes of a file, or why there are none (a clause that follows the file's name).
struct FileBytes {
    std::vector<std::byte> bytes;
    std::optional<std::string> problem;
};

/// Reads a regular file, at most `limit` bytes of it; a longer file is a problem unless `cut` is set.
FileBytes read_file(const std::filesystem::path& path, std::uint64_t limit, bool cut = false);

}  // namespace tessera::scene
