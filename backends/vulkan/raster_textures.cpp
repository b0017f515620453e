#include "backends/vulkan/raster_textures.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;

/// CPUs get linear light: llvmpipe decodes sRGB by a polynomial that is off by a code or so.
vk::Format choose_texture_format(const Context& context) {
    return context.properties.deviceType == vk::PhysicalDeviceType::eCpu ? vk::Format::eR16G16B16A16Sfloat
                                                                         : vk::Format::eR8G8B8A8Srgb;
}

/// Linear light of sRGB codes, and behind it of alpha's, as half floats.
std::array<std::uint16_t, 512> make_half_table() {
    std::array<std::uint16_t, 512> table{};
    for (std::size_t code = 0; code < 256; ++code) {
        const double x = static_cast<double>(code) / 255.0;
        const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        table[code] = glm::packHalf1x16(static_cast<float>(linear));
        table[256 + code] = glm::packHalf1x16(static_cast<float>(x));
    }
    return table;
}

/// Writes `pixels` R, G, B, A as half floats.
void write_linear(const std::uint8_t* rgba, std::uint64_t pixels, std::byte* destination) {
    static const std::array<std::uint16_t, 512> table = make_half_table();
    for (std::uint64_t at = 0; at < 4 * pixels; ++at) {
        const std::uint16_t half = table[rgba[at] + (at % 4 == 3 ? 256u : 0u)];
        std::memcpy(destination + 2 * at, &half, 2);
    }
}

vk::ImageMemoryBarrier between(vk::Image image, Layout from, Layout to, vk::AccessFlags before, vk::AccessFlags after) {
    const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, VK_REMAINING_MIP_LEVELS, 0, 1);
    return {before, after, from, to, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image, all};
}

/// Copies one level in bands of rows that fit the stream's arena.
void upload_level(RasterStream& stream, vk::Image image, vk::Format format, const image::Image& pixels,
                  std::uint32_t level) {
    const bool is_linear = format == vk::Format::eR16G16B16A16Sfloat;
    const std::uint64_t row_bytes = std::uint64_t{pixels.width} * (is_linear ? 8 : 4);
    const auto band = static_cast<std::uint32_t>(RasterStream::arena_size / 4 / row_bytes);
    for (std::uint32_t row = 0; row < pixels.height; row += band) {
        const std::uint32_t rows = std::min(band, pixels.height - row);
        const RasterStream::Piece piece = stream.reserve(rows * row_bytes);
        const std::uint8_t* const first = pixels.rgba.data() + std::uint64_t{row} * pixels.width * 4;
        if (is_linear) {
            write_linear(first, std::uint64_t{rows} * pixels.width, piece.data);
        } else {
            std::memcpy(piece.data, first, rows * row_bytes);
        }
        const vk::BufferImageCopy copy(piece.offset, 0, 0, {vk::ImageAspectFlagBits::eColor, level, 0, 1},
                                       {0, static_cast<std::int32_t>(row), 0}, {pixels.width, rows, 1});
        stream.commands().copyBufferToImage(piece.buffer, image, Layout::eTransferDstOptimal, copy);
    }
}

bool holds_pixels(const image::Image& image) {
    return image.width > 0 && image.height > 0 && image.width <= image::max_side && image.height <= image::max_side &&
           image.rgba.size() == std::size_t{image.width} * image.height * 4;
}

}  // namespace

RasterTextures::RasterTextures(const Context& context, vk::DescriptorSetLayout layout)
    : context_(context), layout_(layout) {
    guarded("preparing textures", [&] {
        vk::SamplerCreateInfo info({}, vk::Filter::eLinear, vk::Filter::eLinear, vk::SamplerMipmapMode::eNearest);
        // The shader blends levels.
        info.setMaxLod(VK_LOD_CLAMP_NONE);  // addresses repeat by default
        sampler_ = vk::raii::Sampler(context.device, info);
    });
}

