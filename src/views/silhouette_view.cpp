#include "views/silhouette_view.hpp"

#include "render/mesh_sinks.hpp"
#include "views/colour_bar.hpp"
#include "views/contours.hpp"

#include <algorithm>

namespace tessera::views {
namespace {

constexpr std::uint32_t largest_side = 8192;  // that rasterisers draw
constexpr float jump = 0.003f;                // of the depth picture's range, which is 1.5 times that of the model

TessellationOptions coarse_options(TessellationOptions options) {
    options.scheme = Scheme::linear;
    options.normals = Normals::linear;
    options.partitioning = Partitioning::integer;
    options.factors = PatchFactors{1, 1, 1, 1, 1, 1};
    return options;
}

class SilhouetteView final : public View {
public:
    SilhouetteView(const Subject& subject, std::unique_ptr<render::Rasteriser> contours)
        : subject_(subject), contours_(std::move(contours)) {}

    std::size_t runs_per_cell() const override { return 3; }

    image::Image draw(Cell& cell, const render::Frame& frame, render::Rasteriser& rasteriser, const Run& run) override {
        if (!coarse_) {
            coarse_ = std::make_unique<SceneTessellator>(
                subject_.device, subject_.patches, coarse_options(cell.options), subject_.hair, subject_.hair_options);
        }
        std::vector<scene::Material> pale;
        for (const scene::Material& material : subject_.scene.materials) {
            pale.emplace_back();
            pale.back().base_color = glm::vec4(0.86f, 0.87f, 0.89f, 1.0f);
            pale.back().double_sided = material.double_sided;
        }
        rasteriser.begin(frame);
        rasteriser.set_materials(pale, {});
        render::DrawSink sink(rasteriser, cell.tessellator->totals().parts);
        run(*cell.tessellator, sink);
        image::Image picture = rasteriser.finish();

        const std::uint32_t times = std::clamp(largest_side / std::max(frame.width, frame.height), 1u, 3u);
        render::Frame large = frame;
        large.width *= times;
        large.height *= times;
        const float width = std::max(1.6f, static_cast<float>(std::min(frame.width, frame.height)) / 420.0f);
        const std::size_t least = std::min(large.width, large.height) / 50;
        const auto add = [&](SceneTessellator& tessellator, const image::Rgba& colour) {
            const DepthPicture depths = draw_depths(tessellator, subject_.scene.materials, large, *contours_, run);
            draw_contours(picture, long_contours(find_contours(depths, jump), least), times, width, colour);
        };
        add(*coarse_, coarse_ink);
        add(*cell.tessellator, refined_ink);
        return picture;
    }

    void append_legend(image::Image& picture, const PanelSize& panel, const image::Rgba& paper) const override {
        append_keys(picture, panel, {{refined_ink, "refined surface"}, {coarse_ink, "coarse mesh"}}, paper);
    }

private:
    const Subject subject_;
    std::unique_ptr<render::Rasteriser> contours_;
    std::unique_ptr<SceneTessellator> coarse_;
};

}  // namespace

std::unique_ptr<View> make_silhouette_view(const Subject& subject, std::unique_ptr<render::Rasteriser> contours) {
    return std::make_unique<SilhouetteView>(subject, std::move(contours));
}

}  // namespace tessera::views
