#include "cli/load.hpp"

#include <fmt/format.h>

namespace tessera::cli {

scene::Scene load(const Context& context, const std::string& input) {
    scene::Scene scene = scene::load_scene(input);
    for (const std::string& message : scene.messages) {
        say(context, message);
    }
    return scene;
}

}  // namespace tessera::cli
