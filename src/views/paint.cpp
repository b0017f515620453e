#include "views/paint.hpp"

namespace tessera::views {
namespace {

constexpr std::size_t most_indices = std::size_t{3} << 17;  // of one draw

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

void Painter::add(std::uint32_t material, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
    if (material != material_ || indices_.size() + indices.size() > most_indices) flush();
    material_ = material;
    const auto base = static_cast<std::uint32_t>(vertices_.size());
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t index : indices)
        indices_.push_back(base + index);
}

void Painter::flush() {
    if (!indices_.empty()) rasteriser_.draw(vertices_, indices_, material_);
    vertices_.clear();
    indices_.clear();
}

}  // namespace tessera::views
