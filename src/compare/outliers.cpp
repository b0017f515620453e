#include "compare/outliers.hpp"

#include "compare/tiles.hpp"

#include <cstdlib>
#include <cstring>
#include <vector>

namespace tessera::compare {
namespace {

class Pixels {
public:
    explicit Pixels(const image::Image& image) : image_(image) {}

    const std::uint8_t* at(std::int64_t x, std::int64_t y) const {
        return &image_.rgba[static_cast<std::size_t>(y * image_.width + x) * 4];
    }

    /// Whether every channel of `pixel` is within the tolerance of the range it has around (x, y).
    bool explain(const std::uint8_t* pixel, std::int64_t x, std::int64_t y, int tolerance) const {
        std::array<int, 4> least{255, 255, 255, 255};
        std::array<int, 4> greatest{};
        const std::int64_t right = std::min(x + 1, std::int64_t{image_.width} - 1);
        const std::int64_t bottom = std::min(y + 1, std::int64_t{image_.height} - 1);
        for (std::int64_t row = std::max(y - 1, std::int64_t{0}); row <= bottom; ++row) {
            for (std::int64_t column = std::max(x - 1, std::int64_t{0}); column <= right; ++column) {
                const std::uint8_t* neighbour = at(column, row);
                for (std::size_t c = 0; c < 4; ++c) {
                    least[c] = std::min(least[c], int{neighbour[c]});
                    greatest[c] = std::max(greatest[c], int{neighbour[c]});
                }
            }
        }
        for (std::size_t c = 0; c < 4; ++c) {
            if (pixel[c] < least[c] - tolerance || pixel[c] > greatest[c] + tolerance) return false;
        }
        return true;
    }

private:
    const image::Image& image_;
};

/// Whether a channel differs by more than the tolerance.
bool is_over(const std::uint8_t* p, const std::uint8_t* q, int tolerance) {
    for (std::size_t c = 0; c < 4; ++c) {
        if (std::abs(int{p[c]} - int{q[c]}) > tolerance) return true;
    }
    return false;
}

bool are_both_hidden(const std::uint8_t* p, const std::uint8_t* q) {
    return p[3] == 0 && q[3] == 0;
}

/// Of pixels that are over the tolerance.
bool is_unexplained(const Pixels& a, const Pixels& b, std::int64_t x, std::int64_t y, int tolerance) {
    return !a.explain(b.at(x, y), x, y, tolerance) || !b.explain(a.at(x, y), x, y, tolerance);
}

void count_pixel(const Pixels& a, const Pixels& b, std::int64_t x, std::int64_t y, int tolerance, PixelCounts& counts) {
    const std::uint8_t* p = a.at(x, y);
    const std::uint8_t* q = b.at(x, y);
    if (std::memcmp(p, q, 4) == 0) return;
    counts.equal = false;
    ++counts.differing;
    if (are_both_hidden(p, q)) return;
    for (std::size_t c = 0; c < 4; ++c)
        counts.max_difference[c] = std::max(counts.max_difference[c], std::abs(int{p[c]} - int{q[c]}));
    if (!is_over(p, q, tolerance)) return;
    ++counts.over_tolerance;
    if (is_unexplained(a, b, x, y, tolerance)) ++counts.outliers;
}

void add(PixelCounts& sum, const PixelCounts& counts) {
    sum.equal = sum.equal && counts.equal;
    sum.differing += counts.differing;
    sum.over_tolerance += counts.over_tolerance;
    sum.outliers += counts.outliers;
    for (std::size_t c = 0; c < 4; ++c)
        sum.max_difference[c] = std::max(sum.max_difference[c], counts.max_difference[c]);
}

}  // namespace

PixelCounts count_pixels(const image::Image& a, const image::Image& b, int tolerance) {
    const Pixels of_a(a);
    const Pixels of_b(b);
    std::vector<PixelCounts> parts(tile_count(a.width, a.height));
    for_each_tile(a.width, a.height, [&](std::size_t number, const Tile& tile) {
        for (std::int64_t y = tile.y; y < tile.y + tile.height; ++y) {
            for (std::int64_t x = tile.x; x < tile.x + tile.width; ++x)
                count_pixel(of_a, of_b, x, y, tolerance, parts[number]);
        }
    });
    PixelCounts counts;
    for (const PixelCounts& part : parts)
        add(counts, part);
    return counts;
}

std::vector<bool> mark_outliers(const image::Image& a, const image::Image& b, int tolerance) {
    const Pixels of_a(a);
    const Pixels of_b(b);
    std::vector<bool> marks(std::size_t{a.width} * a.height, false);
    for (std::size_t at = 0; at < marks.size(); ++at) {
        const auto x = static_cast<std::int64_t>(at % a.width);
        const auto y = static_cast<std::int64_t>(at / a.width);
        const std::uint8_t* p = of_a.at(x, y);
        const std::uint8_t* q = of_b.at(x, y);
        marks[at] = !are_both_hidden(p, q) && is_over(p, q, tolerance) && is_unexplained(of_a, of_b, x, y, tolerance);
    }
    return marks;
}

}  // namespace tessera::compare
