// Kernels bound to buffers, with their parameters in one shared uniform buffer.
#pragma once

#include "gpu/device.hpp"

#include <cstring>
#include <string_view>
#include <vector>

namespace tessera {

/// What jobs do with their buffers: kernels bind them, the host writes and reads them.
inline constexpr gpu::BufferUsage storage_usage =
    gpu::BufferUsage::storage | gpu::BufferUsage::copy_source | gpu::BufferUsage::copy_destination;

/// Hands out parameter slots of one uniform buffer; the slots are filled on the host and uploaded once per submission.
class ParameterRing {
public:
    ParameterRing(gpu::Device& device, std::uint32_t slots);

    /// Starts over; what was recorded before must have been uploaded.
    void reset() { used_ = 0; }
    /// Copies a parameter struct into the next slot and returns its byte offset.
    template <typename Parameters>
    std::uint32_t push(const Parameters& parameters) {
        static_assert(sizeof(Parameters) <= slot_bytes);
        return push_bytes(std::as_bytes(std::span(&parameters, 1)));
    }
    /// Writes all used slots to the device; call before submitting what uses them.
    void upload(gpu::Device& device);
    const gpu::Buffer& buffer() const { return buffer_; }

    static constexpr std::uint32_t slot_bytes = 512;

private:
    std::uint32_t push_bytes(std::span<const std::byte> bytes);

    gpu::Buffer buffer_;
    std::vector<std::byte> host_;
    std::uint32_t slots_ = 0;
    std::uint32_t used_ = 0;
};

/// A kernel with its storage buffers bound; the parameter ring is its last slot.
class Stage {
public:
    Stage() = default;
    Stage(gpu::Device& device, std::string_view kernel, std::span<const gpu::Buffer> storage,
          const ParameterRing& parameters);
    Stage(gpu::Device& device, std::string_view kernel, std::initializer_list<gpu::Buffer> storage,
          const ParameterRing& parameters)
        : Stage(device, kernel, std::span<const gpu::Buffer>(storage.begin(), storage.size()), parameters) {}

    /// Records a dispatch of at least `items` items. `parameter_offset` comes from ParameterRing::push.
    void record(gpu::ComputePass& pass, std::uint32_t parameter_offset, std::uint64_t items) const;

private:
    gpu::ComputePipeline pipeline_;
    gpu::BindGroup group_;
    std::uint32_t most_groups_ = 0;  // per dimension
};

}  // namespace tessera
