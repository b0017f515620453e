#include "backends/opencl/opencl_pipeline.hpp"

#include "base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tessera::backends::opencl {

namespace {

// Nothing here may loosen floats. Contraction is turned off by the source (#pragma OPENCL FP_CONTRACT OFF): OpenCL has
// no option for it. tests/opencl checks the bits. The length of a run is the kernels' (kernels/emission.h). -w: PoCL
// would print on the user's terminal that a loop is not vectorised yet, which it then is.
constexpr const char* cpu_build_options = "-w -cl-std=CL1.2 -DTESSERA_RUN=16";
constexpr const char* build_options = "-w -cl-std=CL1.2 -DTESSERA_RUN=1";

std::string build_log(const Session& session, cl_program program) {
    const auto ask = [&](std::size_t size, char* text, std::size_t* needed) {
        return session.api.clGetProgramBuildInfo(program, session.found.device, CL_PROGRAM_BUILD_LOG, size, text,
                                                 needed);
    };
    std::size_t size = 0;
    if (ask(0, nullptr, &size) != CL_SUCCESS || size == 0) {
        return "no log";
    }
    std::string log(size, '\0');
    if (ask(size, log.data(), nullptr) != CL_SUCCESS) {
        return "no log";
    }
    log.resize(std::min(log.find('\0'), log.size()));
    log.resize(log.find_last_not_of(" \n\r\t") + 1);
    return log.empty() ? "no log" : log;
}

ProgramHandle build(const Session& session, const gpu::Kernel& kernel) {
    const char* source = kernel.opencl_source.data();
    const std::size_t length = kernel.opencl_source.size();
    cl_int code = CL_SUCCESS;
    ProgramHandle program(session.api.clCreateProgramWithSource(session.context.get(), 1, &source, &length, &code),
                          {session.api.clReleaseProgram});
    session.check(code, fmt::format("take the source of kernel \"{}\"", kernel.name));
    const char* options = session.found.info.software ? cpu_build_options : build_options;
    code = session.api.clBuildProgram(program.get(), 1, &session.found.device, options, nullptr, nullptr);
    if (code != CL_SUCCESS) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The kernel \"{}\" could not be built on {} ({}) with {}: {}; the compiler says:\n{}",
                                kernel.name, session.found.info.id, session.found.info.name, options, error_name(code),
                                build_log(session, program.get())));
    }
    return program;
}

}  // namespace

PipelineObject::PipelineObject(const Session& session, const gpu::Kernel& kernel)
    : session_(session), name_(kernel.name), bindings_(kernel.bindings), program_(build(session, kernel)) {
    const KernelHandle made = make_kernel();
    cl_uint arguments = 0;
    session.check(session.api.clGetKernelInfo(made.get(), CL_KERNEL_NUM_ARGS, sizeof arguments, &arguments, nullptr),
                  fmt::format("count the arguments of kernel \"{}\"", name_));
    std::size_t items = 0;
    session.check(session.api.clGetKernelWorkGroupInfo(made.get(), session.found.device, CL_KERNEL_WORK_GROUP_SIZE,
                                                       sizeof items, &items, nullptr),
                  fmt::format("ask for the group size of kernel \"{}\"", name_));
    if (arguments != bindings_.size()) {
        throw Error(ErrorKind::usage, fmt::format("The OpenCL source of kernel \"{}\" takes {} arguments, but the "
                                                  "kernel has {} bindings.",
                                                  name_, arguments, bindings_.size()));
    }
    if (items < group_size) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("{} ({}) runs kernel \"{}\" with at most {} items per work group, but {} are needed; "
                                "use another device.",
                                session.found.info.id, session.found.info.name, name_, items, group_size));
    }
}

KernelHandle PipelineObject::make_kernel() const {
    cl_int code = CL_SUCCESS;
    KernelHandle made(session_.api.clCreateKernel(program_.get(), name_.c_str(), &code),
                      {session_.api.clReleaseKernel});
    session_.check(code, fmt::format("make kernel \"{}\"", name_));
    return made;
}

BindGroupObject::BindGroupObject(const Session& session, const PipelineObject& pipeline,
                                 std::span<const gpu::BoundBuffer> resources)
    : session_(session), kernel_(pipeline.make_kernel()) {
    for (const gpu::KernelBinding& binding : pipeline.bindings()) {
        const gpu::BoundBuffer& bound = resources[binding.slot];
        auto& buffer = static_cast<BufferObject&>(*bound.buffer);
        if (binding.kind == gpu::BindingKind::uniform) {
            // One struct, not the rest of the buffer: the range has to fit behind every dynamic offset.
            uniform_ = Uniform{binding.slot, &buffer, bound.offset, binding.size, 0};
            set_argument(binding.slot, buffer.range(bound.offset, binding.size));
        } else {
            set_argument(binding.slot, buffer.range(bound.offset, bound.size));
        }
    }
}

cl_kernel BindGroupObject::at(std::uint32_t uniform_offset) {
    if (uniform_ && uniform_->dynamic_offset != uniform_offset) {
        set_argument(uniform_->slot, uniform_->buffer->range(uniform_->offset + uniform_offset, uniform_->size));
        uniform_->dynamic_offset = uniform_offset;
    }
    return kernel_.get();
}

void BindGroupObject::set_argument(std::uint32_t slot, cl_mem memory) {
    session_.check(session_.api.clSetKernelArg(kernel_.get(), slot, sizeof memory, &memory),
                   fmt::format("set argument {}", slot));
}

}  // namespace tessera::backends::opencl
