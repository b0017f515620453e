// Compute devices in the shape of WebGPU: Device, Queue, Buffer, ComputePipeline, BindGroup, CommandEncoder,
// ComputePass, QuerySet. All validation is here, shared by every backend; a violation throws Error(usage) with one
// sentence that names the object by its label and gives the offending value.
//
//   Buffer b = device.create_buffer({"factors", 64, BufferUsage::storage | BufferUsage::copy_destination});
//   device.queue().write_buffer(b, 0, bytes);
//   ComputePipeline p = device.create_compute_pipeline(find_kernel("counts"));
//   BindGroup g = device.create_bind_group(p, {{b}, ...});
//   CommandEncoder e = device.create_command_encoder();
//   ComputePass pass = e.begin_compute_pass();
//   pass.set_pipeline(p); pass.set_bind_group(g, uniform_offset); pass.dispatch_workgroups(groups); pass.end();
//   device.queue().submit(e.finish());
//
// Handles are cheap to copy and share one object. Everything of one device is used by one thread at a time.
#pragma once

#include "gpu/backend.hpp"

namespace tessera::gpu {

namespace detail {
struct DeviceState;
struct BufferState;
struct PipelineState;
struct BindGroupState;
struct QuerySetState;
struct EncoderState;
struct CommandBufferState;
}  // namespace detail

/// A block of device memory. A default-made handle is null and refused by every call.
class Buffer {
public:
    Buffer() = default;
    explicit operator bool() const { return state_ != nullptr; }
    /// Whether two handles share one object.
    bool operator==(const Buffer&) const = default;
    std::uint64_t size() const;  ///< bytes
    const std::string& label() const;
    /// Frees the memory now, once work already submitted is done; any later use of any copy of this handle throws.
    void destroy();
    /// For code of this device's backend that works beside this interface. Throws Error(usage) where it was destroyed.
    BackendObject& object() const;

    std::shared_ptr<detail::BufferState> state_;  // for the shared code only
};

/// One kernel, ready to run on one device.
class ComputePipeline {
public:
    ComputePipeline() = default;
    const Kernel& kernel() const;

    std::shared_ptr<detail::PipelineState> state_;
};

/// A range of a buffer for one slot. `size` 0 means "to the end" for storage and "the kernel's struct" for a uniform,
/// so that dynamic offsets can walk one buffer of many structs. Offsets obey the device's alignment limits.
struct Binding {
    Buffer buffer;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
};

class BindGroup {
public:
    BindGroup() = default;

    std::shared_ptr<detail::BindGroupState> state_;
};

/// A fixed number of timestamps.
class QuerySet {
public:
    QuerySet() = default;

    std::shared_ptr<detail::QuerySetState> state_;
};

/// Recorded work; submitted at most once.
class CommandBuffer {
public:
    std::shared_ptr<detail::CommandBufferState> state_;
};

/// Records dispatches. Ends with end(); the encoder refuses other commands until then.
class ComputePass {
public:
    void set_pipeline(const ComputePipeline& pipeline);
    /// `uniform_offset`: bytes added to the uniform binding's offset, a multiple of limits.uniform_offset_alignment.
    void set_bind_group(const BindGroup& group, std::uint32_t uniform_offset = 0);
    /// Groups per dimension, each in [0, limits.max_workgroups_per_dimension]; zero groups do nothing. At most 2^32 - 1
    /// items in all, for kernels index them with 32 bits.
    void dispatch_workgroups(std::uint32_t groups_x, std::uint32_t groups_y = 1);
    /// The group counts are three uint32 at `offset` (a multiple of 4) of `arguments` (usage indirect), which
    /// the kernel does not write; z is 1.
    void dispatch_workgroups_indirect(const Buffer& arguments, std::uint64_t offset);
    void end();

    std::shared_ptr<detail::EncoderState> state_;
    std::uint32_t number_ = 0;  // of the pass in its encoder, from 1
};

class CommandEncoder {
public:
    ComputePass begin_compute_pass();
    /// Offsets and size in bytes, multiples of 4. Source (usage copy_source) and destination (copy_destination) differ.
    void copy_buffer_to_buffer(const Buffer& source, std::uint64_t source_offset, const Buffer& destination,
                               std::uint64_t destination_offset, std::uint64_t size);
    /// Fills with a repeated 32-bit value (WebGPU's clearBuffer with a value); usage copy_destination.
    void fill_buffer(const Buffer& buffer, std::uint64_t offset, std::uint64_t size, std::uint32_t value);
    void write_timestamp(const QuerySet& queries, std::uint32_t index);
    /// Writes `count` uint64 nanosecond values at `offset` (a multiple of 8) of a query_resolve buffer.
    /// Each must have been written by then, at the latest by these commands; submit checks it.
    void resolve_query_set(const QuerySet& queries, std::uint32_t first, std::uint32_t count, const Buffer& destination,
                           std::uint64_t offset);
    CommandBuffer finish();

    std::shared_ptr<detail::EncoderState> state_;
};

/// The one queue of a device. Work runs in the order given.
class Queue {
public:
    void submit(const CommandBuffer& commands);
    /// Offset and size in bytes, multiples of 4; usage copy_destination.
    void write_buffer(const Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data);
    /// Waits for all earlier work; usage copy_source.
    void read_buffer(const Buffer& buffer, std::uint64_t offset, std::span<std::byte> data);
    void wait();

    std::shared_ptr<detail::DeviceState> state_;
};

/// What has gone to and from a device since it was opened, for measurements.
struct Traffic {
    std::uint64_t submits = 0;
    std::uint64_t dispatches = 0;
    std::uint64_t uploaded = 0;  ///< bytes of write_buffer
    std::uint64_t read = 0;      ///< bytes of read_buffer
};

class Device {
public:
    Device() = default;
    explicit Device(std::unique_ptr<Backend> backend);
    /// Whether two handles share one object.
    bool operator==(const Device&) const = default;

    const DeviceInfo& info() const;
    const Limits& limits() const { return info().limits; }
    const Traffic& traffic() const;
    /// For code of this backend that works beside this interface.
    Backend& backend() const;
    Queue queue() const;
    /// New memory holds zeros.
    Buffer create_buffer(const BufferDescriptor& descriptor);
    /// Pipelines are cached per kernel by name: a second call returns the same one.
    ComputePipeline create_compute_pipeline(const Kernel& kernel);
    /// One binding per slot of the pipeline's kernel, in slot order.
    BindGroup create_bind_group(const ComputePipeline& pipeline, std::span<const Binding> bindings);
    BindGroup create_bind_group(const ComputePipeline& pipeline, std::initializer_list<Binding> bindings);
    /// `count` in [1, max_query_set_size]; needs info().timestamps.
    QuerySet create_query_set(std::uint32_t count);
    CommandEncoder create_command_encoder();

    std::shared_ptr<detail::DeviceState> state_;
};

/// A new buffer that holds `data`, for kernels to read.
Buffer create_filled_buffer(Device& device, const char* label, std::span<const std::byte> data);

}  // namespace tessera::gpu
