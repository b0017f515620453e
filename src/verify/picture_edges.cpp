#include "verify/picture_edges.hpp"

#include "render/survey.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tessera::verify {
namespace {

// Codes by which the second of three points may lie beside the middle of the others, doubled. Two are rounding.
constexpr int normal_steps = 8;  // of 127 for a unit: a bend of 4 degrees
constexpr int depth_steps = 3;   // of 255 for the depth of the model
constexpr int uv_steps = 12;     // of 255 for a unit

/// The pictures of twice the size.
struct Views {
    image::Image normals, depths, uvs;

    const std::uint8_t* at(const image::Image& view, std::int64_t x, std::int64_t y) const {
        return &view.rgba[static_cast<std::size_t>(y * view.width + x) * 4];
    }
};

Views draw_views(const gpu::Device& device, const PictureSubject& subject, render::Rasteriser& portable,
                 const render::Frame& frame) {
    render::Frame view = frame;
    view.width = 2 * frame.width;
    view.height = 2 * frame.height;
    view.samples = 1;
    view.wires = false;
    view.background = glm::vec4(0.0f);
    view.depth_range = render::depth_range(frame.camera, render::bounds_of(subject.patches.control_vertices));
    const auto draw = [&](render::Shading shading) {
        view.shading = shading;
        return draw_picture(device, subject, portable, view);
    };
    return {draw(render::Shading::normals), draw(render::Shading::depth), draw(render::Shading::uv)};
}

/// Whether codes of three points in a row do not lie on a line. Coordinates begin again after 256 steps.
bool bends(int before, int here, int after, int steps, bool wraps) {
    int bend = before - 2 * here + after;
    if (wraps) bend -= 256 * static_cast<int>(std::lround(bend / 256.0));
    return std::abs(bend) > steps;
}

/// Whether there is an edge at a point or between it and the one before or behind in direction (dx, dy).
bool is_edge(const Views& views, std::int64_t x, std::int64_t y, int dx, int dy) {
    const std::uint8_t* const before = views.at(views.normals, x - dx, y - dy);
    const std::uint8_t* const here = views.at(views.normals, x, y);
    const std::uint8_t* const after = views.at(views.normals, x + dx, y + dy);
    if (before[3] != here[3] || here[3] != after[3]) return true;
    const auto code = [&](const image::Image& view, int step, int channel) {
        return int{views.at(view, x + step * dx, y + step * dy)[channel]};
    };
    const auto view_bends = [&](const image::Image& view, int channel, int steps, bool wraps) {
        return bends(code(view, -1, channel), code(view, 0, channel), code(view, 1, channel), steps, wraps);
    };
    for (int c = 0; c < 3; ++c) {
        if (view_bends(views.normals, c, normal_steps, false)) return true;
    }
    return view_bends(views.depths, 0, depth_steps, false) || view_bends(views.uvs, 0, uv_steps, true) ||
           view_bends(views.uvs, 1, uv_steps, true);
}

}  // namespace

std::vector<bool> find_edges(const gpu::Device& device, const PictureSubject& subject, render::Rasteriser& portable,
                             const render::Frame& frame) {
    const Views views = draw_views(device, subject, portable, frame);
    const std::int64_t width = frame.width;
    const std::int64_t height = frame.height;
    std::vector<bool> near(static_cast<std::size_t>(width * height), false);
    for (std::int64_t y = 1; y + 1 < 2 * height; ++y) {
        for (std::int64_t x = 1; x + 1 < 2 * width; ++x) {
            if (!is_edge(views, x, y, 1, 0) && !is_edge(views, x, y, 0, 1)) continue;
            for (std::int64_t row = std::max(y / 2 - 1, std::int64_t{0}); row <= std::min(y / 2 + 1, height - 1);
                 ++row) {
                for (std::int64_t column = std::max(x / 2 - 1, std::int64_t{0});
                     column <= std::min(x / 2 + 1, width - 1); ++column) {
                    near[static_cast<std::size_t>(row * width + column)] = true;
                }
            }
        }
    }
    return near;
}

}  // namespace tessera::verify
