// Runs patches through the tessellation stage and captures, by transform feedback, what comes out.
#pragma once

#include <span>

#include "backends/vulkan/fixed_function_pipelines.hpp"
#include "backends/vulkan/memory.hpp"
#include "tessellate/refined_mesh.hpp"

namespace tessera::backends::vulkan {

class OracleCapture {
public:
    /// Most patches of one run.
    static constexpr std::uint32_t run_patches = 64;
    /// Bytes of a captured vertex, as the shaders lay it out: coordinate and patch number; on surfaces also position
    /// and normal.
    static constexpr std::uint32_t domain_stride = 16, surface_stride = 40;

    /// Both must outlive the capture. Throws Error(device_unavailable).
    OracleCapture(const Context& context, OraclePipelines& pipelines);

    /// Tessellates a run of patches and returns the captured vertices, in patch order; they stay until the next run.
    /// `corners` is empty, or three per patch for a surface. Throws Error(device_unavailable) when the device fails.
    std::span<const std::byte> run(const OracleVariant& variant, float alpha, std::span<const PatchFactors> factors,
                                   std::span<const Vertex> corners);

private:
    void record(const vk::raii::CommandBuffer& commands, const OracleVariant& variant, float alpha,
                std::uint32_t patch_count, std::uint64_t capture_bytes) const;

    const Context& context_;
    OraclePipelines& pipelines_;
    BufferAllocation factors_, corners_, captured_;
    vk::raii::Framebuffer framebuffer_{nullptr};
    vk::raii::DescriptorPool pool_{nullptr};
    vk::raii::DescriptorSet set_{nullptr};
    vk::raii::QueryPool query_{nullptr};
};

}  // namespace tessera::backends::vulkan
