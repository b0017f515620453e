// The tangent frame of an output vertex, as the kernels make it.
#pragma once

namespace tessera {

/// 32 bytes, interleaved. Tangent and bitangent are unit vectors along the surface's derivatives: not at right angles
/// to each other as a rule, nor to a vertex normal that is not the surface's own. Free of the model's scale.
struct Tangent {
    float tangent[3];
    /// 1 or -1, so that bitangent = handedness * cross(vertex normal, tangent) but for length and the angle between
    /// tangent and bitangent; -1 where the texture is mirrored.
    float handedness;
    float bitangent[3];
    float unused;  ///< zero
};
static_assert(sizeof(Tangent) == 32);

}  // namespace tessera
