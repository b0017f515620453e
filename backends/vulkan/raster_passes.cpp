// The render passes of the rasteriser.
#include <array>

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/raster_targets.hpp"

namespace tessera::backends::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;

vk::Format choose_depth_format(const Context& context) {
    for (const vk::Format format : {vk::Format::eD32Sfloat, vk::Format::eX8D24UnormPack32, vk::Format::eD16Unorm}) {
        const vk::FormatProperties properties = context.physical.getFormatProperties(format);
        if (properties.optimalTilingFeatures & vk::FormatFeatureFlagBits::eDepthStencilAttachment) return format;
    }
    return vk::Format::eD16Unorm;  // Vulkan requires it
}

/// Draws into colour and depth. Between two such passes, of one submission or of two, writes are finished before they
/// are read or written again; reading by the resolve of an earlier picture is over as well.
vk::raii::RenderPass create_draw_pass(const Context& context, const RasterPasses& passes, bool clears) {
    const auto load = clears ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad;
    const auto attachment = [&](vk::Format format, Layout layout) {
        return vk::AttachmentDescription({}, format, passes.samples, load, vk::AttachmentStoreOp::eStore,
                                         vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                         clears ? Layout::eUndefined : layout, layout);
    };
    const std::array attachments = {
        attachment(passes.colour_format, Layout::eColorAttachmentOptimal),
        attachment(passes.depth_format, Layout::eDepthStencilAttachmentOptimal),
    };
    const vk::AttachmentReference colour(0, Layout::eColorAttachmentOptimal);
    const vk::AttachmentReference depth(1, Layout::eDepthStencilAttachmentOptimal);
    vk::SubpassDescription subpass;
    subpass.setColorAttachments(colour).setPDepthStencilAttachment(&depth);
    const auto targets = Stage::eColorAttachmentOutput | Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
    const auto writes = Access::eColorAttachmentWrite | Access::eDepthStencilAttachmentWrite;
    const auto reads = Access::eColorAttachmentRead | Access::eDepthStencilAttachmentRead;
    const vk::SubpassDependency before(VK_SUBPASS_EXTERNAL, 0, targets | Stage::eFragmentShader, targets, writes,
                                       writes | reads);
    vk::RenderPassCreateInfo info;
    info.setAttachments(attachments).setSubpasses(subpass).setDependencies(before);
    return vk::raii::RenderPass(context.device, info);
}

vk::raii::RenderPass create_resolve_pass(const Context& context, const RasterPasses& passes) {
    const vk::AttachmentDescription picture({}, passes.colour_format, vk::SampleCountFlagBits::e1,
                                            vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eStore,
                                            vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                            Layout::eUndefined, Layout::eTransferSrcOptimal);
    const vk::AttachmentReference colour(0, Layout::eColorAttachmentOptimal);
    vk::SubpassDescription subpass;
    subpass.setColorAttachments(colour);
    const std::array dependencies = {
        // The picture before has been copied out.
        vk::SubpassDependency(VK_SUBPASS_EXTERNAL, 0, Stage::eTransfer, Stage::eColorAttachmentOutput, {},
                              Access::eColorAttachmentWrite),
        vk::SubpassDependency(0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput, Stage::eTransfer,
                              Access::eColorAttachmentWrite, Access::eTransferRead),
    };
    vk::RenderPassCreateInfo info;
    info.setAttachments(picture).setSubpasses(subpass).setDependencies(dependencies);
    return vk::raii::RenderPass(context.device, info);
}

}  // namespace

RasterPasses create_raster_passes(const Context& context) {
    const vk::PhysicalDeviceLimits& limits = context.properties.limits;
    const vk::SampleCountFlags drawn = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
    if (!(context.queue_properties.queueFlags & vk::QueueFlagBits::eGraphics) || !(drawn & RasterPasses::samples) ||
        !(limits.sampledImageColorSampleCounts & RasterPasses::samples)) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The Vulkan device '{}' cannot draw triangles with 4 samples per pixel; choose another "
                                "device.",
                                context.properties.deviceName.data()));
    }
    return guarded("preparing to draw", [&] {
        RasterPasses passes;
        passes.depth_format = choose_depth_format(context);
        passes.clear = create_draw_pass(context, passes, true);
        passes.draw = create_draw_pass(context, passes, false);
        passes.resolve = create_resolve_pass(context, passes);
        return passes;
    });
}

}  // namespace tessera::backends::vulkan
