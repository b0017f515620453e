// A backend without a device: it records what the shared code tells it, so that validation is tested anywhere.
#pragma once

#include "gpu/backend.hpp"

#include <string>

namespace tessera::gpu {

/// What a NullBackend was told. Outlives it, for tests of destruction order.
struct NullLog {
    std::vector<std::string> calls;               ///< one short line per call, such as "submit 3"
    std::vector<Command> commands;                ///< of all submits
    std::vector<std::vector<BoundBuffer>> bound;  ///< resources of each bind group
    int objects = 0;                              ///< alive
    bool backend_alive = false;
    bool object_outlived_backend = false;
};

struct NullObject : BackendObject {
    explicit NullObject(NullLog& log) : log(log) { ++log.objects; }
    ~NullObject() override {
        --log.objects;
        log.object_outlived_backend |= !log.backend_alive;
    }
    NullLog& log;
};

class NullBackend final : public Backend {
public:
    NullBackend(NullLog& log, DeviceInfo info) : log_(log), info_(std::move(info)) { log_.backend_alive = true; }
    ~NullBackend() override { log_.backend_alive = false; }

    const DeviceInfo& info() const override { return info_; }
    std::unique_ptr<BackendObject> create_buffer(const BufferDescriptor& descriptor) override {
        return make("buffer " + descriptor.label + " " + std::to_string(descriptor.size));
    }
    std::unique_ptr<BackendObject> create_pipeline(const Kernel& kernel) override {
        return make("pipeline " + kernel.name);
    }
    std::unique_ptr<BackendObject> create_bind_group(BackendObject&, std::span<const BoundBuffer> resources) override {
        log_.bound.emplace_back(resources.begin(), resources.end());
        return make("bind_group " + std::to_string(resources.size()));
    }
    std::unique_ptr<BackendObject> create_query_set(std::uint32_t count) override {
        return make("query_set " + std::to_string(count));
    }
    void write_buffer(BackendObject&, std::uint64_t offset, std::span<const std::byte> data) override {
        log_.calls.push_back("write " + std::to_string(offset) + " " + std::to_string(data.size()));
    }
    void read_buffer(BackendObject&, std::uint64_t offset, std::span<std::byte> data) override {
        log_.calls.push_back("read " + std::to_string(offset) + " " + std::to_string(data.size()));
    }
    void submit(std::span<const Command> commands) override {
        log_.calls.push_back("submit " + std::to_string(commands.size()));
        log_.commands.insert(log_.commands.end(), commands.begin(), commands.end());
    }
    void wait() override { log_.calls.push_back("wait"); }

private:
    std::unique_ptr<BackendObject> make(std::string call) {
        log_.calls.push_back(std::move(call));
        return std::make_unique<NullObject>(log_);
    }

    NullLog& log_;
    DeviceInfo info_;
};

}  // namespace tessera::gpu
