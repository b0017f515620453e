// Drawing a surface in the colours of the colour map, by any rasteriser that knows textures.
#pragma once

#include "render/rasteriser.hpp"
#include "views/colour_map.hpp"

namespace tessera::views {

/// Sets the light under which colours are to be told: it comes from the viewer and leaves no highlight. What faces the
/// viewer has the colour of the bar itself, what is seen edge-on little more than half of its light.
void light_for_colours(render::Frame& frame);

/// The materials of a scene with the colour map for all of them; none is see-through. Index 0 of `images` is the map.
struct Palette {
    std::vector<scene::Material> materials;
    std::vector<scene::SceneImage> images;
};
Palette make_palette(const std::vector<scene::Material>& materials);

/// Gathers triangles and draws them in large pieces. flush() after the last.
///
/// A triangle whose colours run across it faster than pixels can show takes their mean all over: filters of textures
/// would give it that of colours that it does not have.
class Painter {
public:
    /// The rasteriser has begun that frame.
    Painter(render::Rasteriser& rasteriser, const render::Frame& frame);

    /// Vertices bring their colours as texture coordinates (set_place). Indices count from the first of them.
    void add(std::uint32_t material, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);
    void flush();

private:
    void level_out(std::size_t first_index);

    render::Rasteriser& rasteriser_;
    glm::mat4 to_clip_;
    glm::vec2 half_size_;  // of the picture
    std::uint32_t material_ = 0;
    std::vector<Vertex> vertices_;
    std::vector<glm::vec2> pixels_;  // where vertices are seen; not finite behind the viewer
    std::vector<std::uint32_t> indices_;
};

/// Gives a vertex the colour of a place on the map.
inline void set_place(Vertex& vertex, double place) {
    vertex.uv[0] = map_u(place);
    vertex.uv[1] = 0.5f;
}

}  // namespace tessera::views
