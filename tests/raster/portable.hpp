// Small scenes for the portable rasteriser.
#pragma once

#include "gpu/device.hpp"
#include "render/rasteriser.hpp"

#include <cstdint>
#include <vector>

namespace tessera::test {

/// A frame of x, y in [-1, 1] without perspective, z in [-1, 1], transparent; larger z is nearer.
render::Frame flat_frame(std::uint32_t width, std::uint32_t height, std::uint32_t samples);

/// A position on the sub-pixel grid of a flat frame: `x` and `y` in sub-pixels (256 to a pixel) from the upper left.
Vertex place_vertex(const render::Frame& frame, int x, int y, float z = 0.0f);

/// Draws with one material.
image::Image draw_portable(const gpu::Device& device, const render::Frame& frame, const std::vector<Vertex>& vertices,
                           const std::vector<std::uint32_t>& indices, const scene::Material& material = {},
                           const std::vector<VertexAttributes>& attributes = {});

/// How often each sample of a picture of 1 sample is covered, up to 5 times: drawn as glass of half alpha, in the order
/// of triangles, each layer leaves half of the light through.
std::vector<int> coverage_counts(const gpu::Device& device, const render::Frame& frame,
                                 const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices);

}  // namespace tessera::test
