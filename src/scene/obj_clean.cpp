#include "scene/obj_read.hpp"
#include "scene/topology.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace tessera::scene {
namespace {

/// Removes corners that repeat the one before, and pairs of corners that run out and back (a, b, a: b and one a).
void remove_repeats(std::vector<Corner>& corners) {
    const auto same = [&](std::size_t i, std::size_t k) {
        return corners[i % corners.size()].position == corners[k % corners.size()].position;
    };
    const auto erase = [&](std::size_t i) { corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i)); };
    for (std::size_t i = 0, unchanged = 0; corners.size() > 1 && unchanged < corners.size();) {
        i %= corners.size();
        if (same(i, i + 1)) {
            erase((i + 1) % corners.size());
            unchanged = 0;
        } else if (corners.size() > 2 && same(i, i + 2)) {
            // Whatever stood before may meet its like now, so go back a step.
            const std::size_t first = (i + 1) % corners.size();
            const std::size_t second = (i + 2) % corners.size();
            erase(std::max(first, second));
            erase(std::min(first, second));
            unchanged = 0;
            i = i > 0 ? i - 1 : 0;
        } else {
            ++unchanged;
            ++i;
        }
    }
}

std::vector<bool> flags(std::size_t size, std::span<const std::uint32_t> set) {
    std::vector<bool> out(size);
    for (const std::uint32_t i : set)
        out[i] = true;
    return out;
}

}  // namespace

void clean_polygons(Polygons& polygons, const ObjText& text, Diagnostics& diagnostics) {
    std::vector<bool> unusable = flags(polygons.positions.size(), text.unusable_positions);
    std::size_t positions = text.unusable_positions.size();
    for (std::size_t i = 0; i < polygons.positions.size(); ++i) {
        const glm::vec3& p = polygons.positions[i];
        if (unusable[i] || (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) continue;
        unusable[i] = true;
        ++positions;
    }
    const std::vector<bool> hole = flags(text.face_statements, text.tags.holes);
    std::size_t broken = 0, holes = 0, shortened = 0, collapsed = 0;
    std::vector<Polygon> faces;
    std::vector<Corner> kept, around;
    faces.reserve(polygons.faces.size());
    kept.reserve(polygons.corners.size());
    for (Polygon face : polygons.faces) {
        const auto corners = polygons.corners_of(face);
        if (hole[face.number]) {
            ++holes;
            polygons.parts[face.part].holes.push_back(face.number);
            continue;
        }
        if (std::any_of(corners.begin(), corners.end(), [&](const Corner& c) { return unusable[c.position]; })) {
            ++broken;
            continue;
        }
        around.assign(corners.begin(), corners.end());
        remove_repeats(around);
        if (around.size() < 3) {
            ++collapsed;
            continue;
        }
        shortened += around.size() < corners.size() ? 1 : 0;
        face.first = kept.size();
        face.count = static_cast<std::uint32_t>(around.size());
        kept.insert(kept.end(), around.begin(), around.end());
        faces.push_back(face);
    }
    polygons.faces = std::move(faces);
    polygons.corners = std::move(kept);
    if (positions > 0) {
        diagnostics.note(
            fmt::format("{} positions are not finite numbers; they are left out with the {} faces that "
                        "use them.",
                        positions, broken));
    }
    if (holes > 0) diagnostics.note(fmt::format("{} faces are tagged as holes and are left out.", holes));
    if (shortened > 0) {
        diagnostics.note(
            fmt::format("{} faces repeat a corner or run back to one; those corners are left out.", shortened));
    }
    if (collapsed > 0) {
        diagnostics.note(fmt::format("{} faces have fewer than three different corners and are left out.", collapsed));
    }
}

void note_topology(const Polygons& polygons, Diagnostics& diagnostics) {
    std::unordered_map<std::uint64_t, std::uint32_t> uses;
    uses.reserve(polygons.corners.size());
    std::vector<bool> used(polygons.positions.size());
    for (const Polygon& face : polygons.faces) {
        const auto corners = polygons.corners_of(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            used[corners[i].position] = true;
            ++uses[edge_key(corners[i].position, corners[(i + 1) % corners.size()].position)];
        }
    }
    const auto crowded = std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second > 2; });
    const auto unused = std::count(used.begin(), used.end(), false);
    note_crowded_edges(static_cast<std::size_t>(crowded), diagnostics);
    if (unused > 0) diagnostics.note(fmt::format("{} positions are used by no face and are left out.", unused));
}

}  // namespace tessera::scene
