// PNG and JPEG through stb, with every size checked first.
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "image/image.hpp"
#include "image/jpeg_check.hpp"
#include "image/stb.hpp"

#include <fmt/format.h>
#include <limits>
#include <memory>

namespace tessera::image {

namespace {

constexpr int channels = 4;

struct StbFree {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

/// stb's output callback: `context` is a vector of bytes.
void append(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::byte>*>(context);
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

void require_sound(const Image& image) {
    if (image.width == 0 || image.height == 0 || image.width > max_side || image.height > max_side) {
        throw Error(ErrorKind::output,
                    fmt::format("A PNG of {} x {} pixels cannot be written: sides must be in [1, {}].", image.width,
                                image.height, max_side));
    }
    const std::size_t expected = std::size_t{image.width} * image.height * channels;
    if (image.rgba.size() != expected) {
        throw Error(ErrorKind::output, fmt::format("An image of {} x {} pixels holds {} bytes instead of {}.",
                                                   image.width, image.height, image.rgba.size(), expected));
    }
}

}  // namespace

Image decode(std::span<const std::byte> bytes, const std::string& name) {
    const auto refuse = [&](const std::string& reason) -> Error {
        return {ErrorKind::usage, fmt::format("Image '{}' cannot be read: {}.", name, reason)};
    };
    if (bytes.empty()) throw refuse("it is empty");
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw refuse(fmt::format("{} bytes are more than the 2 GiB that can be decoded", bytes.size()));
    }
    if (!jpeg_tables_fit(bytes)) throw refuse("a Huffman table of the JPEG has more than 256 codes");
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int ignored_channels = 0;
    // stb checks its own limit while it reads the header and then says "too large".
    if (stbi_info_from_memory(data, size, &width, &height, &ignored_channels) == 0) {
        throw refuse(
            fmt::format("it is no sound PNG or JPEG with sides up to {} pixels ({})", max_side, stbi_failure_reason()));
    }
    if (width <= 0 || height <= 0 || width > static_cast<int>(max_side) || height > static_cast<int>(max_side)) {
        throw refuse(fmt::format("{} x {} pixels are outside [1, {}]", width, height, max_side));
    }
    const std::unique_ptr<stbi_uc, StbFree> pixels(
        stbi_load_from_memory(data, size, &width, &height, &ignored_channels, channels));
    if (!pixels) throw refuse(fmt::format("it is damaged ({})", stbi_failure_reason()));
    Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
    image.rgba.assign(pixels.get(), pixels.get() + std::size_t{image.width} * image.height * channels);
    return image;
}

std::vector<std::byte> encode_png(const Image& image) {
    require_sound(image);
    std::vector<std::byte> png;
    const auto width = static_cast<int>(image.width);
    const auto height = static_cast<int>(image.height);
    if (stbi_write_png_to_func(append, &png, width, height, channels, image.rgba.data(), width * channels) == 0) {
        throw Error(ErrorKind::output, "A PNG could not be encoded: memory ran out.");
    }
    return png;
}

void write_png(const Image& image, const std::filesystem::path& path) {
    write_file(path, encode_png(image));
}

}  // namespace tessera::image
