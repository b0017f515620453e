#include "verify/compare_pictures.hpp"

#include "raster/portable_rasteriser.hpp"
#include "render/mesh_sinks.hpp"
#include "render/survey.hpp"
#include "tessellate/scene_tessellator.hpp"

#include <fmt/format.h>
#include <cstring>

namespace tessera::verify {
namespace {

SceneTessellator make_tessellator(const gpu::Device& device, const PictureSubject& subject) {
    return {device, subject.patches, subject.options, subject.hair, subject.hair_options};
}

/// An empty picture in a colour that depends on `number`, wherever the next picture will be written.
void leave_sentinel(render::Rasteriser& rasteriser, const render::Frame& frame, std::size_t number) {
    render::Frame empty = frame;
    const auto hue = static_cast<float>((number * 37 + 11) % 101) / 101.0f;
    empty.background = glm::vec4(hue, 1.0f - hue, 0.5f * hue, 0.5f + 0.5f * hue);
    rasteriser.begin(empty);
    rasteriser.set_materials({}, {});
    rasteriser.finish();
}

image::Image draw(render::Rasteriser& rasteriser, const render::Frame& frame, const scene::Scene& scene,
                  SceneTessellator& tessellator) {
    rasteriser.begin(frame);
    rasteriser.set_materials(scene.materials, scene.images);
    render::DrawSink sink(rasteriser, tessellator.totals().parts);
    tessellator.run(sink, Space::kernel);
    return rasteriser.finish();
}

std::uint32_t pixel_at(const image::Image& picture, std::size_t at) {
    const std::uint8_t* p = &picture.rgba[at * 4];
    return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | p[3];
}

void compare(PictureComparison& result, const image::Image& expected, const image::Image& found) {
    const std::size_t pixels = std::size_t{expected.width} * expected.height;
    result.pixels += pixels;
    if (std::memcmp(expected.rgba.data(), found.rgba.data(), pixels * 4) == 0) return;
    for (std::size_t at = 0; at < pixels; ++at) {
        const std::uint32_t wanted = pixel_at(expected, at);
        const std::uint32_t seen = pixel_at(found, at);
        if (wanted == seen) continue;
        if (result.differing++ == 0) {
            result.first = PixelDifference{static_cast<std::uint32_t>(at % expected.width),
                                           static_cast<std::uint32_t>(at / expected.width), wanted, seen};
        }
    }
}

}  // namespace

image::Image draw_picture(const gpu::Device& device, const PictureSubject& subject, render::Rasteriser& rasteriser,
                          const render::Frame& frame) {
    SceneTessellator tessellator = make_tessellator(device, subject);
    return draw(rasteriser, frame, subject.scene, tessellator);
}

render::Camera fit_camera(const gpu::Device& device, const PictureSubject& subject, float aspect) {
    render::Survey survey(render::View{}, aspect, false, render::bounds_of(subject.patches.control_vertices));
    make_tessellator(device, subject).run(survey, Space::kernel);
    return survey.camera();
}

PictureDevices::PictureDevices(const std::vector<gpu::Device>& devices) {
    for (const gpu::Device& device : devices)
        painters_.push_back({device, raster::open_portable(device)});
}

std::vector<PictureComparison> PictureDevices::compare(const PictureSubject& subject,
                                                       std::span<const render::Frame> frames,
                                                       std::vector<image::Image>* pictures) {
    std::vector<image::Image> expected;
    std::vector<PictureComparison> results;
    for (std::size_t d = 0; d < painters_.size(); ++d) {
        Painter& painter = painters_[d];
        SceneTessellator tessellator = make_tessellator(painter.device, subject);
        PictureComparison& result = results.emplace_back(PictureComparison{painter.device.info(), 0, 0, {}});
        for (std::size_t f = 0; f < frames.size(); ++f) {
            leave_sentinel(*painter.rasteriser, frames[f], d);
            image::Image picture = draw(*painter.rasteriser, frames[f], subject.scene, tessellator);
            verify::compare(result, d == 0 ? picture : expected[f], picture);
            if (d == 0) expected.push_back(std::move(picture));
        }
    }
    if (pictures != nullptr) *pictures = std::move(expected);
    return results;
}

std::string describe(const PixelDifference& d) {
    return fmt::format("pixel ({}, {}): {:08x} expected, {:08x} found", d.x, d.y, d.expected, d.found);
}

}  // namespace tessera::verify
