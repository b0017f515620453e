// One primitive as the file has it: in its mesh's own space, triangles only.
#pragma once

#include "scene/gltf_document.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace tessera::scene {

struct SourcePrimitive {
    std::string element;  ///< its path in the file, for messages
    const tinygltf::Primitive* primitive = nullptr;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;        ///< empty where the file has none
    bool quantized_normals = false;        ///< integers in the file: not of unit length by nature
    std::vector<glm::vec2> uvs;            ///< one per position, as the material's texture wants them
    std::vector<float> alphas;             ///< as Mesh::alphas
    std::vector<glm::vec3> stpn;           ///< as Mesh::stpn
    std::vector<glm::vec4> colors;         ///< as Mesh::colors
    std::vector<glm::vec4> tangents;       ///< as the file has them, one per position or none
    std::vector<std::uint32_t> triangles;  ///< all < positions.size(), no index twice in a triangle
    std::vector<std::uint32_t>
        guide_points;                       ///< of lines: the curves' points one after another, all < positions.size()
    std::vector<std::uint32_t> guide_ends;  ///< where each curve ends in `guide_points`
    std::size_t influences = 0;             ///< joints per vertex
    std::vector<std::uint32_t> joints;      ///< `influences` per position
    std::vector<float> weights;
};

/// Reads primitive `index` of mesh `mesh`. Lines and line strips come back as guides. Points, line loops and primitives
/// without positions come back without triangles, and a message says so. Throws Error(usage) for indices past the
/// vertices.
SourcePrimitive read_primitive(const Document& document, std::size_t mesh, std::size_t index);

/// The triangles of a list, strip or fan (`mode` 4, 5, 6; glTF 2.0, section 3.7.2.1), all turning the same way.
std::vector<std::uint32_t> to_triangle_list(int mode, std::span<const std::uint32_t> indices);

/// Numbers as vectors; `numbers` holds three per vector.
std::vector<glm::vec3> as_vec3(std::span<const float> numbers);

}  // namespace tessera::scene
