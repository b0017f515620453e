#include "backends/vulkan/raster_targets.hpp"

#include <algorithm>
#include <array>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

using ImageUsage = vk::ImageUsageFlagBits;

constexpr std::uint32_t largest_side = 8192;

void require_size(const Context& context, std::uint32_t width, std::uint32_t height) {
    const vk::PhysicalDeviceLimits& limits = context.properties.limits;
    const std::uint32_t largest =
        std::min({largest_side, limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                  limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]});
    if (width == 0 || height == 0 || width > largest || height > largest) {
        throw Error(ErrorKind::usage,
                    fmt::format("A picture of {} x {} pixels cannot be drawn on '{}': sides must be in [1, {}].", width,
                                height, context.properties.deviceName.data(), largest));
    }
}

RasterImage create(const Context& context, vk::Format format, vk::Extent2D size, vk::SampleCountFlagBits samples,
                   vk::ImageUsageFlags usage, vk::ImageAspectFlags aspect, std::string_view label) {
    const vk::ImageCreateInfo info({}, vk::ImageType::e2D, format, vk::Extent3D(size, 1), 1, 1, samples,
                                   vk::ImageTiling::eOptimal, usage);
    RasterImage result;
    result.image = create_image(context, info, label);
    result.view = vk::raii::ImageView(
        context.device, vk::ImageViewCreateInfo({}, *result.image.image, vk::ImageViewType::e2D, format, {},
                                                vk::ImageSubresourceRange(aspect, 0, 1, 0, 1)));
    return result;
}

}  // namespace

RasterTargets create_raster_targets(const Context& context, const RasterPasses& passes, std::uint32_t width,
                                    std::uint32_t height) {
    require_size(context, width, height);
    return guarded(fmt::format("preparing a picture of {} x {} pixels", width, height), [&] {
        const vk::Extent2D size(width, height);
        RasterTargets targets;
        targets.width = width;
        targets.height = height;
        targets.colour =
            create(context, passes.colour_format, size, passes.samples,
                   ImageUsage::eColorAttachment | ImageUsage::eSampled, vk::ImageAspectFlagBits::eColor, "colour");
        targets.depth = create(context, passes.depth_format, size, passes.samples, ImageUsage::eDepthStencilAttachment,
                               vk::ImageAspectFlagBits::eDepth, "depth");
        targets.picture =
            create(context, passes.colour_format, size, vk::SampleCountFlagBits::e1,
                   ImageUsage::eColorAttachment | ImageUsage::eTransferSrc, vk::ImageAspectFlagBits::eColor, "picture");
        const std::array drawn = {*targets.colour.view, *targets.depth.view};
        targets.draw_framebuffer =
            vk::raii::Framebuffer(context.device, vk::FramebufferCreateInfo({}, *passes.draw, drawn, width, height, 1));
        targets.resolve_framebuffer = vk::raii::Framebuffer(
            context.device, vk::FramebufferCreateInfo({}, *passes.resolve, *targets.picture.view, width, height, 1));
        targets.readback = create_buffer(context, std::uint64_t{width} * height * 4,
                                         vk::BufferUsageFlagBits::eTransferDst, MemoryUse::readback, "picture to read");
        return targets;
    });
}

}  // namespace tessera::backends::vulkan
