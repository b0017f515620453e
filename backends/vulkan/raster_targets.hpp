// What the rasteriser draws into: multisampled colour and depth, and the picture they are averaged into.
#pragma once

#include "backends/vulkan/memory.hpp"

namespace tessera::backends::vulkan {

/// Formats and passes; the same for every image size.
struct RasterPasses {
    static constexpr vk::Format colour_format = vk::Format::eR8G8B8A8Srgb;
    static constexpr vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e4;

    vk::Format depth_format = vk::Format::eUndefined;
    vk::raii::RenderPass clear{nullptr};    ///< empties colour and depth
    vk::raii::RenderPass draw{nullptr};     ///< goes on drawing; compatible with `clear`
    vk::raii::RenderPass resolve{nullptr};  ///< averages into the picture and leaves it ready to be copied
};

/// Throws Error(device_unavailable) where the device cannot draw with 4 samples.
RasterPasses create_raster_passes(const Context& context);

struct RasterImage {
    ImageAllocation image;
    vk::raii::ImageView view{nullptr};
};

/// The images of one size, in bytes 36 per pixel.
struct RasterTargets {
    std::uint32_t width = 0, height = 0;
    RasterImage colour, depth;  ///< 4 samples
    RasterImage picture;        ///< 1 sample
    vk::raii::Framebuffer draw_framebuffer{nullptr};
    vk::raii::Framebuffer resolve_framebuffer{nullptr};
    BufferAllocation readback;  ///< 4 bytes per pixel
};

/// Throws Error(usage) for a size outside [1, 8192] or what the device can draw, Error(device_unavailable) when memory
/// is out.
RasterTargets create_raster_targets(const Context& context, const RasterPasses& passes, std::uint32_t width,
                                    std::uint32_t height);

}  // namespace tessera::backends::vulkan
