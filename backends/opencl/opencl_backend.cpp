#include "backends/opencl/opencl_backend.hpp"

#include "backends/opencl/opencl_submit.hpp"
#include "base/error.hpp"

#include <fmt/format.h>

namespace tessera::backends::opencl {

namespace {

class OpenClBackend : public gpu::Backend {
public:
    OpenClBackend(const Api& api, FoundDevice found) : session_(open_session(api, std::move(found))) {}
    ~OpenClBackend() override { session_.api.clFinish(session_.queue.get()); }  // the staging is read until then

    const gpu::DeviceInfo& info() const override { return session_.found.info; }

    std::unique_ptr<gpu::BackendObject> create_buffer(const gpu::BufferDescriptor& descriptor) override {
        return std::make_unique<BufferObject>(session_, descriptor);
    }
    std::unique_ptr<gpu::BackendObject> create_pipeline(const gpu::Kernel& kernel) override {
        return std::make_unique<PipelineObject>(session_, kernel);
    }
    std::unique_ptr<gpu::BackendObject> create_bind_group(gpu::BackendObject& pipeline,
                                                          std::span<const gpu::BoundBuffer> resources) override {
        return std::make_unique<BindGroupObject>(session_, static_cast<PipelineObject&>(pipeline), resources);
    }
    std::unique_ptr<gpu::BackendObject> create_query_set(std::uint32_t count) override {
        return std::make_unique<QuerySetObject>(count);
    }
    void write_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<const std::byte> data) override {
        enqueue_write(session_, staging_, static_cast<BufferObject&>(buffer), offset, data);
    }
    void read_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<std::byte> data) override {
        read_now(session_, staging_, static_cast<BufferObject&>(buffer), offset, data);
    }
    void submit(std::span<const gpu::Command> commands) override { enqueue_commands(session_, staging_, commands); }
    void wait() override {
        session_.check(session_.api.clFinish(session_.queue.get()), "finish");
        staging_.recycle();
    }

private:
    Session session_;
    Staging staging_;
};

}  // namespace

std::unique_ptr<gpu::Backend> open(std::size_t index) {
    Findings findings = find_devices();
    if (index < findings.devices.size()) {
        return std::make_unique<OpenClBackend>(*findings.api, std::move(findings.devices[index]));
    }
    std::string sentence = fmt::format("There is no OpenCL device {}: {} can be used.", index, findings.devices.size());
    for (const gpu::UnusableDevice& unusable : findings.unusable) {
        sentence += " " + unusable.reason;
    }
    throw Error(ErrorKind::device_unavailable, sentence);
}

}  // namespace tessera::backends::opencl
