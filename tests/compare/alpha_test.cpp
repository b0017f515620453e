// Transparency: what both hide is no difference, what one shows is, over black or over white.
#include "compare/comparison.hpp"
#include "compare/pictures.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace tessera::test {
namespace {

using namespace compare;

TEST(Alpha, OpaquePicturesHaveNoBackdrop) {
    EXPECT_FALSE(is_transparent(drawing(9, 9)));
    EXPECT_FALSE(compare::compare(drawing(9, 9), drawing(9, 9)).transparent);
    const image::Image a = drawing(40, 30);
    const image::Image b = noisy(a, 50);
    EXPECT_EQ(flip_map(a, b, Backdrop::black), flip_map(a, b, Backdrop::white));
}

TEST(Alpha, HiddenColoursLookTheSame) {
    const Comparison comparison = compare::compare(flat(20, 20, {255, 0, 0, 0}), flat(20, 20, {0, 0, 255, 0}));
    EXPECT_TRUE(comparison.transparent);
    EXPECT_FALSE(comparison.pixels.equal);
    EXPECT_TRUE(std::isinf(comparison.psnr));
    EXPECT_NEAR(comparison.ssim, 1.0, 1e-12);
    EXPECT_EQ(comparison.flip_max, 0.0);
}

TEST(Alpha, ABlackOrWhiteShapeDoesNotHideInItsBackdrop) {
    for (const int value : {0, 255}) {
        const Comparison comparison =
            compare::compare(flat(20, 20, {value, value, value, 255}), flat(20, 20, {value, value, value, 0}));
        EXPECT_NEAR(comparison.psnr, 0.0, 1e-5) << value;
        EXPECT_LT(comparison.ssim, 0.01) << value;
        EXPECT_GT(comparison.flip_mean, 0.96) << value;
    }
}

TEST(Alpha, IsMixedInLinearLight) {
    const std::array<std::uint8_t, 4> half_white{255, 255, 255, 128};
    const Rgb over_black = linear_over(half_white.data(), Backdrop::black);
    EXPECT_NEAR(over_black[0], 128.0f / 255.0f, 1e-6f);
    EXPECT_NEAR(encoded_over(half_white.data(), Backdrop::black)[0], 188.0f / 255.0f, 0.5f / 255.0f);
    EXPECT_NEAR(linear_over(half_white.data(), Backdrop::white)[1], 1.0f, 1e-6f);
    const std::array<std::uint8_t, 4> opaque{12, 34, 56, 255};
    EXPECT_EQ(encoded_over(opaque.data(), Backdrop::white)[1], 34.0f / 255.0f);
}

}  // namespace
}  // namespace tessera::test
