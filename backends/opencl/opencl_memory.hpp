// Device memory: buffers, ranges of them, and the staging that lets small writes return at once.
#pragma once

#include "backends/opencl/opencl_session.hpp"
#include "gpu/backend.hpp"

#include <map>
#include <utility>

namespace tessera::backends::opencl {

/// A zeroed buffer. On a CPU device it is page-aligned host memory that the kernels work on in place; a read or a write
/// is one copy between it and the caller's bytes, which mapping could not save.
///
/// Kernel arguments are memory objects, so a bound range that is not the whole buffer is a sub-buffer. Ranges are made
/// once and kept until the buffer goes: a dynamic uniform offset that was used before costs a look-up, nothing is made
/// per dispatch, and bind groups hold no memory back when a buffer is destroyed.
class BufferObject : public gpu::BackendObject {
public:
    BufferObject(const Session& session, const gpu::BufferDescriptor& descriptor);

    cl_mem whole() const { return whole_.get(); }
    /// The memory object for `size` bytes at `offset`, a multiple of limits.storage_offset_alignment.
    cl_mem range(std::uint64_t offset, std::uint64_t size);

private:
    const Session& session_;
    std::string label_;
    std::uint64_t size_;
    MemoryHandle whole_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, MemoryHandle> ranges_;
};

/// Keeps the bytes of writes that the queue has not done yet. Small writes are copied here and need not wait; a large
/// one would cost more to copy than to wait for.
class Staging {
public:
    /// A place for `size` bytes that stays until recycle(), or null where there is none.
    std::byte* take(std::size_t size);
    /// To be called when the queue is known to be empty.
    void recycle() { used_ = 0; }

private:
    static constexpr std::size_t capacity = 1u << 20;
    std::unique_ptr<std::byte[]> memory_ = std::make_unique<std::byte[]>(capacity);
    std::size_t used_ = 0;
};

/// The largest write in bytes that is staged.
inline constexpr std::size_t max_staged_write = 64u << 10;

}  // namespace tessera::backends::opencl
