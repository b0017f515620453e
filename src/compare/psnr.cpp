#include "compare/psnr.hpp"

#include "compare/tiles.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace tessera::compare {

double psnr(const image::Image& a, const image::Image& b, Backdrop backdrop) {
    std::vector<double> sums(tile_count(a.width, a.height));
    for_each_tile(a.width, a.height, [&](std::size_t number, const Tile& tile) {
        for (std::int64_t y = tile.y; y < tile.y + tile.height; ++y) {
            for (std::int64_t x = tile.x; x < tile.x + tile.width; ++x) {
                const auto pixel = static_cast<std::size_t>(y * a.width + x) * 4;
                if (std::memcmp(&a.rgba[pixel], &b.rgba[pixel], 4) == 0) continue;
                const Rgb p = encoded_over(&a.rgba[pixel], backdrop);
                const Rgb q = encoded_over(&b.rgba[pixel], backdrop);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double apart = double{p[c]} - double{q[c]};
                    sums[number] += apart * apart;
                }
            }
        }
    });
    double sum = 0.0;
    for (const double part : sums)
        sum += part;
    if (!(sum > 0.0)) return std::numeric_limits<double>::infinity();
    return 10.0 * std::log10(3.0 * static_cast<double>(a.width) * static_cast<double>(a.height) / sum);
}

}  // namespace tessera::compare
