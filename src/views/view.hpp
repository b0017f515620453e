// What a picture shows of tessellated models: a way of drawing each, and a legend that all pictures of a run share.
#pragma once

#include "image/text.hpp"
#include "render/rasteriser.hpp"
#include "tessellate/scene_tessellator.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tessera::views {

/// A surface to be shown, beside others or alone.
struct Cell {
    std::string label;
    TessellationOptions options;
    std::unique_ptr<SceneTessellator> tessellator;
};

/// Runs a tessellator in kernel space into a sink; whoever gives it counts the runs.
using Run = std::function<void(SceneTessellator&, MeshSink&)>;

/// What all cells are made of. Everything referred to must outlive the view.
struct Subject {
    const gpu::Device& device;
    const scene::Scene& scene;
    const patches::PatchSet& patches;
    const patches::HairSet& hair;
    const HairOptions& hair_options;
};

/// Of one of the pictures side by side, in pixels.
struct PanelSize {
    std::uint32_t width = 0, height = 0;
};

class View {
public:
    virtual ~View() = default;

    /// How many runs prepare() takes for that many cells, and draw() for one.
    virtual std::size_t runs_before(std::size_t /*cells*/) const { return 0; }
    virtual std::size_t runs_per_cell() const { return 1; }

    /// Before the first picture: finds what all pictures share, such as a scale.
    virtual void prepare(std::span<Cell>, const Run&) {}
    /// `frame` is complete, but for what the view itself changes. The rasteriser is idle before and after.
    virtual image::Image draw(Cell& cell, const render::Frame& frame, render::Rasteriser& rasteriser,
                              const Run& run) = 0;
    /// Appends the legend, on a strip of `paper`, to pictures of one size that stand side by side.
    virtual void append_legend(image::Image& /*picture*/, const PanelSize&, const image::Rgba& /*paper*/) const {}
};

/// The frame's own shading, with the materials of the scene.
std::unique_ptr<View> make_plain_view(const Subject& subject);

}  // namespace tessera::views
