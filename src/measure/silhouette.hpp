// Silhouettes: which pixels a surface covers.
#pragma once

#include "measure/patch_surface.hpp"
#include "render/rasteriser.hpp"

#include <cstdint>

namespace tessera::measure {

/// An orbiting camera that frames the surface in a square picture. `azimuth` as in render::View.
render::Camera frame_surface(const PatchSurface& surface, float azimuth);

/// The surface in white, or as `shading` says, over nothing; both sides of it are drawn. The alpha of a pixel is the
/// share of it that is covered. `size` is the width and height in pixels.
image::Image draw_surface(render::Rasteriser& rasteriser, const PatchSurface& surface, const render::Camera& camera,
                          std::uint32_t size, render::Shading shading = render::Shading::phong);

/// In pixels.
struct SilhouetteDifference {
    std::uint64_t differing = 0;  ///< whose coverage is not the same
    double area = 0.0;            ///< sum of the differences in coverage
};

/// Throws Error(usage) where the sizes differ.
SilhouetteDifference compare_silhouettes(const image::Image& a, const image::Image& b);

/// Pixels that the outline runs through: partly covered ones, and covered ones beside ones that are not.
std::uint64_t outline_pixels(const image::Image& silhouette);

}  // namespace tessera::measure
