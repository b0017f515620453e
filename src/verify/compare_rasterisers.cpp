#include "verify/compare_rasterisers.hpp"

#include "verify/picture_edges.hpp"

namespace tessera::verify {
namespace {

std::uint32_t word_of(const std::uint8_t* p) {
    return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | p[3];
}

}  // namespace

RasteriserComparison compare_rasterisers(const gpu::Device& device, const PictureSubject& subject,
                                         const render::Frame& frame, render::Rasteriser& own,
                                         render::Rasteriser& portable, std::vector<image::Image>* pictures) {
    const image::Image found = draw_picture(device, subject, own, frame);
    const image::Image expected = draw_picture(device, subject, portable, frame);
    const compare::Comparison comparison = compare::compare(expected, found, {.tolerance = outlier_steps});
    RasteriserComparison result;
    result.flip_mean = comparison.flip_mean;
    result.pixels = std::uint64_t{frame.width} * frame.height;
    result.over_tolerance = comparison.pixels.over_tolerance;
    result.outliers = comparison.pixels.outliers;
    if (result.outliers > 0) {
        const std::vector<bool> outliers = compare::mark_outliers(expected, found, outlier_steps);
        const std::vector<bool> edges = find_edges(device, subject, portable, frame);
        for (std::size_t at = 0; at < outliers.size(); ++at) {
            if (!outliers[at] || edges[at]) continue;
            if (result.off_edges++ == 0) {
                result.first = PixelDifference{static_cast<std::uint32_t>(at % frame.width),
                                               static_cast<std::uint32_t>(at / frame.width),
                                               word_of(&expected.rgba[at * 4]), word_of(&found.rgba[at * 4])};
            }
        }
    }
    if (pictures != nullptr) *pictures = {found, expected};
    return result;
}

}  // namespace tessera::verify
