#include "scene/gltf_builder.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace tessera::test {
namespace {

std::string u32(std::size_t value) {
    std::string out;
    for (int i = 0; i < 4; ++i)
        out += static_cast<char>((value >> (8 * i)) & 0xff);
    return out;
}

using PositionBits = std::array<std::uint32_t, 3>;

PositionBits bits(const glm::vec3& p) {
    PositionBits out;
    std::memcpy(out.data(), &p, sizeof out);
    return out;
}

}  // namespace

std::string base64(const std::string& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k > bytes.size() ? '=' : digits[(three >> (18 - 6 * k)) & 63];
        }
    }
    return out;
}

std::string make_glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::string chunks = u32(json.size()) + "JSON" + json +
                               (binary.empty() ? "" : u32(binary.size()) + std::string("BIN\0", 4) + binary);
    return "glTF" + u32(2) + u32(12 + chunks.size()) + chunks;
}

std::string GltfBuilder::text() const {
    json whole = document;
    if (!binary.empty() && !whole.contains("buffers")) {
        whole["buffers"] = json::array(
            {{{"byteLength", binary.size()}, {"uri", "data:application/octet-stream;base64," + base64(binary)}}});
    }
    return whole.dump();
}

std::string GltfBuilder::glb() const {
    json whole = document;
    if (!binary.empty() && !whole.contains("buffers")) {
        whole["buffers"] = json::array({{{"byteLength", binary.size()}}});
    }
    return make_glb(whole.dump(), binary);
}

scene::Scene GltfBuilder::load(const std::string& name) const {
    const TemporaryFolder folder;
    return scene::load_scene(folder.write(name, name.find(".glb") != std::string::npos ? glb() : text()).string());
}

