// Numbers as colours.
#pragma once

#include "image/text.hpp"
#include "scene/scene.hpp"

namespace tessera::views {

/// The numbers that the ends of the colour map stand for.
struct Scale {
    double least = 0.0, greatest = 1.0;

    /// Where a number lies, 0 to 1; the middle where the scale has no length. NaN counts as the least.
    double place(double value) const;
};

/// Viridis (Smith and van der Walt, matplotlib 1.5, 2015, CC0), from dark violet at 0 to yellow at 1: as its ten
/// colours at even steps, and mixed between them.
image::Rgba map_colour(double place);

/// The colour map as a texture for any rasteriser, and where it has the colour of a place: at (map_u(place), 0.5).
/// Beyond both ends it goes on in their colours, so that no filter mixes one end with the other.
scene::SceneImage map_texture();
float map_u(double place);

}  // namespace tessera::views
