#include "render/mesh_sinks.hpp"
#include "views/view.hpp"

namespace tessera::views {
namespace {

class PlainView final : public View {
public:
    explicit PlainView(const scene::Scene& scene) : scene_(scene) {}

    image::Image draw(Cell& cell, const render::Frame& frame, render::Rasteriser& rasteriser, const Run& run) override {
        rasteriser.begin(frame);
        rasteriser.set_materials(scene_.materials, scene_.images);
        render::DrawSink sink(rasteriser, cell.tessellator->totals().parts);
        run(*cell.tessellator, sink);
        return rasteriser.finish();
    }

private:
    const scene::Scene& scene_;
};

}  // namespace

std::unique_ptr<View> make_plain_view(const Subject& subject) {
    return std::make_unique<PlainView>(subject.scene);
}

}  // namespace tessera::views
