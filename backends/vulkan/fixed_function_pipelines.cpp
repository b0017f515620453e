#include "backends/vulkan/fixed_function_pipelines.hpp"

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/fixed_function_modes.hpp"
#include "backends/vulkan/fixed_function_shaders.hpp"
#include "backends/vulkan/shader_module.hpp"

namespace tessera::backends::vulkan {
namespace {

using ShaderStage = vk::ShaderStageFlagBits;

/// Constants of fixed_function.tese.
struct SurfaceConstants {
    std::uint32_t scheme;
    vk::Bool32 quadratic;
};

std::uint32_t number_of(Scheme scheme) {
    return scheme == Scheme::linear ? 0 : scheme == Scheme::phong ? 1 : 2;
}

vk::raii::Pipeline create_pipeline(const Context& context, const OracleVariant& variant, vk::PipelineLayout layout,
                                   vk::RenderPass pass) {
    const auto vertex = create_module(context, shaders::oracle_vertex());
    const auto control = create_module(context, shaders::oracle_control(variant.surface));
    const auto evaluation =
        create_module(context, with_modes(shaders::oracle_evaluation(variant.domain, variant.surface),
                                          variant.partitioning, variant.clockwise));
    const SurfaceConstants values{number_of(variant.scheme), variant.normals == Normals::quadratic};
    const std::array entries = {
        vk::SpecializationMapEntry(0, offsetof(SurfaceConstants, scheme), sizeof(values.scheme)),
        vk::SpecializationMapEntry(1, offsetof(SurfaceConstants, quadratic), sizeof(values.quadratic))};
    vk::SpecializationInfo constants;
    if (variant.surface) constants.setMapEntries(entries).setData<SurfaceConstants>(values);
    const std::array stages = {
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eTessellationControl, *control, "main"),
        vk::PipelineShaderStageCreateInfo({}, ShaderStage::eTessellationEvaluation, *evaluation, "main", &constants)};
    const vk::PipelineVertexInputStateCreateInfo no_input;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::ePatchList);
    const vk::PipelineTessellationStateCreateInfo tessellation({}, 1);
    vk::PipelineRasterizationStateCreateInfo discard;
    discard.setRasterizerDiscardEnable(VK_TRUE).setLineWidth(1.0f);
    return {context.device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &no_input, &assembly, &tessellation, nullptr, &discard, nullptr,
                                           nullptr, nullptr, nullptr, layout, pass)};
}

}  // namespace

OraclePipelines::OraclePipelines(const Context& context) : context_(context) {
    const auto storage = [](std::uint32_t binding) {
        return vk::DescriptorSetLayoutBinding(binding, vk::DescriptorType::eStorageBuffer, 1,
                                              ShaderStage::eTessellationControl);
    };
    guarded("preparing the tessellation stage", [&] {
        const std::array bindings = {storage(0), storage(1)};
        set_layout_ = vk::raii::DescriptorSetLayout(context.device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
        const vk::PushConstantRange range(constant_stages, 0, sizeof(OracleConstants));
        layout_ = vk::raii::PipelineLayout(context.device, vk::PipelineLayoutCreateInfo({}, *set_layout_, range));
        const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics);
        render_pass_ = vk::raii::RenderPass(context.device, vk::RenderPassCreateInfo({}, {}, subpass));
    });
}

vk::Pipeline OraclePipelines::get(const OracleVariant& variant) {
    if (const auto found = made_.find(variant); found != made_.end()) return *found->second;
    return guarded("preparing a pipeline of the tessellation stage", [&] {
        auto pipeline = create_pipeline(context_, variant, *layout_, *render_pass_);
        return *made_.emplace(variant, std::move(pipeline)).first->second;
    });
}

}  // namespace tessera::backends::vulkan
