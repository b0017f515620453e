#include "export/mesh_readers.hpp"

#include <fmt/format.h>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tessera::test {
namespace {

void require(bool condition, const std::string& what) {
    if (!condition) throw std::runtime_error("the file read back is unsound: " + what);
}

template <typename T>
T take(const std::string& bytes, std::size_t at) {
    T value;
    require(at <= bytes.size() && sizeof(T) <= bytes.size() - at, fmt::format("it ends before byte {}", at));
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

/// Copies `components` floats per element of a vertex accessor to `offset` bytes within each vertex.
void read_attribute(const GlbFile& glb, const nlohmann::json& number, const char* type, int components,
                    std::size_t offset, std::span<Vertex> to) {
    const nlohmann::json& accessor = glb.json["accessors"][number.get<std::size_t>()];
    const nlohmann::json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    require(accessor["type"] == type && accessor["componentType"] == 5126 && accessor["count"] == to.size(), type);
    const std::size_t stride = view["byteStride"];
    const std::size_t start = accessor.value("byteOffset", 0u);
    const std::size_t length = view["byteLength"];
    for (std::size_t i = 0; i < to.size(); ++i) {
        for (int c = 0; c < components; ++c) {
            const std::size_t within = start + i * stride + 4 * static_cast<std::size_t>(c);
            require(within + 4 <= length, "accessor beyond its view");
            const auto value = take<float>(glb.binary, view.value("byteOffset", 0u) + within);
            std::memcpy(reinterpret_cast<char*>(&to[i]) + offset + 4 * c, &value, 4);
        }
    }
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    require(file.good(), "cannot open " + path.string());
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

GlbFile read_glb_file(const std::filesystem::path& path) {
    const std::string bytes = read_bytes(path);
    require(bytes.starts_with("glTF") && take<std::uint32_t>(bytes, 4) == 2, "GLB header");
    require(take<std::uint32_t>(bytes, 8) == bytes.size(), "GLB length");
    const std::size_t json_bytes = take<std::uint32_t>(bytes, 12);
    require(json_bytes % 4 == 0 && bytes.substr(16, 4) == "JSON", "JSON chunk");
    GlbFile glb{nlohmann::json::parse(bytes.substr(20, json_bytes)), {}};
    const std::size_t binary_at = 20 + json_bytes;
    if (binary_at == bytes.size()) return glb;
    const std::size_t binary_bytes = take<std::uint32_t>(bytes, binary_at);
    require(binary_bytes % 4 == 0 && bytes.substr(binary_at + 4, 4) == std::string("BIN\0", 4), "BIN chunk");
    glb.binary = bytes.substr(binary_at + 8);
    require(glb.binary.size() == binary_bytes && glb.json["buffers"][0]["byteLength"] == binary_bytes, "BIN length");
    return glb;
}

ReadMesh read_glb(const std::filesystem::path& path) {
    const GlbFile glb = read_glb_file(path);
    ReadMesh mesh;
    for (const nlohmann::json& primitive : glb.json["meshes"][0]["primitives"]) {
        const nlohmann::json& attributes = primitive["attributes"];
        const std::size_t count = glb.json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
        const std::size_t first = mesh.vertices.size();
        mesh.vertices.resize(first + count);
        const auto to = std::span(mesh.vertices).subspan(first);
        read_attribute(glb, attributes["POSITION"], "VEC3", 3, offsetof(Vertex, position), to);
        read_attribute(glb, attributes["NORMAL"], "VEC3", 3, offsetof(Vertex, normal), to);
        read_attribute(glb, attributes["TEXCOORD_0"], "VEC2", 2, offsetof(Vertex, uv), to);
        for (const auto& [name, vectors] : {std::pair{"TANGENT", &mesh.tangents}, {"COLOR_0", &mesh.colors}}) {
            if (!attributes.contains(name)) continue;
            const nlohmann::json& accessor = glb.json["accessors"][attributes[name].get<std::size_t>()];
            const nlohmann::json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            require(accessor["type"] == "VEC4" && accessor["componentType"] == 5126 && accessor["count"] == count &&
                        view["byteStride"] == 16 && view["target"] == 34962,
                    name);
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t within = accessor.value("byteOffset", 0u) + 16 * i;
                require(within + 16 <= view["byteLength"], std::string(name) + " beyond its view");
                vectors->push_back(take<std::array<float, 4>>(glb.binary, view.value("byteOffset", 0u) + within));
            }
        }
        ReadPart part;
        part.material = glb.json["materials"][primitive["material"].get<std::size_t>()]["name"];
        const nlohmann::json& accessor = glb.json["accessors"][primitive["indices"].get<std::size_t>()];
        const nlohmann::json& view = glb.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        require(accessor["componentType"] == 5125, "index type");
        for (std::size_t i = 0; i < accessor["count"]; ++i) {
            const std::size_t within = accessor.value("byteOffset", 0u) + 4 * i;
            require(within + 4 <= view["byteLength"], "indices beyond their view");
            const auto index = take<std::uint32_t>(glb.binary, view.value("byteOffset", 0u) + within);
            require(index < count, "index out of range");
            part.indices.push_back(static_cast<std::uint32_t>(first) + index);
        }
        mesh.parts.push_back(part);
    }
    return mesh;
}

ReadMesh read_obj(const std::filesystem::path& path) {
    std::istringstream file(read_bytes(path));
    ReadMesh mesh;
    std::size_t normals = 0;
    std::size_t uvs = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        std::string word[3];
        words >> kind >> word[0] >> word[1] >> word[2];
        const auto at = [&](std::size_t i) -> Vertex& {
            if (mesh.vertices.size() <= i) mesh.vertices.resize(i + 1);
            return mesh.vertices[i];
        };
        if (kind == "v") {
            Vertex& vertex = at(mesh.vertices.size());
            for (int i = 0; i < 3; ++i)
                vertex.position[i] = std::strtof(word[i].c_str(), nullptr);
        } else if (kind == "vn") {
            Vertex& vertex = at(normals++);
            for (int i = 0; i < 3; ++i)
                vertex.normal[i] = std::strtof(word[i].c_str(), nullptr);
        } else if (kind == "vt") {
            Vertex& vertex = at(uvs++);
            vertex.uv[0] = std::strtof(word[0].c_str(), nullptr);
            vertex.uv[1] = static_cast<float>(1.0 - std::strtod(word[1].c_str(), nullptr));
        } else if (kind == "o") {
            mesh.parts.push_back({word[0], "", {}});
        } else if (kind == "usemtl") {
            mesh.parts.back().material = word[0];
        } else if (kind == "f") {
            for (const std::string& corner : word) {
                const std::size_t slash = corner.find('/');
                const std::string number = corner.substr(0, slash);
                require(corner == number + "/" + number + "/" + number, line);
                mesh.parts.back().indices.push_back(static_cast<std::uint32_t>(std::stoul(number) - 1));
                require(mesh.parts.back().indices.back() < mesh.vertices.size(), "face before its vertices: " + line);
            }
        } else {
            require(kind == "#" || kind == "mtllib", line);
        }
    }
    require(normals == mesh.vertices.size() && uvs == mesh.vertices.size(), "unequal counts of v, vn and vt");
    return mesh;
}

ReadMesh read_ply(const std::filesystem::path& path) {
    const std::string bytes = read_bytes(path);
    const std::string end = "end_header\n";
    const std::size_t data = bytes.find(end) + end.size();
    std::istringstream header(bytes.substr(0, data));
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::string properties;
    std::string line;
    std::getline(header, line);
    require(line == "ply", line);
    std::getline(header, line);
    require(line == "format binary_little_endian 1.0", line);
    while (std::getline(header, line)) {
        if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
        if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
        if (line.starts_with("property ")) properties += line.substr(9) + ";";
    }
    const std::string frame = "float tx;float ty;float tz;float tw;float bx;float by;float bz;";
    const std::string colour = "float red;float green;float blue;float alpha;";
    const bool has_tangents = properties.find(frame) != std::string::npos;
    const bool has_colors = properties.find(colour) != std::string::npos;
    require(properties == "float x;float y;float z;float nx;float ny;float nz;float s;float t;" +
                              (has_tangents ? frame : "") + (has_colors ? colour : "") +
                              "list uchar uint vertex_indices;",
            properties);
    const std::size_t colors_at = has_tangents ? 60 : 32;
    const std::size_t stride = colors_at + (has_colors ? 16 : 0);
    require(bytes.size() == data + stride * vertices + 13 * faces, "PLY size");
    ReadMesh mesh;
    for (std::size_t i = 0; i < vertices; ++i)
        mesh.vertices.push_back(take<Vertex>(bytes, data + stride * i));
    for (std::size_t i = 0; i < vertices && has_tangents; ++i) {
        mesh.tangents.push_back(take<std::array<float, 4>>(bytes, data + stride * i + 32));
        mesh.bitangents.push_back(take<std::array<float, 3>>(bytes, data + stride * i + 48));
    }
    for (std::size_t i = 0; i < vertices && has_colors; ++i)
        mesh.colors.push_back(take<std::array<float, 4>>(bytes, data + stride * i + colors_at));
    mesh.parts.resize(1);
    for (std::size_t i = 0; i < faces; ++i) {
        const std::size_t at = data + stride * vertices + 13 * i;
        require(bytes[at] == 3, "a face is not a triangle");
        for (std::size_t c = 0; c < 3; ++c)
            mesh.parts[0].indices.push_back(take<std::uint32_t>(bytes, at + 1 + 4 * c));
    }
    return mesh;
}

ReadMesh read_mesh(const std::filesystem::path& path) {
    if (path.extension() == ".glb") return read_glb(path);
    if (path.extension() == ".obj") return read_obj(path);
    return read_ply(path);
}

}  // namespace tessera::test
