#include "backends/opencl/opencl_submit.hpp"

#include "base/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>

namespace tessera::backends::opencl {

namespace {

class Submission {
public:
    Submission(const Session& session, Staging& staging) : session_(session), staging_(staging) {}

    void operator()(const gpu::Dispatch& command) {
        run(*command.bind_group, command.uniform_offset, command.groups_x, command.groups_y);
    }

    void operator()(const gpu::DispatchIndirect& command) {
        std::array<std::uint32_t, 3> groups{};
        read_now(session_, staging_, static_cast<BufferObject&>(*command.arguments), command.arguments_offset,
                 std::as_writable_bytes(std::span(groups)));
        const std::uint32_t most = session_.found.info.limits.max_workgroups_per_dimension;
        if (groups[0] > most || groups[1] > most || groups[2] > 1) {
            throw Error(ErrorKind::usage,
                        fmt::format("An indirect dispatch asks for {} x {} x {} groups, but at most {} x {} x 1 are "
                                    "allowed.",
                                    groups[0], groups[1], groups[2], most, most));
        }
        if (groups[2] == 1) {
            run(*command.bind_group, command.uniform_offset, groups[0], groups[1]);
        }
    }

    void operator()(const gpu::CopyBuffer& command) {
        if (command.size == 0) {
            return;
        }
        session_.check(session_.api.clEnqueueCopyBuffer(session_.queue.get(), memory(*command.source),
                                                        memory(*command.destination), command.source_offset,
                                                        command.destination_offset, command.size, 0, nullptr, nullptr),
                       fmt::format("copy {} bytes", command.size));
    }

    void operator()(const gpu::FillBuffer& command) {
        if (command.size == 0) {
            return;
        }
        session_.check(
            session_.api.clEnqueueFillBuffer(session_.queue.get(), memory(*command.buffer), &command.value,
                                             sizeof command.value, command.offset, command.size, 0, nullptr, nullptr),
            fmt::format("fill {} bytes", command.size));
    }

    void operator()(const gpu::WriteTimestamp& command) {
        cl_event marker = nullptr;
        session_.check(session_.api.clEnqueueMarkerWithWaitList(session_.queue.get(), 0, nullptr, &marker),
                       "write a timestamp");
        static_cast<QuerySetObject&>(*command.query_set).markers[command.index] =
            EventHandle(marker, {session_.api.clReleaseEvent});
    }

    void operator()(const gpu::ResolveQuerySet& command) {
        const auto& markers = static_cast<QuerySetObject&>(*command.query_set).markers;
        std::vector<std::uint64_t> times(command.count);
        for (std::uint32_t i = 0; i < command.count; ++i) {
            times[i] = time_of(markers[command.first + i].get());
        }
        enqueue_write(session_, staging_, static_cast<BufferObject&>(*command.destination), command.offset,
                      std::as_bytes(std::span(times)));
    }

private:
    static cl_mem memory(gpu::BackendObject& buffer) { return static_cast<BufferObject&>(buffer).whole(); }

    void run(gpu::BackendObject& bind_group, std::uint32_t uniform_offset, std::uint32_t groups_x,
             std::uint32_t groups_y) {
        if (groups_x == 0 || groups_y == 0) {
            return;
        }
        // Always two dimensions, so that a driver which specialises kernels for their shape does it once.
        const std::array<std::size_t, 2> items{groups_x * group_size, groups_y};
        const std::array<std::size_t, 2> group{group_size, 1};
        session_.check(session_.api.clEnqueueNDRangeKernel(session_.queue.get(),
                                                           static_cast<BindGroupObject&>(bind_group).at(uniform_offset),
                                                           2, nullptr, items.data(), group.data(), 0, nullptr, nullptr),
                       fmt::format("dispatch {} x {} groups", groups_x, groups_y));
    }

    // Nanoseconds; 0 for a timestamp that was never written, as in WebGPU.
    std::uint64_t time_of(cl_event marker) const {
        if (marker == nullptr) {
            return 0;
        }
        session_.check(session_.api.clWaitForEvents(1, &marker), "wait for a timestamp");
        cl_ulong time = 0;
        session_.check(
            session_.api.clGetEventProfilingInfo(marker, CL_PROFILING_COMMAND_END, sizeof time, &time, nullptr),
            "read a timestamp");
        return time;
    }

    const Session& session_;
    Staging& staging_;
};

}  // namespace

void enqueue_write(const Session& session, Staging& staging, BufferObject& buffer, std::uint64_t offset,
                   std::span<const std::byte> data) {
    if (data.empty()) {
        return;
    }
    std::byte* staged = data.size() <= max_staged_write ? staging.take(data.size()) : nullptr;
    if (staged != nullptr) {
        std::memcpy(staged, data.data(), data.size());
    }
    session.check(session.api.clEnqueueWriteBuffer(session.queue.get(), buffer.whole(),
                                                   staged != nullptr ? CL_FALSE : CL_TRUE, offset, data.size(),
                                                   staged != nullptr ? staged : data.data(), 0, nullptr, nullptr),
                  fmt::format("write {} bytes", data.size()));
    if (staged == nullptr) {
        staging.recycle();  // the queue is in order: everything before this write is done
    }
}

void read_now(const Session& session, Staging& staging, BufferObject& buffer, std::uint64_t offset,
              std::span<std::byte> data) {
    if (data.empty()) {
        session.check(session.api.clFinish(session.queue.get()), "finish");
    } else {
        session.check(session.api.clEnqueueReadBuffer(session.queue.get(), buffer.whole(), CL_TRUE, offset, data.size(),
                                                      data.data(), 0, nullptr, nullptr),
                      fmt::format("read {} bytes", data.size()));
    }
    staging.recycle();
}

void enqueue_commands(const Session& session, Staging& staging, std::span<const gpu::Command> commands) {
    Submission submission(session, staging);
    for (const gpu::Command& command : commands) {
        std::visit(submission, command);
    }
    session.check(session.api.clFlush(session.queue.get()), "start the work");
}

}  // namespace tessera::backends::opencl
