#include "cli/look_options.hpp"

#include "base/error.hpp"
#include "views/paint.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::cli {
namespace {

render::Shading parse_shading(const std::string& name) {
    if (name == "phong") return render::Shading::phong;
    if (name == "blinn") return render::Shading::reflection;
    if (name == "pbr") return render::Shading::pbr;
    if (name == "normals") return render::Shading::normals;
    if (name == "wireframe") return render::Shading::wireframe;
    throw Error(ErrorKind::usage,
                fmt::format("There is no shading named \"{}\"; choose phong, blinn, pbr, normals or wireframe.", name));
}

/// Van Veen and Baakman, "Curved PN triangles on the GPU", figure 14. They look along +z: their light at (-2, 5, -10)
/// is up to the left of the model and before it.
void use_van_veen_preset(render::Frame& frame) {
    frame.reflection.half_vector = frame.shading == render::Shading::reflection;
    frame.reflection.ambient = 0.4f;
    frame.reflection.diffuse = 0.5f;
    frame.reflection.specular = 0.3f;
    frame.reflection.shininess = 150.0f;
    frame.reflection.light = glm::vec3(-2.0f, 5.0f, 10.0f);
    frame.reflection.light_is_place = true;
    frame.reflection.colour = glm::vec3(0.9734f, 0.0f, 0.1527f);  // (0.988, 0, 0.427) as codes of the screen
    frame.shading = render::Shading::reflection;
}

void show(const std::string& view, render::Frame& frame) {
    if (view == "shaded") return;
    if (view == "wireframe") {
        frame.wires = true;
    } else if (view == "normals") {
        frame.shading = render::Shading::normals;
    } else if (view == "depth") {
        frame.shading = render::Shading::depth;
    } else if (view == "uv") {
        frame.shading = render::Shading::uv;
    } else if (view == "factors" || view == "scheme-difference" || view == "silhouette") {
        views::light_for_colours(frame);
    } else {
        throw Error(ErrorKind::usage,
                    fmt::format("There is no view named \"{}\"; choose shaded, normals, wireframe, depth, uv, factors, "
                                "scheme-difference or silhouette.",
                                view));
    }
}

scene::Light to_kernel_space(scene::Light light, int exponent) {
    const float down = std::ldexp(1.0f, -exponent);
    if (light.kind != scene::Light::Kind::directional) {
        light.place *= down;
        light.range *= down;
        light.intensity *= down * down;  // falls off with the square of the distance
    }
    return light;
}

}  // namespace

void add_look_options(CLI::App& command, LookWords& words) {
    command
        .add_option("--view", words.view,
                    "What is shown: shaded, normals, wireframe (edges over the shading), depth (white is near), uv "
                    "(texture coordinates as red and green), factors (as colours), scheme-difference (the distance to "
                    "the surface of another scheme, see --against) or silhouette (outlines of the surface and of its "
                    "coarse mesh)")
        ->capture_default_str();
    command
        .add_option("--shading", words.shading,
                    "phong, blinn, pbr (metallic-roughness materials under the file's lights and a sky), normals or "
                    "wireframe (edges over a flat fill)")
        ->capture_default_str();
    command
        .add_option("--preset", words.preset,
                    "Constants of phong and blinn: none, or van-veen (colour, light and shininess of van Veen and "
                    "Baakman's figures)")
        ->check(CLI::IsMember({"none", "van-veen"}))
        ->capture_default_str();
    command
        .add_option("--tonemap", words.tonemap,
                    "From light to the screen, of pbr: none (light above 1 is white) or aces (Narkowicz's fit)")
        ->check(CLI::IsMember({"none", "aces"}))
        ->capture_default_str();
    command.add_option("--exposure", words.exposure, "Stops by which pbr makes light brighter, before the tone curve")
        ->check(CLI::Range(-30.0, 30.0))
        ->capture_default_str();
}

bool needs_all_maps(const LookWords& words) {
    return words.shading == "pbr";
}

void apply(const LookWords& words, const scene::Scene& scene, int exponent, render::Frame& frame) {
    frame.shading = parse_shading(words.shading);
    if (words.preset == "van-veen") {
        if (words.shading != "phong" && words.shading != "blinn") {
            throw Error(ErrorKind::usage, fmt::format("The preset van-veen is one of phong and blinn, not of --shading "
                                                      "{}.",
                                                      words.shading));
        }
        use_van_veen_preset(frame);
    }
    show(words.view, frame);
    frame.tone_curve = words.tonemap == "aces" ? render::ToneCurve::aces : render::ToneCurve::none;
    frame.exposure = std::exp2(words.exposure);
    for (const scene::Light& light : scene.lights)
        frame.lights.push_back(to_kernel_space(light, exponent));
    if (frame.lights.empty()) {
        scene::Light key;
        key.fixed_to_camera = true;
        key.direction = frame.reflection.light_is_place ? glm::vec3(0.0f, 0.0f, 1.0f) : frame.reflection.light;
        key.intensity = glm::vec3(2.0f);
        frame.lights.push_back(key);
    }
}

}  // namespace tessera::cli
