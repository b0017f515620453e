#include "backends/reference/reference_backend.hpp"

#include "backends/reference/cpu_name.hpp"
#include "backends/reference/objects.hpp"
#include "backends/reference/run_commands.hpp"
#include "base/error.hpp"
#include "gpu/kernel_catalog.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/version.h>

#include <cstring>
#include <new>

namespace tessera::backends::reference {

namespace {

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

gpu::DeviceInfo describe() {
    gpu::DeviceInfo info;
    info.id = "reference";
    info.backend = "reference";
    info.name = cpu_name();
    info.driver = fmt::format("C++ on oneTBB {}", TBB_runtime_version());
    info.version = fmt::format("{}, {} kernels", compiler(), gpu::reference_instruction_set());
    info.software = true;
    info.timestamps = true;
    info.compute_units = static_cast<std::uint32_t>(oneapi::tbb::info::default_concurrency());
    info.limits.max_buffer_size = 1ull << 30;  // otherwise WebGPU's limits, so that what runs here runs anywhere
    info.float_controls = {.preserves_denormals = true,
                           .flushes_denormals = false,
                           .preserves_nan_and_infinity = true,
                           .rounds_to_nearest_even = true};
    return info;
}

class ReferenceBackend final : public gpu::Backend {
public:
    const gpu::DeviceInfo& info() const override { return info_; }

    std::unique_ptr<gpu::BackendObject> create_buffer(const gpu::BufferDescriptor& descriptor) override {
        try {
            return std::make_unique<Buffer>(descriptor.size);
        } catch (const std::bad_alloc&) {
            throw Error(ErrorKind::device_unavailable,
                        fmt::format("The reference device has no memory for buffer '{}' of {} bytes.", descriptor.label,
                                    descriptor.size));
        }
    }

    std::unique_ptr<gpu::BackendObject> create_pipeline(const gpu::Kernel& kernel) override {
        if (kernel.reference == nullptr) {
            throw Error(ErrorKind::usage,
                        fmt::format("Kernel '{}' has no C++ form, which the reference device needs.", kernel.name));
        }
        return std::make_unique<Pipeline>(kernel);
    }

    std::unique_ptr<gpu::BackendObject> create_bind_group(gpu::BackendObject& pipeline,
                                                          std::span<const gpu::BoundBuffer> resources) override {
        const gpu::Kernel& kernel = static_cast<Pipeline&>(pipeline).kernel;
        auto group = std::make_unique<BindGroup>();
        for (std::size_t slot = 0; slot < resources.size(); ++slot) {
            const gpu::BoundBuffer& bound = resources[slot];
            group->slots[slot] = static_cast<Buffer*>(bound.buffer)->memory + bound.offset;
            if (kernel.bindings[slot].kind == gpu::BindingKind::uniform) {
                group->uniform_slot = static_cast<std::uint32_t>(slot);
            }
        }
        return group;
    }

    std::unique_ptr<gpu::BackendObject> create_query_set(std::uint32_t count) override {
        return std::make_unique<QuerySet>(count);
    }

    void write_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<const std::byte> data) override {
        std::memcpy(static_cast<Buffer&>(buffer).memory + offset, data.data(), data.size());
    }

    void read_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<std::byte> data) override {
        std::memcpy(data.data(), static_cast<Buffer&>(buffer).memory + offset, data.size());
    }

    void submit(std::span<const gpu::Command> commands) override { run_commands(commands, info_.limits); }

    void wait() override {}  // submit returns when all is done

private:
    gpu::DeviceInfo info_ = describe();
};

}  // namespace

Inventory list() {
    Inventory inventory;
    inventory.devices.push_back(describe());
    return inventory;
}

std::unique_ptr<gpu::Backend> open(std::size_t index) {
    if (index != 0) {
        throw Error(ErrorKind::device_unavailable, fmt::format("There is one reference device, not number {}.", index));
    }
    return std::make_unique<ReferenceBackend>();
}

}  // namespace tessera::backends::reference
