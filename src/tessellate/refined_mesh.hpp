// What tessellation gives: interleaved vertices and triangles.
#pragma once

#include "base/tangent.hpp"
#include "base/vertex.hpp"
#include "base/vertex_attributes.hpp"
#include "gpu/device.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera {

/// A run of output made from one mesh of the scene.
struct MeshPart {
    std::string name;
    std::uint32_t material = 0;
    std::uint64_t first_vertex = 0, vertex_count = 0;
    std::uint64_t first_index = 0, index_count = 0;
};

/// The size of a whole output, known before any of it is made. Parts lie one after another without gaps.
struct MeshTotals {
    std::uint64_t vertex_count = 0;
    std::uint64_t index_count = 0;
    std::vector<MeshPart> parts;
    bool has_quads = false;       ///< whether batches mark quads
    bool has_tangents = false;    ///< whether batches bring tangents
    bool has_attributes = false;  ///< whether batches bring attributes
    bool has_colors = false;      ///< whether the colours of these are not all white for want of others
};

/// A piece of the output. Batches come in order; vertices and indices continue those of the batch before. Indices are
/// global (they count vertices from the start of the output); every batch is closed: its triangles use its own
/// vertices only.
struct MeshBatch {
    std::uint64_t first_vertex = 0;
    std::uint64_t first_index = 0;
    std::span<const Vertex> vertices;
    std::span<const std::uint32_t> indices;
    /// Empty, or one element per triangle: 1 where this triangle (a, b, c) and the next, (a, c, d), are the halves of a
    /// quad. Neighbouring faces then begin with different corners.
    std::span<const std::uint8_t> quads{};
    /// Empty, or one element per vertex.
    std::span<const Tangent> tangents{};
    /// Empty, or one element per vertex.
    std::span<const VertexAttributes> attributes{};
};

/// A piece of the output as it lies on the device that made it, from the start of each buffer, in kernel space.
/// Otherwise like MeshBatch.
struct DeviceMeshBatch {
    gpu::Device device;
    std::uint64_t first_vertex = 0, vertex_count = 0;
    std::uint64_t first_index = 0, index_count = 0;
    gpu::Buffer vertices;    ///< of Vertex
    gpu::Buffer indices;     ///< of uint32; global
    gpu::Buffer tangents;    ///< null, or Tangent for each vertex
    gpu::Buffer attributes;  ///< null, or VertexAttributes for each vertex
};

/// Receives batches; what writers and rasterisers implement.
class MeshSink {
public:
    virtual ~MeshSink() = default;
    virtual void append(const MeshBatch& batch) = 0;
    /// Offered first where kernel space is asked for. A sink that works on this device submits what reads the buffers,
    /// to the device's queue, and returns true: nothing is read back then, and later work writes the buffers anew.
    virtual bool take_from_device(const DeviceMeshBatch& /*batch*/) { return false; }
};

}  // namespace tessera