std::string refusal(const std::string& name) {
    try {
        scene::load_scene(name);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    ADD_FAILURE() << name << " was loaded, but must be refused";
    return "";
}

std::string refusal(const GltfBuilder& builder) {
    const TemporaryFolder folder;
    return refusal(folder.write("model.gltf", builder.text()).string());
}

bool has_message(const scene::Scene& scene, const std::string& text) {
    for (const std::string& message : scene.messages) {
        if (message.find(text) != std::string::npos) return true;
    }
    return false;
}

void expect_sound(const scene::Scene& scene) {
    ASSERT_FALSE(scene.materials.empty());
    for (const auto& mesh : scene.meshes) {
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
        ASSERT_EQ(mesh.triangles.size() % 3, 0u);
        ASSERT_EQ(mesh.quads.size() % 4, 0u);
        ASSERT_FALSE(mesh.triangles.empty() && mesh.quads.empty());
        ASSERT_LT(mesh.material, scene.materials.size());
        bool sound = true;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            for (int c = 0; c < 3; ++c) {
                sound = sound && std::isfinite(mesh.positions[v][c]) && std::isfinite(mesh.normals[v][c]);
                sound = sound && !(mesh.positions[v][c] == 0.0f && std::signbit(mesh.positions[v][c]));
            }
            sound = sound && std::isfinite(mesh.uvs[v].x) && std::isfinite(mesh.uvs[v].y);
            sound = sound && std::abs(glm::length(mesh.normals[v]) - 1.0f) < 1e-5f;
        }
        ASSERT_TRUE(sound) << mesh.name << " has a number that is not finite, or a normal that is not unit";
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const auto* t = &mesh.triangles[i];
            sound = sound && t[0] < mesh.positions.size() && t[1] < mesh.positions.size() &&
                    t[2] < mesh.positions.size() && t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        }
        ASSERT_TRUE(sound) << mesh.name << " has an index out of range or twice in a triangle";
        for (std::size_t i = 0; i < mesh.quads.size(); i += 4) {
            const std::set<std::uint32_t> corners(&mesh.quads[i], &mesh.quads[i] + 4);
            sound = sound && corners.size() == 4 && *corners.rbegin() < mesh.positions.size();
        }
        ASSERT_TRUE(sound) << mesh.name << " has an index out of range or twice in a quad";
        for (const auto& crease : mesh.tags.creases) {
            sound = sound && crease.a < mesh.positions.size() && crease.b < mesh.positions.size();
            sound = sound && crease.a != crease.b && crease.sharpness >= 0.0f && std::isfinite(crease.sharpness);
        }
        for (const auto& corner : mesh.tags.corners)
            sound = sound && corner.vertex < mesh.positions.size() && std::isfinite(corner.sharpness);
        ASSERT_TRUE(sound) << mesh.name << " has an unsound tag";
    }
    for (const auto& guides : scene.guides) {
        ASSERT_LT(guides.material, scene.materials.size());
        ASSERT_EQ(guides.normals.size(), guides.points.size());
        ASSERT_EQ(guides.widths.size(), guides.points.size());
        ASSERT_FALSE(guides.ends.empty());
        ASSERT_EQ(guides.ends.back(), guides.points.size());
        bool sound = true;
        std::uint32_t begin = 0;
        for (const std::uint32_t end : guides.ends) {
            sound = sound && end >= begin + 2;
            for (std::uint32_t i = begin; i < end && sound; ++i) {
                const glm::vec3& p = guides.points[i];
                sound = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
                sound = sound && (i == begin || p != guides.points[i - 1]);
                const float width = guides.widths[i];
                sound = sound && std::isfinite(width) && (width >= 0.0f || width == scene::no_width);
                const float length = glm::length(guides.normals[i]);
                sound = sound && (length == 0.0f || std::abs(length - 1.0f) < 1e-5f);
            }
            begin = end;
        }
        ASSERT_TRUE(sound) << guides.name << " has an unsound curve";
    }
    for (const auto& camera : scene.cameras) {
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_TRUE(std::isfinite(camera.eye[axis])) << camera.name;
            ASSERT_NEAR(glm::length(camera.axes[axis]), 1.0, 1e-9) << camera.name;
            ASSERT_NEAR(glm::dot(camera.axes[axis], camera.axes[(axis + 1) % 3]), 0.0, 1e-9) << camera.name;
        }
        ASSERT_TRUE(camera.half_height > 0.0 && std::isfinite(camera.half_height)) << camera.name;
        ASSERT_TRUE(camera.half_width >= 0.0 && std::isfinite(camera.half_width)) << camera.name;
        ASSERT_TRUE(camera.near_plane >= 0.0 && camera.near_plane < camera.far_plane) << camera.name;
    }
    for (const auto& material : scene.materials) {
        ASSERT_LT(material.base_color_image.value_or(0), std::max<std::size_t>(scene.images.size(), 1));
    }
    for (const auto& image : scene.images) {
        ASSERT_EQ(image.pixels.rgba.size(), 4ull * image.pixels.width * image.pixels.height);
        ASSERT_FALSE(image.encoded.empty());
        ASSERT_TRUE(image.mime_type == "image/png" || image.mime_type == "image/jpeg");
    }
}

void expect_closed(const scene::Mesh& mesh) {
    expect_closed(std::span(&mesh, 1));
}

void expect_closed(std::span<const scene::Mesh> meshes) {
    std::map<std::pair<PositionBits, PositionBits>, int> edges;
    for (const scene::Mesh& mesh : meshes) {
        const auto add_faces = [&](const std::vector<std::uint32_t>& faces, std::size_t corners) {
            for (std::size_t i = 0; i < faces.size(); ++i) {
                const std::size_t next = i % corners + 1 == corners ? i + 1 - corners : i + 1;
                ++edges[{bits(mesh.positions[faces[i]]), bits(mesh.positions[faces[next]])}];
            }
        };
        add_faces(mesh.triangles, 3);
        add_faces(mesh.quads, 4);
    }
    for (const auto& [edge, uses] : edges) {
        ASSERT_EQ(uses, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "the surface is open";
    }
}

double volume(const scene::Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.triangles[i]], b = mesh.positions[mesh.triangles[i + 1]],
                         c = mesh.positions[mesh.triangles[i + 2]];
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

}  // namespace tessera::test
