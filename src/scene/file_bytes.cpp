#include "scene/file_bytes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <fstream>
#include <system_error>

namespace tessera::scene {

FileBytes read_file(const std::filesystem::path& path, std::uint64_t limit, bool cut) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return {{}, "does not exist"};
    // A pipe or device could block for ever or never end.
    if (!std::filesystem::is_regular_file(status)) return {{}, "is not a regular file"};
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) return {{}, fmt::format("cannot be read ({})", error.message())};
    if (size > limit && !cut) return {{}, fmt::format("has {} bytes, more than the {} supported", size, limit)};

    std::ifstream in(path, std::ios::binary);
    if (!in) return {{}, "cannot be opened for reading"};
    FileBytes result;
    result.bytes.resize(std::min(size, limit));
    in.read(reinterpret_cast<char*>(result.bytes.data()), static_cast<std::streamsize>(result.bytes.size()));
    if (static_cast<std::uint64_t>(in.gcount()) != result.bytes.size()) {
        return {{}, fmt::format("ended after {} of {} bytes", in.gcount(), result.bytes.size())};
    }
    return result;
}

}  // namespace tessera::scene
