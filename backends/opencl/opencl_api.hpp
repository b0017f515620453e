// The OpenCL functions that the backend uses, found at run time, and handles that release what they hold.
#pragma once

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <memory>
#include <string>
#include <type_traits>

namespace tessera::backends::opencl {

// Every function used; all are of OpenCL 1.2 or older.
// clang-format off
#define TESSERA_OPENCL_FUNCTIONS(X)                                                                        \
    X(clGetPlatformIDs) X(clGetPlatformInfo) X(clGetDeviceIDs) X(clGetDeviceInfo)                          \
    X(clCreateContext) X(clReleaseContext) X(clCreateCommandQueue) X(clReleaseCommandQueue)                \
    X(clCreateBuffer) X(clCreateSubBuffer) X(clSetMemObjectDestructorCallback) X(clReleaseMemObject)       \
    X(clCreateProgramWithSource) X(clBuildProgram) X(clGetProgramBuildInfo) X(clReleaseProgram)            \
    X(clCreateKernel) X(clGetKernelInfo) X(clGetKernelWorkGroupInfo) X(clSetKernelArg) X(clReleaseKernel)  \
    X(clEnqueueNDRangeKernel) X(clEnqueueReadBuffer) X(clEnqueueWriteBuffer) X(clEnqueueCopyBuffer)        \
    X(clEnqueueFillBuffer) X(clEnqueueMarkerWithWaitList) X(clFlush) X(clFinish)                           \
    X(clWaitForEvents) X(clGetEventProfilingInfo) X(clReleaseEvent)
// clang-format on

/// The function table of one OpenCL loader.
struct Api {
#define TESSERA_OPENCL_MEMBER(name) decltype(&::name) name = nullptr;
    TESSERA_OPENCL_FUNCTIONS(TESSERA_OPENCL_MEMBER)
#undef TESSERA_OPENCL_MEMBER
};

/// The loader's usual file name.
inline constexpr const char* default_library = "libOpenCL.so.1";

/// Opens a loader and finds every function. The library is never closed, because drivers leave threads behind; a
/// second call for the same name is cheap. Throws Error(device_unavailable) where the library or a function is missing.
const Api& load_api(const std::string& library = default_library);

/// "CL_OUT_OF_RESOURCES (-5)", or "error -1234" for a code without a known name.
std::string error_name(cl_int code);

/// Throws Error(device_unavailable) "OpenCL could not <action>: <code>." unless `code` is CL_SUCCESS.
void check(cl_int code, const std::string& action);

template <typename T>
struct Release {
    cl_int(CL_API_CALL* function)(T*) = nullptr;
    void operator()(T* handle) const { function(handle); }
};
template <typename T>
using Handle = std::unique_ptr<std::remove_pointer_t<T>, Release<std::remove_pointer_t<T>>>;

using ContextHandle = Handle<cl_context>;
using QueueHandle = Handle<cl_command_queue>;
using MemoryHandle = Handle<cl_mem>;
using ProgramHandle = Handle<cl_program>;
using KernelHandle = Handle<cl_kernel>;
using EventHandle = Handle<cl_event>;

}  // namespace tessera::backends::opencl
