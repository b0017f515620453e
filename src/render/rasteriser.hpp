// What draws triangles into an image. Implemented by backends that have a rasteriser (Vulkan), and for every other
// device by kernels (raster/portable_rasteriser.hpp).
#pragma once

#include "image/image.hpp"
#include "render/camera.hpp"
#include "render/device_draw.hpp"
#include "render/triangle_batches.hpp"
#include "scene/scene.hpp"
#include "tessellate/refined_mesh.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace tessera::render {

enum class Shading {
    phong,      ///< Blinn-Phong with the light and material constants of the literature; base colour and texture
    normals,    ///< the interpolated normal as a colour
    wireframe,  ///< triangle edges over a flat fill
    // Of the portable rasteriser alone:
    reflection,  ///< Frame::reflection
    pbr,         ///< metallic-roughness materials of glTF under Frame::lights and a sky; linear light, tone curve
    depth,       ///< distance from the camera's plane, white to black over Frame::depth_range
    uv,          ///< texture coordinates
};

/// Phong's model, or Blinn's.
struct Reflection {
    bool half_vector = true;  ///< Blinn's; false: Phong's reflected ray
    float ambient = 0.4f, diffuse = 0.5f, specular = 0.3f;
    float shininess = 150.0f;  ///< (0, 2^20]
    /// In camera space: the direction to the light, or its place from the model's origin in the units in which the
    /// model's largest coordinate lies in [1, 2).
    glm::vec3 light{-0.379049021f, 0.530668616f, 0.758098043f};
    bool light_is_place = false;
    std::optional<glm::vec3> colour;  ///< instead of the materials', linear
};

/// From light to what a screen shows.
enum class ToneCurve {
    none,  ///< what is above 1 is white
    aces,  ///< Narkowicz's fit of the ACES curve
};

/// Light that comes from everywhere, by height: linear colours.
struct Sky {
    glm::vec3 zenith{0.30f, 0.42f, 0.62f}, horizon{0.72f, 0.71f, 0.68f}, ground{0.13f, 0.115f, 0.105f};
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
    // What follows is drawn by the portable rasteriser alone.
    bool wires = false;  ///< edges of triangles over the shading
    Reflection reflection;
    std::vector<scene::Light> lights;  ///< in the model's kernel space; up to 16
    Sky sky;
    ToneCurve tone_curve = ToneCurve::none;
    float exposure = 1.0f;              ///< what light is multiplied by before the tone curve
    glm::vec2 depth_range{0.0f, 1.0f};  ///< distances in camera space that are white and black
};

/// True for what a device's own rasteriser draws too.
inline bool is_common(const Frame& frame) {
    return !frame.wires && (frame.shading == Shading::phong || frame.shading == Shading::normals ||
                            frame.shading == Shading::wireframe);
}

/// Draws into one image with depth. Call order: begin, set_materials once, draw any number of times,
/// finish.
class Rasteriser {
public:
    virtual ~Rasteriser() = default;
    virtual void begin(const Frame& frame) = 0;
    virtual void set_materials(const std::vector<scene::Material>& materials,
                               const std::vector<scene::SceneImage>& images) = 0;
    /// Draws triangles. Data is copied before the call returns; any size. Colours of vertices multiply the base colour,
    /// alpha included; a normal map tilts the normals of vertices that have tangents. Throws like check_draw.
    virtual void draw(const Draw& draw) = 0;
    /// The same without attributes.
    void draw(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, std::uint32_t material) {
        draw(Draw{vertices, indices, material});
    }
    /// Whether draws of the frame that was begun may come from buffers of this device.
    virtual bool draws_from(const gpu::Device& /*device*/) const { return false; }
    /// Draws triangles that lie on such a device, in order, between what its queue was given before and what it is
    /// given from now on. Throws like check_draw, and Error(usage) where draws_from() is false for all devices.
    virtual void draw(std::span<const DeviceDraw> draws);
    void draw(const DeviceDraw& one) { draw(std::span(&one, 1)); }
    /// Resolves and reads the image back.
    virtual image::Image finish() = 0;
};

}  // namespace tessera::render
