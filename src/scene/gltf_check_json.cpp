// What the JSON text alone must fulfil (glTF 2.0, section 5). Order and names follow the specification's schema.
#include "scene/gltf_document.hpp"
#include "scene/json_object.hpp"
#include "scene/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace tessera::scene {
namespace {

constexpr std::int64_t int_max = JsonObject::int_max;
constexpr std::array<std::string_view, 3> supported_extensions{"FB_ngon_encoding", "KHR_mesh_quantization",
                                                               "KHR_texture_transform"};
// Of metallic-roughness shading.
constexpr std::array<std::string_view, 3> extensions_of_light{"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                                              "KHR_materials_unlit"};

struct Sizes {
    std::size_t accessors, buffers, buffer_views, cameras, images, materials, meshes, nodes, samplers, scenes, skins,
        textures;
};

void check_asset(JsonObject& asset) {
    const auto supported = [&](const char* key, const std::string& version, bool minimum) {
        const bool is_two = version == "2.0" || (!minimum && version.substr(0, 2) == "2.");
        if (!is_two) asset.refuse(key, "is " + in_quotes(version) + ", but only glTF 2.0 is read");
    };
    supported("version", asset.string("version", Need::required).value(), false);
    if (const auto version = asset.string("minVersion")) supported("minVersion", *version, true);
}

void check_extensions(JsonObject& root, Diagnostics& diagnostics, bool all_maps) {
    const auto supported = [all_maps](const std::string& name) {
        const auto is_name = [&](std::string_view known) { return known == name; };
        return std::ranges::any_of(supported_extensions, is_name) ||
               (all_maps && std::ranges::any_of(extensions_of_light, is_name));
    };
    for (const std::string& name : root.strings("extensionsRequired")) {
        if (!supported(name)) {
            diagnostics.refuse("extensionsRequired",
                               "asks for " + in_quotes(name) + ", which is not supported; export the model without it");
        }
    }
    for (const std::string& name : root.strings("extensionsUsed")) {
        if (!supported(name)) diagnostics.note("The optional extension " + in_quotes(name) + " is ignored.");
    }
}

/// Returns whether the accessor has a buffer view.
bool check_accessor(JsonObject& accessor, const Sizes& sizes) {
    const auto view = accessor.reference("bufferView", sizes.buffer_views);
    accessor.integer("byteOffset", 0, int_max);
    if (!view && accessor.has("byteOffset")) accessor.refuse("byteOffset", "needs a bufferView, but there is none");
    const auto component = accessor.integer("componentType", 5120, 5126, Need::required);
    if (component == 5124) accessor.refuse("componentType", "is 5124 (a signed int), which glTF does not have");
    accessor.boolean("normalized");
    accessor.integer("count", 1, int_max, Need::required);
    constexpr std::array<std::string_view, 7> types{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    const std::string type = accessor.string("type", Need::required).value();
    if (std::find(types.begin(), types.end(), type) == types.end()) {
        accessor.refuse("type", "is " + in_quotes(type) + ", but must be SCALAR, VEC2 to VEC4 or MAT2 to MAT4");
    }
    accessor.object("sparse", [&](JsonObject& sparse) {
        sparse.integer("count", 1, int_max, Need::required);
        sparse.object(
            "indices",
            [&](JsonObject& indices) {
                indices.reference("bufferView", sizes.buffer_views, Need::required);
                indices.integer("byteOffset", 0, int_max);
                const auto type = indices.integer("componentType", 5121, 5125, Need::required);
                if (type != 5121 && type != 5123 && type != 5125) {
                    indices.refuse("componentType", fmt::format("is {}, but must be unsigned", *type));
                }
            },
            Need::required);
        sparse.object(
            "values",
            [&](JsonObject& values) {
                values.reference("bufferView", sizes.buffer_views, Need::required);
                values.integer("byteOffset", 0, int_max);
            },
            Need::required);
    });
    return view.has_value();
}

void check_buffer_view(JsonObject& view, const Sizes& sizes) {
    view.reference("buffer", sizes.buffers, Need::required);
    view.integer("byteOffset", 0, int_max);
    view.integer("byteLength", 1, int_max, Need::required);
    const auto stride = view.integer("byteStride", 4, 252);
    if (stride && *stride % 4 != 0) view.refuse("byteStride", fmt::format("is {}, not a multiple of 4", *stride));
}

void check_primitive(JsonObject& primitive, const Sizes& sizes, const std::vector<bool>& has_view) {
    primitive.reference_map("attributes", sizes.accessors, Need::required);
    const auto indices = primitive.reference("indices", sizes.accessors);
    if (indices && !has_view[static_cast<std::size_t>(*indices)]) {
        primitive.refuse("indices", fmt::format("is accessor {}, which has no bufferView", *indices));
    }
    primitive.reference("material", sizes.materials);
    primitive.integer("mode", 0, 6);
    primitive.reference_maps("targets", sizes.accessors);
    primitive.object("extensions",
                     [](JsonObject& extensions) { extensions.object("FB_ngon_encoding", [](JsonObject&) {}); });
}

void check_node(JsonObject& node, const Sizes& sizes) {
    node.string("name");
    node.references("children", sizes.nodes);
    node.reference("mesh", sizes.meshes);
    node.reference("camera", sizes.cameras);
    node.reference("skin", sizes.skins);
    node.numbers("matrix", 16);
    node.numbers("rotation", 4);
    node.numbers("scale", 3);
    node.numbers("translation", 3);
    node.numbers("weights", 0);
}

CameraSource read_camera(JsonObject& camera) {
    CameraSource source;
    source.name = camera.string("name").value_or("");
    const std::string type = camera.string("type", Need::required).value();
    if (type != "perspective" && type != "orthographic") {
        camera.refuse("type", "is " + in_quotes(type) + ", but must be perspective or orthographic");
    }
    source.orthographic = type == "orthographic";
    camera.object("perspective", [&](JsonObject& perspective) {
        source.field_of_view = perspective.number("yfov");
        source.aspect = perspective.number("aspectRatio");
        if (!source.orthographic) {
            source.near_plane = perspective.number("znear");
            source.far_plane = perspective.number("zfar");
        }
    });
    camera.object("orthographic", [&](JsonObject& orthographic) {
        source.half_width = orthographic.number("xmag");
        source.half_height = orthographic.number("ymag");
        if (source.orthographic) {
            source.near_plane = orthographic.number("znear");
            source.far_plane = orthographic.number("zfar");
        }
    });
    return source;
}

void check_texture(JsonObject& info, const Sizes& sizes) {
    info.reference("index", sizes.textures, Need::required);
    info.integer("texCoord", 0, int_max);
    info.number("scale");
    info.number("strength");
    info.object("extensions", [&](JsonObject& extensions) {
        extensions.object("KHR_texture_transform", [&](JsonObject& transform) {
            transform.numbers("offset", 2);
            transform.numbers("scale", 2);
            transform.number("rotation");
            transform.integer("texCoord", 0, int_max);
        });
    });
}

/// What metallic-roughness shading looks at.
void check_maps(JsonObject& material, const Sizes& sizes) {
    const auto texture = [&](JsonObject& info) { check_texture(info, sizes); };
    material.object("normalTexture", texture);
    material.object("occlusionTexture", texture);
    material.object("emissiveTexture", texture);
    material.numbers("emissiveFactor", 3);
    material.object("extensions", [](JsonObject& extensions) {
        extensions.object("KHR_materials_unlit", [](JsonObject&) {});
        extensions.object("KHR_materials_emissive_strength",
                          [](JsonObject& emissive) { emissive.number("emissiveStrength"); });
    });
}

void check_material(JsonObject& material, const Sizes& sizes, Diagnostics& diagnostics, bool all_maps) {
    bool more = material.has("normalTexture") || material.has("occlusionTexture") || material.has("emissiveTexture");
    material.string("name");
    material.object("pbrMetallicRoughness", [&](JsonObject& pbr) {
        more = more || pbr.has("metallicRoughnessTexture");
        pbr.numbers("baseColorFactor", 4);
        pbr.object("baseColorTexture", [&](JsonObject& info) { check_texture(info, sizes); });
        if (all_maps) {
            pbr.number("metallicFactor");
            pbr.number("roughnessFactor");
            pbr.object("metallicRoughnessTexture", [&](JsonObject& info) { check_texture(info, sizes); });
        }
    });
    if (all_maps) check_maps(material, sizes);
    if (const auto mode = material.string("alphaMode");
        mode && *mode != "OPAQUE" && *mode != "MASK" && *mode != "BLEND") {
        material.refuse("alphaMode", "is " + in_quotes(*mode) + ", but must be OPAQUE, MASK or BLEND");
    }
    material.number("alphaCutoff");
    material.boolean("doubleSided");
    if (more && !all_maps)
        diagnostics.note("Of the materials, only base colours are used: other textures are ignored.");
}

void check_images_and_buffers(JsonObject& root, const Sizes& sizes, CheckedJson& checked) {
    root.objects("buffers", [&](JsonObject& buffer) {
        BufferSource source;
        source.byte_length =
            static_cast<std::uint64_t>(buffer.integer("byteLength", 1, int_max, Need::required).value());
        const auto uri = buffer.string("uri");
        if (uri && uri->empty()) buffer.refuse("uri", "is empty");
        source.uri = uri.value_or("");
        checked.buffers.push_back(std::move(source));
    });
    root.objects("images", [&](JsonObject& image) {
        ImageSource source;
        source.name = image.string("name").value_or("");
        source.uri = image.string("uri").value_or("");
        source.buffer_view = image.reference("bufferView", sizes.buffer_views);
        if (image.has("uri") == image.has("bufferView")) {
            image.refuse("uri", "and bufferView: an image has one of them, but this one has both or none");
        }
        checked.images.push_back(std::move(source));
    });
}

void note_what_is_not_read(JsonObject& root, Diagnostics& diagnostics) {
    if (const auto count = root.size_of("animations")) {
        diagnostics.note(fmt::format("{} animation(s) are ignored: the model is taken in its rest pose.", count));
    }
}

}  // namespace

CheckedJson check_json(const nlohmann::json& document, Diagnostics& diagnostics, bool all_maps) {
    CheckedJson checked;
    JsonObject root(document, checked.json, "", diagnostics);
    root.object("asset", check_asset, Need::required);
    check_extensions(root, diagnostics, all_maps);
    const Sizes sizes{root.size_of("accessors"), root.size_of("buffers"), root.size_of("bufferViews"),
                      root.size_of("cameras"),   root.size_of("images"),  root.size_of("materials"),
                      root.size_of("meshes"),    root.size_of("nodes"),   root.size_of("samplers"),
                      root.size_of("scenes"),    root.size_of("skins"),   root.size_of("textures")};
    std::vector<bool> has_view;
    root.objects("accessors", [&](JsonObject& accessor) { has_view.push_back(check_accessor(accessor, sizes)); });
    check_images_and_buffers(root, sizes, checked);
    root.objects("bufferViews", [&](JsonObject& view) { check_buffer_view(view, sizes); });
    root.objects("cameras", [&](JsonObject& camera) { checked.cameras.push_back(read_camera(camera)); });
    root.objects("materials", [&](JsonObject& material) { check_material(material, sizes, diagnostics, all_maps); });
    root.objects("meshes", [&](JsonObject& mesh) {
        mesh.string("name");
        if (!mesh.has("primitives")) mesh.refuse("primitives", "is missing");
        mesh.objects("primitives", [&](JsonObject& primitive) { check_primitive(primitive, sizes, has_view); });
        mesh.numbers("weights", 0);
        mesh.extra_number("alpha");
    });
    root.objects("nodes", [&](JsonObject& node) { check_node(node, sizes); });
    root.objects("samplers", [&](JsonObject& sampler) {
        sampler.integer("wrapS", 0, int_max);
        sampler.integer("wrapT", 0, int_max);
    });
    root.reference("scene", sizes.scenes);
    root.objects("scenes", [&](JsonObject& scene) { scene.references("nodes", sizes.nodes); });
    root.objects("skins", [&](JsonObject& skin) {
        skin.reference("inverseBindMatrices", sizes.accessors);
        if (skin.references("joints", sizes.nodes, Need::required).empty()) skin.refuse("joints", "is empty");
    });
    root.objects("textures", [&](JsonObject& texture) {
        texture.reference("sampler", sizes.samplers);
        texture.reference("source", sizes.images);
    });
    note_what_is_not_read(root, diagnostics);
    checked.json.erase("buffers");
    checked.json.erase("images");
    checked.json.erase("cameras");
    return checked;
}

}  // namespace tessera::scene
