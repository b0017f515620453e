// Views of small scenes, drawn by the reference device.
#pragma once

#include "views/view.hpp"

#include <string>
#include <vector>

namespace tessera::test {

/// A scene with all that a view is made of.
struct Stage {
    explicit Stage(scene::Scene made, const std::string& device_id = "reference");
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    views::Cell cell(const TessellationOptions& options);

    gpu::Device device;
    scene::Scene scene;
    patches::PatchSet patches;
    patches::HairSet hair;
    HairOptions hair_options;
    views::Subject subject;
};

/// Runs as the command line does.
views::Run plain_run();

/// The square [-1, 1] x [-1, 1] that faces +z: a quad, or two triangles.
scene::Scene square(bool quad);

/// An orthographic camera that looks along -z and sees [-1.25, 1.25] of kernel space, over nothing.
render::Frame front_frame(std::uint32_t size);

image::Rgba pixel(const image::Image& picture, std::uint32_t x, std::uint32_t y);

/// The largest difference of a channel.
int apart(const image::Rgba& a, const image::Rgba& b);

/// Keeps what is drawn.
class Recorder final : public render::Rasteriser {
public:
    struct Triangle {
        Vertex corners[3];
    };

    void begin(const render::Frame&) override {}
    void set_materials(const std::vector<scene::Material>&, const std::vector<scene::SceneImage>&) override {}
    using Rasteriser::draw;
    void draw(const render::Draw& draw) override;
    image::Image finish() override { return {}; }

    std::vector<Triangle> triangles;
};

}  // namespace tessera::test
