// Kernels built for the device, kernels with their arguments set, and timestamps.
#pragma once

#include "backends/opencl/opencl_memory.hpp"

#include <optional>

namespace tessera::backends::opencl {

/// The program of one kernel, built for the device.
class PipelineObject : public gpu::BackendObject {
public:
    /// Throws Error(device_unavailable) with the compiler's log where the source does not build, and where the device
    /// cannot run it with `group_size` items.
    PipelineObject(const Session& session, const gpu::Kernel& kernel);

    const std::vector<gpu::KernelBinding>& bindings() const { return bindings_; }
    /// A kernel object of its own, so that arguments set on it stay.
    KernelHandle make_kernel() const;

private:
    const Session& session_;
    std::string name_;
    std::vector<gpu::KernelBinding> bindings_;
    ProgramHandle program_;
};

/// A kernel object whose arguments are set: storage when the group is made, the uniform when its offset changes.
class BindGroupObject : public gpu::BackendObject {
public:
    BindGroupObject(const Session& session, const PipelineObject& pipeline,
                    std::span<const gpu::BoundBuffer> resources);

    /// The kernel with the uniform at `uniform_offset` bytes beyond its bound offset.
    cl_kernel at(std::uint32_t uniform_offset);

private:
    void set_argument(std::uint32_t slot, cl_mem memory);

    struct Uniform {
        std::uint32_t slot;
        BufferObject* buffer;
        std::uint64_t offset;
        std::uint64_t size;
        std::uint32_t dynamic_offset;  ///< as set last
    };
    const Session& session_;
    KernelHandle kernel_;
    std::optional<Uniform> uniform_;
};

/// Markers in the queue; a marker's end is the time at which all commands before it were done.
struct QuerySetObject : gpu::BackendObject {
    explicit QuerySetObject(std::uint32_t count) : markers(count) {}
    std::vector<EventHandle> markers;  ///< null where never written
};

}  // namespace tessera::backends::opencl
