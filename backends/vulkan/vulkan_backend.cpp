#include "backends/vulkan/vulkan_backend.hpp"

#include "backends/vulkan/counters.hpp"
#include "backends/vulkan/device_info.hpp"
#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/pipeline.hpp"
#include "backends/vulkan/recorder.hpp"
#include "backends/vulkan/sharing.hpp"

namespace tessera::backends::vulkan {
namespace {

vk::BufferUsageFlags usage_flags(gpu::BufferUsage usage) {
    using Flag = vk::BufferUsageFlagBits;
    // Any buffer may be written and read through staging, whatever its user may do with it.
    vk::BufferUsageFlags flags = Flag::eTransferSrc | Flag::eTransferDst;
    // What kernels write may be drawn, too.
    if (has(usage, gpu::BufferUsage::storage)) flags |= Flag::eStorageBuffer | Flag::eVertexBuffer | Flag::eIndexBuffer;
    if (has(usage, gpu::BufferUsage::uniform)) flags |= Flag::eUniformBuffer;
    if (has(usage, gpu::BufferUsage::indirect)) flags |= Flag::eIndirectBuffer;
    return flags;
}

class VulkanBackend final : public gpu::Backend {
public:
    VulkanBackend(Context context, gpu::DeviceInfo info, HostAccess access)
        : context_(std::move(context)), info_(std::move(info)), access_(access) {}

    ~VulkanBackend() override { timeline_.drain(); }

    const gpu::DeviceInfo& info() const override { return info_; }

    std::unique_ptr<gpu::BackendObject> create_buffer(const gpu::BufferDescriptor& descriptor) override {
        const MemoryUse use = access_ == HostAccess::staged ? MemoryUse::unmapped : MemoryUse::device;
        auto made =
            vulkan::create_buffer(context_, descriptor.size, usage_flags(descriptor.usage), use, descriptor.label);
        ++counters_.allocations;
        auto buffer = std::make_unique<Buffer>(timeline_, std::move(made));
        guarded("clearing a new buffer", [&] { recorder_.clear(*buffer, descriptor.size); });
        return buffer;
    }

    std::unique_ptr<gpu::BackendObject> create_pipeline(const gpu::Kernel& kernel) override {
        ++counters_.pipelines;
        return vulkan::create_pipeline(context_, timeline_, cache_, kernel);
    }

    std::unique_ptr<gpu::BackendObject> create_bind_group(gpu::BackendObject& pipeline,
                                                          std::span<const gpu::BoundBuffer> resources) override {
        ++counters_.descriptor_sets;
        return vulkan::create_bind_group(context_, timeline_, pools_, static_cast<Pipeline&>(pipeline), resources);
    }

    std::unique_ptr<gpu::BackendObject> create_query_set(std::uint32_t count) override {
        return guarded(fmt::format("creating {} timestamps", count), [&] {
            vk::raii::QueryPool pool(context_.device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, count));
            return std::make_unique<QuerySet>(timeline_, std::move(pool), count);
        });
    }

    void write_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<const std::byte> data) override {
        guarded("writing a buffer", [&] { recorder_.write(static_cast<Buffer&>(buffer), offset, data); });
    }

    void read_buffer(gpu::BackendObject& buffer, std::uint64_t offset, std::span<std::byte> data) override {
        guarded("reading a buffer", [&] { recorder_.read(static_cast<Buffer&>(buffer), offset, data); });
    }

    void submit(std::span<const gpu::Command> commands) override {
        guarded("submitting work", [&] {
            for (const gpu::Command& command : commands)
                recorder_.record(command);
            timeline_.submit();
        });
    }

    void wait() override {
        guarded("waiting for the device", [&] { timeline_.wait_all(); });
    }

    Shared share() { return {context_, timeline_}; }

    Counters counters() const {
        Counters result = counters_;
        result.allocations += recorder_.allocations();
        result.barriers = recorder_.barriers();
        result.descriptor_pools = pools_.size();
        result.submissions = timeline_.current() - 1;
        result.kept = timeline_.kept();
        return result;
    }

private:
    // In this order: what the timeline keeps goes before the pools and the device that it came from.
    Context context_;
    gpu::DeviceInfo info_;
    HostAccess access_;
    PipelineCache cache_{context_};
    DescriptorPools pools_{context_};
    Counters counters_;
    Timeline timeline_{context_};
    Recorder recorder_{context_, timeline_};
};

}  // namespace

Counters counters(const gpu::Backend& backend) {
    return dynamic_cast<const VulkanBackend&>(backend).counters();
}

Shared share(const gpu::Device& device) {
    return dynamic_cast<VulkanBackend&>(device.backend()).share();
}

Inventory list() {
    Inventory inventory;
    try {
        const std::shared_ptr<const Instance> instance = shared_instance();
        const std::vector<Candidate> all = candidates(*instance);
        for (std::size_t i = 0; i < all.size(); ++i) {
            gpu::DeviceInfo info = guarded("describing a device", [&] { return describe(all[i].physical, i); });
            if (all[i].objections.empty()) {
                inventory.devices.push_back(std::move(info));
            } else {
                inventory.unusable.push_back({info.id, info.name, refusal(all[i])});
            }
        }
    } catch (const Error& error) {
        inventory.unusable.push_back({"vulkan", "Vulkan", error.what()});
    }
    return inventory;
}

std::unique_ptr<gpu::Backend> open(std::size_t index, HostAccess access) {
    vk::PhysicalDeviceFeatures wanted;
    wanted.fullDrawIndexUint32 = VK_TRUE;  // for what is drawn from its buffers
    Context context = create_context(index, wanted);
    return guarded("opening a device", [&]() -> std::unique_ptr<gpu::Backend> {
        gpu::DeviceInfo info = describe(context.physical, index);
        return std::make_unique<VulkanBackend>(std::move(context), std::move(info), access);
    });
}

}  // namespace tessera::backends::vulkan
