#include "raster/texel_buffers.hpp"

#include "base/error.hpp"
#include "raster/raster_layout.h"
#include "raster/srgb_tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>

namespace tessera::raster {
namespace {

using gpu::BufferUsage;

bool holds_pixels(const image::Image& image) {
    return image.width > 0 && image.height > 0 && image.width <= image::max_side && image.height <= image::max_side &&
           image.rgba.size() == std::size_t{image.width} * image.height * 4;
}

}  // namespace

TexelBuffers::TexelBuffers(const gpu::Device& device) : device_(device), tables_(make_srgb_tables()) {
    plain_.buffer = device_.create_buffer(
        {"sRGB tables", tables_.size() * 4, BufferUsage::storage | BufferUsage::copy_destination});
    device_.queue().write_buffer(plain_.buffer, 0, std::as_bytes(std::span(tables_)));
}

void TexelBuffers::upload(const std::vector<scene::Material>& materials, const std::vector<scene::SceneImage>& images) {
    textures_.clear();
    for (const scene::Material& material : materials) {
        if (!material.base_color_image) continue;
        const std::uint32_t index = *material.base_color_image;
        if (index >= images.size()) {
            throw Error(ErrorKind::usage, fmt::format("Material '{}' uses image {}, but there are {}.", material.name,
                                                      index, images.size()));
        }
        if (textures_.contains(index)) continue;
        const image::Image& pixels = images[index].pixels;
        if (!holds_pixels(pixels)) {
            throw Error(ErrorKind::usage,
                        fmt::format("Image '{}' ({} x {} pixels, {} bytes) cannot be drawn.", images[index].name,
                                    pixels.width, pixels.height, pixels.rgba.size()));
        }
        textures_.emplace(index, create(pixels));
    }
}

const TexelBuffer& TexelBuffers::of(const scene::Material& material) const {
    return material.base_color_image ? textures_.at(*material.base_color_image) : plain_;
}

TexelBuffer TexelBuffers::create(const image::Image& pixels) {
    image::Image halved;
    const image::Image* level = &pixels;
    const auto halve = [&] {
        halved = image::halve(*level);
        level = &halved;
    };
    // All levels together take less than half as much again as the first (a third, and rounding of narrow images).
    const std::uint64_t most = std::min(device_.limits().max_storage_binding_size, device_.limits().max_buffer_size);
    while ((std::uint64_t{level->width} * level->height * 3 / 2 + 2 * image::max_side + TEXELS_AT) * 4 > most) {
        halve();
    }
    TexelBuffer texture;
    texture.width = level->width;
    texture.height = level->height;
    texture.levels = static_cast<std::uint32_t>(std::bit_width(std::max(level->width, level->height)));
    std::vector<std::uint32_t> words = tables_;
    for (std::uint32_t i = 0; i < texture.levels; ++i) {
        if (i > 0) halve();
        words[LEVELS_AT + i] = static_cast<std::uint32_t>(words.size());
        for (std::size_t at = 0; at < level->rgba.size(); at += 4) {
            const std::uint8_t* p = &level->rgba[at];
            words.push_back(p[0] | p[1] << 8u | p[2] << 16u | std::uint32_t{p[3]} << 24u);
        }
    }
    texture.buffer = device_.create_buffer(
        {"base colour texture", words.size() * 4, BufferUsage::storage | BufferUsage::copy_destination});
    device_.queue().write_buffer(texture.buffer, 0, std::as_bytes(std::span(words)));
    return texture;
}

}  // namespace tessera::raster
