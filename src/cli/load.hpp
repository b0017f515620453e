// Loading a model for a command: messages are said, a model without triangles is an error.
#pragma once

#include "cli/command.hpp"
#include "scene/scene.hpp"

namespace tessera::cli {

scene::Scene load(const Context& context, const std::string& input);

}  // namespace tessera::cli
