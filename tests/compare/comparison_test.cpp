// The numbers together.
#include "compare/comparison.hpp"

#include "base/error.hpp"
#include "compare/pictures.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <cmath>
#include <numeric>

namespace tessera::test {
namespace {

using namespace compare;

TEST(Comparison, OfAPictureAndItselfFindsNothing) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 9u}, {300u, 140u}}) {
        const Comparison c = compare::compare(drawing(width, height), drawing(width, height));
        EXPECT_TRUE(c.pixels.equal);
        EXPECT_TRUE(std::isinf(c.psnr));
        EXPECT_NEAR(c.ssim, 1.0, 1e-12);
        EXPECT_EQ(c.flip_mean, 0.0);
        EXPECT_EQ(c.flip_99, 0.0);
        EXPECT_EQ(c.flip_max, 0.0);
        EXPECT_EQ(c.flip.size(), std::size_t{width} * height);
    }
}

TEST(Comparison, OfSinglePixelsIsFinite) {
    for (const Colour& colour : {Colour{0, 0, 0, 255}, Colour{255, 255, 255, 255}, Colour{1, 2, 3, 4}}) {
        const Comparison c = compare::compare(flat(1, 1, colour), flat(1, 1, {0, 255, 0, 128}));
        EXPECT_TRUE(std::isfinite(c.psnr));
        EXPECT_TRUE(std::isfinite(c.ssim));
        EXPECT_GT(c.flip_mean, 0.0);
        EXPECT_LE(c.flip_max, 1.0);
        EXPECT_EQ(c.flip_mean, c.flip_99);
        EXPECT_EQ(c.pixels.outliers, 1u);
    }
}

TEST(Comparison, IsSymmetric) {
    const image::Image a = drawing(100, 80);
    const image::Image b = noisy(a, 40);
    const Comparison ab = compare::compare(a, b, {.tolerance = 5});
    const Comparison ba = compare::compare(b, a, {.tolerance = 5});
    EXPECT_EQ(ab.psnr, ba.psnr);
    EXPECT_EQ(ab.ssim, ba.ssim);
    EXPECT_EQ(ab.flip, ba.flip);
    EXPECT_EQ(ab.flip_mean, ba.flip_mean);
    EXPECT_EQ(ab.pixels.outliers, ba.pixels.outliers);
}

TEST(Comparison, PercentileIsTheLeastThatNinetyNineOfAHundredDoNotExceed) {
    const image::Image a = drawing(40, 25);  // 1,000 pixels
    const Comparison c = compare::compare(a, noisy(a, 80));
    const auto above = std::count_if(c.flip.begin(), c.flip.end(), [&](float f) { return f > c.flip_99; });
    const auto from = std::count_if(c.flip.begin(), c.flip.end(), [&](float f) { return f >= c.flip_99; });
    EXPECT_LE(above, 10);
    EXPECT_GT(from, 10);
    EXPECT_NEAR(c.flip_mean, std::accumulate(c.flip.begin(), c.flip.end(), 0.0) / 1000.0, 1e-12);
}

TEST(Comparison, DoesNotDependOnThreads) {
    const image::Image a = drawing(700, 300);
    const image::Image b = noisy(a, 40);
    const Comparison many = compare::compare(a, b);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Comparison single = compare::compare(a, b);
    EXPECT_EQ(many.psnr, single.psnr);
    EXPECT_EQ(many.ssim, single.ssim);
    EXPECT_EQ(many.flip, single.flip);
    EXPECT_EQ(many.flip_mean, single.flip_mean);
}

std::string refusal_of(const image::Image& a, const image::Image& b, const CompareOptions& options = {}) {
    try {
        compare::compare(a, b, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    return "";
}

TEST(Comparison, RefusesWhatCannotBeCompared) {
    EXPECT_EQ(refusal_of(flat(3, 4, {}), flat(4, 3, {})),
              "Only pictures of the same size can be compared, but the first has 3 x 4 pixels and the second 4 x 3.");
    EXPECT_NE(refusal_of({}, {}), "");
    image::Image cut = flat(3, 4, {});
    cut.rgba.pop_back();
    EXPECT_NE(refusal_of(cut, flat(3, 4, {})), "");
    EXPECT_NE(refusal_of(flat(3, 4, {}), cut), "");
    const image::Image sound = flat(3, 4, {});
    EXPECT_NE(refusal_of(sound, sound, {.tolerance = -1}), "");
    EXPECT_NE(refusal_of(sound, sound, {.tolerance = 256}), "");
    for (const double bad : {0.0, -1.0, 1001.0, std::nan(""), 1e300})
        EXPECT_NE(refusal_of(sound, sound, {.tolerance = 0, .pixels_per_degree = bad}), "") << bad;
}

}  // namespace
}  // namespace tessera::test
