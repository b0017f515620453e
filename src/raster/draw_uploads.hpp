// Meshes in host memory on their way to the device, a batch of bounded size at a time.
#pragma once

#include "render/device_draw.hpp"
#include "render/triangle_batches.hpp"

#include <vector>

namespace tessera::raster {

/// Buffers of a fixed size, about 30 MiB, each batch in place of the one before.
class DrawUploads {
public:
    explicit DrawUploads(const gpu::Device& device);

    /// Uploads a batch of `draw`; data is copied before the call returns.
    render::DeviceDraw upload(const render::TriangleBatch& batch, const render::Draw& draw);

private:
    /// Writes what belongs to the vertices of a batch.
    template <typename Element>
    void upload(const render::TriangleBatch& batch, std::span<const Element> of_vertices, const gpu::Buffer& to);

    gpu::Device device_;
    gpu::Buffer vertices_, attributes_, indices_;
    std::vector<std::byte> corners_;
    std::vector<std::uint32_t> numbers_;
};

}  // namespace tessera::raster
