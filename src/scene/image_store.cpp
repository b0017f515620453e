#include "scene/image_store.hpp"

#include "base/error.hpp"
#include "scene/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

namespace tessera::scene {
namespace {

/// The type by content: what files say about it is often wrong.
std::string mime_type(const std::vector<std::byte>& bytes) {
    const auto starts_with = [&](const auto& magic) {
        return bytes.size() >= magic.size() &&
               std::equal(magic.begin(), magic.end(), bytes.begin(),
                          [](unsigned char a, std::byte b) { return std::byte{a} == b; });
    };
    if (starts_with(std::array<unsigned char, 4>{0x89, 'P', 'N', 'G'})) return "image/png";
    if (starts_with(std::array<unsigned char, 3>{0xff, 0xd8, 0xff})) return "image/jpeg";
    return "";
}

}  // namespace

std::optional<std::uint32_t> ImageStore::drop(const std::string& element, const std::string& reason) {
    diagnostics_.note(fmt::format("{} {}: it is left out.", element, reason));
    return std::nullopt;
}

std::optional<std::uint32_t> ImageStore::add(std::vector<std::byte> encoded, const std::string& name,
                                             const std::string& element) {
    SceneImage image;
    image.mime_type = mime_type(encoded);
    if (image.mime_type.empty()) return drop(element, "is neither PNG nor JPEG");
    image.name = name;
    image.encoded = std::move(encoded);
    try {
        image.pixels = image::decode(image.encoded, element);
    } catch (const Error& error) {
        return drop(element, fmt::format("cannot be decoded ({})", error.what()));
    }
    decoded_bytes_ += image.pixels.rgba.size();
    if (decoded_bytes_ > max_image_bytes) {
        diagnostics_.refuse(element, fmt::format("brings the decoded images to {} bytes, more than the {} supported",
                                                 decoded_bytes_, max_image_bytes));
    }
    scene_.images.push_back(std::move(image));
    return static_cast<std::uint32_t>(scene_.images.size() - 1);
}

}  // namespace tessera::scene
