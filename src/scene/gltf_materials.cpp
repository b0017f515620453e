#include "scene/gltf_materials.hpp"

#include "scene/file_bytes.hpp"
#include "scene/gltf_accessor.hpp"
#include "scene/gltf_maps.hpp"
#include "scene/image_store.hpp"
#include "scene/limits.hpp"
#include "scene/uri.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

namespace tessera::scene {
namespace {

/// An image's bytes as the file has them, or a clause that says why there are none.
FileBytes encoded_image(const Document& document, const ImageSource& source) {
    if (source.buffer_view) {
        const auto bytes = view_bytes(document, static_cast<int>(*source.buffer_view));
        return {{bytes.begin(), bytes.end()}, std::nullopt};
    }
    if (is_data_uri(source.uri)) {
        auto bytes = decode_data_uri(source.uri);
        if (!bytes) return {{}, "is not well-formed base64 data"};
        return {std::move(*bytes), std::nullopt};
    }
    const LocalPath local = resolve_uri(source.uri, document.folder);
    if (local.problem) return {{}, fmt::format("({}) {}", in_quotes(source.uri), *local.problem)};
    FileBytes file = read_file(local.path, max_file_bytes);
    if (file.problem) file.problem = fmt::format("({}) {}", in_quotes(source.uri), *file.problem);
    return file;
}

class ImageLoader {
public:
    ImageLoader(const Document& document, Scene& scene) : document_(document), store_(scene, document.diagnostics) {}

    /// The place of a file's image among the scene's, loading it at first use.
    std::optional<std::uint32_t> load(int source) {
        const auto known = loaded_.find(source);
        if (known != loaded_.end()) return known->second;
        return loaded_[source] = load_new(source);
    }

private:
    std::optional<std::uint32_t> load_new(int source) {
        const ImageSource& from = document_.images[static_cast<std::size_t>(source)];
        const std::string element = fmt::format("images[{}]", source);
        FileBytes file = encoded_image(document_, from);
        if (file.problem) return store_.drop(element, *file.problem);
        return store_.add(std::move(file.bytes), from.name.empty() ? element : from.name, element);
    }

    const Document& document_;
    ImageStore store_;
    std::map<int, std::optional<std::uint32_t>> loaded_;
};

float unit_range(const Document& document, double value, const std::string& element) {
    if (value < 0.0 || value > 1.0) {
        document.diagnostics.note(fmt::format("{} is {}: it is clamped to [0, 1].", element, value));
    }
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

}  // namespace

void load_materials(const Document& document, Scene& scene) {
    ImageLoader images(document, scene);
    const auto& model = document.model;
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        const auto& from = model.materials[i];
        const std::string element = fmt::format("materials[{}]", i);
        Material material;
        material.name = from.name.empty() ? element : from.name;
        for (int c = 0; c < 4; ++c) {
            material.base_color[c] =
                unit_range(document, from.pbrMetallicRoughness.baseColorFactor[static_cast<std::size_t>(c)],
                           element + ".pbrMetallicRoughness.baseColorFactor");
        }
        const auto load = [&](int texture) -> std::optional<std::uint32_t> {
            const int source = model.textures[static_cast<std::size_t>(texture)].source;
            if (source >= 0) return images.load(source);
            document.diagnostics.note(fmt::format("textures[{}] has no PNG or JPEG image: it is left out.", texture));
            return std::nullopt;
        };
        const int base = from.pbrMetallicRoughness.baseColorTexture.index;
        if (base >= 0) material.base_color_image = load(base);
        if (document.all_maps) load_maps(document, static_cast<int>(i), load, material);
        if (from.alphaMode == "MASK") material.alpha_mode = AlphaMode::mask;
        if (from.alphaMode == "BLEND") material.alpha_mode = AlphaMode::blend;
        material.alpha_cutoff = unit_range(document, from.alphaCutoff, element + ".alphaCutoff");
        material.double_sided = from.doubleSided;
        scene.materials.push_back(std::move(material));
    }
    const auto lacks_one = [](const tinygltf::Mesh& mesh) {
        return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                           [](const auto& p) { return p.material < 0; });
    };
    if (scene.materials.empty() || std::any_of(model.meshes.begin(), model.meshes.end(), lacks_one)) {
        Material plain;
        plain.name = "default";
        plain.metallic = plain.roughness = 1.0f;
        scene.materials.push_back(std::move(plain));
    }
}

}  // namespace tessera::scene
