// The first of two runs over a tessellation's output: what cameras need to know of it.
#pragma once

#include "render/camera_choice.hpp"
#include "render/turntable.hpp"
#include "tessellate/refined_mesh.hpp"

namespace tessera::render {

/// Learns the box of all that it receives, and fits an orbiting camera to it. A surface swells out of its coarse mesh,
/// so that fitting takes a run of its own.
class Survey : public MeshSink {
public:
    /// `choice` in the units of the vertices to come; `aspect` is width / height of the image. `turning` tells that the
    /// camera will be asked for at other angles than 0; an orbit then goes around the middle of `coarse`, the box of
    /// the control vertices.
    Survey(const CameraChoice& choice, float aspect, bool turning, const Bounds& coarse);

    void append(const MeshBatch& batch) override;

    /// The camera, moved by `angle` in radians around the model (an orbit), around its target (placed by hand) or
    /// around the middle of the model (given whole). Throws Error(usage) for a LookAt that makes no sense.
    Camera camera(double angle = 0.0) const;

private:
    CameraChoice choice_;
    float aspect_;
    bool turning_;
    glm::dvec3 about_;  // where an orbit's axis is
    Framing framing_;
    TurntableFraming turntable_;
};

/// The box of control vertices, for Survey.
Bounds bounds_of(std::span<const Vertex> vertices);

/// The distances from the camera's plane that a box in the model's frame spans, from 0 on.
glm::vec2 depth_range(const Camera& camera, const Bounds& box);

}  // namespace tessera::render
