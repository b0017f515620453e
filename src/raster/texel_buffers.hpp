// Base colour textures in device memory, with their mip levels.
#pragma once

#include "gpu/device.hpp"
#include "scene/scene.hpp"

#include <map>
#include <vector>

namespace tessera::raster {

/// One texture as kernels read it: tables, levels, texels (kernels/raster/raster_layout.h).
struct TexelBuffer {
    gpu::Buffer buffer;
    std::uint32_t width = 0, height = 0;  ///< pixels of level 0
    std::uint32_t levels = 0;             ///< 0: no texels, only the tables
};

class TexelBuffers {
public:
    explicit TexelBuffers(const gpu::Device& device);

    /// Uploads the images that materials use; halves those that are larger than a binding until they fit. Throws
    /// Error(usage) for a material whose image is not there.
    void upload(const std::vector<scene::Material>& materials, const std::vector<scene::SceneImage>& images);

    /// The texture of a material; tables alone where it has none.
    const TexelBuffer& of(const scene::Material& material) const;
    const TexelBuffer& plain() const { return plain_; }

private:
    TexelBuffer create(const image::Image& pixels);

    gpu::Device device_;
    std::vector<std::uint32_t> tables_;
    TexelBuffer plain_;
    std::map<std::uint32_t, TexelBuffer> textures_;  // by index into the scene's images
};

}  // namespace tessera::raster
