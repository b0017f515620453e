// Reads back what a job has emitted.
#pragma once

#include "tessellate/job.hpp"

namespace tessera {

/// What was emitted, in host memory; kept from batch to batch for its memory.
struct HostBatch {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Tangent> tangents;
    std::vector<VertexAttributes> attributes;

    /// `views` are those of Job::emitted_views (or HairJob's). What they lack is empty.
    void read(const gpu::Device& device, const std::vector<StageView>& views) {
        tangents.clear();
        attributes.clear();
        for (const StageView& view : views) {
            if (view.stage == StageId::vertices) read(device, view, vertices);
            if (view.stage == StageId::indices) read(device, view, indices);
            if (view.stage == StageId::tangents) read(device, view, tangents);
            if (view.stage == StageId::attributes) read(device, view, attributes);
        }
    }

private:
    template <typename Element>
    static void read(const gpu::Device& device, const StageView& view, std::vector<Element>& elements) {
        elements.resize(view.bytes / sizeof(Element));
        device.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(elements)));
    }
};

}  // namespace tessera
