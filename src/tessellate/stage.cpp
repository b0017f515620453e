#include "tessellate/stage.hpp"

#include "base/error.hpp"
#include "dialect.h"
#include "gpu/kernel_catalog.hpp"

#include <algorithm>
#include <cassert>

namespace tessera {

ParameterRing::ParameterRing(gpu::Device& device, std::uint32_t slots)
    : buffer_(device.create_buffer({"kernel parameters", std::uint64_t{slots} * slot_bytes,
                                    gpu::BufferUsage::uniform | gpu::BufferUsage::copy_destination})),
      host_(std::size_t{slots} * slot_bytes),
      slots_(slots) {
    assert(slot_bytes % device.limits().uniform_offset_alignment == 0);
}

std::uint32_t ParameterRing::push_bytes(std::span<const std::byte> bytes) {
    assert(used_ < slots_);
    const std::uint32_t offset = used_++ * slot_bytes;
    std::ranges::copy(bytes, host_.begin() + offset);
    return offset;
}

void ParameterRing::upload(gpu::Device& device) {
    device.queue().write_buffer(buffer_, 0, std::span(host_).first(std::size_t{used_} * slot_bytes));
}

Stage::Stage(gpu::Device& device, std::string_view kernel, std::span<const gpu::Buffer> storage,
             const ParameterRing& parameters)
    : pipeline_(device.create_compute_pipeline(gpu::find_kernel(kernel))),
      most_groups_(device.limits().max_workgroups_per_dimension) {
    std::vector<gpu::Binding> bindings;
    for (const gpu::Buffer& buffer : storage) {
        bindings.push_back({buffer});
    }
    bindings.push_back({parameters.buffer(), 0, ParameterRing::slot_bytes});
    group_ = device.create_bind_group(pipeline_, bindings);
}

void Stage::record(gpu::ComputePass& pass, std::uint32_t parameter_offset, std::uint64_t items) const {
    const std::uint64_t groups = (items + WORKGROUP_SIZE - 1) / WORKGROUP_SIZE;
    const std::uint64_t x = std::min<std::uint64_t>(groups, most_groups_);
    const std::uint64_t y = x == 0 ? 0 : (groups + x - 1) / x;
    pass.set_pipeline(pipeline_);
    pass.set_bind_group(group_, parameter_offset);
    pass.dispatch_workgroups(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
}

}  // namespace tessera
