#include "small_picture.hpp"

#include "support/devices.hpp"
#include "views/paint.hpp"

#include <algorithm>
#include <cstdlib>

namespace tessera::test {

Stage::Stage(scene::Scene made, const std::string& device_id)
    : device(open_device(device_id)),
      scene(std::move(made)),
      patches(patches::make_patches(scene)),
      subject{device, scene, patches, hair, hair_options} {}

views::Cell Stage::cell(const TessellationOptions& options) {
    return {"cell", options, std::make_unique<SceneTessellator>(device, patches, options, hair, hair_options)};
}

views::Run plain_run() {
    return [](SceneTessellator& tessellator, MeshSink& sink) { tessellator.run(sink, Space::kernel); };
}

scene::Scene square(bool quad) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uvs.assign(4, {0, 0});
    if (quad) {
        mesh.quads = {0, 1, 2, 3};
    } else {
        mesh.triangles = {0, 1, 2, 0, 2, 3};
    }
    scene.meshes.push_back(mesh);
    return scene;
}

render::Frame front_frame(std::uint32_t size) {
    render::Frame frame;
    frame.width = size;
    frame.height = size;
    frame.background = glm::vec4(0.0f);
    render::Viewpoint viewpoint;
    viewpoint.eye = {0.0, 0.0, 8.0};
    viewpoint.projection = render::Projection::orthographic;
    viewpoint.half_height = 1.25;
    render::Bounds bounds;
    bounds.min = glm::vec3(-1.0f);
    bounds.max = glm::vec3(1.0f);
    frame.camera = render::make_camera(viewpoint, bounds, 1.0f);
    views::light_for_colours(frame);
    // Of the camera's axis, which may be scaled by a power of two.
    const auto ahead = [&](float z) { return -(frame.camera.view * glm::vec4(0.0f, 0.0f, z, 1.0f)).z; };
    frame.depth_range = {ahead(1.0f), ahead(-1.0f)};
    return frame;
}

image::Rgba pixel(const image::Image& picture, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* const p = &picture.rgba.at((std::size_t{y} * picture.width + x) * 4);
    return {p[0], p[1], p[2], p[3]};
}

int apart(const image::Rgba& a, const image::Rgba& b) {
    int most = 0;
    for (std::size_t c = 0; c < 4; ++c)
        most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return most;
}

void Recorder::draw(const render::Draw& draw) {
    for (std::size_t t = 0; t + 2 < draw.indices.size(); t += 3) {
        const std::uint32_t* corners = draw.indices.data() + t;
        triangles.push_back({{draw.vertices[corners[0]], draw.vertices[corners[1]], draw.vertices[corners[2]]}});
    }
}

}  // namespace tessera::test
