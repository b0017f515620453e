#include "backends/vulkan/fixed_function_capture.hpp"

#include <algorithm>
#include <cstring>

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;
using Usage = vk::BufferUsageFlagBits;

/// Large draws slow lavapipe down out of proportion.
constexpr std::uint32_t draw_patches = 16;

/// Vertices of the largest patch, all factors 64, listed per primitive.
std::uint64_t most_vertices(Domain domain) {
    constexpr std::uint64_t triangle = 6144 * 3, quad = 8192 * 3, isoline = 64 * 64 * 2;
    return domain == Domain::triangle ? triangle : domain == Domain::quad ? quad : isoline;
}

std::uint32_t vertices_per_primitive(Domain domain) {
    return domain == Domain::isoline ? 2 : 3;
}

constexpr std::uint64_t capture_size =
    OracleCapture::run_patches *
    std::max<std::uint64_t>(8192 * 3 * OracleCapture::domain_stride, 6144 * 3 * OracleCapture::surface_stride);

template <typename T>
void upload(const Context& context, const BufferAllocation& buffer, std::span<const T> content) {
    if (content.empty()) return;
    std::memcpy(buffer.allocation.mapped, content.data(), content.size_bytes());
    flush(context, buffer.allocation, 0, content.size_bytes());
}

}  // namespace

OracleCapture::OracleCapture(const Context& context, OraclePipelines& pipelines)
    : context_(context), pipelines_(pipelines) {
    factors_ = create_buffer(context, run_patches * sizeof(PatchFactors), Usage::eStorageBuffer, MemoryUse::upload,
                             "oracle factors");
    corners_ = create_buffer(context, run_patches * 3 * sizeof(Vertex), Usage::eStorageBuffer, MemoryUse::upload,
                             "oracle corners");
    captured_ =
        create_buffer(context, capture_size, Usage::eTransformFeedbackBufferEXT, MemoryUse::readback, "oracle capture");
    guarded("preparing to capture", [&] {
        framebuffer_ = vk::raii::Framebuffer(
            context.device, vk::FramebufferCreateInfo({}, pipelines.render_pass(), 0, nullptr, 1, 1, 1));
        const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 2);
        pool_ = vk::raii::DescriptorPool(
            context.device,
            vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size));
        const vk::DescriptorSetLayout layout = pipelines.set_layout();
        set_ =
            std::move(vk::raii::DescriptorSets(context.device, vk::DescriptorSetAllocateInfo(*pool_, layout)).front());
        const std::array buffers = {vk::DescriptorBufferInfo(*factors_.buffer, 0, VK_WHOLE_SIZE),
                                    vk::DescriptorBufferInfo(*corners_.buffer, 0, VK_WHOLE_SIZE)};
        context.device.updateDescriptorSets(
            vk::WriteDescriptorSet(*set_, 0, 0, vk::DescriptorType::eStorageBuffer, {}, buffers), {});
        query_ = vk::raii::QueryPool(context.device,
                                     vk::QueryPoolCreateInfo({}, vk::QueryType::eTransformFeedbackStreamEXT, 1));
    });
}

void OracleCapture::record(const vk::raii::CommandBuffer& commands, const OracleVariant& variant, float alpha,
                           std::uint32_t patch_count, std::uint64_t capture_bytes) const {
    const vk::PipelineLayout layout = pipelines_.layout();
    commands.resetQueryPool(*query_, 0, 1);
    commands.beginRenderPass(vk::RenderPassBeginInfo(pipelines_.render_pass(), *framebuffer_, vk::Rect2D({}, {1, 1})),
                             vk::SubpassContents::eInline);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipelines_.get(variant));
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, layout, 0, *set_, {});
    const vk::DeviceSize offset = 0;
    commands.bindTransformFeedbackBuffersEXT(0, *captured_.buffer, offset, capture_bytes);
    commands.beginQuery(*query_, 0, {});
    commands.beginTransformFeedbackEXT(0, {}, {});
    for (std::uint32_t first = 0; first < patch_count; first += draw_patches) {
        const OracleConstants constants{first, variant.domain == Domain::triangle ? 3u : 4u, alpha};
        commands.pushConstants<OracleConstants>(layout, OraclePipelines::constant_stages, 0, constants);
        commands.draw(std::min(draw_patches, patch_count - first), 1, 0, 0);
    }
    commands.endTransformFeedbackEXT(0, {}, {});
    commands.endQuery(*query_, 0);
    commands.endRenderPass();
    const vk::MemoryBarrier readable(Access::eTransformFeedbackWriteEXT, Access::eHostRead);
    commands.pipelineBarrier(Stage::eTransformFeedbackEXT, Stage::eHost, {}, readable, {}, {});
}

std::span<const std::byte> OracleCapture::run(const OracleVariant& variant, float alpha,
                                              std::span<const PatchFactors> factors, std::span<const Vertex> corners) {
    const std::uint32_t stride = variant.surface ? surface_stride : domain_stride;
    const std::uint64_t capture_bytes = factors.size() * most_vertices(variant.domain) * stride;
    upload(context_, factors_, factors);
    upload(context_, corners_, corners);
    submit_and_wait(context_, [&](const vk::raii::CommandBuffer& commands) {
        record(commands, variant, alpha, static_cast<std::uint32_t>(factors.size()), capture_bytes);
    });
    return guarded("reading what the tessellation stage made", [&] {
        using Counts = std::array<std::uint64_t, 2>;  // primitives written, primitives needed
        const auto [result, counts] = query_.getResult<Counts>(
            0, 1, sizeof(Counts), vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        if (result != vk::Result::eSuccess) throw vk::SystemError(vk::make_error_code(result));
        if (counts[0] != counts[1]) {
            throw Error(ErrorKind::device_unavailable,
                        fmt::format("The tessellation stage of '{}' made {} primitives of {} patches, and only {} were "
                                    "captured; its driver cannot serve as an oracle.",
                                    context_.properties.deviceName.data(), counts[1], factors.size(), counts[0]));
        }
        const std::uint64_t bytes = counts[0] * vertices_per_primitive(variant.domain) * stride;
        invalidate(context_, captured_.allocation, 0, bytes);
        return std::span<const std::byte>(captured_.allocation.mapped, bytes);
    });
}

}  // namespace tessera::backends::vulkan
