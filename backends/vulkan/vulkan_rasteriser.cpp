#include "backends/vulkan/vulkan_rasteriser.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/raster_pipelines.hpp"
#include "backends/vulkan/raster_stream.hpp"
#include "backends/vulkan/raster_textures.hpp"
#include "backends/vulkan/sharing.hpp"
#include "render/triangle_batches.hpp"

namespace tessera::backends::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;

/// The view's rotation: its axes without their common length.
glm::mat4 rotation_of(const glm::mat4& view) {
    const glm::dmat3 axes{glm::mat3(view)};
    return glm::mat4(glm::mat3(axes / glm::length(axes[0])));
}

MaterialConstants constants_of(const scene::Material& material) {
    MaterialConstants constants{material.base_color, 0.0f, 0};
    if (material.alpha_mode == scene::AlphaMode::mask) constants.alpha_cutoff = material.alpha_cutoff;
    if (material.alpha_mode == scene::AlphaMode::blend) constants.keeps_alpha = 1;
    return constants;
}

class VulkanRasteriser : public render::Rasteriser {
public:
    explicit VulkanRasteriser(const gpu::Device& device)
        : device_(device),
          context_(share(device).context),
          timeline_(share(device).timeline),
          passes_(create_raster_passes(context_)),
          pipelines_(context_, passes_),
          textures_(context_, pipelines_.sampler_set_layout()),
          stream_(context_) {
        guarded("preparing to draw", [&] { create_sets(); });
    }

    void begin(const render::Frame& frame) override {
        if (frame.samples != 4) {
            throw Error(ErrorKind::usage, fmt::format("A Vulkan device draws with 4 samples per pixel, not {}; the "
                                                      "portable rasteriser draws with 1 or 4.",
                                                      frame.samples));
        }
        stream_.finish();
        stream_.set_frame({}, {});
        if (frame.width != targets_.width || frame.height != targets_.height) {
            targets_ = {};  // before the new ones take their memory
            targets_ = create_raster_targets(context_, passes_, frame.width, frame.height);
            const vk::DescriptorImageInfo samples(*sample_reader_, *targets_.colour.view,
                                                  Layout::eShaderReadOnlyOptimal);
            context_.device.updateDescriptorSets(
                vk::WriteDescriptorSet(resolve_set_, 0, 0, vk::DescriptorType::eCombinedImageSampler, samples), {});
        }
        const FrameConstants constants{frame.camera.view, frame.camera.projection, rotation_of(frame.camera.view)};
        std::memcpy(constants_.allocation.mapped, &constants, sizeof(constants));
        flush(context_, constants_.allocation, 0, sizeof(constants));
        shading_ = frame.shading;
        background_ = frame.background;
        cleared_ = false;
        materials_.clear();
        state_ = State::begun;
    }

    void set_materials(const std::vector<scene::Material>& materials,
                       const std::vector<scene::SceneImage>& images) override {
        require(State::begun, "set_materials", "begin");
        textures_.upload(stream_, materials, images);
        materials_ = materials;
        stream_.set_frame([this](const vk::raii::CommandBuffer& commands) { begin_pass(commands); },
                          [](const vk::raii::CommandBuffer& commands) { end_pass(commands); });
        state_ = State::drawing;
    }

    using Rasteriser::draw;
    void draw(const render::Draw& draw) override {
        require(State::drawing, "draw", "set_materials");
        render::check_draw(draw, materials_.size());
        for (auto indices = draw.indices; !indices.empty();) {
            const render::TriangleBatch batch = render::take_batch(indices, draw.vertices.size());
            draw_batch(batch, draw);
            indices = indices.subspan(batch.indices.size());
        }
    }

    // A wireframe tells corners by their place in a draw without indices.
    bool draws_from(const gpu::Device& device) const override {
        return device == device_ && shading_ != render::Shading::wireframe &&
               context_.features.fullDrawIndexUint32 == VK_TRUE;
    }

