#include "raster/portable_rasteriser.hpp"

#include "base/error.hpp"
#include "raster/draw_uploads.hpp"
#include "raster/look.hpp"
#include "raster/raster_pipeline.hpp"
#include "raster/srgb_tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace tessera::raster {
namespace {

constexpr std::uint32_t largest_side = 8192;

void check(const render::Frame& frame) {
    if (frame.width == 0 || frame.height == 0 || frame.width > largest_side || frame.height > largest_side) {
        throw Error(ErrorKind::usage,
                    fmt::format("A picture of {} x {} pixels cannot be drawn: sides must be in [1, {}].", frame.width,
                                frame.height, largest_side));
    }
    if (frame.samples != 1 && frame.samples != 4) {
        throw Error(ErrorKind::usage,
                    fmt::format("A picture of {} samples per pixel cannot be drawn; choose 1 or 4.", frame.samples));
    }
}

/// Multiplied by alpha, as samples hold it.
std::uint32_t packed(const glm::vec4& colour) {
    const double alpha = std::clamp(static_cast<double>(colour.a), 0.0, 1.0);
    const auto code = [&](float channel) { return encode_srgb(static_cast<double>(channel) * alpha); };
    return code(colour.r) | code(colour.g) << 8u | code(colour.b) << 16u |
           static_cast<std::uint32_t>(std::lround(alpha * 255.0)) << 24u;
}

class PortableRasteriser final : public render::Rasteriser {
public:
    explicit PortableRasteriser(const gpu::Device& device)
        : device_(device), uploads_(device), pipeline_(device), textures_(device) {}

    void begin(const render::Frame& frame) override {
        check(frame);
        const std::uint32_t samples = frame.samples;
        if (frame.width != width_ || frame.height != height_ || samples != samples_) {
            windows_.clear();  // before the new ones take their memory
            width_ = 0;
            windows_ = make_windows(device_, frame.width, frame.height, samples, choose_launch(device_.info()).window);
            width_ = frame.width;
            height_ = frame.height;
            samples_ = samples;
        }
        pipeline_.begin(windows_, samples, packed(frame.background));
        frame_ = frame_parameters(frame);
        look_ = make_look(frame);
        textures_for_ = frame.shading == render::Shading::pbr ? TexturesFor::pbr : TexturesFor::base_colours;
        materials_.clear();
        state_ = State::begun;
    }

    void set_materials(const std::vector<scene::Material>& materials,
                       const std::vector<scene::SceneImage>& images) override {
        require(State::begun, "set_materials", "begin");
        textures_.upload(materials, images, look_, textures_for_);
        materials_ = materials;
        state_ = State::drawing;
    }

    using Rasteriser::draw;
    void draw(const render::Draw& draw) override {
        require(State::drawing, "draw", "set_materials");
        render::check_draw(draw, materials_.size());
        for (auto indices = draw.indices; !indices.empty();) {
            const render::TriangleBatch batch = render::take_batch(indices, draw.vertices.size());
            draw_checked(uploads_.upload(batch, draw));
            indices = indices.subspan(batch.indices.size());
        }
    }

    bool draws_from(const gpu::Device& device) const override { return device == device_; }

    void draw(std::span<const render::DeviceDraw> draws) override {
        require(State::drawing, "draw", "set_materials");
        for (const render::DeviceDraw& draw : draws) {
            render::check_draw(draw, materials_.size());
            draw_checked(draw);
        }
    }

    image::Image finish() override {
        require(State::drawing, "finish", "set_materials");
        state_ = State::idle;
        image::Image picture{width_, height_, std::vector<std::uint8_t>(std::size_t{width_} * height_ * 4)};
        std::vector<std::byte> pixels;
        for (const RasterWindow& window : windows_) {
            const std::size_t bytes = std::size_t{window.width} * window.height * 4;
            if (window.width == width_) {  // whole rows lie together
                const auto rows = std::as_writable_bytes(std::span(picture.rgba));
                pipeline_.resolve(window, textures_.plain(), rows.subspan(std::size_t{window.y} * width_ * 4, bytes));
                continue;
            }
            pixels.resize(bytes);
            pipeline_.resolve(window, textures_.plain(), pixels);
            for (std::uint32_t row = 0; row < window.height; ++row) {
                std::memcpy(&picture.rgba[(std::size_t{window.y + row} * width_ + window.x) * 4],
                            &pixels[std::size_t{row} * window.width * 4], std::size_t{window.width} * 4);
            }
        }
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

    void draw_checked(const render::DeviceDraw& draw) {
        const TexelBuffer& texture = textures_.of(draw.material);
        kernels::DrawParams params = frame_;
        set_material(params, materials_[draw.material], texture);
        pipeline_.draw(draw, params, texture);
    }

    gpu::Device device_;
    DrawUploads uploads_;
    RasterPipeline pipeline_;
    TexelBuffers textures_;
    std::vector<RasterWindow> windows_;
    std::uint32_t width_ = 0, height_ = 0, samples_ = 0;
    kernels::DrawParams frame_{};
    Look look_{};
    TexturesFor textures_for_ = TexturesFor::base_colours;
    std::vector<scene::Material> materials_;
    State state_ = State::idle;
};

}  // namespace

std::unique_ptr<render::Rasteriser> open_portable(const gpu::Device& device) {
    return std::make_unique<PortableRasteriser>(device);
}

}  // namespace tessera::raster
