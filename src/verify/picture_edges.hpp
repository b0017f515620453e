// Where a picture has edges: there, two rasterisers that are both right may differ.
#pragma once

#include "verify/compare_pictures.hpp"

#include <vector>

namespace tessera::verify {

/// Marks, row by row, the pixels of a frame within one pixel of an edge of what is drawn: where something begins, where
/// the surface bends by more than 4 degrees or so from one half pixel to the next, or where depth or texture
/// coordinates do not go on as they came (surfaces that hide each other, seams of a texture). Told from pictures of
/// normals, depths and texture coordinates of twice the size, drawn by `portable`. Throws Error(usage) where they would
/// be too large.
std::vector<bool> find_edges(const gpu::Device& device, const PictureSubject& subject, render::Rasteriser& portable,
                             const render::Frame& frame);

}  // namespace tessera::verify