    void draw(std::span<const render::DeviceDraw> draws) override {
        require(State::drawing, "draw", "set_materials");
        if (!draws_from(device_)) {
            Rasteriser::draw(draws);  // refuses
            return;
        }
        for (const render::DeviceDraw& draw : draws) {
            render::check_draw(draw, materials_.size());
            record_draw(draw);
        }
        // Behind what the device's queue was given, and before what comes.
        guarded("submitting work", [&] { timeline_.submit(); });
        stream_.submit();
    }

    image::Image finish() override {
        require(State::drawing, "finish", "set_materials");
        stream_.commands();  // clears, where nothing was drawn
        stream_.submit();
        stream_.set_frame({}, {});
        record_resolve(stream_.commands());
        stream_.finish();
        state_ = State::idle;
        image::Image picture{targets_.width, targets_.height, {}};
        const Allocation& readback = targets_.readback.allocation;
        const std::size_t size = std::size_t{picture.width} * picture.height * 4;
        invalidate(context_, readback, 0, size);
        const auto* pixels = reinterpret_cast<const std::uint8_t*>(readback.mapped);
        picture.rgba.assign(pixels, pixels + size);
        return picture;
    }

private:
    enum class State { idle, begun, drawing };

    void require(State wanted, const char* call, const char* before) const {
        if (state_ != wanted) {
            throw Error(ErrorKind::usage,
                        fmt::format("Rasteriser::{} must follow {}: call begin, set_materials, draw any number of "
                                    "times, finish.",
                                    call, before));
        }
    }

