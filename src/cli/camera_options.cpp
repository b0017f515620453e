#include "cli/camera_options.hpp"

#include "base/error.hpp"
#include "scene/diagnostics.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <map>
#include <vector>

namespace tessera::cli {
namespace {

using scene::in_quotes;

std::vector<std::string> split(const std::string& words) {
    std::vector<std::string> parts(1);
    for (const char c : words) {
        if (c == ',') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::optional<double> parse_number(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (text.empty() || result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::vector<double>> parse_numbers(const std::string& words) {
    std::vector<double> numbers;
    for (const std::string& part : split(words)) {
        const auto number = parse_number(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

Error bad_orbit(const std::string& words) {
    return {ErrorKind::usage,
            fmt::format("The orbit {} is not understood; write YAW,PITCH[,DISTANCE[,FOVY]] with degrees "
                        "around and above the model, a distance above 0 in units of the one that just "
                        "fits, and a field of view of 1 to 170 degrees, such as 40,15.",
                        in_quotes(words))};
}

render::View parse_orbit(const std::string& words, render::Projection projection) {
    const auto numbers = parse_numbers(words);
    if (!numbers || numbers->size() < 2 || numbers->size() > 4) throw bad_orbit(words);
    render::View view;
    view.projection = projection;
    // Whole turns are taken off while there is room for them in a double.
    view.azimuth = static_cast<float>(glm::radians(std::remainder((*numbers)[0], 360.0)));
    view.elevation = static_cast<float>(glm::radians(std::remainder((*numbers)[1], 360.0)));
    if (numbers->size() > 2) view.distance = static_cast<float>((*numbers)[2]);
    if (!(view.distance > 0.0f) || !std::isfinite(view.distance)) throw bad_orbit(words);
    if (numbers->size() > 3) {
        if (!((*numbers)[3] >= 1.0 && (*numbers)[3] <= 170.0)) throw bad_orbit(words);
        view.field_of_view = static_cast<float>(glm::radians((*numbers)[3]));
    }
    return view;
}

Error bad_camera(const std::string& words, const std::string& reason) {
    return {ErrorKind::usage,
            fmt::format(
                "The camera {} is not understood: {}; write "
                "eye=X,Y,Z[,target=X,Y,Z][,up=X,Y,Z][,fovy=DEGREES or ortho=HEIGHT], a name or an index of a camera "
                "of the file.",
                in_quotes(words), reason)};
}

/// "eye=1,2,3,fovy=40" as key -> values.
std::map<std::string, std::vector<std::string>> parse_keys(const std::string& words) {
    std::map<std::string, std::vector<std::string>> keys;
    std::string key;
    for (const std::string& part : split(words)) {
        const std::size_t equals = part.find('=');
        if (equals != std::string::npos) {
            key = part.substr(0, equals);
            if (keys.contains(key)) throw bad_camera(words, key + " is given twice");
        }
        if (key.empty()) throw bad_camera(words, "it does not begin with a word and =");
        keys[key].push_back(equals == std::string::npos ? part : part.substr(equals + 1));
    }
    return keys;
}

render::LookAt parse_look(const std::string& words) {
    render::LookAt look;
    bool has_eye = false;
    bool has_lens = false;
    for (const auto& [key, values] : parse_keys(words)) {
        const auto place = [&, &key = key, &values = values] {
            glm::dvec3 result(0.0);
            if (values.size() != 3) throw bad_camera(words, key + " takes three numbers");
            for (int i = 0; i < 3; ++i) {
                const auto number = parse_number(values[static_cast<std::size_t>(i)]);
                if (!number) throw bad_camera(words, key + " takes three numbers");
                result[i] = *number;
            }
            return result;
        };
        if (key == "eye") {
            look.eye = place();
            has_eye = true;
        } else if (key == "target") {
            look.target = place();
        } else if (key == "up") {
            look.up = place();
        } else if (key == "fovy" || key == "ortho") {
            if (has_lens) throw bad_camera(words, "fovy and ortho exclude each other");
            has_lens = true;
            // A field of view may be in radians as well: fovy=0.7rad.
            std::string text = values.front();
            const bool radians = key == "fovy" && text.ends_with("rad");
            if (radians) text.resize(text.size() - 3);
            const auto number = parse_number(text);
            if (values.size() != 1 || !number) throw bad_camera(words, key + " takes one number");
            if (key == "ortho") {
                if (!(*number > 0.0)) throw bad_camera(words, "ortho takes a height above 0");
                look.projection = render::Projection::orthographic;
                look.half_height = *number / 2.0;
            } else {
                const double angle = radians ? *number : glm::radians(*number);
                if (!(angle >= glm::radians(0.1) && angle <= glm::radians(179.0))) {
                    throw bad_camera(words, "fovy takes an angle from 0.1 to 179 degrees");
                }
                look.half_height = std::tan(angle / 2.0);
            }
        } else {
            throw bad_camera(words, in_quotes(key) + " is not known");
        }
    }
    if (!has_eye) throw bad_camera(words, "there is no eye");
    return look;
}

std::string list_of(const scene::Scene& scene) {
    if (scene.cameras.empty()) return fmt::format("{} has no cameras", in_quotes(scene.source));
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.cameras.size(), 20); ++i) {
        list += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, in_quotes(scene.cameras[i].name));
    }
    if (scene.cameras.size() > 20) list += fmt::format(" and {} more", scene.cameras.size() - 20);
    return fmt::format("{} has {}", in_quotes(scene.source), list);
}

/// A camera of the file by name (the first of that name), else by its place among them.
render::Viewpoint find_camera(const std::string& words, const scene::Scene& scene) {
    const auto named = std::ranges::find(scene.cameras, words, &scene::Camera::name);
    if (named != scene.cameras.end()) return render::viewpoint_of(*named);
    std::size_t index = 0;
    const char* const end = words.data() + words.size();
    const auto result = std::from_chars(words.data(), end, index);
    if (!words.empty() && result.ec == std::errc() && result.ptr == end && index < scene.cameras.size()) {
        return render::viewpoint_of(scene.cameras[index]);
    }
    throw bad_camera(words, list_of(scene));
}

render::Projection projection_from_name(const std::string& name) {
    if (name == "perspective") return render::Projection::perspective;
    if (name == "orthographic") return render::Projection::orthographic;
    throw Error(ErrorKind::usage,
                fmt::format("There is no projection named {}; choose perspective or orthographic.", in_quotes(name)));
}

}  // namespace

void add_camera_options(CLI::App& command, CameraWords& words) {
    auto* const camera = command.add_option(
        "--camera", words.camera,
        "A camera of the file by NAME or INDEX, or one given as "
        "eye=X,Y,Z[,target=X,Y,Z][,up=X,Y,Z][,fovy=DEGREES | ,fovy=RADIANSrad | ,ortho=HEIGHT] in the model's units; "
        "numbers alone, YAW,PITCH,..., are an --orbit");
    command
        .add_option("--orbit", words.orbit,
                    "YAW,PITCH[,DISTANCE[,FOVY]]: degrees around the model and above it, distance in units of the one "
                    "that just fits, vertical field of view in degrees; the model is framed")
        ->excludes(camera);
    command.add_option("--projection", words.projection, "Of an orbit: perspective or orthographic")
        ->capture_default_str();
}

render::CameraChoice resolve(const CameraWords& words, const scene::Scene& scene) {
    const render::Projection projection = projection_from_name(words.projection);
    if (!words.orbit.empty()) return parse_orbit(words.orbit, projection);
    if (words.camera.empty()) {
        render::View view;
        view.projection = projection;
        return view;
    }
    const bool has_name = std::ranges::find(scene.cameras, words.camera, &scene::Camera::name) != scene.cameras.end();
    if (!has_name && words.camera.find(',') != std::string::npos && parse_numbers(words.camera)) {
        return parse_orbit(words.camera, projection);
    }
    if (projection == render::Projection::orthographic) {
        throw Error(ErrorKind::usage,
                    "--projection orthographic is for orbits; a camera says itself what it is (ortho=HEIGHT).");
    }
    if (!has_name && words.camera.find('=') != std::string::npos) return parse_look(words.camera);
    return find_camera(words.camera, scene);
}

}  // namespace tessera::cli
