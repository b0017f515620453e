// Small glTF files made in the test, and what tests ask of a loaded mesh.
#pragma once

#include "base/error.hpp"
#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace tessera::test {

/// A folder that goes away with the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "tessera-scene-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        const auto path = path_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string base64(const std::string& bytes);

/// Builds a document with one buffer. add_* return the index of the new element.
class GltfBuilder {
public:
    using json = nlohmann::json;

    GltfBuilder() { document = {{"asset", {{"version", "2.0"}}}}; }

    /// An accessor over its own view. `type` as in glTF, such as "VEC3".
    template <typename T>
    int add(const std::string& type, int component_type, const std::vector<T>& values, int stride = 0) {
        constexpr std::size_t sizes[] = {1, 2, 3, 4, 16};
        constexpr const char* names[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT4"};
        std::size_t components = 1;
        for (int i = 0; i < 5; ++i)
            components = type == names[i] ? sizes[i] : components;
        const int view = add_view(values, components, stride);
        return push("accessors", {{"bufferView", view},
                                  {"componentType", component_type},
                                  {"count", values.size() / components},
                                  {"type", type}});
    }
    int add_positions(const std::vector<float>& values) { return add("VEC3", 5126, values); }

    template <typename T>
    int add_view(const std::vector<T>& values, std::size_t components = 1, int stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4);
        const std::size_t offset = binary.size();
        const std::size_t element = components * sizeof(T);
        const std::size_t step = stride != 0 ? static_cast<std::size_t>(stride) : element;
        for (std::size_t i = 0; i < values.size() / components; ++i) {
            std::string bytes(reinterpret_cast<const char*>(values.data() + i * components), element);
            bytes.resize(step, '\x7f');
            binary += bytes;
        }
        json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", binary.size() - offset}};
        if (stride != 0) view["byteStride"] = stride;
        return push("bufferViews", std::move(view));
    }

    /// A mesh with one primitive, and a node that shows it, which it returns.
    int add_mesh_node(json primitive) {
        const int mesh = push("meshes", {{"primitives", json::array({std::move(primitive)})}});
        return push("nodes", {{"mesh", mesh}});
    }

    int push(const char* array, json element) {
        document[array].push_back(std::move(element));
        return static_cast<int>(document[array].size()) - 1;
    }

    std::string text() const;  ///< a .gltf with the buffer as a data URI
    std::string glb() const;   ///< the same as a .glb
    scene::Scene load(const std::string& name = "model.gltf") const;

    json document;
    std::string binary;
};

/// A GLB of these two parts.
std::string make_glb(std::string json, std::string binary);

/// The triangle (0,0,0) (1,0,0) (0,1,0), which faces +z.
inline const std::vector<float> triangle_positions{0, 0, 0, 1, 0, 0, 0, 1, 0};

/// What load_scene says when it refuses a file; fails if it does not.
std::string refusal(const std::string& name);
std::string refusal(const GltfBuilder& builder);

/// True if a message holds the text.
bool has_message(const scene::Scene& scene, const std::string& text);

/// Expects all that scene.hpp promises of a scene.
void expect_sound(const scene::Scene& scene);

/// Expects that every edge between positions is used once in each direction.
void expect_closed(const scene::Mesh& mesh);
void expect_closed(std::span<const scene::Mesh> meshes);

/// Signed volume inside the triangles; positive where they face outward.
double volume(const scene::Mesh& mesh);

}  // namespace tessera::test
