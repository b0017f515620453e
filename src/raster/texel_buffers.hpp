// The textures of materials in device memory, with their mip levels and what kernels have to know to light them.
#pragma once

#include "gpu/device.hpp"
#include "raster/look.hpp"
#include "scene/scene.hpp"

#include <map>
#include <vector>

namespace tessera::raster {

/// The textures of a material as kernels read them: tables, levels, look, texels (kernels/raster/raster_layout.h).
struct TexelBuffer {
    gpu::Buffer buffer;
    std::uint32_t width = 0, height = 0;  ///< pixels of level 0 of the base colour
    std::uint32_t levels = 0;             ///< of the base colour; 0: none, or maps that the look tells of
};

/// What is uploaded of a material.
enum class TexturesFor {
    base_colours,  ///< the base colour's image, shared by all materials that use it
    pbr,           ///< its maps and factors
};

class TexelBuffers {
public:
    explicit TexelBuffers(const gpu::Device& device);

    /// Uploads the images that materials use, for a picture of this look; halves those that are too large for a
    /// binding until they fit. Throws Error(usage) for a material whose image is not there.
    void upload(const std::vector<scene::Material>& materials, const std::vector<scene::SceneImage>& images,
                const Look& look, TexturesFor what);

    /// The textures of material number `material` of the last upload.
    const TexelBuffer& of(std::size_t material) const { return *of_material_[material]; }
    const TexelBuffer& plain() const { return plain_; }

private:
    /// Level after level of an image, halved until all take at most `most` words.
    struct Levels {
        std::uint32_t width = 0, height = 0;
        std::vector<std::vector<std::uint32_t>> texels;
    };
    static Levels make_levels(const image::Image& pixels, std::uint64_t most);
    const TexelBuffer& add_base_colour(std::uint32_t index, const image::Image& pixels, const Look& look);
    const TexelBuffer& add_maps(const scene::Material& material, const std::vector<scene::SceneImage>& images,
                                Look look);
    gpu::Buffer create(const std::vector<std::uint32_t>& words);
    std::vector<std::uint32_t> header(const Look& look) const;
    std::uint64_t most_words() const;

    gpu::Device device_;
    std::vector<std::uint32_t> tables_;
    TexelBuffer plain_;
    std::map<std::vector<std::uint32_t>, TexelBuffer> textures_;  // by images, and the look of those with maps
    std::vector<const TexelBuffer*> of_material_;
};

}  // namespace tessera::raster
