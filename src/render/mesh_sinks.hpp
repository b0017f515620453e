// Receivers of tessellation output on its way to a picture.
#pragma once

#include "render/rasteriser.hpp"

namespace tessera::render {

/// Fits a camera to everything it receives.
class FramingSink : public MeshSink {
public:
    FramingSink(const View& view, float aspect) : framing_(view, aspect) {}

    void append(const MeshBatch& batch) override;
    Camera camera() const { return framing_.camera(); }

private:
    Framing framing_;
};

/// Draws what it receives, each part with its material.
class DrawSink : public MeshSink {
public:
    /// `rasteriser` has begun a frame; `parts` are those of the totals. Both must outlive the sink.
    DrawSink(Rasteriser& rasteriser, const std::vector<MeshPart>& parts) : rasteriser_(rasteriser), parts_(parts) {}

    void append(const MeshBatch& batch) override;

private:
    Rasteriser& rasteriser_;
    const std::vector<MeshPart>& parts_;
    std::vector<std::uint32_t> local_;  // indices of one part of a batch, from its first vertex
};

}  // namespace tessera::render
