// The same pictures from every device: tessellated and drawn there by kernels alone, compared bit by bit.
#pragma once

#include "gpu/device.hpp"
#include "patches/hair.hpp"
#include "render/rasteriser.hpp"
#include "tessellate/hair_options.hpp"
#include "tessellate/options.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera::verify {

/// What is drawn: the surfaces and the hair of one scene. What it refers to must outlive it.
struct PictureSubject {
    const scene::Scene& scene;
    const patches::PatchSet& patches;
    const patches::HairSet& hair;
    TessellationOptions options;
    HairOptions hair_options;
};

/// Tessellates on `device` and draws a frame into `rasteriser`.
image::Image draw_picture(const gpu::Device& device, const PictureSubject& subject, render::Rasteriser& rasteriser,
                          const render::Frame& frame);

/// A camera that frames the subject as it comes out of `device`, for pictures of this width / height.
render::Camera fit_camera(const gpu::Device& device, const PictureSubject& subject, float aspect);

/// The first pixel that differs.
struct PixelDifference {
    std::uint32_t x = 0, y = 0;
    std::uint32_t expected = 0, found = 0;  ///< R, G, B, A from the highest byte down
};

/// All pictures from one device against those of the first device.
struct PictureComparison {
    gpu::DeviceInfo device;
    std::uint64_t pixels = 0;     ///< compared
    std::uint64_t differing = 0;  ///< that differ in any bit
    std::optional<PixelDifference> first;
};

/// Devices and a portable rasteriser on each, kept from picture to picture.
class PictureDevices {
public:
    /// The first device is what the others are held against.
    explicit PictureDevices(const std::vector<gpu::Device>& devices);

    /// Draws every frame on every device; one result per device. Before a frame each device draws an empty picture of
    /// the same size in a colour of its own, so that a pixel left unwritten differs. `pictures` (may be null) gets the
    /// first device's.
    std::vector<PictureComparison> compare(const PictureSubject& subject, std::span<const render::Frame> frames,
                                           std::vector<image::Image>* pictures = nullptr);

private:
    struct Painter {
        gpu::Device device;
        std::unique_ptr<render::Rasteriser> rasteriser;
    };

    std::vector<Painter> painters_;
};

/// "pixel (3, 4): 804020ff expected, 804021ff found"
std::string describe(const PixelDifference& difference);

}  // namespace tessera::verify
