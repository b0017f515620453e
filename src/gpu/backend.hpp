// The interface that a backend implements. Everything it is handed has been validated by the shared code of this room.
#pragma once

#include "gpu/types.hpp"

namespace tessera::gpu {

/// One device of one backend. Objects it makes are destroyed before it. They may be destroyed as soon as submit has
/// returned: a backend that still runs waits, or defers the release. Sizes are never 0, ranges lie inside their
/// buffers, and dispatches have at least one group. New buffers hold zeros. Calls come from one thread at a time.
class Backend {
public:
    virtual ~Backend() = default;

    virtual const DeviceInfo& info() const = 0;
    virtual std::unique_ptr<BackendObject> create_buffer(const BufferDescriptor& descriptor) = 0;
    virtual std::unique_ptr<BackendObject> create_pipeline(const Kernel& kernel) = 0;
    /// `resources` holds one entry per binding of the pipeline's kernel, by slot.
    virtual std::unique_ptr<BackendObject> create_bind_group(BackendObject& pipeline,
                                                             std::span<const BoundBuffer> resources) = 0;
    virtual std::unique_ptr<BackendObject> create_query_set(std::uint32_t count) = 0;
    /// Ordered with submits: later commands see the data, earlier ones do not.
    virtual void write_buffer(BackendObject& buffer, std::uint64_t offset, std::span<const std::byte> data) = 0;
    /// Waits for all earlier work, then copies.
    virtual void read_buffer(BackendObject& buffer, std::uint64_t offset, std::span<std::byte> data) = 0;
    virtual void submit(std::span<const Command> commands) = 0;
    virtual void wait() = 0;
};

}  // namespace tessera::gpu
