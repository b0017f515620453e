// The receiver of tessellation output on its way to a picture.
#pragma once

#include "render/rasteriser.hpp"

namespace tessera::render {

/// Draws what it receives, each part with its material: from the device's buffers where the rasteriser can.
class DrawSink : public MeshSink {
public:
    /// `rasteriser` has begun a frame; `parts` are those of the totals. Both must outlive the sink.
    DrawSink(Rasteriser& rasteriser, const std::vector<MeshPart>& parts) : rasteriser_(rasteriser), parts_(parts) {}

    void append(const MeshBatch& batch) override;
    bool take_from_device(const DeviceMeshBatch& batch) override;

private:
    Rasteriser& rasteriser_;
    const std::vector<MeshPart>& parts_;
    std::vector<std::uint32_t> local_;  // indices of one part of a batch, from its first vertex
};

}  // namespace tessera::render
