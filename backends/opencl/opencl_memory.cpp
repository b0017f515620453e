#include "backends/opencl/opencl_memory.hpp"

#include "base/error.hpp"
#include "base/host_memory.hpp"

#include <fmt/format.h>

#include <new>

namespace tessera::backends::opencl {

namespace {

[[noreturn]] void out_of_memory(const Session& session, const gpu::BufferDescriptor& descriptor, cl_int code) {
    throw Error(ErrorKind::device_unavailable,
                fmt::format("The buffer \"{}\" of {} bytes could not be made on {} ({}): {}; use smaller buffers or "
                            "another device.",
                            descriptor.label, descriptor.size, session.found.info.id, session.found.info.name,
                            error_name(code)));
}

void CL_CALLBACK release_pages(cl_mem, void* pages) {
    delete static_cast<HostMemory*>(pages);
}

// CPU drivers use pages in place, and the threads that fill them touch them first. The driver tells when nothing uses
// them any more: commands in flight keep the buffer beyond its release.
MemoryHandle use_host_pages(const Session& session, const gpu::BufferDescriptor& descriptor) {
    std::unique_ptr<HostMemory> pages;
    try {
        pages = std::make_unique<HostMemory>(descriptor.size);
    } catch (const std::bad_alloc&) {
        out_of_memory(session, descriptor, CL_OUT_OF_HOST_MEMORY);
    }
    cl_int code = CL_SUCCESS;
    MemoryHandle memory(session.api.clCreateBuffer(session.context.get(), CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR,
                                                   descriptor.size, pages->data(), &code),
                        {session.api.clReleaseMemObject});
    if (code != CL_SUCCESS) {
        out_of_memory(session, descriptor, code);
    }
    session.check(session.api.clSetMemObjectDestructorCallback(memory.get(), release_pages, pages.get()),
                  "watch the end of a buffer");
    pages.release();
    return memory;
}

MemoryHandle use_device_memory(const Session& session, const gpu::BufferDescriptor& descriptor) {
    cl_int code = CL_SUCCESS;
    MemoryHandle memory(
        session.api.clCreateBuffer(session.context.get(), CL_MEM_READ_WRITE, descriptor.size, nullptr, &code),
        {session.api.clReleaseMemObject});
    if (code != CL_SUCCESS) {
        out_of_memory(session, descriptor, code);
    }
    const cl_uint zero = 0;
    code = session.api.clEnqueueFillBuffer(session.queue.get(), memory.get(), &zero, sizeof zero, 0, descriptor.size, 0,
                                           nullptr, nullptr);
    if (code != CL_SUCCESS) {  // drivers that allocate late say only here that memory is short
        out_of_memory(session, descriptor, code);
    }
    return memory;
}

}  // namespace

BufferObject::BufferObject(const Session& session, const gpu::BufferDescriptor& descriptor)
    : session_(session),
      label_(descriptor.label),
      size_(descriptor.size),
      whole_(session.found.info.software ? use_host_pages(session, descriptor)
                                         : use_device_memory(session, descriptor)) {}

cl_mem BufferObject::range(std::uint64_t offset, std::uint64_t size) {
    if (offset == 0 && size == size_) {
        return whole_.get();
    }
    MemoryHandle& made = ranges_[{offset, size}];
    if (!made) {
        const cl_buffer_region region{offset, size};
        cl_int code = CL_SUCCESS;
        MemoryHandle part(session_.api.clCreateSubBuffer(whole_.get(), CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION,
                                                         &region, &code),
                          {session_.api.clReleaseMemObject});
        session_.check(code, fmt::format("bind {} bytes at offset {} of the buffer \"{}\" ({} bytes)", size, offset,
                                         label_, size_));
        made = std::move(part);
    }
    return made.get();
}

std::byte* Staging::take(std::size_t size) {
    if (size > capacity - used_) {
        return nullptr;
    }
    std::byte* place = memory_.get() + used_;
    used_ += size;
    return place;
}

}  // namespace tessera::backends::opencl