void RasterTextures::upload(RasterStream& stream, const std::vector<scene::Material>& materials,
                            const std::vector<scene::SceneImage>& images) {
    std::vector<std::uint32_t> used;
    for (const scene::Material& material : materials) {
        if (!material.base_color_image) continue;
        if (*material.base_color_image >= images.size()) {
            throw Error(ErrorKind::usage, fmt::format("Material '{}' uses image {}, but there are {}.", material.name,
                                                      *material.base_color_image, images.size()));
        }
        used.push_back(*material.base_color_image);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    stream.finish();  // nothing reads the old textures any more
    textures_.clear();
    white_ = {};
    guarded("uploading textures", [&] {
        const auto count = static_cast<std::uint32_t>(used.size() + 1);
        const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, count);
        pool_ = vk::raii::DescriptorPool(context_.device, vk::DescriptorPoolCreateInfo({}, count, size));
        white_ = create(stream, {1, 1, {255, 255, 255, 255}});
        for (const std::uint32_t index : used) {
            const image::Image& pixels = images[index].pixels;
            if (!holds_pixels(pixels)) {
                throw Error(ErrorKind::usage,
                            fmt::format("Image '{}' ({} x {} pixels, {} bytes) cannot be drawn.", images[index].name,
                                        pixels.width, pixels.height, pixels.rgba.size()));
            }
            textures_.emplace(index, create(stream, pixels));
        }
        stream.submit();
    });
}

vk::DescriptorSet RasterTextures::of(const scene::Material& material) const {
    return material.base_color_image ? textures_.at(*material.base_color_image).set : white_.set;
}

RasterTextures::Texture RasterTextures::create(RasterStream& stream, const image::Image& pixels) {
    image::Image halved;
    const image::Image* level_pixels = &pixels;
    const auto halve = [&] {
        halved = image::halve(*level_pixels);
        level_pixels = &halved;
    };
    const auto longest = [&] { return std::max(level_pixels->width, level_pixels->height); };
    while (longest() > context_.properties.limits.maxImageDimension2D)
        halve();

    const vk::Format format = choose_texture_format(context_);
    const auto levels = static_cast<std::uint32_t>(std::bit_width(longest()));
    const vk::ImageCreateInfo info({}, vk::ImageType::e2D, format, {level_pixels->width, level_pixels->height, 1},
                                   levels, 1, vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                   vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst);
    Texture texture;
    texture.image = create_image(context_, info, "base colour texture");
    const vk::Image image = *texture.image.image;

    using Access = vk::AccessFlagBits;
    stream.commands().pipelineBarrier(
        Stage::eTopOfPipe, Stage::eTransfer, {}, {}, {},
        between(image, Layout::eUndefined, Layout::eTransferDstOptimal, {}, Access::eTransferWrite));
    for (std::uint32_t level = 0; level < levels; ++level) {
        if (level > 0) halve();
        upload_level(stream, image, format, *level_pixels, level);
    }
    stream.commands().pipelineBarrier(Stage::eTransfer, Stage::eFragmentShader, {}, {}, {},
                                      between(image, Layout::eTransferDstOptimal, Layout::eShaderReadOnlyOptimal,
                                              Access::eTransferWrite, Access::eShaderRead));

    texture.view = vk::raii::ImageView(context_.device,
                                       vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format, {},
                                                               {vk::ImageAspectFlagBits::eColor, 0, levels, 0, 1}));
    texture.set =
        (*context_.device).allocateDescriptorSets({*pool_, 1, &layout_}, *context_.device.getDispatcher()).front();
    const vk::DescriptorImageInfo sampled(*sampler_, *texture.view, Layout::eShaderReadOnlyOptimal);
    context_.device.updateDescriptorSets(
        vk::WriteDescriptorSet(texture.set, 0, 0, vk::DescriptorType::eCombinedImageSampler, sampled), {});
    return texture;
}

}  // namespace tessera::backends::vulkan
