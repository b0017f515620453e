#include "backends/opencl/opencl_session.hpp"

namespace tessera::backends::opencl {

Session open_session(const Api& api, FoundDevice found) {
    Session session{api, std::move(found), {}, {}};
    const cl_context_properties properties[] = {CL_CONTEXT_PLATFORM,
                                                reinterpret_cast<cl_context_properties>(session.found.platform), 0};
    cl_int code = CL_SUCCESS;
    session.context = ContextHandle(api.clCreateContext(properties, 1, &session.found.device, nullptr, nullptr, &code),
                                    {api.clReleaseContext});
    session.check(code, "make a context");
    const cl_command_queue_properties timed = session.found.info.timestamps ? CL_QUEUE_PROFILING_ENABLE : 0;
    session.queue = QueueHandle(api.clCreateCommandQueue(session.context.get(), session.found.device, timed, &code),
                                {api.clReleaseCommandQueue});
    session.check(code, "make a queue");
    return session;
}

}  // namespace tessera::backends::opencl
