// The options that say where a picture is seen from.
#pragma once

#include "render/camera_choice.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of those options; empty where not given.
struct CameraWords {
    std::string camera, orbit, projection = "perspective";
};

void add_camera_options(CLI::App& command, CameraWords& words);

/// The camera that the words ask for, in the model's units. Throws Error(usage) with what can be written, and with the
/// cameras that the scene has.
render::CameraChoice resolve(const CameraWords& words, const scene::Scene& scene);

}  // namespace tessera::cli
