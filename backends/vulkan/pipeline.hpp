// Compute pipelines and the bind groups that feed them.
#pragma once

#include "backends/vulkan/objects.hpp"
#include "backends/vulkan/pipeline_cache.hpp"

namespace tessera::backends::vulkan {

/// Compiles `kernel`: binding n of set 0 is slot n, uniforms have dynamic offsets. Throws Error(device_unavailable).
std::unique_ptr<Pipeline> create_pipeline(const Context& context, Timeline& timeline, const PipelineCache& cache,
                                          const gpu::Kernel& kernel);

/// Grows by a pool whenever the last one is full; freed sets are used again.
class DescriptorPools {
public:
    explicit DescriptorPools(const Context& context) : context_(context) {}

    vk::raii::DescriptorSet allocate(const vk::raii::DescriptorSetLayout& layout);
    std::size_t size() const { return pools_.size(); }

private:
    const Context& context_;
    std::vector<vk::raii::DescriptorPool> pools_;
};

/// One descriptor set over `resources`, by slot of the pipeline's kernel. Throws Error(device_unavailable).
std::unique_ptr<BindGroup> create_bind_group(const Context& context, Timeline& timeline, DescriptorPools& pools,
                                             Pipeline& pipeline, std::span<const gpu::BoundBuffer> resources);

}  // namespace tessera::backends::vulkan
