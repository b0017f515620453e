// What draws triangles into an image. Implemented by backends that have a rasteriser (Vulkan), and for every other
// device by kernels (raster/portable_rasteriser.hpp).
#pragma once

#include "image/image.hpp"
#include "render/camera.hpp"
#include "scene/scene.hpp"
#include "tessellate/refined_mesh.hpp"

namespace tessera::render {

enum class Shading {
    phong,      ///< Blinn-Phong with the light and material constants of the literature; base colour and texture
    normals,    ///< the interpolated normal as a colour
    wireframe,  ///< triangle edges over a flat fill
};

/// The picture to be made.
struct Frame {
    std::uint32_t width = 1024, height = 1024;  ///< pixels, [1, 8192]
    Camera camera;
    Shading shading = Shading::phong;
    std::uint32_t samples = 4;  ///< per pixel: 1 (its middle) or 4 (the places of Vulkan); Vulkan's own draws with 4
    /// Linear RGBA, not premultiplied; alpha 0 is transparent. The default is a light neutral grey, sRGB (244, 245,
    /// 247).
    glm::vec4 background{0.905f, 0.913f, 0.930f, 1.0f};
};

/// Draws into one image with depth. Call order: begin, set_materials once, draw any number of times,
/// finish.
class Rasteriser {
public:
    virtual ~Rasteriser() = default;
    virtual void begin(const Frame& frame) = 0;
    virtual void set_materials(const std::vector<scene::Material>& materials,
                               const std::vector<scene::SceneImage>& images) = 0;
    /// Draws triangles; indices count from `vertices[0]`. Data is copied before the call returns; any size.
    virtual void draw(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                      std::uint32_t material) = 0;
    /// Resolves and reads the image back.
    virtual image::Image finish() = 0;
};

}  // namespace tessera::render
