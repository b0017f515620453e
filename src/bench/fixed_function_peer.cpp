#include "bench/fixed_function_peer.hpp"

#include "bench/marks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tessera::bench {
namespace {

constexpr std::uint64_t software_patches = 2000;
constexpr std::uint32_t software_draw = 2;

struct StagePatches {
    std::vector<PatchFactors> factors;
    std::vector<Vertex> corners;
    double scale = 1.0;
    float greatest_factor = 1.0f;
};

StagePatches gather(const Workload& workload, bool software) {
    const std::uint64_t all = workload.patches.patch_count();
    const std::uint64_t step = software ? std::max<std::uint64_t>(all / software_patches, 1) : 1;
    const auto* each = std::get_if<std::vector<PatchFactors>>(&workload.options.factors);
    StagePatches result;
    for (std::uint64_t i = 0; i < all; i += step) {
        result.factors.push_back(each != nullptr ? (*each)[i] : std::get<PatchFactors>(workload.options.factors));
        result.greatest_factor = std::max(result.greatest_factor, *std::ranges::max_element(result.factors.back()));
        for (std::size_t k = 0; k < 3; ++k) {
            result.corners.push_back(workload.patches.control_vertices[workload.patches.corners[i][k]]);
        }
    }
    result.scale = static_cast<double>(all) / static_cast<double>(result.factors.size());
    return result;
}

class FixedFunction final : public Peer {
public:
    FixedFunction(TimedStage& stage, Destination destination, const Workload& workload)
        : destination_(destination), software_(stage.info().software), patches_(gather(workload, software_)) {
        const auto most = static_cast<std::uint64_t>(std::ceil(std::clamp(patches_.greatest_factor, 1.0f, 64.0f)));
        TimedPatches timed;
        timed.partitioning = workload.options.partitioning;
        timed.factors = patches_.factors;
        timed.corners = patches_.corners;
        timed.draw_patches = software_ ? software_draw : static_cast<std::uint32_t>(patches_.factors.size());
        timed.most_triangles = 6 * (most + 1) * (most + 1);  // fractional partitionings round up by one segment
        draw_ = stage.prepare(destination, timed);
    }

    void run() override {
        draw_->run();
        triangles_ = std::max(triangles_, draw_->captured_triangles());
    }
    OutputSize size() const override { return {3 * triangles_, triangles_}; }
    std::uint64_t bytes() const override { return triangles_ * 3 * sizeof(Vertex); }
    double scale() const override { return patches_.scale; }

    // The sphere's points are near the unit sphere in any case; what is looked for is a capture that did not happen.
    std::string check() override {
        if (destination_ != Destination::captured) return {};
        if (triangles_ == 0) return "Nothing was captured.";
        for (const Vertex& vertex : draw_->captured(300)) {
            const float* n = vertex.normal;
            const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            if (!(std::abs(length - 1.0f) < 1e-3f)) return "A captured normal is not of unit length.";
        }
        return {};
    }

    std::string note() const override {
        std::string text = destination_ == Destination::captured ? "three vertices of 32 bytes per triangle"
                                                                 : "nothing is written to memory";
        if (destination_ == Destination::drawn) text = "into 1024 x 1024 pixels";
        if (software_) text += fmt::format("; draws of {} patches", software_draw);
        if (patches_.scale > 1.0) text += fmt::format(", time of {} patches scaled up", patches_.factors.size());
        return text;
    }

private:
    Destination destination_;
    bool software_;
    StagePatches patches_;
    std::unique_ptr<TimedDraw> draw_;
    std::uint64_t triangles_ = 0;
};

}  // namespace

std::vector<PeerMaker> fixed_function_peers(std::shared_ptr<TimedStage> stage) {
    std::vector<PeerMaker> makers;
    const auto add = [&](const char* prefix, Destination destination) {
        makers.push_back({prefix + stage->info().id,
                          [stage, destination](const Workload& workload) -> std::unique_ptr<Peer> {
                              if (workload.patches.has_quads || workload.options.scheme != Scheme::pn ||
                                  workload.options.normals != Normals::quadratic) {
                                  return nullptr;
                              }
                              return std::make_unique<FixedFunction>(*stage, destination, workload);
                          },
                          destination == Destination::captured && stage->info().software});
    };
    add(captured_peer_prefix, Destination::captured);
    add(discarded_peer_prefix, Destination::discarded);
    add(drawn_peer_prefix, Destination::drawn);
    return makers;
}

}  // namespace tessera::bench
