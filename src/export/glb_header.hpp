// The JSON of a .glb and where its binary data lie.
#pragma once

#include "scene/scene.hpp"
#include "tessellate/refined_mesh.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace tessera::exporting {

/// An image's place in the binary chunk.
struct GlbImage {
    std::uint32_t image = 0;  ///< index into Scene::images
    std::uint64_t offset = 0;
};

/// Lays out the binary chunk (all vertices, all tangents and all colours where there are any, all indices, then the
/// images, each at a multiple of 4 bytes) and describes it: asset, scene, one node, one mesh with a primitive per part
/// that has triangles, and the materials and images those use. Indices count from a part's own first vertex, so that a
/// reader need not take in the whole vertex buffer for every part.
class GlbHeader {
public:
    /// `file` is used in messages, `name` for mesh and node. Throws Error(output) for an image that is neither PNG nor
    /// JPEG.
    GlbHeader(const std::string& file, const std::string& name, const MeshTotals& totals, const scene::Scene& scene);

    std::uint64_t tangents_at() const { return tangents_at_; }
    std::uint64_t colors_at() const { return colors_at_; }
    std::uint64_t indices_at() const { return indices_at_; }
    std::uint64_t binary_bytes() const { return binary_bytes_; }
    const std::vector<GlbImage>& images() const { return images_; }

    /// Sets the box around the positions of a part, which glTF demands. Until then it has the longest numbers there
    /// are, so that text() only ever becomes shorter.
    void set_bounds(std::size_t part, const std::array<float, 3>& min, const std::array<float, 3>& max);

    std::string text() const;

private:
    using Json = nlohmann::ordered_json;

    void place_images(const std::string& file, const std::set<std::uint32_t>& materials, const scene::Scene& scene);
    void add_buffer_views(const MeshTotals& totals, const scene::Scene& scene);
    Json material(const scene::Material& material) const;
    Json primitive(const MeshPart& part, std::size_t material);
    std::size_t append(const char* array, const Json& entry);

    std::uint64_t tangents_at_ = 0;
    std::uint64_t colors_at_ = 0;
    std::uint64_t indices_at_ = 0;
    std::uint64_t binary_bytes_ = 0;
    std::vector<GlbImage> images_;
    std::vector<std::size_t> position_accessors_;  // per part
    bool has_quads_ = false;
    bool has_tangents_ = false;
    bool has_colors_ = false;
    Json json_;
};

}  // namespace tessera::exporting
