// The views draw the same picture on every device.
#include "raster/portable_rasteriser.hpp"
#include "small_picture.hpp"
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "views/factor_view.hpp"
#include "views/scheme_difference.hpp"
#include "views/silhouette_view.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

enum class Which { factors, difference, silhouette };

image::Image draw(const std::string& device, Which which) {
    Stage stage(scene::load_scene("shape:icosahedron"), device);
    TessellationOptions options;
    options.factors = random_edge_factors(stage.patches, 1.0f, 9.0f, 5);
    std::vector<views::Cell> cells;
    cells.push_back(stage.cell(options));
    std::unique_ptr<views::View> view;
    if (which == Which::factors) view = views::make_factor_view(stage.subject, {});
    if (which == Which::difference) view = views::make_difference_view(stage.subject, Scheme::phong, "phong", {});
    if (which == Which::silhouette) {
        view = views::make_silhouette_view(stage.subject, raster::open_portable(stage.device));
    }
    view->prepare(cells, plain_run());
    const auto rasteriser = raster::open_portable(stage.device);
    image::Image picture = view->draw(cells[0], front_frame(150), *rasteriser, plain_run());
    view->append_legend(picture, {150, 150}, {255, 255, 255, 255});
    return picture;
}

class ViewOn : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(ViewOn, IsThatOfTheReference) {
    for (const Which which : {Which::factors, Which::difference, Which::silhouette}) {
        const image::Image wanted = draw("reference", which), made = draw(GetParam().id, which);
        EXPECT_EQ(made.height, wanted.height);
        EXPECT_TRUE(made.rgba == wanted.rgba) << static_cast<int>(which);
    }
}

TESSERA_ON_EVERY_DEVICE(ViewOn);

}  // namespace
}  // namespace tessera::test
