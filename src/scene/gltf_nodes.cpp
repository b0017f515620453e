#include "scene/gltf_nodes.hpp"

#include <fmt/format.h>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace tessera::scene {
namespace {

/// tinygltf leaves out what the file leaves out.
glm::dvec3 vector_or(const std::vector<double>& values, double otherwise) {
    return values.empty() ? glm::dvec3(otherwise) : glm::dvec3(values[0], values[1], values[2]);
}

glm::dmat4 local_matrix(const Document& document, std::size_t index) {
    const tinygltf::Node& node = document.model.nodes[index];
    if (!node.matrix.empty()) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0) {
            document.diagnostics.note(
                fmt::format("nodes[{}].matrix is not affine; its last row is taken as 0, 0, 0, 1.", index));
            for (int column = 0; column < 4; ++column)
                matrix[column][3] = column == 3 ? 1.0 : 0.0;
        }
        return matrix;
    }
    glm::dmat3 turn(1.0);
    if (!node.rotation.empty()) {
        const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = std::hypot(std::hypot(q.x, q.y), std::hypot(q.z, q.w));
        if (!(length > 0.0) || !std::isfinite(length)) {
            document.diagnostics.refuse(fmt::format("nodes[{}].rotation", index),
                                        "has no usable length, but must be a unit quaternion");
        }
        turn = glm::mat3_cast(glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length));
    }
    const glm::dvec3 scale = vector_or(node.scale, 1.0);
    return glm::dmat4(glm::dvec4(turn[0] * scale.x, 0.0), glm::dvec4(turn[1] * scale.y, 0.0),
                      glm::dvec4(turn[2] * scale.z, 0.0), glm::dvec4(vector_or(node.translation, 0.0), 1.0));
}

std::vector<int> find_parents(const Document& document) {
    const auto& nodes = document.model.nodes;
    std::vector<int> parent(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            int& of_child = parent[static_cast<std::size_t>(child)];
            if (of_child >= 0) {
                document.diagnostics.refuse(fmt::format("nodes[{}]", child),
                                            fmt::format("is a child twice, of nodes[{}] and of nodes[{}]; a node has "
                                                        "one parent at most",
                                                        of_child, i));
            }
            of_child = static_cast<int>(i);
        }
    }
    return parent;
}

/// Visits the nodes below `roots` depth first, without recursion: a file may nest as deep as it has nodes.
template <typename Visit>
void depth_first(const std::vector<tinygltf::Node>& nodes, const std::vector<int>& roots, Visit visit) {
    std::vector<int> stack(roots.rbegin(), roots.rend());
    while (!stack.empty()) {
        const int node = stack.back();
        stack.pop_back();
        if (!visit(node)) continue;
        const auto& children = nodes[static_cast<std::size_t>(node)].children;
        stack.insert(stack.end(), children.rbegin(), children.rend());
    }
}

std::vector<int> scene_roots(const Document& document, const std::vector<int>& parent, const std::vector<int>& roots) {
    const auto& model = document.model;
    if (model.scenes.empty()) return roots;
    const auto scene = static_cast<std::size_t>(model.defaultScene < 0 ? 0 : model.defaultScene);
    std::vector<bool> listed(model.nodes.size());
    for (const int node : model.scenes[scene].nodes) {
        const int above = parent[static_cast<std::size_t>(node)];
        if (above >= 0) {
            document.diagnostics.note(
                fmt::format("scenes[{}] lists nodes[{}], which is a child of nodes[{}]: it is "
                            "drawn once, where its parent puts it.",
                            scene, node, above));
        } else if (listed[static_cast<std::size_t>(node)]) {
            document.diagnostics.note(fmt::format("scenes[{}] lists nodes[{}] twice: it is drawn once.", scene, node));
        }
        listed[static_cast<std::size_t>(node)] = true;
    }
    return model.scenes[scene].nodes;
}

}  // namespace

NodeGraph flatten_nodes(const Document& document) {
    const auto& nodes = document.model.nodes;
    const std::vector<int> parent = find_parents(document);
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (parent[i] < 0) roots.push_back(static_cast<int>(i));
    }

    NodeGraph graph;
    graph.world.resize(nodes.size());
    std::vector<bool> reached(nodes.size());
    depth_first(nodes, roots, [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        reached[i] = true;
        const glm::dmat4 local = local_matrix(document, i);
        graph.world[i] = parent[i] < 0 ? local : graph.world[static_cast<std::size_t>(parent[i])] * local;
        return true;
    });
    // With one parent each, a node that no root reaches can only be on a cycle or below one.
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!reached[i]) {
            document.diagnostics.refuse(fmt::format("nodes[{}]", i), "is on a cycle of children or below one");
        }
    }

    std::vector<bool> visited(nodes.size());
    depth_first(nodes, scene_roots(document, parent, roots), [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        if (visited[i]) return false;
        visited[i] = true;
        if (nodes[i].mesh >= 0) graph.drawn.push_back(node);
        if (nodes[i].camera >= 0) graph.cameras.push_back(node);
        return true;
    });
    graph.shown = std::move(visited);
    return graph;
}

}  // namespace tessera::scene
