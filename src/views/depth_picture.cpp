#include "views/depth_picture.hpp"

#include "render/mesh_sinks.hpp"

#include <algorithm>
#include <cmath>

namespace tessera::views {
namespace {

constexpr float fine_periods = 64.0f;  // of v over the range

/// Distances along the view, from 0 to 1 over a range, as texture coordinates.
class DepthSink final : public MeshSink {
public:
    DepthSink(MeshSink& sink, const render::Frame& frame) : sink_(sink), view_(frame.camera.view) {
        // Surfaces swell out of their coarse mesh.
        const float length = std::max(frame.depth_range.y - frame.depth_range.x, 1e-6f);
        first_ = frame.depth_range.x - 0.25f * length;
        scale_ = 1.0f / (1.5f * length);
    }

    void append(const MeshBatch& batch) override {
        vertices_.assign(batch.vertices.begin(), batch.vertices.end());
        for (Vertex& vertex : vertices_) {
            const glm::vec4 place(vertex.position[0], vertex.position[1], vertex.position[2], 1.0f);
            const float ahead = -(view_ * place).z;
            const float depth = std::clamp((ahead - first_) * scale_, 0.001f, 0.998f);
            vertex.uv[0] = depth;
            vertex.uv[1] = depth * fine_periods;
        }
        MeshBatch changed = batch;
        changed.vertices = vertices_;
        sink_.append(changed);
    }

private:
    MeshSink& sink_;
    glm::mat4 view_;
    float first_ = 0.0f, scale_ = 1.0f;
    std::vector<Vertex> vertices_;
};

float decode(std::uint8_t coarse, std::uint8_t fine) {
    const float share = static_cast<float>(fine) / 255.0f;
    const float whole = std::round(static_cast<float>(coarse) / 255.0f * fine_periods - share);
    return (whole + share) / fine_periods;
}

}  // namespace

DepthPicture draw_depths(SceneTessellator& tessellator, const std::vector<scene::Material>& materials,
                         render::Frame frame, render::Rasteriser& rasteriser, const Run& run) {
    frame.shading = render::Shading::uv;
    frame.wires = false;
    frame.samples = 1;
    frame.background = glm::vec4(0.0f);
    std::vector<scene::Material> plain;
    for (const scene::Material& material : materials) {
        plain.emplace_back();
        plain.back().double_sided = material.double_sided;
    }
    rasteriser.begin(frame);
    rasteriser.set_materials(plain, {});
    render::DrawSink drawing(rasteriser, tessellator.totals().parts);
    DepthSink sink(drawing, frame);
    run(tessellator, sink);
    const image::Image picture = rasteriser.finish();
    DepthPicture result{picture.width, picture.height, {}};
    result.depths.resize(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < result.depths.size(); ++i) {
        const std::uint8_t* const pixel = &picture.rgba[4 * i];
        result.depths[i] = pixel[3] == 0 ? -1.0f : decode(pixel[0], pixel[1]);
    }
    return result;
}

}  // namespace tessera::views
