#include "views/paint.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace tessera::views {
namespace {

constexpr std::size_t most_indices = std::size_t{3} << 17;  // of one draw
// Share of the map's colours in a pixel from which on filters leave the map: its ten colours are ten texels.
constexpr float steepest = 0.3f;

/// Where a vertex is seen, in pixels from the middle.
glm::vec2 pixel_of(const glm::mat4& to_clip, const glm::vec2& half_size, const Vertex& vertex) {
    const glm::vec4 clip = to_clip * glm::vec4(vertex.position[0], vertex.position[1], vertex.position[2], 1.0f);
    if (!(clip.w > 0.0f)) return glm::vec2(std::numeric_limits<float>::quiet_NaN());
    return glm::vec2(clip.x, clip.y) / clip.w * half_size;
}

/// How fast a value changes over a triangle, per pixel. NaN where a corner has no place.
float steepness(const std::array<glm::vec2, 3>& p, const std::array<float, 3>& value) {
    const glm::vec2 a = p[1] - p[0], b = p[2] - p[0];
    const float over_a = value[1] - value[0], over_b = value[2] - value[0];
    const glm::vec2 slope(over_a * b.y - over_b * a.y, over_b * a.x - over_a * b.x);
    return glm::length(slope) / std::abs(a.x * b.y - a.y * b.x);
}

}  // namespace

void light_for_colours(render::Frame& frame) {
    frame.shading = render::Shading::reflection;
    frame.reflection = {};
    frame.reflection.ambient = 0.55f;
    frame.reflection.diffuse = 0.45f;
    frame.reflection.specular = 0.0f;
    frame.reflection.shininess = 1.0f;
    frame.reflection.light = glm::vec3(0.0f, 0.0f, 1.0f);
}

Palette make_palette(const std::vector<scene::Material>& materials) {
    Palette palette;
    palette.images.push_back(map_texture());
    for (const scene::Material& material : materials) {
        scene::Material painted;
        painted.name = material.name;
        painted.base_color_image = 0;
        painted.double_sided = material.double_sided;
        palette.materials.push_back(painted);
    }
    return palette;
}

Painter::Painter(render::Rasteriser& rasteriser, const render::Frame& frame)
    : rasteriser_(rasteriser),
      to_clip_(frame.camera.projection * frame.camera.view),
      half_size_(0.5f * static_cast<float>(frame.width), 0.5f * static_cast<float>(frame.height)) {}

void Painter::add(std::uint32_t material, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
    if (material != material_ || indices_.size() + indices.size() > most_indices) flush();
    material_ = material;
    const auto base = static_cast<std::uint32_t>(vertices_.size());
    const std::size_t first = indices_.size();
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    for (const Vertex& vertex : vertices)
        pixels_.push_back(pixel_of(to_clip_, half_size_, vertex));
    for (const std::uint32_t index : indices)
        indices_.push_back(base + index);
    for (std::size_t t = first; t + 2 < indices_.size(); t += 3)
        level_out(t);
}

void Painter::level_out(std::size_t first_index) {
    std::array<glm::vec2, 3> places;
    std::array<float, 3> shown{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = indices_[first_index + k];
        places[k] = pixels_[vertex];
        shown[k] = vertices_[vertex].uv[0];
    }
    const float whole_map = map_u(1.0) - map_u(0.0);
    if (!(steepness(places, shown) > steepest * whole_map)) return;
    for (std::size_t k = 0; k < 3; ++k) {
        Vertex own = vertices_[indices_[first_index + k]];
        own.uv[0] = (shown[0] + shown[1] + shown[2]) / 3.0f;
        indices_[first_index + k] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(own);
        pixels_.push_back(places[k]);
    }
}

void Painter::flush() {
    if (!indices_.empty()) rasteriser_.draw(vertices_, indices_, material_);
    vertices_.clear();
    pixels_.clear();
    indices_.clear();
}

}  // namespace tessera::views
