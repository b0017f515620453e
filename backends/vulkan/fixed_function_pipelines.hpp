// The pipelines of the fixed-function oracle: nothing is drawn, so they end with the evaluation shader.
#pragma once

#include <compare>
#include <map>

#include "backends/vulkan/context.hpp"
#include "tessellate/options.hpp"

namespace tessera::backends::vulkan {

/// What a pipeline is made for.
struct OracleVariant {
    Domain domain = Domain::triangle;
    Partitioning partitioning = Partitioning::integer;
    /// Vulkan draws its domain with v pointing down, D3D's patterns are described with v pointing up: the same
    /// triangles are clockwise in both.
    bool clockwise = true;
    bool surface = false;  ///< evaluates `scheme` and `normals`, which do not matter otherwise
    Scheme scheme = Scheme::linear;
    Normals normals = Normals::linear;

    auto operator<=>(const OracleVariant&) const = default;
};

/// Push constants, as the shaders declare them.
struct OracleConstants {
    std::uint32_t first_patch = 0;  ///< of a draw, in the buffer of factors
    std::uint32_t first_inner = 0;  ///< place of the first inside factor in a set of factors
    float alpha = 0.0f;
};

class OraclePipelines {
public:
    static constexpr vk::ShaderStageFlags constant_stages =
        vk::ShaderStageFlagBits::eTessellationControl | vk::ShaderStageFlagBits::eTessellationEvaluation;

    /// `context` must outlive the pipelines.
    explicit OraclePipelines(const Context& context);

    /// Made at first use. Throws Error(device_unavailable).
    vk::Pipeline get(const OracleVariant& variant);
    vk::PipelineLayout layout() const { return *layout_; }
    /// Storage buffers: 0 factors, 1 corners.
    vk::DescriptorSetLayout set_layout() const { return *set_layout_; }
    /// Without attachments.
    vk::RenderPass render_pass() const { return *render_pass_; }

private:
    const Context& context_;
    vk::raii::DescriptorSetLayout set_layout_{nullptr};
    vk::raii::PipelineLayout layout_{nullptr};
    vk::raii::RenderPass render_pass_{nullptr};
    std::map<OracleVariant, vk::raii::Pipeline> made_;
};

}  // namespace tessera::backends::vulkan
