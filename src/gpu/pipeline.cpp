#include "gpu/validation.hpp"

#include <algorithm>

namespace tessera::gpu {

namespace {

/// Kernels come from the build, so a refusal here means a kernel outgrew a device or the catalog is wrong.
void check_kernel(const Kernel& kernel, const Limits& limits) {
    if (kernel.name.empty()) {
        detail::refuse("create_compute_pipeline got a kernel without a name.");
    }
    std::uint32_t storage = 0;
    std::uint32_t uniforms = 0;
    for (std::uint32_t slot = 0; slot < kernel.bindings.size(); ++slot) {
        const KernelBinding& binding = kernel.bindings[slot];
        if (binding.slot != slot) {
            detail::refuse("create_compute_pipeline got kernel '{}' with slot {} at place {}; slots count from 0.",
                           kernel.name, binding.slot, slot);
        }
        if (binding.size == 0) {
            detail::refuse("create_compute_pipeline got kernel '{}' with elements of 0 bytes in slot {}.", kernel.name,
                           slot);
        }
        if (binding.kind == BindingKind::uniform && binding.size > limits.max_uniform_binding_size) {
            detail::refuse(
                "create_compute_pipeline got kernel '{}' with a uniform of {} bytes, more than the device's "
                "{}.",
                kernel.name, binding.size, limits.max_uniform_binding_size);
        }
        ++(binding.kind == BindingKind::uniform ? uniforms : storage);
    }
    if (storage > limits.max_storage_buffers) {
        detail::refuse("create_compute_pipeline got kernel '{}' with {} storage buffers, more than the device's {}.",
                       kernel.name, storage, limits.max_storage_buffers);
    }
    if (uniforms > 1) {
        detail::refuse("create_compute_pipeline got kernel '{}' with {} uniform bindings; one is the most.",
                       kernel.name, uniforms);
    }
    if (limits.max_workgroup_invocations < workgroup_size) {
        detail::refuse("create_compute_pipeline got kernel '{}' with groups of {} items, more than the device's {}.",
                       kernel.name, workgroup_size, limits.max_workgroup_invocations);
    }
}

bool same_kernel(const Kernel& a, const Kernel& b) {
    const auto same_binding = [](const KernelBinding& x, const KernelBinding& y) {
        return x.slot == y.slot && x.kind == y.kind && x.size == y.size;
    };
    return a.reference == b.reference && std::ranges::equal(a.spirv, b.spirv) && a.opencl_source == b.opencl_source &&
           std::ranges::equal(a.bindings, b.bindings, same_binding);
}

}  // namespace

ComputePipeline Device::create_compute_pipeline(const Kernel& kernel) {
    detail::not_null(state_, "create_compute_pipeline", "device");
    auto found = state_->pipelines.find(kernel.name);
    if (found == state_->pipelines.end()) {
        check_kernel(kernel, limits());
        auto pipeline = std::make_unique<detail::PipelineState>();
        pipeline->device = state_.get();
        pipeline->kernel = kernel;
        pipeline->object = state_->backend->create_pipeline(pipeline->kernel);
        found = state_->pipelines.emplace(kernel.name, std::move(pipeline)).first;
    } else if (!same_kernel(found->second->kernel, kernel)) {
        detail::refuse("create_compute_pipeline got a kernel '{}' that differs from the one it made before.",
                       kernel.name);
    }
    ComputePipeline handle;
    handle.state_ = std::shared_ptr<detail::PipelineState>(state_, found->second.get());  // owns the device
    return handle;
}

const Kernel& ComputePipeline::kernel() const {
    return detail::not_null(state_, "ComputePipeline::kernel", "pipeline").kernel;
}

}  // namespace tessera::gpu
