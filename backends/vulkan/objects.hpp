// The objects of the backend: buffers, pipelines, bind groups, query sets. Each hands its Vulkan handles to the
// timeline when it goes, which keeps them until the device has done the last work that uses them.
#pragma once

#include <string>

#include "backends/vulkan/hazards.hpp"
#include "backends/vulkan/memory.hpp"
#include "backends/vulkan/timeline.hpp"
#include "gpu/types.hpp"

namespace tessera::backends::vulkan {

/// Handles of type `Handles` that outlive their owner while the device works with them.
template <typename Handles>
class Deferred {
public:
    Deferred(Timeline& timeline, Handles handles) : timeline_(timeline), handles_(std::move(handles)) {}
    ~Deferred() { timeline_.keep_until(last_use_, std::make_shared<Handles>(std::move(handles_))); }
    Deferred(const Deferred&) = delete;
    Deferred& operator=(const Deferred&) = delete;

    /// The commands recorded now use the handles.
    void use() { last_use_ = timeline_.current(); }
    /// True where the device has nothing left to do with the handles.
    bool idle() const { return timeline_.is_done(last_use_); }
    const Handles* operator->() const { return &handles_; }
    const Handles& get() const { return handles_; }

private:
    Timeline& timeline_;
    Handles handles_;
    Timeline::Serial last_use_ = 0;
};

struct Buffer final : gpu::BackendObject {
    Buffer(Timeline& timeline, BufferAllocation handles) : vulkan(timeline, std::move(handles)) {}

    Deferred<BufferAllocation> vulkan;
    LastAccess last_access;
};

struct PipelineHandles {
    vk::raii::DescriptorSetLayout set_layout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::Pipeline pipeline{nullptr};
};

struct Pipeline final : gpu::BackendObject {
    Pipeline(Timeline& timeline, PipelineHandles handles, std::string kernel_name,
             std::vector<gpu::KernelBinding> kernel_bindings)
        : vulkan(timeline, std::move(handles)), name(std::move(kernel_name)), bindings(std::move(kernel_bindings)) {}

    Deferred<PipelineHandles> vulkan;
    std::string name;
    std::vector<gpu::KernelBinding> bindings;
};

struct BindGroup final : gpu::BackendObject {
    BindGroup(Timeline& timeline, vk::raii::DescriptorSet set) : vulkan(timeline, std::move(set)) {}

    Deferred<vk::raii::DescriptorSet> vulkan;
    std::vector<Buffer*> buffers;        ///< by slot; alive whenever the group is used
    std::vector<BufferAccess> accesses;  ///< what a dispatch does to them
    std::uint32_t uniforms = 0;          ///< number of dynamic offsets
};

struct QuerySet final : gpu::BackendObject {
    QuerySet(Timeline& timeline, vk::raii::QueryPool pool, std::uint32_t count)
        : vulkan(timeline, std::move(pool)), written(count, false) {}

    Deferred<vk::raii::QueryPool> vulkan;
    std::vector<bool> written;  ///< only these can be read
};

}  // namespace tessera::backends::vulkan
