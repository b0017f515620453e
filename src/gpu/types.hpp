// Plain data of the device room: limits, descriptors, recorded commands. Shapes follow WebGPU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tessera::gpu {

/// What a buffer may be used for; a bit set. Storage: read or written by kernels; uniform: kernel parameters.
enum class BufferUsage : std::uint32_t {
    none = 0,
    storage = 1u << 0,
    uniform = 1u << 1,
    copy_source = 1u << 2,       ///< source of copies and of read_buffer
    copy_destination = 1u << 3,  ///< destination of copies, fills and write_buffer
    indirect = 1u << 4,          ///< holds the three group counts of dispatch_indirect
    query_resolve = 1u << 5,     ///< receives timestamps
};
constexpr BufferUsage operator|(BufferUsage a, BufferUsage b) {
    return static_cast<BufferUsage>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(BufferUsage set, BufferUsage flag) {
    return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(flag)) == static_cast<std::uint32_t>(flag);
}

/// Limits of a device, in bytes or items. The defaults are those of WebGPU core; a kernel of the project fits them.
struct Limits {
    std::uint32_t max_storage_buffers = 8;
    std::uint64_t max_storage_binding_size = 128ull << 20;
    std::uint64_t max_uniform_binding_size = 64ull << 10;
    std::uint64_t max_buffer_size = 256ull << 20;
    std::uint32_t max_workgroup_invocations = 256;
    std::uint32_t max_workgroups_per_dimension = 65535;
    std::uint32_t storage_offset_alignment = 256;
    std::uint32_t uniform_offset_alignment = 256;
};

/// How a device treats 32-bit floats, as far as the driver tells.
struct FloatControls {
    std::optional<bool> preserves_denormals;
    std::optional<bool> flushes_denormals;
    std::optional<bool> preserves_nan_and_infinity;
    std::optional<bool> rounds_to_nearest_even;
};

/// What a device is. `backend` is "reference", "vulkan" or "opencl"; `id` is what `--device` takes ("vulkan:1").
struct DeviceInfo {
    std::string id;
    std::string backend;
    std::string name;
    std::string driver;
    std::string version;
    bool software = false;            ///< runs on the CPU
    bool tessellation_stage = false;  ///< has a fixed-function tessellator
    bool transform_feedback = false;
    bool rasteriser = false;  ///< can draw triangles
    bool timestamps = false;
    std::uint32_t compute_units = 0;  ///< hardware threads or compute units; 0 where unknown
    Limits limits;
    FloatControls float_controls;
};

/// A device that is there but cannot be used, or a backend that is missing, and why (a full sentence).
struct UnusableDevice {
    std::string id;
    std::string name;
    std::string reason;
};

enum class BindingKind { read_storage, write_storage, uniform };

/// One binding of a kernel. `size` is the struct size of a uniform and the element size of a storage buffer, in bytes.
struct KernelBinding {
    std::uint32_t slot = 0;
    BindingKind kind = BindingKind::read_storage;
    std::uint32_t size = 0;
};

/// A range of items for the reference backend, with the bound memory per slot.
using ReferenceKernel = void (*)(std::uint32_t first_item, std::uint32_t last_item, std::byte* const* slots);

/// A kernel in every form a backend may want. Made by the build; see kernel_catalog.hpp.
struct Kernel {
    std::string name;
    std::vector<KernelBinding> bindings;   ///< slots 0, 1, 2, ... in order
    std::span<const std::uint32_t> spirv;  ///< entry point "main", local size WORKGROUP_SIZE x 1 x 1
    std::string_view opencl_source;        ///< complete OpenCL C 1.2 program; kernel function is `name`
    ReferenceKernel reference = nullptr;
};

struct BufferDescriptor {
    std::string label;       ///< named in every error about the buffer
    std::uint64_t size = 0;  ///< bytes, a multiple of 4, > 0
    BufferUsage usage = BufferUsage::none;
};

/// Items per workgroup of every kernel: WORKGROUP_SIZE of kernels/dialect.h.
inline constexpr std::uint32_t workgroup_size = 64;

/// The most timestamps of one query set, as in WebGPU.
inline constexpr std::uint32_t max_query_set_size = 4096;

// ---- what backends implement their objects with ----

/// Base of a backend's own objects; a backend casts them back to what it made.
struct BackendObject {
    virtual ~BackendObject() = default;
};

/// A bound range of a buffer. For a uniform binding the dynamic offset of the dispatch is added to `offset`.
struct BoundBuffer {
    BackendObject* buffer = nullptr;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
};

// ---- recorded commands; they run in order and each sees the writes of those before it ----

struct Dispatch {
    BackendObject* pipeline;
    BackendObject* bind_group;
    std::uint32_t uniform_offset;  ///< bytes, added to the offset of the uniform binding
    std::uint32_t groups_x, groups_y;
};
/// Group counts come from memory, so nobody has checked them: the backend skips the dispatch where a count is over
/// limits.max_workgroups_per_dimension, as WebGPU does, if it can.
struct DispatchIndirect {
    BackendObject* pipeline;
    BackendObject* bind_group;
    std::uint32_t uniform_offset;
    BackendObject* arguments;  ///< three uint32: groups x, y, z (z must be 1)
    std::uint64_t arguments_offset;
};
struct CopyBuffer {
    BackendObject* source;
    std::uint64_t source_offset;
    BackendObject* destination;
    std::uint64_t destination_offset;
    std::uint64_t size;
};
struct FillBuffer {
    BackendObject* buffer;
    std::uint64_t offset, size;
    std::uint32_t value;  ///< repeated
};
struct WriteTimestamp {
    BackendObject* query_set;
    std::uint32_t index;
};
/// Writes `count` uint64 timestamps in nanoseconds.
struct ResolveQuerySet {
    BackendObject* query_set;
    std::uint32_t first, count;
    BackendObject* destination;
    std::uint64_t offset;
};
using Command = std::variant<Dispatch, DispatchIndirect, CopyBuffer, FillBuffer, WriteTimestamp, ResolveQuerySet>;

}  // namespace tessera::gpu
