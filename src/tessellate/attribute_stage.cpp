#include "tessellate/attribute_stage.hpp"

#include "base/error.hpp"
#include "layout.h"

#include <fmt/format.h>

namespace tessera {
namespace {

using PatchAttributes = std::array<VertexAttributes, PATCH_CORNERS>;

static_assert(sizeof(VertexAttributes) == ATTRIBUTE_FLOATS * sizeof(float));
static_assert(sizeof(PatchAttributes) == PATCH_CORNERS * ATTRIBUTE_FLOATS * sizeof(float));

}  // namespace

AttributeStage::AttributeStage(const gpu::Device& device, const patches::PatchSet& patches,
                               const ParameterRing& parameters, std::uint32_t largest_chunk)
    : device_(device), patches_(patches), parameters_(parameters) {
    if (!is_wanted()) return;
    if (patches.corner_attributes.size() != patches.patch_count()) {
        throw Error(ErrorKind::usage, fmt::format("There are attributes of the corners of {} patches for {} patches; "
                                                  "give none, or one set per patch.",
                                                  patches.corner_attributes.size(), patches.patch_count()));
    }
    corners_ = device_.create_buffer(
        {"corner attributes", std::uint64_t{largest_chunk} * sizeof(PatchAttributes), storage_usage});
}

void AttributeStage::upload(std::uint64_t first, std::uint32_t count) {
    if (!is_wanted()) return;
    const std::span chunk = std::span(patches_.corner_attributes).subspan(first, count);
    device_.queue().write_buffer(corners_, 0, std::as_bytes(chunk));
}

void AttributeStage::reserve(std::uint64_t bytes, const gpu::Buffer& records, const gpu::Buffer& offsets,
                             const gpu::Buffer& patch_list, const gpu::Buffer& ring_table) {
    if (!is_wanted() || (output_ && output_.size() >= bytes)) return;
    if (output_) output_.destroy();
    output_ = device_.create_buffer({"vertex attributes", bytes, storage_usage});
    for (const Domain domain : {Domain::triangle, Domain::quad}) {
        if (domain == Domain::quad && !patches_.has_quads) continue;
        std::vector<gpu::Buffer> bindings{corners_, records, offsets, patch_list, output_};
        if (domain == Domain::triangle) bindings.push_back(ring_table);
        stages_[static_cast<std::size_t>(domain)] =
            Stage(device_, fmt::format("attributes_{}", name(domain)), bindings, parameters_);
    }
}

void AttributeStage::record(gpu::ComputePass& pass, Domain domain, std::uint32_t parameter_offset,
                            std::uint64_t items) const {
    stages_[static_cast<std::size_t>(domain)].record(pass, parameter_offset, items);
}

std::uint64_t AttributeStage::device_bytes() const {
    return (corners_ ? corners_.size() : 0) + (output_ ? output_.size() : 0);
}

std::uint64_t AttributeStage::bytes_per_patch(const patches::PatchSet& patches) {
    return patches.corner_attributes.empty() ? 0 : sizeof(PatchAttributes);
}

}  // namespace tessera
