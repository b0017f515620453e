#include "measure/silhouette.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <cstdlib>

namespace tessera::measure {
namespace {

/// Alpha of a pixel; nothing is outside the picture.
int alpha(const image::Image& picture, std::int64_t x, std::int64_t y) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return 0;
    return picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x) + 3)];
}

}  // namespace

render::Camera frame_surface(const PatchSurface& surface, float azimuth) {
    render::View view;
    view.azimuth = azimuth;
    render::Framing framing(view, 1.0f);
    for (const Vertex& v : surface.vertices)
        framing.add({v.position[0], v.position[1], v.position[2]});
    return framing.camera();
}

image::Image draw_surface(render::Rasteriser& rasteriser, const PatchSurface& surface, const render::Camera& camera,
                          std::uint32_t size, render::Shading shading) {
    render::Frame frame;
    frame.width = size;
    frame.height = size;
    frame.camera = camera;
    frame.shading = shading;
    frame.background = glm::vec4(0.0f);
    scene::Material both_sides;
    both_sides.double_sided = true;
    rasteriser.begin(frame);
    rasteriser.set_materials({both_sides}, {});
    rasteriser.draw(surface.vertices, surface.indices, 0);
    return rasteriser.finish();
}

SilhouetteDifference compare_silhouettes(const image::Image& a, const image::Image& b) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::usage, fmt::format("Silhouettes of {} x {} and {} x {} pixels cannot be compared.",
                                                  a.width, a.height, b.width, b.height));
    }
    SilhouetteDifference result;
    for (std::size_t i = 3; i < a.rgba.size(); i += 4) {
        const int apart = std::abs(int{a.rgba[i]} - int{b.rgba[i]});
        result.differing += apart > 0 ? 1 : 0;
        result.area += apart / 255.0;
    }
    return result;
}

std::uint64_t outline_pixels(const image::Image& silhouette) {
    std::uint64_t count = 0;
    for (std::int64_t y = 0; y < silhouette.height; ++y) {
        for (std::int64_t x = 0; x < silhouette.width; ++x) {
            const int here = alpha(silhouette, x, y);
            const bool beside_nothing = alpha(silhouette, x - 1, y) == 0 || alpha(silhouette, x + 1, y) == 0 ||
                                        alpha(silhouette, x, y - 1) == 0 || alpha(silhouette, x, y + 1) == 0;
            count += here > 0 && (here < 255 || beside_nothing) ? 1 : 0;
        }
    }
    return count;
}

}  // namespace tessera::measure
