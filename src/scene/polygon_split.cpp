#include "scene/polygons.hpp"

#include <cmath>
#include <unordered_map>

namespace tessera::scene {
namespace {

glm::vec3 middle_normal(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 1e-6 ? glm::vec3(v / length) + 0.0f : glm::vec3(0.0f);
}

/// Middles of pairs of pool elements, made once for each pair.
class Middles {
public:
    /// The element between a and b; `make` appends it to its pool and returns its place.
    template <typename Make>
    std::uint32_t find(std::uint32_t a, std::uint32_t b, Make make) {
        if (a == no_index || b == no_index) return no_index;
        if (a == b) return a;
        const auto [entry, is_new] = places_.try_emplace(edge_key(a, b), 0u);
        if (is_new) entry->second = make();
        return entry->second;
    }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> places_;
};

class Splitter {
public:
    explicit Splitter(Polygons& polygons) : p_(polygons) {}

    void run() {
        std::vector<Polygon> faces;
        std::vector<Corner> corners;
        faces.reserve(p_.corners.size());
        corners.reserve(4 * p_.corners.size());
        std::vector<Corner> middles;
        for (const Polygon& face : p_.faces) {
            const std::span<const Corner> around = p_.corners_of(face);
            middles.clear();
            for (std::size_t i = 0; i < around.size(); ++i)
                middles.push_back(middle(around[i], around[(i + 1) % around.size()]));
            const Corner centre = mean(around);
            for (std::size_t i = 0; i < around.size(); ++i) {
                Polygon quad = face;
                quad.first = corners.size();
                quad.count = 4;
                faces.push_back(quad);
                corners.insert(corners.end(),
                               {around[i], middles[i], centre, middles[(i + around.size() - 1) % around.size()]});
            }
        }
        split_creases();
        p_.faces = std::move(faces);
        p_.corners = std::move(corners);
    }

private:
    template <typename T>
    static std::uint32_t append(std::vector<T>& pool, const T& value) {
        pool.push_back(value);
        return static_cast<std::uint32_t>(pool.size() - 1);
    }

    std::uint32_t middle_position(std::uint32_t a, std::uint32_t b) {
        return positions_.find(a, b, [&] {
            return append(p_.positions,
                          glm::vec3((glm::dvec3(p_.positions[a]) + glm::dvec3(p_.positions[b])) * 0.5) + 0.0f);
        });
    }

    Corner middle(const Corner& a, const Corner& b) {
        Corner out;
        out.position = middle_position(a.position, b.position);
        out.uv = uvs_.find(a.uv, b.uv, [&] {
            return append(p_.uvs, glm::vec2((glm::dvec2(p_.uvs[a.uv]) + glm::dvec2(p_.uvs[b.uv])) * 0.5));
        });
        out.normal = normals_.find(a.normal, b.normal, [&] {
            return append(p_.normals,
                          middle_normal(glm::dvec3(p_.normals[a.normal]) + glm::dvec3(p_.normals[b.normal])));
        });
        drop_zero_normal(out);
        return out;
    }

    Corner mean(std::span<const Corner> around) {
        glm::dvec3 position(0.0), normal(0.0);
        glm::dvec2 uv(0.0);
        Corner out;
        bool has_uv = true, has_normal = true;
        for (const Corner& corner : around) {
            position += glm::dvec3(p_.positions[corner.position]);
            has_uv = has_uv && corner.uv != no_index;
            has_normal = has_normal && corner.normal != no_index;
            if (has_uv) uv += glm::dvec2(p_.uvs[corner.uv]);
            if (has_normal) normal += glm::dvec3(p_.normals[corner.normal]);
        }
        const auto n = static_cast<double>(around.size());
        out.position = append(p_.positions, glm::vec3(position / n) + 0.0f);
        if (has_uv) out.uv = append(p_.uvs, glm::vec2(uv / n));
        if (has_normal) out.normal = append(p_.normals, middle_normal(normal));
        drop_zero_normal(out);
        return out;
    }

    /// Opposite normals have no middle: it is computed from the faces then.
    void drop_zero_normal(Corner& corner) const {
        if (corner.normal != no_index && p_.normals[corner.normal] == glm::vec3(0.0f)) corner.normal = no_index;
    }

    void split_creases() {
        std::vector<Crease> halves;
        for (const Crease& crease : p_.tags.creases) {
            const std::uint32_t middle = middle_position(crease.a, crease.b);
            halves.push_back({crease.a, middle, crease.sharpness});
            halves.push_back({middle, crease.b, crease.sharpness});
        }
        p_.tags.creases = std::move(halves);
    }

    Polygons& p_;
    Middles positions_, uvs_, normals_;
};

}  // namespace

void split_polygons(Polygons& polygons) {
    Splitter(polygons).run();
}

}  // namespace tessera::scene
