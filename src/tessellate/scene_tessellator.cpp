#include "tessellate/scene_tessellator.hpp"

#include "base/error.hpp"

namespace tessera {
namespace {

/// Hair has no quads and no attributes; where the surface before it has, its batches say so.
class LikeSurface final : public MeshSink {
public:
    LikeSurface(MeshSink& sink, const MeshTotals& totals) : sink_(sink), totals_(totals) {}
    void append(const MeshBatch& batch) override {
        MeshBatch marked = batch;
        if (totals_.has_quads) {
            no_quads_.assign(batch.indices.size() / 3, 0);
            marked.quads = no_quads_;
        }
        if (totals_.has_attributes) {
            no_attributes_.assign(batch.vertices.size(), {});
            marked.attributes = no_attributes_;
        }
        sink_.append(marked);
    }
    bool take_from_device(const DeviceMeshBatch& batch) override { return sink_.take_from_device(batch); }

private:
    MeshSink& sink_;
    const MeshTotals& totals_;
    std::vector<std::uint8_t> no_quads_;
    std::vector<VertexAttributes> no_attributes_;
};

}  // namespace

SceneTessellator::SceneTessellator(const gpu::Device& device, const patches::PatchSet& patches,
                                   const TessellationOptions& options, const patches::HairSet& hair,
                                   const HairOptions& hair_options) {
    if (options.tangents != Tangents::none && !hair.empty()) {
        throw Error(ErrorKind::usage,
                    "The model has guide curves, and the ribbons of hair have no tangents; leave the tangents out, or "
                    "the guides.");
    }
    TessellationOptions surface_options = options;
    HairOptions ribbon_options = hair_options;
    if (patches.patch_count() > 0 && !hair.empty()) {
        surface_options.memory_budget /= 2;
        ribbon_options.memory_budget /= 2;
    }
    if (patches.patch_count() > 0) {
        surface_.emplace(device, patches, surface_options);
        totals_ = surface_->totals();
    }
    if (!hair.empty()) {
        hair_.emplace(device, hair, ribbon_options);
        for (MeshPart part : hair_->totals().parts) {
            part.first_vertex += totals_.vertex_count;
            part.first_index += totals_.index_count;
            totals_.parts.push_back(std::move(part));
        }
        totals_.vertex_count += hair_->totals().vertex_count;
        totals_.index_count += hair_->totals().index_count;
    }
}

void SceneTessellator::face(const glm::vec3& eye) {
    if (hair_) hair_->face(eye);
}

void SceneTessellator::run(MeshSink& sink, Space space, const std::function<void(double)>& progress) {
    const std::uint64_t hair_vertices = hair_ ? hair_->totals().vertex_count : 0;
    const std::uint64_t hair_indices = hair_ ? hair_->totals().index_count : 0;
    const std::uint64_t first_vertex = totals_.vertex_count - hair_vertices;
    const double share =
        totals_.vertex_count == 0 ? 0.0 : static_cast<double>(first_vertex) / static_cast<double>(totals_.vertex_count);
    if (surface_) {
        surface_->run(sink, space, [&](double done) {
            if (progress) progress(share * done);
        });
    }
    if (hair_) {
        LikeSurface like_surface(sink, totals_);
        hair_->run(like_surface, first_vertex, totals_.index_count - hair_indices, space, [&](double done) {
            if (progress) progress(share + (1.0 - share) * done);
        });
    }
}

StageTimes SceneTessellator::times() {
    StageTimes sum;
    const auto add = [&](const StageTimes& times) {
        sum.measured = times.measured;
        for (std::size_t i = 0; i < stage_count; ++i)
            sum.seconds[i] += times.seconds[i];
    };
    if (surface_) add(surface_->times());
    if (hair_) add(hair_->times());
    return sum;
}

std::uint64_t SceneTessellator::device_bytes() const {
    return (surface_ ? surface_->device_bytes() : 0) + (hair_ ? hair_->device_bytes() : 0);
}

}  // namespace tessera
