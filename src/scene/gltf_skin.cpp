#include "scene/gltf_skin.hpp"

#include "scene/gltf_accessor.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::scene {
namespace {

bool usable(float weight) {
    return weight > 0.0f && std::isfinite(weight);
}

}  // namespace

std::vector<glm::dmat4> joint_matrices(const Document& document, const NodeGraph& graph, std::size_t skin) {
    const auto& from = document.model.skins[skin];
    std::vector<float> inverse_bind;
    if (from.inverseBindMatrices >= 0) inverse_bind = read_floats(document, from.inverseBindMatrices);
    std::vector<glm::dmat4> matrices;
    matrices.reserve(from.joints.size());
    for (std::size_t j = 0; j < from.joints.size(); ++j) {
        glm::dmat4 to_joint(1.0);
        if (!inverse_bind.empty()) {
            for (std::size_t i = 0; i < 16; ++i) {
                to_joint[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = inverse_bind[16 * j + i];
            }
        }
        matrices.push_back(graph.world[static_cast<std::size_t>(from.joints[j])] * to_joint);
    }
    return matrices;
}

void check_influences(const Document& document, const SourcePrimitive& source, std::size_t joint_count) {
    for (const std::uint32_t joint : source.joints) {
        if (joint >= joint_count) {
            document.diagnostics.refuse(source.element + ".attributes.JOINTS",
                                        fmt::format("names joint {}, but the skin has {}", joint, joint_count));
        }
    }
    std::size_t without_weight = 0;
    for (std::size_t v = 0; v < source.positions.size(); ++v) {
        const auto first = source.weights.begin() + static_cast<std::ptrdiff_t>(v * source.influences);
        const auto last = first + static_cast<std::ptrdiff_t>(source.influences);
        if (std::none_of(first, last, usable)) ++without_weight;
    }
    if (without_weight > 0) {
        document.diagnostics.note(fmt::format("{}: {} vertices have no skin weight and follow their first joint.",
                                              source.element, without_weight));
    }
}

glm::dmat4 blended_matrix(const SourcePrimitive& source, const std::vector<glm::dmat4>& joints, std::size_t vertex) {
    glm::dmat4 sum(0.0);
    double total = 0.0;
    const std::size_t first = vertex * source.influences;
    for (std::size_t i = first; i < first + source.influences; ++i) {
        if (!usable(source.weights[i])) continue;
        sum += joints[source.joints[i]] * static_cast<double>(source.weights[i]);
        total += source.weights[i];
    }
    return total > 0.0 ? sum / total : joints[source.joints[first]];
}

}  // namespace tessera::scene
