#include "scene/obj_materials.hpp"

#include "scene/file_bytes.hpp"
#include "scene/image_store.hpp"
#include "scene/limits.hpp"
#include "scene/obj_lines.hpp"
#include "scene/uri.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace tessera::scene {
namespace {

/// Backslashes are common in files of one system, and never part of a name there.
std::string portable(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

class MaterialLoader {
public:
    MaterialLoader(const std::filesystem::path& folder, Scene& scene, Diagnostics& diagnostics)
        : folder_(folder), scene_(scene), diagnostics_(diagnostics), images_(scene, diagnostics) {}

    /// `names`: what stands behind mtllib, one file name with spaces in it or several without.
    void read_libraries(const std::string& names) {
        const LocalPath whole = resolve_path(portable(names), folder_);
        std::error_code ignored;
        if (!whole.problem && std::filesystem::is_regular_file(whole.path, ignored)) return read_library(names);
        std::vector<std::string_view> words;
        split_words(names, words);
        if (words.empty()) diagnostics_.note("A mtllib statement names no file.");
        for (const std::string_view word : words)
            read_library(std::string(word));
    }

    std::uint32_t find(const std::string& name) {
        const auto known = places_.find(name);
        if (known != places_.end()) return known->second;
        const auto found = found_.find(name);
        Material material;
        material.name = name.empty() ? "default" : name;
        material.double_sided = true;
        if (found != found_.end()) {
            convert(found->second, material);
        } else if (!name.empty()) {
            diagnostics_.note(fmt::format("The material {} is not defined: it is plain white.", in_quotes(name)));
        }
        scene_.materials.push_back(std::move(material));
        return places_[name] = static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

private:
    struct Found {
        tinyobj::material_t material;
        std::filesystem::path library;  ///< relative to the folder
    };

    void read_library(const std::string& name) {
        const std::string element = fmt::format("The material library {}", in_quotes(name));
        const LocalPath local = resolve_path(portable(name), folder_);
        if (local.problem) return diagnostics_.note(fmt::format("{} {}.", element, *local.problem));
        const FileBytes file = read_file(local.path, max_mtl_bytes);
        if (file.problem) return diagnostics_.note(fmt::format("{} {}.", element, *file.problem));
        if (std::find(file.bytes.begin(), file.bytes.end(), std::byte{0}) != file.bytes.end()) {
            return diagnostics_.note(fmt::format("{} holds a zero byte and is ignored.", element));
        }
        std::istringstream in(std::string(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()));
        std::map<std::string, int> names;
        std::vector<tinyobj::material_t> materials;
        std::string warnings, errors;
        tinyobj::LoadMtl(&names, &materials, &in, &warnings, &errors);
        for (const auto& [material, place] : names)
            found_.try_emplace(material, Found{materials[static_cast<std::size_t>(place)], portable(name)});
    }

    float unit_range(float value, const std::string& element) {
        const float clamped = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 1.0f;
        if (clamped != value) diagnostics_.note(fmt::format("{} is {}: it is taken as {}.", element, value, clamped));
        return clamped;
    }

    void convert(const Found& from, Material& material) {
        const std::string element = fmt::format("The material {}:", in_quotes(material.name));
        for (int c = 0; c < 3; ++c)
            material.base_color[c] = unit_range(from.material.diffuse[c], element + " Kd");
        material.base_color.a = unit_range(from.material.dissolve, element + " d");
        if (material.base_color.a < 1.0f) material.alpha_mode = AlphaMode::blend;
        if (!from.material.alpha_texname.empty()) diagnostics_.note(element + " map_d is ignored.");
        if (from.material.diffuse_texname.empty()) return;
        if (from.material.diffuse_texopt.clamp) {
            diagnostics_.note(element + " its texture is repeated beyond [0, 1], where the file would clamp it.");
        }
        const auto name = from.library.parent_path() / portable(from.material.diffuse_texname);
        material.base_color_image = image(name.lexically_normal().string());
    }

    std::optional<std::uint32_t> image(const std::string& name) {
        const auto known = images_by_name_.find(name);
        if (known != images_by_name_.end()) return known->second;
        const std::string element = fmt::format("The texture {}", in_quotes(name));
        const LocalPath local = resolve_path(name, folder_);
        FileBytes file = local.problem ? FileBytes{{}, local.problem} : read_file(local.path, max_file_bytes);
        const auto place =
            file.problem ? images_.drop(element, *file.problem) : images_.add(std::move(file.bytes), name, element);
        return images_by_name_[name] = place;
    }

    std::filesystem::path folder_;
    Scene& scene_;
    Diagnostics& diagnostics_;
    ImageStore images_;
    std::map<std::string, Found> found_;
    std::map<std::string, std::uint32_t> places_;
    std::map<std::string, std::optional<std::uint32_t>> images_by_name_;
};

}  // namespace

std::vector<std::uint32_t> load_obj_materials(const std::vector<std::string>& libraries,
                                              const std::vector<PolygonPart>& parts,
                                              const std::filesystem::path& folder, Scene& scene,
                                              Diagnostics& diagnostics) {
    MaterialLoader loader(folder, scene, diagnostics);
    for (const std::string& names : libraries)
        loader.read_libraries(names);
    std::vector<std::uint32_t> materials;
    for (const PolygonPart& part : parts)
        materials.push_back(loader.find(part.material));
    if (scene.materials.empty()) loader.find("");
    return materials;
}

}  // namespace tessera::scene
