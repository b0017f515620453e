#include "backends/vulkan/timed_draw_pipeline.hpp"

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/fixed_function_modes.hpp"
#include "backends/vulkan/fixed_function_shaders.hpp"
#include "backends/vulkan/shader_module.hpp"

namespace tessera::backends::vulkan {
namespace {

using ShaderStage = vk::ShaderStageFlagBits;

constexpr vk::Format colour_format = vk::Format::eR8G8B8A8Unorm;

void create_target(const Context& context, TimedPipeline& timed, bool drawn) {
    const vk::AttachmentDescription colour({}, colour_format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eClear,
                                           vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                           vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eUndefined,
                                           vk::ImageLayout::eColorAttachmentOptimal);
    const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
    vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics);
    vk::RenderPassCreateInfo pass({}, {}, subpass);
    if (drawn) {
        subpass.setColorAttachments(reference);
        pass.setAttachments(colour);
    }
    timed.pass = vk::raii::RenderPass(context.device, pass);
    vk::FramebufferCreateInfo framebuffer({}, *timed.pass, 0, nullptr, TimedPipeline::side, TimedPipeline::side, 1);
    if (drawn) {
        const vk::ImageCreateInfo info(
            {}, vk::ImageType::e2D, colour_format, vk::Extent3D(TimedPipeline::side, TimedPipeline::side, 1), 1, 1,
            vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, vk::ImageUsageFlagBits::eColorAttachment);
        timed.image = create_image(context, info, "target of timed draws");
        timed.view = vk::raii::ImageView(
            context.device,
            vk::ImageViewCreateInfo({}, *timed.image.image, vk::ImageViewType::e2D, colour_format, {},
                                    vk::ImageSubresourceRange(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1)));
        framebuffer.setAttachments(*timed.view);
    }
    timed.framebuffer = vk::raii::Framebuffer(context.device, framebuffer);
}

vk::raii::Pipeline create_pipeline(const Context& context, const TimedPipeline& timed, bool drawn,
                                   Partitioning partitioning) {
    const auto vertex = create_module(context, shaders::oracle_vertex());
    const auto control = create_module(context, shaders::timed_control());
    const auto evaluation = create_module(context, with_modes(shaders::timed_evaluation(), partitioning, true));
    const auto fragment = create_module(context, shaders::timed_fragment());
    std::vector<vk::PipelineShaderStageCreateInfo> stages = {
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eTessellationControl, *control, "main"),
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eTessellationEvaluation, *evaluation, "main")};
    if (drawn) stages.emplace_back(vk::PipelineShaderStageCreateFlags(), ShaderStage::eFragment, *fragment, "main");
    const vk::PipelineVertexInputStateCreateInfo no_input;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::ePatchList);
    const vk::PipelineTessellationStateCreateInfo tessellation({}, 1);
    const vk::Viewport viewport(0.0f, 0.0f, TimedPipeline::side, TimedPipeline::side, 0.0f, 1.0f);
    const vk::Rect2D scissor({}, {TimedPipeline::side, TimedPipeline::side});
    const vk::PipelineViewportStateCreateInfo viewports({}, viewport, scissor);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.setRasterizerDiscardEnable(drawn ? VK_FALSE : VK_TRUE).setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo multisample({}, vk::SampleCountFlagBits::e1);
    using Component = vk::ColorComponentFlagBits;
    vk::PipelineColorBlendAttachmentState blend;
    blend.setColorWriteMask(Component::eR | Component::eG | Component::eB | Component::eA);
    const vk::PipelineColorBlendStateCreateInfo blending({}, VK_FALSE, {}, blend);
    return {context.device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &no_input, &assembly, &tessellation,
                                           drawn ? &viewports : nullptr, &raster, drawn ? &multisample : nullptr,
                                           nullptr, drawn ? &blending : nullptr, nullptr, *timed.layout, *timed.pass)};
}

}  // namespace

TimedPipeline create_timed_pipeline(const Context& context, bench::Destination destination, Partitioning partitioning) {
    return guarded("preparing timed draws", [&] {
        const bool drawn = destination == bench::Destination::drawn;
        const auto storage = [](std::uint32_t binding) {
            return vk::DescriptorSetLayoutBinding(binding, vk::DescriptorType::eStorageBuffer, 1,
                                                  ShaderStage::eTessellationControl);
        };
        TimedPipeline timed;
        const std::array bindings = {storage(0), storage(1)};
        timed.set_layout =
            vk::raii::DescriptorSetLayout(context.device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
        const vk::PushConstantRange range(OraclePipelines::constant_stages, 0, sizeof(OracleConstants));
        timed.layout =
            vk::raii::PipelineLayout(context.device, vk::PipelineLayoutCreateInfo({}, *timed.set_layout, range));
        create_target(context, timed, drawn);
        timed.pipeline = create_pipeline(context, timed, drawn, partitioning);
        return timed;
    });
}

}  // namespace tessera::backends::vulkan
