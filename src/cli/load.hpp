// Loading a model for a command: messages are said, a model without faces is an error (of make_patches). And pictures.
#pragma once

#include "cli/command.hpp"
#include "scene/scene.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of the options about input.
struct LoadWords {
    std::string ngons = "split";
    bool smooth_normals = false;
};

void add_load_options(CLI::App& command, LoadWords& words);

/// `all_maps` as in scene::LoadOptions. Throws Error(usage) for words that make no sense and for files that cannot be
/// read.
scene::Scene load(const Context& context, const std::string& input, const LoadWords& words, bool all_maps = false);

/// Reads a PNG or JPEG file. Throws Error(usage).
image::Image load_picture(const std::string& path);

}  // namespace tessera::cli
