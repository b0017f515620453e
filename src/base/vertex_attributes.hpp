// What a vertex may carry besides what every vertex has.
#pragma once

namespace tessera {

/// The colour and the tangent of a patch's corner or of an output vertex, as the kernels lay them out: 32 bytes,
/// interleaved.
struct VertexAttributes {
    float color[4]{1.0f, 1.0f, 1.0f, 1.0f};  ///< linear RGBA in [0, 1]: what the base colour is multiplied by
    /// x, y, z: the unit direction in which a normal map's first coordinate grows; zero where there is none. w: 1 or
    /// -1, so that the map's green points along w * cross(normal, tangent); 0 where there is no tangent.
    float tangent[4]{};
};
static_assert(sizeof(VertexAttributes) == 32);

}  // namespace tessera