    void create_sets() {
        const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, 1),
                                  vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, 1)};
        sets_ = vk::raii::DescriptorPool(context_.device, vk::DescriptorPoolCreateInfo({}, 2, sizes));
        const std::array layouts = {pipelines_.frame_set_layout(), pipelines_.sampler_set_layout()};
        const auto made = (*context_.device)
                              .allocateDescriptorSets(vk::DescriptorSetAllocateInfo(*sets_, layouts),
                                                      *context_.device.getDispatcher());
        frame_set_ = made[0];
        resolve_set_ = made[1];
        constants_ = create_buffer(context_, sizeof(FrameConstants), vk::BufferUsageFlagBits::eUniformBuffer,
                                   MemoryUse::upload, "frame constants");
        const vk::DescriptorBufferInfo buffer(*constants_.buffer, 0, sizeof(FrameConstants));
        context_.device.updateDescriptorSets(
            vk::WriteDescriptorSet(frame_set_, 0, 0, vk::DescriptorType::eUniformBuffer, {}, buffer), {});
        sample_reader_ = vk::raii::Sampler(context_.device, vk::SamplerCreateInfo());
    }

    void set_viewport(const vk::raii::CommandBuffer& commands) const {
        const auto width = static_cast<float>(targets_.width);
        const auto height = static_cast<float>(targets_.height);
        commands.setViewport(0, vk::Viewport(0.0f, 0.0f, width, height, 0.0f, 1.0f));
        commands.setScissor(0, vk::Rect2D({}, {targets_.width, targets_.height}));
    }

    void begin_pass(const vk::raii::CommandBuffer& commands) {
        const glm::vec4 b = background_;
        const std::array<vk::ClearValue, 2> clear = {
            vk::ClearColorValue(std::array<float, 4>{b.r * b.a, b.g * b.a, b.b * b.a, b.a}),
            vk::ClearDepthStencilValue(1.0f, 0)};
        // Kernels may have written what is drawn.
        commands.pipelineBarrier(Stage::eComputeShader | Stage::eTransfer, Stage::eVertexInput, {},
                                 vk::MemoryBarrier(Access::eShaderWrite | Access::eTransferWrite,
                                                   Access::eVertexAttributeRead | Access::eIndexRead),
                                 {}, {});
        const vk::RenderPass pass = cleared_ ? *passes_.draw : *passes_.clear;
        cleared_ = true;
        const vk::RenderPassBeginInfo info(pass, *targets_.draw_framebuffer,
                                           vk::Rect2D({}, {targets_.width, targets_.height}), clear);
        commands.beginRenderPass(info, vk::SubpassContents::eInline);
        set_viewport(commands);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, pipelines_.mesh_layout(), 0, frame_set_, {});
    }

    // Kernels may write next to what was drawn.
    static void end_pass(const vk::raii::CommandBuffer& commands) {
        commands.endRenderPass();
        commands.pipelineBarrier(Stage::eVertexInput, Stage::eComputeShader | Stage::eTransfer, {}, {}, {}, {});
    }

    void draw_batch(const render::TriangleBatch& batch, const render::Draw& draw) {
        const scene::Material& material = materials_[draw.material];
        const bool wireframe = shading_ == render::Shading::wireframe;
        const bool indexed = batch.is_local() && !wireframe;  // a wireframe tells corners by their place in the draw
        const bool coloured = !draw.attributes.empty();
        const std::uint64_t vertex_count = indexed ? batch.vertex_count : std::uint64_t{batch.indices.size()};
        const std::uint64_t vertex_bytes = vertex_count * sizeof(Vertex);
        const std::uint64_t attribute_bytes = (coloured ? vertex_count : 1) * sizeof(VertexAttributes);
        const std::uint64_t index_bytes = indexed ? batch.indices.size_bytes() : 0;
        const std::uint64_t indices_at = vertex_bytes + attribute_bytes;
        const RasterStream::Piece piece = stream_.reserve(indices_at + index_bytes);
        write_vertices(batch, draw.vertices, indexed, piece.data);
        if (coloured) {
            write_vertices(batch, draw.attributes, indexed, piece.data + vertex_bytes);
        } else {
            const VertexAttributes white{};
            std::memcpy(piece.data + vertex_bytes, &white, sizeof(white));
        }
        if (indexed) {
            render::write_local_indices(batch, reinterpret_cast<std::uint32_t*>(piece.data + indices_at));
        }

        const vk::raii::CommandBuffer& commands = stream_.commands();
        bind_material(commands, material, coloured);
        commands.bindVertexBuffers(0, {piece.buffer, piece.buffer}, {piece.offset, piece.offset + vertex_bytes});
        const auto count = static_cast<std::uint32_t>(batch.indices.size());
        if (indexed) {
            commands.bindIndexBuffer(piece.buffer, piece.offset + indices_at, vk::IndexType::eUint32);
            commands.drawIndexed(count, 1, 0, 0, 0);
        } else {
            commands.draw(count, 1, 0, 0);
        }
    }

    void bind_material(const vk::raii::CommandBuffer& commands, const scene::Material& material, bool coloured) {
        const bool blend = material.alpha_mode == scene::AlphaMode::blend && shading_ != render::Shading::wireframe;
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics,
                              pipelines_.mesh({shading_, material.double_sided, blend, coloured}));
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, pipelines_.mesh_layout(), 1,
                                    textures_.of(material), {});
        MaterialConstants constants = constants_of(material);
        if (!blend) constants.keeps_alpha = 0;
        commands.pushConstants<MaterialConstants>(pipelines_.mesh_layout(), vk::ShaderStageFlagBits::eFragment, 0,
                                                  constants);
    }

    void record_draw(const render::DeviceDraw& draw) {
        const bool coloured = bool{draw.attributes};
        const VertexAttributes white{};
        const RasterStream::Piece piece = stream_.reserve(sizeof(white));
        std::memcpy(piece.data, &white, sizeof(white));
        const vk::raii::CommandBuffer& commands = stream_.commands();
        bind_material(commands, materials_[draw.material], coloured);
        const auto used = [&](const gpu::Buffer& buffer) {
            Buffer& shared = shared_buffer(buffer);
            shared.vulkan.use();
            return *shared.vulkan->buffer;
        };
        const vk::DeviceSize at = draw.first_vertex * sizeof(Vertex);
        const vk::DeviceSize attributes_at = draw.first_vertex * sizeof(VertexAttributes);
        commands.bindVertexBuffers(0, {used(draw.vertices), coloured ? used(draw.attributes) : piece.buffer},
                                   {at, coloured ? attributes_at : piece.offset});
        commands.bindIndexBuffer(used(draw.indices), 0, vk::IndexType::eUint32);
        constexpr std::uint64_t most = 3 * render::TriangleBatch::max_triangles;
        for (std::uint64_t first = 0; first < draw.index_count; first += most) {
            // The offset is added modulo 2^32.
            commands.drawIndexed(static_cast<std::uint32_t>(std::min(draw.index_count - first, most)), 1,
                                 static_cast<std::uint32_t>(draw.first_index + first),
                                 static_cast<std::int32_t>(0u - draw.index_base), 0);
        }
    }

    template <typename Element>
    static void write_vertices(const render::TriangleBatch& batch, std::span<const Element> of_vertices, bool indexed,
                               std::byte* to) {
        if (indexed) {
            const auto used = of_vertices.subspan(batch.first_vertex, batch.vertex_count);
            std::memcpy(to, used.data(), used.size_bytes());
        } else {
            render::write_corners(batch, of_vertices, reinterpret_cast<Element*>(to));
        }
    }

    void record_resolve(const vk::raii::CommandBuffer& commands) {
        const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
        commands.pipelineBarrier(
            Stage::eColorAttachmentOutput, Stage::eFragmentShader, {}, {}, {},
            vk::ImageMemoryBarrier(Access::eColorAttachmentWrite, Access::eShaderRead, Layout::eColorAttachmentOptimal,
                                   Layout::eShaderReadOnlyOptimal, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                   *targets_.colour.image.image, whole));
        const vk::RenderPassBeginInfo info(*passes_.resolve, *targets_.resolve_framebuffer,
                                           vk::Rect2D({}, {targets_.width, targets_.height}));
        commands.beginRenderPass(info, vk::SubpassContents::eInline);
        set_viewport(commands);
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipelines_.resolve());
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, pipelines_.resolve_layout(), 0, resolve_set_, {});
        commands.draw(3, 1, 0, 0);
        commands.endRenderPass();
        const vk::BufferImageCopy copy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                       {targets_.width, targets_.height, 1});
        commands.copyImageToBuffer(*targets_.picture.image.image, Layout::eTransferSrcOptimal,
                                   *targets_.readback.buffer, copy);
        commands.pipelineBarrier(
            Stage::eTransfer, Stage::eHost, {}, {},
            vk::BufferMemoryBarrier(Access::eTransferWrite, Access::eHostRead, VK_QUEUE_FAMILY_IGNORED,
                                    VK_QUEUE_FAMILY_IGNORED, *targets_.readback.buffer, 0, VK_WHOLE_SIZE),
            {});
    }

    // Members are destroyed in reverse: the stream, which waits for the device, goes before what the device reads.
    gpu::Device device_;
    const Context& context_;
    Timeline& timeline_;
    RasterPasses passes_;
    RasterPipelines pipelines_;
    vk::raii::DescriptorPool sets_{nullptr};
    vk::raii::Sampler sample_reader_{nullptr};
    BufferAllocation constants_;
    RasterTargets targets_;
    RasterTextures textures_;
    RasterStream stream_;
    vk::DescriptorSet frame_set_, resolve_set_;
    std::vector<scene::Material> materials_;
    render::Shading shading_ = render::Shading::phong;
    glm::vec4 background_{0.0f};
    bool cleared_ = false;
    State state_ = State::idle;
};

}  // namespace

std::unique_ptr<render::Rasteriser> open_rasteriser(const gpu::Device& device) {
    return std::make_unique<VulkanRasteriser>(device);
}

}  // namespace tessera::backends::vulkan
