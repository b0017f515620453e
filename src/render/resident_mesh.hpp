// A mesh put on a device to be drawn many times.
#pragma once

#include "base/vertex.hpp"
#include "base/vertex_attributes.hpp"
#include "render/device_draw.hpp"

#include <span>

namespace tessera::render {

/// Uploads a mesh into new buffers of `device`: all of it, with material 0. `attributes` are empty, or as many as the
/// vertices. Throws Error(usage) where one of the first two is empty or the attributes do not fit.
DeviceDraw upload_mesh(gpu::Device device, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                       std::span<const VertexAttributes> attributes = {});

}  // namespace tessera::render
