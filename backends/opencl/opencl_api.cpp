#include "backends/opencl/opencl_api.hpp"

#include "base/error.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <map>
#include <mutex>

namespace tessera::backends::opencl {

namespace {

Api open_library(const std::string& library) {
    void* opened = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (opened == nullptr) {
        const char* reason = dlerror();
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The OpenCL loader {} could not be opened ({}); install an OpenCL loader and a driver, "
                                "on Debian ocl-icd-libopencl1 and pocl-opencl-icd.",
                                library, reason != nullptr ? reason : "no reason given"));
    }
    Api api;
    std::string missing;
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(opened, name));
        if (function == nullptr) {
            missing += missing.empty() ? name : fmt::format(", {}", name);
        }
    };
#define TESSERA_OPENCL_FIND(name) find(api.name, #name);
    TESSERA_OPENCL_FUNCTIONS(TESSERA_OPENCL_FIND)
#undef TESSERA_OPENCL_FIND
    if (!missing.empty()) {
        dlclose(opened);
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("The library {} lacks functions of OpenCL 1.2 ({}); install a newer OpenCL loader.",
                                library, missing));
    }
    return api;
}

}  // namespace

const Api& load_api(const std::string& library) {
    static std::mutex mutex;
    static std::map<std::string, Api> opened;
    const std::lock_guard lock(mutex);
    const auto found = opened.find(library);
    return found != opened.end() ? found->second : opened.emplace(library, open_library(library)).first->second;
}

std::string error_name(cl_int code) {
#define TESSERA_OPENCL_CODE(name) \
    case name:                    \
        return fmt::format(#name " ({})", code);
    switch (code) {
        TESSERA_OPENCL_CODE(CL_DEVICE_NOT_FOUND)
        TESSERA_OPENCL_CODE(CL_DEVICE_NOT_AVAILABLE)
        TESSERA_OPENCL_CODE(CL_COMPILER_NOT_AVAILABLE)
        TESSERA_OPENCL_CODE(CL_MEM_OBJECT_ALLOCATION_FAILURE)
        TESSERA_OPENCL_CODE(CL_OUT_OF_RESOURCES)
        TESSERA_OPENCL_CODE(CL_OUT_OF_HOST_MEMORY)
        TESSERA_OPENCL_CODE(CL_PROFILING_INFO_NOT_AVAILABLE)
        TESSERA_OPENCL_CODE(CL_BUILD_PROGRAM_FAILURE)
        TESSERA_OPENCL_CODE(CL_MISALIGNED_SUB_BUFFER_OFFSET)
        TESSERA_OPENCL_CODE(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST)
        TESSERA_OPENCL_CODE(CL_INVALID_VALUE)
        TESSERA_OPENCL_CODE(CL_INVALID_DEVICE)
        TESSERA_OPENCL_CODE(CL_INVALID_CONTEXT)
        TESSERA_OPENCL_CODE(CL_INVALID_QUEUE_PROPERTIES)
        TESSERA_OPENCL_CODE(CL_INVALID_COMMAND_QUEUE)
        TESSERA_OPENCL_CODE(CL_INVALID_MEM_OBJECT)
        TESSERA_OPENCL_CODE(CL_INVALID_BUILD_OPTIONS)
        TESSERA_OPENCL_CODE(CL_INVALID_PROGRAM_EXECUTABLE)
        TESSERA_OPENCL_CODE(CL_INVALID_KERNEL_NAME)
        TESSERA_OPENCL_CODE(CL_INVALID_KERNEL_ARGS)
        TESSERA_OPENCL_CODE(CL_INVALID_ARG_INDEX)
        TESSERA_OPENCL_CODE(CL_INVALID_ARG_SIZE)
        TESSERA_OPENCL_CODE(CL_INVALID_WORK_GROUP_SIZE)
        TESSERA_OPENCL_CODE(CL_INVALID_WORK_ITEM_SIZE)
        TESSERA_OPENCL_CODE(CL_INVALID_GLOBAL_WORK_SIZE)
        TESSERA_OPENCL_CODE(CL_INVALID_BUFFER_SIZE)
        TESSERA_OPENCL_CODE(CL_INVALID_OPERATION)
        default:
            return fmt::format("error {}", code);
    }
#undef TESSERA_OPENCL_CODE
}

void check(cl_int code, const std::string& action) {
    if (code != CL_SUCCESS) {
        throw Error(ErrorKind::device_unavailable, fmt::format("OpenCL could not {}: {}.", action, error_name(code)));
    }
}

}  // namespace tessera::backends::opencl
