// The pipelines of the rasteriser and the shape of their resources.
#pragma once

#include <array>
#include <map>

#include "backends/vulkan/raster_targets.hpp"
#include "render/rasteriser.hpp"

namespace tessera::backends::vulkan {

/// The uniform block of raster_mesh: three matrices by column.
struct FrameConstants {
    glm::mat4 view, projection, rotation;
};
static_assert(sizeof(FrameConstants) == 192);

/// The push constants of raster_mesh.frag.
struct MaterialConstants {
    glm::vec4 base_color;
    float alpha_cutoff;         ///< 0: keeps every pixel
    std::uint32_t keeps_alpha;  ///< 0: drawn opaque
};
static_assert(sizeof(MaterialConstants) == 24);

/// What tells pipelines apart.
struct MeshState {
    render::Shading shading = render::Shading::phong;
    bool double_sided = false;
    bool blend = false;
    bool coloured = false;  ///< vertices have attributes of their own; else one record holds for all
    auto operator<=>(const MeshState&) const = default;
};

class RasterPipelines {
public:
    RasterPipelines(const Context& context, const RasterPasses& passes);

    vk::DescriptorSetLayout frame_set_layout() const { return *frame_set_layout_; }      ///< 0: FrameConstants
    vk::DescriptorSetLayout sampler_set_layout() const { return *sampler_set_layout_; }  ///< 0: sampled image
    vk::PipelineLayout mesh_layout() const { return *mesh_layout_; }                     ///< frame, sampler, material
    vk::PipelineLayout resolve_layout() const { return *resolve_layout_; }               ///< sampler
    vk::Pipeline resolve() const { return *resolve_; }

    /// Made at its first use.
    vk::Pipeline mesh(const MeshState& state);

private:
    const Context& context_;
    const RasterPasses& passes_;
    vk::raii::DescriptorSetLayout frame_set_layout_{nullptr}, sampler_set_layout_{nullptr};
    vk::raii::PipelineLayout mesh_layout_{nullptr}, resolve_layout_{nullptr};
    vk::raii::ShaderModule mesh_vertex_{nullptr}, mesh_fragment_{nullptr};
    vk::raii::Pipeline resolve_{nullptr};
    std::map<MeshState, vk::raii::Pipeline> meshes_;
};

}  // namespace tessera::backends::vulkan
