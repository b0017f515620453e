#include "scene/obj_read.hpp"

#include "scene/finite.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>

namespace tessera::scene {
namespace {

/// What tinyobjloader calls back. Its callback interface is used because the other one counts the corners of a face in
/// eight bits.
class Reader {
public:
    explicit Reader(const ObjText& text) : text_(text) {
        out_.positions.reserve(text.positions);
        out_.uvs.reserve(text.uvs);
        out_.normals.reserve(text.normals);
        out_.corners.reserve(text.corners);
        out_.faces.reserve(text.faces.size());
    }

    Polygons read(Diagnostics& diagnostics) {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float x, float y, float z, float) { of(self).position({x, y, z}); };
        callbacks.normal_cb = [](void* self, float x, float y, float z) { of(self).normal({x, y, z}); };
        callbacks.texcoord_cb = [](void* self, float u, float v, float) { of(self).uv(u, v); };
        callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            of(self).face({corners, static_cast<std::size_t>(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char* name, int) { of(self).select(of(self).material_, name); };
        callbacks.object_cb = [](void* self, const char* name) {
            of(self).group_.clear();
            of(self).select(of(self).object_, name);
        };
        callbacks.group_cb = [](void* self, const char** names, int count) {
            std::string joined;
            for (int i = 0; i < count; ++i)
                joined.append(i > 0 ? " " : "").append(names[i]);
            of(self).select(of(self).group_, joined);
        };
        std::istringstream in(text_.statements);
        std::string warnings, errors;
        if (!tinyobj::LoadObjWithCallback(in, callbacks, this, nullptr, &warnings, &errors) || !is_sound()) {
            diagnostics.refuse("the file", fmt::format("cannot be read by tinyobjloader: {}", in_quotes(errors)));
        }
        for (const std::uint32_t n : text_.unusable_normals)
            out_.normals[n] = glm::vec3(0.0f);
        drop_unusable_normals(diagnostics);
        out_.tags = text_.tags;
        out_.tags.holes.clear();
        return std::move(out_);
    }

private:
    static Reader& of(void* self) { return *static_cast<Reader*>(self); }

    void position(const glm::vec3& p) { out_.positions.push_back(p + 0.0f); }

    void normal(const glm::vec3& n) {
        const double length = finite(n) ? std::hypot(double{n.x}, double{n.y}, double{n.z}) : 0.0;
        out_.normals.push_back(length > 0.0 ? glm::vec3(glm::dvec3(n) / length) + 0.0f : glm::vec3(0.0f));
    }

    void uv(float u, float v) {
        const glm::vec2 down(u, static_cast<float>(1.0 - double{v}));
        out_.uvs.push_back(std::isfinite(down.x) && std::isfinite(down.y) ? down : glm::vec2(0.0f));
    }

    void select(std::string& what, std::string name) {
        what = std::move(name);
        part_.reset();
    }

    /// From 1, or backwards from the last with -1; 0 is none.
    static std::uint32_t resolve(int index, std::size_t count) {
        if (index > 0) return static_cast<std::uint32_t>(index) - 1;
        return index < 0 ? static_cast<std::uint32_t>(count - static_cast<std::size_t>(-index)) : no_index;
    }

    /// The text was checked, but two readers may take one text differently: so look again at what the other one made.
    bool is_sound() const {
        const auto in_range = [](std::uint32_t index, std::size_t size) { return index == no_index || index < size; };
        return out_.positions.size() == text_.positions && out_.uvs.size() == text_.uvs &&
               out_.normals.size() == text_.normals && out_.faces.size() == text_.faces.size() &&
               out_.corners.size() == text_.corners &&
               std::all_of(out_.corners.begin(), out_.corners.end(), [&](const Corner& c) {
                   return c.position < out_.positions.size() && in_range(c.uv, out_.uvs.size()) &&
                          in_range(c.normal, out_.normals.size());
               });
    }

    void face(std::span<const tinyobj::index_t> corners) {
        if (out_.faces.size() == text_.faces.size()) return;
        const ObjFaceLine& line = text_.faces[out_.faces.size()];
        out_.faces.push_back(
            {out_.corners.size(), static_cast<std::uint32_t>(corners.size()), part(), line.smoothing, line.number});
        for (const tinyobj::index_t& c : corners) {
            out_.corners.push_back({resolve(c.vertex_index, out_.positions.size()),
                                    resolve(c.texcoord_index, out_.uvs.size()),
                                    resolve(c.normal_index, out_.normals.size())});
        }
    }

    std::uint32_t part() {
        if (part_) return *part_;
        const auto [entry, is_new] = parts_.try_emplace({object_, group_, material_}, out_.parts.size());
        if (is_new) {
            const char* separator = object_.empty() || group_.empty() ? "" : "/";
            out_.parts.push_back({object_ + separator + group_, material_, {}});
        }
        part_ = static_cast<std::uint32_t>(entry->second);
        return *part_;
    }

    void drop_unusable_normals(Diagnostics& diagnostics) {
        std::size_t dropped = 0;
        for (Corner& corner : out_.corners) {
            if (corner.normal == no_index || out_.normals[corner.normal] != glm::vec3(0.0f)) continue;
            corner.normal = no_index;
            ++dropped;
        }
        if (dropped > 0) {
            diagnostics.note(
                fmt::format("{} corners have a normal that is zero or not finite; it is computed from "
                            "the faces.",
                            dropped));
        }
    }

    const ObjText& text_;
    Polygons out_;
    std::string object_, group_, material_;
    std::optional<std::uint32_t> part_;
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> parts_;
};

}  // namespace

Polygons read_obj(const ObjText& text, Diagnostics& diagnostics) {
    return Reader(text).read(diagnostics);
}

}  // namespace tessera::scene
