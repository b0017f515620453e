// The one place that compiles tinygltf. Its parser converts numbers without looking and drops what it dislikes, so it
// only ever gets JSON that check_json copied, and the result is compared with what went in.
#include "scene/gltf_document.hpp"

#include <fmt/format.h>
#include <fstream>
#include <limits>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

namespace tessera::scene {

tinygltf::Model parse_model(const nlohmann::json& checked, const Diagnostics& diagnostics) {
    const std::string text = checked.dump();
    if (text.size() > std::numeric_limits<unsigned int>::max()) {
        diagnostics.refuse("the JSON text", fmt::format("has {} bytes, too many to read", text.size()));
    }
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    if (!reader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()),
                                    "")) {
        diagnostics.refuse("the document", "was not understood: " + in_quotes(error));
    }
    const auto compare = [&](const char* key, std::size_t got) {
        const auto it = checked.find(key);
        const std::size_t expected = it == checked.end() ? 0 : it->size();
        if (got != expected) {
            diagnostics.refuse(key, fmt::format("has {} entries, of which {} were understood", expected, got));
        }
    };
    compare("bufferViews", model.bufferViews.size());
    compare("accessors", model.accessors.size());
    compare("meshes", model.meshes.size());
    compare("nodes", model.nodes.size());
    compare("scenes", model.scenes.size());
    compare("materials", model.materials.size());
    compare("textures", model.textures.size());
    compare("samplers", model.samplers.size());
    compare("skins", model.skins.size());
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const std::size_t expected = checked["meshes"][i]["primitives"].size();
        if (model.meshes[i].primitives.size() != expected) {
            diagnostics.refuse(fmt::format("meshes[{}].primitives", i),
                               fmt::format("has {} entries, of which {} were understood", expected,
                                           model.meshes[i].primitives.size()));
        }
    }
    return model;
}

}  // namespace tessera::scene
