// The options of render about what a picture shows and how it is lit.
#pragma once

#include "render/rasteriser.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of the command line; apply() makes a frame of them.
struct LookWords {
    std::string view = "shaded";
    std::string shading = "phong";
    std::string preset = "none";
    std::string tonemap = "none";
    float exposure = 0.0f;  // stops
};

void add_look_options(CLI::App& command, LookWords& words);

/// Whether the words ask for what LoadOptions::all_maps loads.
bool needs_all_maps(const LookWords& words);

/// Sets the look of a frame for a scene whose coordinates are 2^exponent times those of the frame. Throws Error(usage)
/// for words that make no sense.
void apply(const LookWords& words, const scene::Scene& scene, int exponent, render::Frame& frame);

}  // namespace tessera::cli
