// What holds across elements: the formats of attributes, equal counts, skins that fit their matrices.
#include "scene/gltf_accessor.hpp"

#include <fmt/format.h>
#include <initializer_list>

namespace tessera::scene {
namespace {

struct Format {
    int type;
    std::initializer_list<int> components;
    const char* text;
};

constexpr int s8 = TINYGLTF_COMPONENT_TYPE_BYTE, u8 = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
              s16 = TINYGLTF_COMPONENT_TYPE_SHORT, u16 = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
              u32 = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, f32 = TINYGLTF_COMPONENT_TYPE_FLOAT;

// The core formats and those of KHR_mesh_quantization, which are read whether or not a file announces them.
const Format position_format{TINYGLTF_TYPE_VEC3, {f32, s8, u8, s16, u16}, "a VEC3 of floats, bytes or shorts"};
const Format normal_format{TINYGLTF_TYPE_VEC3, {f32, s8, s16}, "a VEC3 of floats, signed bytes or signed shorts"};
const Format uv_format{TINYGLTF_TYPE_VEC2, {f32, s8, u8, s16, u16}, "a VEC2 of floats, bytes or shorts"};
const Format tangent_format{TINYGLTF_TYPE_VEC4, {f32, s8, s16}, "a VEC4 of floats, signed bytes or signed shorts"};
const Format rgb_format{TINYGLTF_TYPE_VEC3, {f32, u8, u16}, "a VEC3 or VEC4 of floats, unsigned bytes or shorts"};
const Format rgba_format{TINYGLTF_TYPE_VEC4, {f32, u8, u16}, rgb_format.text};
const Format joints_format{TINYGLTF_TYPE_VEC4, {u8, u16}, "a VEC4 of unsigned bytes or shorts"};
const Format weights_format{TINYGLTF_TYPE_VEC4, {f32, u8, u16}, "a VEC4 of floats, unsigned bytes or shorts"};
const Format index_format{TINYGLTF_TYPE_SCALAR, {u8, u16, u32}, "a SCALAR of unsigned integers"};
const Format matrix_format{TINYGLTF_TYPE_MAT4, {f32}, "a MAT4 of floats"};

class ModelCheck {
public:
    explicit ModelCheck(const Document& document) : document_(document), model_(document.model) {}

    void primitive(const tinygltf::Primitive& primitive, const std::string& element) const {
        if (primitive.indices >= 0) {
            const std::string indices = element + ".indices";
            check(primitive.indices, index_format, indices);
            if (accessor(primitive.indices).normalized) refuse(indices, "are normalised, but must be plain integers");
        }
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) return;
        const std::size_t count = accessor(position->second).count;
        for (const auto& [name, index] : primitive.attributes) {
            attribute(name, index, count, fmt::format("{}.attributes.{}", element, in_quotes(name)));
        }
        for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
            for (const auto& [name, index] : primitive.targets[i]) {
                // Displacements of positions, normals and tangents are alike; anything else in a target is not read.
                const std::string target = fmt::format("{}.targets[{}].{}", element, i, in_quotes(name));
                equal_count(index, count, target);
                if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") check(index, position_format, target);
            }
        }
    }

    void mesh_weights(const tinygltf::Mesh& mesh, const std::vector<double>& weights,
                      const std::string& element) const {
        for (const auto& primitive : mesh.primitives) {
            if (!weights.empty() && primitive.targets.size() != weights.size()) {
                refuse(element, fmt::format("has {} values, but the mesh has {} morph targets", weights.size(),
                                            primitive.targets.size()));
            }
        }
    }

    void skin(const tinygltf::Skin& skin, const std::string& element) const {
        if (skin.inverseBindMatrices < 0) return;
        const std::string matrices = element + ".inverseBindMatrices";
        check(skin.inverseBindMatrices, matrix_format, matrices);
        const std::size_t count = accessor(skin.inverseBindMatrices).count;
        if (count < skin.joints.size()) {
            refuse(matrices, fmt::format("has {} matrices for {} joints", count, skin.joints.size()));
        }
    }

private:
    const tinygltf::Accessor& accessor(int index) const { return model_.accessors[static_cast<std::size_t>(index)]; }

    [[noreturn]] void refuse(const std::string& element, const std::string& reason) const {
        document_.diagnostics.refuse(element, reason);
    }

    void check(int index, const Format& format, const std::string& element) const {
        const auto& a = accessor(index);
        for (const int component : format.components) {
            if (a.type == format.type && a.componentType == component) return;
        }
        refuse(element, fmt::format("is accessor {} with {} values per element of component type {}, but must be {}",
                                    index, components_of(a), a.componentType, format.text));
    }

    void check_normalized(int index, const std::string& element) const {
        const auto& a = accessor(index);
        if (a.componentType != f32 && !a.normalized) refuse(element, "holds integers that are not normalised");
    }

    void equal_count(int index, std::size_t count, const std::string& element) const {
        if (accessor(index).count != count) {
            refuse(element, fmt::format("has {} elements, but POSITION has {}", accessor(index).count, count));
        }
    }

    void attribute(const std::string& name, int index, std::size_t count, const std::string& element) const {
        const auto begins = [&](const char* prefix) { return name.rfind(prefix, 0) == 0; };
        if (name == "POSITION") check(index, position_format, element);
        if (name == "NORMAL") check(index, normal_format, element);
        if (name == "TANGENT") {
            check(index, tangent_format, element);
            check_normalized(index, element);
        }
        if (begins("COLOR_")) {
            check(index, accessor(index).type == TINYGLTF_TYPE_VEC4 ? rgba_format : rgb_format, element);
            check_normalized(index, element);
        }
        if (begins("TEXCOORD_")) check(index, uv_format, element);
        if (begins("JOINTS_")) check(index, joints_format, element);
        if (begins("WEIGHTS_")) check(index, weights_format, element);
        equal_count(index, count, element);
    }

    const Document& document_;
    const tinygltf::Model& model_;
};

}  // namespace

void check_model(const Document& document) {
    check_accessors(document);
    const auto& model = document.model;
    const ModelCheck check(document);
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const auto& mesh = model.meshes[i];
        for (std::size_t j = 0; j < mesh.primitives.size(); ++j) {
            check.primitive(mesh.primitives[j], fmt::format("meshes[{}].primitives[{}]", i, j));
        }
        check.mesh_weights(mesh, mesh.weights, fmt::format("meshes[{}].weights", i));
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const auto& node = model.nodes[i];
        if (node.mesh < 0) continue;
        check.mesh_weights(model.meshes[static_cast<std::size_t>(node.mesh)], node.weights,
                           fmt::format("nodes[{}].weights", i));
    }
    for (std::size_t i = 0; i < model.skins.size(); ++i)
        check.skin(model.skins[i], fmt::format("skins[{}]", i));
}

}  // namespace tessera::scene
