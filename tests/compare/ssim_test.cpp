// SSIM against its definition, and PSNR.
#include "compare/ssim.hpp"

#include "compare/pictures.hpp"
#include "compare/psnr.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace tessera::test {
namespace {

using namespace compare;

constexpr double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;

double luma(const image::Image& image, int x, int y) {
    const std::uint8_t* p = &image.rgba[(static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)) * 4];
    return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
}

/// The definition, word for word: one window after the other, means first and then deviations from them.
double defined_ssim(const image::Image& a, const image::Image& b) {
    double total = 0.0;
    int count = 0;
    for (int cy = 5; cy + 5 < static_cast<int>(a.height); ++cy) {
        for (int cx = 5; cx + 5 < static_cast<int>(a.width); ++cx, ++count) {
            double weights = 0.0, mean_a = 0.0, mean_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
            const auto each = [&](const auto& use) {
                for (int y = -5; y <= 5; ++y) {
                    for (int x = -5; x <= 5; ++x)
                        use(std::exp(-(x * x + y * y) / 4.5), luma(a, cx + x, cy + y), luma(b, cx + x, cy + y));
                }
            };
            each([&](double w, double p, double q) {
                weights += w;
                mean_a += w * p;
                mean_b += w * q;
            });
            mean_a /= weights;
            mean_b /= weights;
            each([&](double w, double p, double q) {
                aa += w / weights * (p - mean_a) * (p - mean_a);
                bb += w / weights * (q - mean_b) * (q - mean_b);
                ab += w / weights * (p - mean_a) * (q - mean_b);
            });
            total += (2 * mean_a * mean_b + c1) * (2 * ab + c2) /
                     ((mean_a * mean_a + mean_b * mean_b + c1) * (aa + bb + c2));
        }
    }
    return total / count;
}

TEST(Ssim, IsWhatItsDefinitionSays) {
    const image::Image d = drawing(60, 47);
    for (const image::Image& other : {noisy(d, 10), noisy(d, 100), blurred(d, 2), drawing(60, 47, 3)})
        EXPECT_NEAR(mean_ssim(d, other, Backdrop::black), defined_ssim(d, other), 1e-6);
    // More than a tile each way.
    const image::Image wide = drawing(300, 150);
    EXPECT_NEAR(mean_ssim(wide, noisy(wide, 30), Backdrop::black), defined_ssim(wide, noisy(wide, 30)), 1e-6);
    EXPECT_NEAR(mean_ssim(drawing(11, 11), noisy(drawing(11, 11), 30), Backdrop::black),
                defined_ssim(drawing(11, 11), noisy(drawing(11, 11), 30)), 1e-6);
}

TEST(Ssim, OfFlatPicturesIsKnown) {
    for (const std::uint32_t size : {1u, 5u, 11u, 40u}) {
        const image::Image a = flat(size, size, {100, 100, 100, 255});
        const image::Image b = flat(size, size, {150, 150, 150, 255});
        EXPECT_NEAR(mean_ssim(a, b, Backdrop::black), (2 * 100.0 * 150.0 + c1) / (100.0 * 100.0 + 150.0 * 150.0 + c1),
                    1e-6);
    }
}

TEST(Ssim, IsOneForAPictureAndItself) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 30u}, {30u, 3u}, {64u, 48u}})
        EXPECT_NEAR(mean_ssim(drawing(width, height), drawing(width, height), Backdrop::black), 1.0, 1e-12);
}

TEST(Ssim, IsNegativeForANegative) {
    const auto noise = [](int sign) {
        return make_picture(40, 40, [&](int x, int y) -> Colour {
            const int value = 128 + sign * (hash(x, y, 1) - 128) / 2;
            return {value, value, value, 255};
        });
    };
    EXPECT_LT(mean_ssim(noise(1), noise(-1), Backdrop::black), -0.8);
}

TEST(Ssim, FallsWithNoiseAndIsSymmetric) {
    const image::Image d = drawing(80, 60);
    double last = 1.0;
    for (const int strength : {2, 5, 10, 20, 40, 80, 127}) {
        const image::Image other = noisy(d, strength);
        const double now = mean_ssim(d, other, Backdrop::black);
        EXPECT_LT(now, last) << strength;
        EXPECT_EQ(now, mean_ssim(other, d, Backdrop::black));
        last = now;
    }
}

TEST(Psnr, OfAConstantDifferenceIsKnown) {
    const image::Image a = flat(7, 5, {100, 50, 200, 255});
    EXPECT_NEAR(psnr(a, flat(7, 5, {110, 60, 190, 255}), Backdrop::black), 20.0 * std::log10(25.5), 1e-4);
    EXPECT_NEAR(psnr(a, flat(7, 5, {110, 50, 200, 255}), Backdrop::black), 10.0 * std::log10(3.0 * 25.5 * 25.5), 1e-4);
    EXPECT_NEAR(psnr(flat(1, 1, {0, 0, 0, 255}), flat(1, 1, {255, 255, 255, 255}), Backdrop::black), 0.0, 1e-9);
}

TEST(Psnr, IsInfiniteForAPictureAndItself) {
    EXPECT_TRUE(std::isinf(psnr(drawing(20, 20), drawing(20, 20), Backdrop::black)));
}

TEST(Psnr, FallsWithNoiseAndIsSymmetric) {
    const image::Image d = drawing(80, 60);
    double last = 1e9;
    for (const int strength : {2, 5, 10, 20, 40, 80, 127}) {
        const image::Image other = noisy(d, strength);
        const double now = psnr(d, other, Backdrop::black);
        EXPECT_LT(now, last) << strength;
        EXPECT_EQ(now, psnr(other, d, Backdrop::black));
        last = now;
    }
}

}  // namespace
}  // namespace tessera::test
