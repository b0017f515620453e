#include "backends/vulkan/timed_draw.hpp"

#include <algorithm>
#include <cstring>

#include "backends/vulkan/device_info.hpp"
#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/timed_draw_pipeline.hpp"

namespace tessera::backends::vulkan {
namespace {

using bench::Destination;
using Usage = vk::BufferUsageFlagBits;

/// Bytes of a captured triangle.
constexpr std::uint64_t triangle_bytes = 3 * sizeof(Vertex);
/// Most that is captured before the capture starts over at the front of its buffer.
constexpr std::uint64_t capture_bytes = 64ull << 20;

template <typename T>
BufferAllocation create_filled(const Context& context, std::span<const T> content, std::string_view label) {
    BufferAllocation buffer =
        create_buffer(context, content.size_bytes(), Usage::eStorageBuffer, MemoryUse::upload, label);
    std::memcpy(buffer.allocation.mapped, content.data(), content.size_bytes());
    flush(context, buffer.allocation, 0, content.size_bytes());
    return buffer;
}

class VulkanTimedDraw final : public bench::TimedDraw {
public:
    VulkanTimedDraw(std::shared_ptr<const Context> context, Destination destination, const bench::TimedPatches& patches)
        : context_(std::move(context)),
          destination_(destination),
          patch_count_(static_cast<std::uint32_t>(patches.factors.size())),
          draw_patches_(patches.draw_patches),
          factors_(create_filled(*context_, patches.factors, "factors of timed draws")),
          corners_(create_filled(*context_, patches.corners, "corners of timed draws")),
          timed_(create_timed_pipeline(*context_, destination, patches.partitioning)) {
        if (destination_ == Destination::captured) {
            const std::uint64_t per_patch = std::max<std::uint64_t>(patches.most_triangles, 1) * triangle_bytes;
            capture_patches_ = static_cast<std::uint32_t>(std::max<std::uint64_t>(capture_bytes / per_patch, 1));
            draw_patches_ = std::min(draw_patches_, capture_patches_);
            capture_patches_ = capture_patches_ / draw_patches_ * draw_patches_;
            captured_ = create_buffer(*context_, capture_patches_ * per_patch, Usage::eTransformFeedbackBufferEXT,
                                      MemoryUse::readback, "capture of timed draws");
        }
        guarded("preparing timed draws", [&] {
            const vk::raii::Device& device = context_->device;
            const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 2);
            pool_ = vk::raii::DescriptorPool(
                device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size));
            const vk::DescriptorSetLayout layout = *timed_.set_layout;
            set_ = std::move(vk::raii::DescriptorSets(device, vk::DescriptorSetAllocateInfo(*pool_, layout)).front());
            const std::array buffers = {vk::DescriptorBufferInfo(*factors_.buffer, 0, VK_WHOLE_SIZE),
                                        vk::DescriptorBufferInfo(*corners_.buffer, 0, VK_WHOLE_SIZE)};
            device.updateDescriptorSets(
                vk::WriteDescriptorSet(*set_, 0, 0, vk::DescriptorType::eStorageBuffer, {}, buffers), {});
            if (destination_ == Destination::captured) {
                queries_ = vk::raii::QueryPool(
                    device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTransformFeedbackStreamEXT, captures()));
            }
        });
    }

    void run() override {
        submit_and_wait(*context_, [&](const vk::raii::CommandBuffer& commands) { record(commands); });
    }

    std::uint64_t captured_triangles() override {
        std::uint64_t sum = 0;
        for (std::uint32_t i = 0; destination_ == Destination::captured && i < captures(); ++i) {
            using Counts = std::array<std::uint64_t, 2>;  // primitives written, primitives needed
            guarded("counting what was captured", [&] {
                const auto [result, counts] = queries_.getResult<Counts>(
                    i, 1, sizeof(Counts), vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
                if (result != vk::Result::eSuccess) throw vk::SystemError(vk::make_error_code(result));
                sum += counts[0];
            });
        }
        return sum;
    }

    std::vector<Vertex> captured(std::size_t count) override {
        if (destination_ != Destination::captured) return {};
        count = std::min<std::size_t>(count, captured_.allocation.size / sizeof(Vertex));
        guarded("reading what was captured",
                [&] { invalidate(*context_, captured_.allocation, 0, count * sizeof(Vertex)); });
        std::vector<Vertex> vertices(count);
        std::memcpy(vertices.data(), captured_.allocation.mapped, count * sizeof(Vertex));
        return vertices;
    }

private:
    std::uint32_t captures() const { return (patch_count_ + capture_patches_ - 1) / capture_patches_; }

    void draw(const vk::raii::CommandBuffer& commands, std::uint32_t first, std::uint32_t last) const {
        for (; first < last; first += draw_patches_) {
            const OracleConstants constants{first, 3u, 0.0f};
            commands.pushConstants<OracleConstants>(*timed_.layout, OraclePipelines::constant_stages, 0, constants);
            commands.draw(std::min(draw_patches_, last - first), 1, 0, 0);
        }
    }

    void record(const vk::raii::CommandBuffer& commands) const {
        const bool captured = destination_ == Destination::captured;
        if (captured) commands.resetQueryPool(*queries_, 0, captures());
        const vk::ClearValue background(vk::ClearColorValue(std::array<float, 4>{}));
        const vk::Rect2D area({}, {TimedPipeline::side, TimedPipeline::side});
        commands.beginRenderPass(vk::RenderPassBeginInfo(*timed_.pass, *timed_.framebuffer, area, background),
                                 vk::SubpassContents::eInline);
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *timed_.pipeline);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *timed_.layout, 0, *set_, {});
        if (!captured) {
            draw(commands, 0, patch_count_);
        } else {
            // Each capture writes over the one before: the stage's work counts, not the size of the memory.
            for (std::uint32_t i = 0; i < captures(); ++i) {
                const vk::DeviceSize offset = 0;
                const vk::DeviceSize size = captured_.allocation.size;
                commands.bindTransformFeedbackBuffersEXT(0, *captured_.buffer, offset, size);
                commands.beginQuery(*queries_, i, {});
                commands.beginTransformFeedbackEXT(0, {}, {});
                draw(commands, i * capture_patches_, std::min(patch_count_, (i + 1) * capture_patches_));
                commands.endTransformFeedbackEXT(0, {}, {});
                commands.endQuery(*queries_, i);
            }
        }
        commands.endRenderPass();
        if (captured) {
            const vk::MemoryBarrier readable(vk::AccessFlagBits::eTransformFeedbackWriteEXT,
                                             vk::AccessFlagBits::eHostRead);
            commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransformFeedbackEXT, vk::PipelineStageFlagBits::eHost,
                                     {}, readable, {}, {});
        }
    }

    std::shared_ptr<const Context> context_;
    Destination destination_;
    std::uint32_t patch_count_, draw_patches_;
    std::uint32_t capture_patches_ = 1;  // what the capture buffer holds, a multiple of draw_patches_
    BufferAllocation factors_, corners_, captured_;
    TimedPipeline timed_;
    vk::raii::DescriptorPool pool_{nullptr};
    vk::raii::DescriptorSet set_{nullptr};
    vk::raii::QueryPool queries_{nullptr};
};

