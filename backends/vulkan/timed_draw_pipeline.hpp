// The pipeline of timed draws through the tessellation stage, and what it draws into.
#pragma once

#include "backends/vulkan/fixed_function_pipelines.hpp"
#include "backends/vulkan/memory.hpp"
#include "bench/timed_draw.hpp"

namespace tessera::backends::vulkan {

struct TimedPipeline {
    vk::raii::DescriptorSetLayout set_layout{nullptr};  ///< storage buffers: 0 factors, 1 corners
    vk::raii::PipelineLayout layout{nullptr};           ///< push constants: OracleConstants
    vk::raii::RenderPass pass{nullptr};
    ImageAllocation image;  ///< only where triangles are drawn
    vk::raii::ImageView view{nullptr};
    vk::raii::Framebuffer framebuffer{nullptr};
    vk::raii::Pipeline pipeline{nullptr};

    static constexpr std::uint32_t side = 1024;  ///< pixels
};

/// Throws Error(device_unavailable).
TimedPipeline create_timed_pipeline(const Context& context, bench::Destination destination, Partitioning partitioning);

}  // namespace tessera::backends::vulkan
