// The distance of what is seen in each pixel, from any rasteriser that shows texture coordinates.
#pragma once

#include "render/rasteriser.hpp"
#include "tessellate/refined_mesh.hpp"
#include "views/view.hpp"

#include <vector>

namespace tessera::views {

/// Row-major, top row first.
struct DepthPicture {
    std::uint32_t width = 0, height = 0;
    /// 0 (near) to 1 (far) over a range that holds the model, in steps of 1/16,000 or so; less than 0 where nothing is.
    std::vector<float> depths;
};

/// Draws a surface with materials of no see-through parts; `frame.depth_range` need not hold all of it. Distances are
/// carried by texture coordinates, coarse in u and fine in v, so that the picture of the view `uv` has them in 8-bit
/// channels.
DepthPicture draw_depths(SceneTessellator& tessellator, const std::vector<scene::Material>& materials,
                         render::Frame frame, render::Rasteriser& rasteriser, const Run& run);

}  // namespace tessera::views
