#include "cli/load.hpp"

#include "base/error.hpp"
#include "scene/file_bytes.hpp"

#include <fmt/format.h>

namespace tessera::cli {
namespace {

scene::NgonMode ngons_from_name(const std::string& name) {
    if (name == "split") return scene::NgonMode::split;
    if (name == "fan") return scene::NgonMode::fan;
    throw Error(ErrorKind::usage,
                fmt::format("There is no way of treating polygons named \"{}\"; choose split or fan.", name));
}

}  // namespace

void add_load_options(CLI::App& command, LoadWords& words) {
    command
        .add_option("--ngons", words.ngons,
                    "Faces of more than four corners: split (all faces of the file become quads) "
                    "or fan (they become triangles)")
        ->capture_default_str();
    command.add_flag("--smooth-normals", words.smooth_normals,
                     "Replace the model's normals by smooth ones, welded by position: hard edges become round, without "
                     "cracks");
}

scene::Scene load(const Context& context, const std::string& input, const LoadWords& words, bool all_maps) {
    scene::Scene scene = scene::load_scene(input, {ngons_from_name(words.ngons), words.smooth_normals, all_maps});
    for (const std::string& message : scene.messages) {
        say(context, message);
    }
    return scene;
}

image::Image load_picture(const std::string& path) {
    constexpr std::uint64_t most_bytes = 1ull << 31;  // as image::decode takes
    const scene::FileBytes file = scene::read_file(path, most_bytes);
    if (file.problem) throw Error(ErrorKind::usage, fmt::format("{}: the picture {}.", path, *file.problem));
    return image::decode(file.bytes, path);
}

}  // namespace tessera::cli