class VulkanTimedStage final : public bench::TimedStage {
public:
    VulkanTimedStage(Context context, gpu::DeviceInfo info)
        : context_(std::make_shared<const Context>(std::move(context))), info_(std::move(info)) {}

    const gpu::DeviceInfo& info() const override { return info_; }

    std::unique_ptr<bench::TimedDraw> prepare(Destination destination, const bench::TimedPatches& patches) override {
        if (patches.partitioning == Partitioning::pow2 || patches.partitioning == Partitioning::uniform) {
            throw Error(ErrorKind::usage,
                        fmt::format("The tessellation stage of Vulkan has no spacing for the partitioning {}; choose "
                                    "integer, fractional_odd or fractional_even.",
                                    name(patches.partitioning)));
        }
        if (destination == Destination::captured && !info_.transform_feedback) {
            throw Error(ErrorKind::device_unavailable,
                        fmt::format("'{}' has no transform feedback to capture with.", info_.name));
        }
        return std::make_unique<VulkanTimedDraw>(context_, destination, patches);
    }

private:
    std::shared_ptr<const Context> context_;
    gpu::DeviceInfo info_;
};

}  // namespace

std::unique_ptr<bench::TimedStage> open_timed_stage(std::size_t index) {
    std::shared_ptr<const Instance> instance = shared_instance();
    vk::raii::PhysicalDevice physical = usable_device(*instance, index);
    gpu::DeviceInfo info = guarded("describing a device", [&] { return describe(physical, index); });
    if (!info.rasteriser || !info.tessellation_stage) {
        throw Error(ErrorKind::device_unavailable, fmt::format("'{}' has no tessellation stage.", info.name));
    }
    std::vector<const char*> extensions;
    if (info.transform_feedback) extensions.push_back(VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME);
    const vk::PhysicalDeviceTransformFeedbackFeaturesEXT feedback(VK_TRUE);
    vk::PhysicalDeviceFeatures wanted;
    wanted.tessellationShader = VK_TRUE;
    Context context = create_context(std::move(instance), std::move(physical), wanted, extensions,
                                     info.transform_feedback ? &feedback : nullptr);
    return std::make_unique<VulkanTimedStage>(std::move(context), std::move(info));
}

}  // namespace tessera::backends::vulkan
