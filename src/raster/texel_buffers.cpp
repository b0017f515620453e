#include "raster/texel_buffers.hpp"

#include "base/error.hpp"
#include "raster/srgb_tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>

namespace tessera::raster {
namespace {

bool holds_pixels(const image::Image& image) {
    return image.width > 0 && image.height > 0 && image.width <= image::max_side && image.height <= image::max_side &&
           image.rgba.size() == std::size_t{image.width} * image.height * 4;
}

const image::Image& pixels_of(const scene::Material& material, std::uint32_t index,
                              const std::vector<scene::SceneImage>& images) {
    if (index >= images.size()) {
        throw Error(ErrorKind::usage,
                    fmt::format("Material '{}' uses image {}, but there are {}.", material.name, index, images.size()));
    }
    const image::Image& pixels = images[index].pixels;
    if (!holds_pixels(pixels)) {
        throw Error(ErrorKind::usage, fmt::format("Image '{}' ({} x {} pixels, {} bytes) cannot be drawn.",
                                                  images[index].name, pixels.width, pixels.height, pixels.rgba.size()));
    }
    return pixels;
}

}  // namespace

TexelBuffers::TexelBuffers(const gpu::Device& device) : device_(device), tables_(make_srgb_tables()) {
    plain_.buffer = create(header(Look{}));
}

std::vector<std::uint32_t> TexelBuffers::header(const Look& look) const {
    std::vector<std::uint32_t> words = tables_;
    words.insert(words.end(), look.begin(), look.end());
    return words;
}

gpu::Buffer TexelBuffers::create(const std::vector<std::uint32_t>& words) {
    return gpu::create_filled_buffer(device_, "textures of a material", std::as_bytes(std::span(words)));
}

std::uint64_t TexelBuffers::most_words() const {
    return std::min(device_.limits().max_storage_binding_size, device_.limits().max_buffer_size) / 4 - TEXELS_AT;
}

void TexelBuffers::upload(const std::vector<scene::Material>& materials, const std::vector<scene::SceneImage>& images,
                          const Look& look, TexturesFor what) {
    textures_.clear();
    of_material_.clear();
    const std::vector<std::uint32_t> head = header(look);
    device_.queue().write_buffer(plain_.buffer, 0, std::as_bytes(std::span(head)));
    for (const scene::Material& material : materials) {
        if (what == TexturesFor::pbr) {
            of_material_.push_back(&add_maps(material, images, look));
        } else if (material.base_color_image) {
            const std::uint32_t index = *material.base_color_image;
            of_material_.push_back(&add_base_colour(index, pixels_of(material, index, images), look));
        } else {
            of_material_.push_back(&plain_);
        }
    }
}

TexelBuffers::Levels TexelBuffers::make_levels(const image::Image& pixels, std::uint64_t most) {
    image::Image halved;
    const image::Image* level = &pixels;
    const auto halve = [&] {
        halved = image::halve(*level);
        level = &halved;
    };
    // All levels together take less than half as much again as the first (a third, and rounding of narrow images).
    while (std::uint64_t{level->width} * level->height * 3 / 2 + 2 * image::max_side > most &&
           (level->width > 1 || level->height > 1)) {
        halve();
    }
    Levels levels{level->width, level->height, {}};
    const int count = std::bit_width(std::max(level->width, level->height));
    for (int i = 0; i < count; ++i) {
        if (i > 0) halve();
        std::vector<std::uint32_t>& words = levels.texels.emplace_back();
        words.reserve(level->rgba.size() / 4);
        for (std::size_t at = 0; at < level->rgba.size(); at += 4) {
            const std::uint8_t* p = &level->rgba[at];
            words.push_back(p[0] | p[1] << 8u | p[2] << 16u | std::uint32_t{p[3]} << 24u);
        }
    }
    return levels;
}

const TexelBuffer& TexelBuffers::add_base_colour(std::uint32_t index, const image::Image& pixels, const Look& look) {
    const auto [found, is_new] = textures_.try_emplace({index});
    if (!is_new) return found->second;
    const Levels levels = make_levels(pixels, most_words());
    std::vector<std::uint32_t> words = header(look);
    for (std::size_t i = 0; i < levels.texels.size(); ++i) {
        words[LEVELS_AT + i] = static_cast<std::uint32_t>(words.size());
        words.insert(words.end(), levels.texels[i].begin(), levels.texels[i].end());
    }
    found->second = {create(words), levels.width, levels.height, static_cast<std::uint32_t>(levels.texels.size())};
    return found->second;
}

const TexelBuffer& TexelBuffers::add_maps(const scene::Material& material, const std::vector<scene::SceneImage>& images,
                                          Look look) {
    set_material(look, material);
    const std::vector<MapUse> maps = maps_of(material);
    std::vector<std::uint32_t> key(look.begin(), look.end());
    for (const MapUse& use : maps)
        key.push_back(use.map.image);
    const auto [found, is_new] = textures_.try_emplace(std::move(key));
    if (!is_new) return found->second;
    std::vector<std::uint32_t> words(TEXELS_AT);
    std::map<std::uint32_t, std::size_t> first_use;  // a map of the same image: its texels are there
    std::vector<std::vector<std::uint32_t>> starts(maps.size());
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const std::uint32_t index = maps[m].map.image;
        const image::Image& pixels = pixels_of(material, index, images);
        const auto [first, unseen] = first_use.emplace(index, m);
        if (unseen) {
            const Levels levels = make_levels(pixels, most_words() / maps.size());
            for (const std::vector<std::uint32_t>& texels : levels.texels) {
                starts[m].push_back(static_cast<std::uint32_t>(words.size()));
                words.insert(words.end(), texels.begin(), texels.end());
            }
            set_map_levels(look, m, levels.width, levels.height, starts[m]);
        } else {
            const std::size_t at = MAPS_AT - LOOK_AT + first->second * MAP_WORDS;
            set_map_levels(look, m, look[at + 1], look[at + 2], starts[first->second]);
        }
    }
    const std::vector<std::uint32_t> head = header(look);
    std::copy(head.begin(), head.end(), words.begin());
    found->second = {create(words), 0, 0, 0};
    return found->second;
}

}  // namespace tessera::raster
