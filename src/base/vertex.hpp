// The vertex that goes into the kernels and comes out of them.
#pragma once

namespace tessera {

/// A control vertex and an output vertex alike, as the kernels lay it out: 32 bytes, interleaved.
struct Vertex {
    float position[3];
    float normal[3];  ///< unit
    float uv[2];
};
static_assert(sizeof(Vertex) == 32);

}  // namespace tessera
