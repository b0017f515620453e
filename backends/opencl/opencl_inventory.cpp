#include "backends/opencl/opencl_inventory.hpp"

#include "backends/opencl/opencl_backend.hpp"
#include "base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tessera::backends::opencl {

namespace {

// What the loader answers where it knows no platform (cl_khr_icd).
constexpr cl_int platform_not_found = -1001;

// A driver that fails is listed with its error and does not hide the others.
template <typename Action>
void report_errors(Findings& findings, Action action) {
    try {
        action();
    } catch (const Error& error) {
        findings.unusable.push_back({"opencl", "", error.what()});
    }
}

void add_device(Findings& findings, cl_platform_id platform, cl_device_id device) {
    FoundDevice found{platform, device, query_device(*findings.api, platform, device), {}};
    const std::vector<std::string> reasons = refusals(found.facts);
    if (!reasons.empty()) {
        findings.unusable.push_back(
            {"opencl", found.facts.name,
             fmt::format("The OpenCL device \"{}\" cannot be used: {}.", found.facts.name, fmt::join(reasons, "; "))});
        return;
    }
    found.info = describe(found.facts, fmt::format("opencl:{}", findings.devices.size()));
    findings.devices.push_back(std::move(found));
}

void add_platform(Findings& findings, cl_platform_id platform) {
    const Api& api = *findings.api;
    cl_uint count = 0;
    const cl_int code = api.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count);
    if (code == CL_DEVICE_NOT_FOUND || (code == CL_SUCCESS && count == 0)) {
        findings.unusable.push_back({"opencl", "",
                                     "An OpenCL platform is installed but it has no device. (PoCL needs a "
                                     "folder that it may write: POCL_CACHE_DIR names one.)"});
        return;
    }
    check(code, "count the devices of a platform");
    std::vector<cl_device_id> devices(count);
    check(api.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, devices.data(), nullptr),
          "list the devices of a platform");
    for (cl_device_id device : devices) {
        report_errors(findings, [&] { add_device(findings, platform, device); });
    }
}

void add_platforms(Findings& findings) {
    cl_uint count = 0;
    const cl_int code = findings.api->clGetPlatformIDs(0, nullptr, &count);
    if (code == platform_not_found || (code == CL_SUCCESS && count == 0)) {
        findings.unusable.push_back({"opencl", "",
                                     "The OpenCL loader is installed but knows no platform; install a driver, on "
                                     "Debian pocl-opencl-icd."});
        return;
    }
    check(code, "count the platforms");
    std::vector<cl_platform_id> platforms(count);
    check(findings.api->clGetPlatformIDs(count, platforms.data(), nullptr), "list the platforms");
    for (cl_platform_id platform : platforms) {
        report_errors(findings, [&] { add_platform(findings, platform); });
    }
}

}  // namespace

Findings find_devices(const std::string& library) {
    Findings findings;
    report_errors(findings, [&] {
        findings.api = &load_api(library);
        add_platforms(findings);
    });
    return findings;
}

Inventory inventory(const Findings& findings) {
    Inventory result;
    for (const FoundDevice& found : findings.devices) {
        result.devices.push_back(found.info);
    }
    result.unusable = findings.unusable;
    return result;
}

Inventory list() {
    return inventory(find_devices());
}

}  // namespace tessera::backends::opencl
