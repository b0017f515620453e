// An opened OpenCL device and short words for what the tests do with it.
#pragma once

#include "backends/opencl/opencl_backend.hpp"
#include "support/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tessera::test {

using gpu::BackendObject;
using gpu::BindingKind;
using Object = std::unique_ptr<BackendObject>;

/// Runs on the first OpenCL device; skips where there is none (fails where everything is required).
class OpenClTest : public testing::Test {
protected:
    void SetUp() override {
        const auto found = backends::opencl::list();
        if (found.devices.empty()) {
            if (everything_required()) {
                FAIL() << found.unusable.front().reason;
            }
            GTEST_SKIP() << found.unusable.front().reason;
        }
        device = backends::opencl::open(0);
    }

    Object buffer(std::uint64_t size, const std::string& label = "test") {
        using enum gpu::BufferUsage;
        return device->create_buffer({label, size, storage | uniform | copy_source | copy_destination | indirect});
    }
    template <typename T>
    Object buffer_of(const std::vector<T>& values) {
        Object made = buffer(values.size() * sizeof(T));
        write(made, 0, values);
        return made;
    }
    template <typename T>
    void write(const Object& to, std::uint64_t offset, const std::vector<T>& values) {
        device->write_buffer(*to, offset, std::as_bytes(std::span(values)));
    }
    template <typename T>
    std::vector<T> read(const Object& from, std::size_t count, std::uint64_t offset = 0) {
        std::vector<T> values(count);
        device->read_buffer(*from, offset, std::as_writable_bytes(std::span(values)));
        return values;
    }
    Object bind(const Object& pipeline, const std::vector<gpu::BoundBuffer>& resources) {
        return device->create_bind_group(*pipeline, resources);
    }
    void submit(const std::vector<gpu::Command>& commands) { device->submit(commands); }

    std::unique_ptr<gpu::Backend> device;
};

/// A kernel in its OpenCL form only. `source` must outlive it.
inline gpu::Kernel opencl_kernel(const std::string& name, std::vector<gpu::KernelBinding> bindings,
                                 std::string_view source) {
    gpu::Kernel kernel;
    kernel.name = name;
    kernel.bindings = std::move(bindings);
    kernel.opencl_source = source;
    return kernel;
}

struct ScaleParams {
    std::uint32_t count;
    float factor;
};

/// output[i] = input[i] * factor + 1 for i < count.
inline gpu::Kernel scale_kernel() {
    return opencl_kernel(
        "scale", {{0, BindingKind::read_storage, 4}, {1, BindingKind::write_storage, 4}, {2, BindingKind::uniform, 8}},
        "#pragma OPENCL FP_CONTRACT OFF\n"
        "typedef struct { uint count; float factor; } Params;\n"
        "__kernel void scale(__global const float* restrict input, __global float* restrict output,\n"
        "                    __global const Params* restrict params) {\n"
        "    uint i = (uint)get_global_id(0) + (uint)get_global_id(1) * (uint)get_global_size(0);\n"
        "    if (i < params->count) output[i] = input[i] * params->factor + 1.0f;\n"
        "}\n");
}

}  // namespace tessera::test
