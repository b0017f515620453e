#include "backends/vulkan/raster_pipelines.hpp"

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/raster_shaders.hpp"
#include "backends/vulkan/shader_module.hpp"

namespace tessera::backends::vulkan {
namespace {

using ShaderStage = vk::ShaderStageFlagBits;

vk::raii::DescriptorSetLayout create_set_layout(const Context& context, vk::DescriptorType type,
                                                vk::ShaderStageFlags stages) {
    const vk::DescriptorSetLayoutBinding binding(0, type, 1, stages);
    return {context.device, vk::DescriptorSetLayoutCreateInfo({}, binding)};
}

/// What the mesh and the resolve pipelines have in common: triangle lists on the whole of a target whose size is set
/// while recording.
struct PipelineParts {
    std::array<vk::PipelineShaderStageCreateInfo, 2> stages;
    vk::PipelineVertexInputStateCreateInfo vertex_input;
    vk::PipelineInputAssemblyStateCreateInfo assembly{{}, vk::PrimitiveTopology::eTriangleList};
    vk::PipelineViewportStateCreateInfo viewport{{}, 1, nullptr, 1, nullptr};
    vk::PipelineRasterizationStateCreateInfo raster;
    vk::PipelineMultisampleStateCreateInfo multisample;
    vk::PipelineDepthStencilStateCreateInfo depth;
    vk::PipelineColorBlendAttachmentState blend;

    vk::raii::Pipeline create(const Context& context, vk::PipelineLayout layout, vk::RenderPass pass) {
        const std::array dynamic = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
        const vk::PipelineDynamicStateCreateInfo dynamic_state({}, dynamic);
        using Component = vk::ColorComponentFlagBits;
        blend.setColorWriteMask(Component::eR | Component::eG | Component::eB | Component::eA);
        const vk::PipelineColorBlendStateCreateInfo blending({}, VK_FALSE, {}, blend);
        raster.setLineWidth(1.0f);
        const vk::GraphicsPipelineCreateInfo info({}, stages, &vertex_input, &assembly, nullptr, &viewport, &raster,
                                                  &multisample, &depth, &blending, &dynamic_state, layout, pass);
        return {context.device, nullptr, info};
    }
};

}  // namespace

RasterPipelines::RasterPipelines(const Context& context, const RasterPasses& passes)
    : context_(context), passes_(passes) {
    guarded("preparing shaders", [&] {
        frame_set_layout_ = create_set_layout(context, vk::DescriptorType::eUniformBuffer,
                                              ShaderStage::eVertex | ShaderStage::eFragment);
        sampler_set_layout_ =
            create_set_layout(context, vk::DescriptorType::eCombinedImageSampler, ShaderStage::eFragment);
        const std::array sets = {*frame_set_layout_, *sampler_set_layout_};
        const vk::PushConstantRange material(ShaderStage::eFragment, 0, sizeof(MaterialConstants));
        mesh_layout_ = vk::raii::PipelineLayout(context.device, vk::PipelineLayoutCreateInfo({}, sets, material));
        resolve_layout_ =
            vk::raii::PipelineLayout(context.device, vk::PipelineLayoutCreateInfo({}, *sampler_set_layout_));
        mesh_vertex_ = create_module(context, shaders::mesh_vertex());
        mesh_fragment_ = create_module(context, shaders::mesh_fragment());

        const auto vertex = create_module(context, shaders::resolve_vertex());
        const auto fragment = create_module(context, shaders::resolve_fragment());
        PipelineParts parts;
        parts.stages = {vk::PipelineShaderStageCreateInfo({}, ShaderStage::eVertex, *vertex, "main"),
                        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eFragment, *fragment, "main")};
        resolve_ = parts.create(context, *resolve_layout_, *passes.resolve);
    });
}

vk::Pipeline RasterPipelines::mesh(const MeshState& state) {
    if (const auto found = meshes_.find(state); found != meshes_.end()) return *found->second;
    return guarded("preparing a pipeline", [&] {
        const auto shading = static_cast<std::uint32_t>(state.shading);
        const vk::SpecializationMapEntry entry(0, 0, sizeof(shading));
        const vk::SpecializationInfo constants(1, &entry, sizeof(shading), &shading);
        const auto attribute_rate = state.coloured ? vk::VertexInputRate::eVertex : vk::VertexInputRate::eInstance;
        const std::array bindings = {
            vk::VertexInputBindingDescription(0, sizeof(Vertex), vk::VertexInputRate::eVertex),
            vk::VertexInputBindingDescription(1, sizeof(VertexAttributes), attribute_rate),
        };
        const std::array attributes = {
            vk::VertexInputAttributeDescription(0, 0, vk::Format::eR32G32B32Sfloat, offsetof(Vertex, position)),
            vk::VertexInputAttributeDescription(1, 0, vk::Format::eR32G32B32Sfloat, offsetof(Vertex, normal)),
            vk::VertexInputAttributeDescription(2, 0, vk::Format::eR32G32Sfloat, offsetof(Vertex, uv)),
            vk::VertexInputAttributeDescription(3, 1, vk::Format::eR32G32B32A32Sfloat,
                                                offsetof(VertexAttributes, color)),
        };
        PipelineParts parts;
        parts.stages = {
            vk::PipelineShaderStageCreateInfo({}, ShaderStage::eVertex, *mesh_vertex_, "main"),
            vk::PipelineShaderStageCreateInfo({}, ShaderStage::eFragment, *mesh_fragment_, "main", &constants)};
        parts.vertex_input.setVertexBindingDescriptions(bindings).setVertexAttributeDescriptions(attributes);
        // Counter-clockwise as the viewer sees it; Vulkan means the same by it once the projection turns y.
        parts.raster.setFrontFace(vk::FrontFace::eCounterClockwise)
            .setCullMode(state.double_sided ? vk::CullModeFlagBits::eNone : vk::CullModeFlagBits::eBack);
        parts.multisample.setRasterizationSamples(RasterPasses::samples);
        parts.depth.setDepthTestEnable(VK_TRUE)
            .setDepthWriteEnable(state.blend ? VK_FALSE : VK_TRUE)
            .setDepthCompareOp(vk::CompareOp::eLess);
        using Factor = vk::BlendFactor;
        parts.blend.setBlendEnable(state.blend ? VK_TRUE : VK_FALSE)
            .setSrcColorBlendFactor(Factor::eOne)
            .setDstColorBlendFactor(Factor::eOneMinusSrcAlpha)
            .setSrcAlphaBlendFactor(Factor::eOne)
            .setDstAlphaBlendFactor(Factor::eOneMinusSrcAlpha);
        return *meshes_.emplace(state, parts.create(context_, *mesh_layout_, *passes_.draw)).first->second;
    });
}

}  // namespace tessera::backends::vulkan
