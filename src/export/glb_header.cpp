#include "export/glb_header.hpp"

#include "base/error.hpp"
#include "export/gltf_tangent.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <map>

namespace tessera::exporting {
namespace {

using Json = nlohmann::ordered_json;

constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int component_float = 5126, component_uint = 5125;
constexpr std::size_t vertex_view = 0, index_view = 1, next_view = 2;  // of tangents, colours, images: what there is
constexpr std::size_t color_bytes = sizeof(VertexAttributes::color);
constexpr std::size_t no_accessor = static_cast<std::size_t>(-1);

/// As a decimal number: sign, point, 17 digits and an exponent of two, which no float exceeds.
constexpr float longest_number = -1.17549435e-38f;

/// The materials of the parts that become primitives, in ascending order.
std::set<std::uint32_t> used_materials(const MeshTotals& totals) {
    std::set<std::uint32_t> used;
    for (const MeshPart& part : totals.parts) {
        if (part.index_count > 0) used.insert(part.material);
    }
    return used;
}

/// A factor as glTF allows it; input files may hold others.
float unit(float value) {
    return value >= 0.0f ? std::min(value, 1.0f) : 0.0f;
}

Json vertex_accessor(const MeshPart& part, std::size_t member_offset, const char* type) {
    return {{"bufferView", vertex_view},
            {"byteOffset", part.first_vertex * sizeof(Vertex) + member_offset},
            {"componentType", component_float},
            {"count", part.vertex_count},
            {"type", type}};
}

}  // namespace

GlbHeader::GlbHeader(const std::string& file, const std::string& name, const MeshTotals& totals,
                     const scene::Scene& scene)
    : tangents_at_(totals.vertex_count * sizeof(Vertex)),
      colors_at_(tangents_at_ + (totals.has_tangents ? totals.vertex_count * sizeof(GltfTangent) : 0)),
      indices_at_(colors_at_ + (totals.has_colors ? totals.vertex_count * color_bytes : 0)),
      binary_bytes_(indices_at_ + totals.index_count * sizeof(std::uint32_t)),
      position_accessors_(totals.parts.size(), no_accessor) {
    json_["asset"] = {{"version", "2.0"}, {"generator", fmt::format("Tessera {}", TESSERA_VERSION)}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({Json::object()});
    const std::set<std::uint32_t> used = used_materials(totals);
    if (used.empty()) {  // glTF has no empty meshes and buffers: an empty scene is left
        binary_bytes_ = 0;
        return;
    }
    has_quads_ = totals.has_quads;
    has_tangents_ = totals.has_tangents;
    has_colors_ = totals.has_colors;
    if (has_quads_) json_["extensionsUsed"] = {"FB_ngon_encoding"};
    place_images(file, used, scene);
    add_buffer_views(totals, scene);
    std::map<std::uint32_t, std::size_t> material_numbers;
    for (const std::uint32_t number : used) {
        material_numbers[number] = append("materials", material(scene.materials[number]));
    }
    Json primitives = Json::array();
    for (std::size_t i = 0; i < totals.parts.size(); ++i) {
        const MeshPart& part = totals.parts[i];
        if (part.index_count == 0) continue;
        primitives.push_back(primitive(part, material_numbers.at(part.material)));
        position_accessors_[i] = primitives.back()["attributes"]["POSITION"];
        set_bounds(i, {longest_number, longest_number, longest_number},
                   {longest_number, longest_number, longest_number});
    }
    append("meshes", {{"name", name}, {"primitives", primitives}});
    append("nodes", {{"name", name}, {"mesh", 0}});
    json_["scenes"][0]["nodes"] = {0};
}

void GlbHeader::place_images(const std::string& file, const std::set<std::uint32_t>& materials,
                             const scene::Scene& scene) {
    std::set<std::uint32_t> used;
    for (const std::uint32_t number : materials) {
        const auto& image = scene.materials[number].base_color_image;
        if (image) used.insert(*image);
    }
    for (const std::uint32_t number : used) {
        const scene::SceneImage& image = scene.images.at(number);
        const bool known = image.mime_type == "image/png" || image.mime_type == "image/jpeg";
        if (!known || image.encoded.empty()) {
            throw Error(ErrorKind::output,
                        fmt::format("Cannot write '{}': image {} ('{}') is {} bytes of type '{}', but a .glb embeds "
                                    "PNG and JPEG files only.",
                                    file, number, image.name, image.encoded.size(), image.mime_type));
        }
        images_.push_back({number, binary_bytes_});
        binary_bytes_ += (image.encoded.size() + 3) / 4 * 4;
    }
}

void GlbHeader::add_buffer_views(const MeshTotals& totals, const scene::Scene& scene) {
    append("buffers", {{"byteLength", binary_bytes_}});
    append("bufferViews",
           {{"buffer", 0}, {"byteLength", tangents_at_}, {"byteStride", sizeof(Vertex)}, {"target", array_buffer}});
    append("bufferViews", {{"buffer", 0},
                           {"byteOffset", indices_at_},
                           {"byteLength", totals.index_count * sizeof(std::uint32_t)},
                           {"target", element_array_buffer}});
    const auto add_vertex_view = [&](std::uint64_t begin, std::uint64_t end, std::size_t stride) {
        append("bufferViews", {{"buffer", 0},
                               {"byteOffset", begin},
                               {"byteLength", end - begin},
                               {"byteStride", stride},
                               {"target", array_buffer}});
    };
    if (has_tangents_) add_vertex_view(tangents_at_, colors_at_, sizeof(GltfTangent));
    if (has_colors_) add_vertex_view(colors_at_, indices_at_, color_bytes);
    const std::size_t first_image_view = json_["bufferViews"].size();
    for (std::size_t i = 0; i < images_.size(); ++i) {
        const scene::SceneImage& image = scene.images[images_[i].image];
        append("bufferViews", {{"buffer", 0}, {"byteOffset", images_[i].offset}, {"byteLength", image.encoded.size()}});
        append("images", {{"name", image.name}, {"mimeType", image.mime_type}, {"bufferView", first_image_view + i}});
        append("textures", {{"source", i}});
    }
}

Json GlbHeader::material(const scene::Material& material) const {
    const glm::vec4& color = material.base_color;
    Json surface = {{"baseColorFactor", {unit(color.r), unit(color.g), unit(color.b), unit(color.a)}},
                    {"metallicFactor", 0}};
    if (material.base_color_image) {
        const auto image = std::find_if(images_.begin(), images_.end(), [&](const GlbImage& placed) {
            return placed.image == *material.base_color_image;
        });
        surface["baseColorTexture"] = {{"index", image - images_.begin()}};
    }
    Json json = {{"name", material.name}, {"pbrMetallicRoughness", surface}};
    if (material.alpha_mode == scene::AlphaMode::mask) {
        json["alphaMode"] = "MASK";
        json["alphaCutoff"] = std::max(0.0f, material.alpha_cutoff);  // 0 also where it is not a number
    } else if (material.alpha_mode == scene::AlphaMode::blend) {
        json["alphaMode"] = "BLEND";
    }
    if (material.double_sided) json["doubleSided"] = true;
    return json;
}

Json GlbHeader::primitive(const MeshPart& part, std::size_t material) {
    Json attributes = {{"POSITION", append("accessors", vertex_accessor(part, offsetof(Vertex, position), "VEC3"))},
                       {"NORMAL", append("accessors", vertex_accessor(part, offsetof(Vertex, normal), "VEC3"))},
                       {"TEXCOORD_0", append("accessors", vertex_accessor(part, offsetof(Vertex, uv), "VEC2"))}};
    const auto add_vec4 = [&](std::size_t view, std::size_t stride) {
        return append("accessors", {{"bufferView", view},
                                    {"byteOffset", part.first_vertex * stride},
                                    {"componentType", component_float},
                                    {"count", part.vertex_count},
                                    {"type", "VEC4"}});
    };
    if (has_tangents_) attributes["TANGENT"] = add_vec4(next_view, sizeof(GltfTangent));
    if (has_colors_) attributes["COLOR_0"] = add_vec4(has_tangents_ ? next_view + 1 : next_view, color_bytes);
    const std::size_t indices = append("accessors", {{"bufferView", index_view},
                                                     {"byteOffset", part.first_index * sizeof(std::uint32_t)},
                                                     {"componentType", component_uint},
                                                     {"count", part.index_count},
                                                     {"type", "SCALAR"}});
    Json json = {{"attributes", attributes}, {"indices", indices}, {"material", material}};
    if (has_quads_) json["extensions"] = {{"FB_ngon_encoding", Json::object()}};
    return json;
}

void GlbHeader::set_bounds(std::size_t part, const std::array<float, 3>& min, const std::array<float, 3>& max) {
    if (position_accessors_[part] == no_accessor) return;
    Json& accessor = json_["accessors"][position_accessors_[part]];
    accessor["min"] = min;
    accessor["max"] = max;
}

std::string GlbHeader::text() const {
    // Names come from files and need not be UTF-8, which JSON must be.
    return json_.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::size_t GlbHeader::append(const char* array, const Json& entry) {
    json_[array].push_back(entry);
    return json_[array].size() - 1;
}

}  // namespace tessera::exporting
