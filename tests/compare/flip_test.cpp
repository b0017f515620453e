// FLIP against the authors' own implementation and the constants of the paper.
#include "compare/flip.hpp"

#include "compare/flip_filters.hpp"
#include "compare/opponent_colour.hpp"
#include "compare/pictures.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numeric>

namespace tessera::test {
namespace {

using namespace compare;

double mean(const std::vector<float>& map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

struct Published {
    const char* name;
    image::Image a, b;
    double pixels_per_degree;
    double mean, max, at_5_7, middle, first;
};

// What FLIP.h of github.com/NVlabs/flip (version 1.6, C++) gives for these pictures, linear sRGB in. It works in single
// precision with another order of sums and other digits of the same matrices.
TEST(Flip, AgreesWithTheAuthorsImplementation) {
    const image::Image d = drawing(300, 150);
    const double usual = default_pixels_per_degree;
    const std::vector<Published> cases{
        {"weak noise", d, noisy(d, 20), usual, 0.0960255, 0.3024134, 0.0633957, 0.0651272, 0.1550436},
        {"strong noise", d, noisy(d, 120), usual, 0.4147362, 0.9511860, 0.2162502, 0.2920949, 0.5777619},
        {"weak blur", d, blurred(d, 1), usual, 0.1665974, 0.6312494, 0.0416643, 0.0, 0.0902541},
        {"strong blur", d, blurred(d, 3), usual, 0.2726584, 0.8939417, 0.1383653, 0.0, 0.1332994},
        {"shift", d, drawing(300, 150, 1), usual, 0.1590449, 0.9790676, 0.0743889, 0.0345996, 0.4401673},
        {"shift from afar", d, drawing(300, 150, 1), 150.0, 0.1368589, 0.9303897, 0.2011634, 0.0349395, 0.4332364},
        {"shift from nearby", d, drawing(300, 150, 1), 30.0, 0.1743189, 0.9883638, 0.0494851, 0.0343830, 0.4571970},
    };
    for (const Published& c : cases) {
        SCOPED_TRACE(c.name);
        const std::vector<float> map = flip_map(c.a, c.b, Backdrop::black, c.pixels_per_degree);
        EXPECT_NEAR(mean(map), c.mean, 1e-6);
        EXPECT_NEAR(*std::max_element(map.begin(), map.end()), c.max, 4e-6);
        EXPECT_NEAR(map[7 * 300 + 5], c.at_5_7, 4e-6);
        EXPECT_NEAR(map[75 * 300 + 150], c.middle, 2e-3) << "near 0 its slope is steep";
        EXPECT_NEAR(map[0], c.first, 4e-6);
    }
}

TEST(Flip, AgreesOnFlatColours) {
    const auto of = [](const Colour& a, const Colour& b) {
        const std::vector<float> map = flip_map(flat(16, 9, a), flat(16, 9, b), Backdrop::black);
        EXPECT_NEAR(map.front(), map[70], 1e-5) << "flat everywhere, borders included";
        return map.front();
    };
    EXPECT_NEAR(of({0, 0, 0, 255}, {255, 255, 255, 255}), 0.9673883, 1e-5);
    EXPECT_NEAR(of({255, 0, 0, 255}, {0, 255, 0, 255}), 0.9866650, 1e-5);
    EXPECT_NEAR(of({0, 255, 0, 255}, {0, 0, 255, 255}), 1.0, 1e-5) << "by definition the largest error";
    EXPECT_NEAR(of({100, 100, 100, 255}, {110, 110, 110, 255}), 0.1534754, 1e-5);
}

TEST(Flip, HasTheConstantsOfThePaper) {
    EXPECT_NEAR(default_pixels_per_degree, 67.02, 0.01) << "section 4.1.1";
    const Opponent white = to_adjusted_lab({1.0f, 1.0f, 1.0f});
    EXPECT_NEAR(white.luminance, 100.0f, 1e-4f);
    EXPECT_NEAR(white.red_green, 0.0f, 1e-3f);
    EXPECT_NEAR(white.blue_yellow, 0.0f, 1e-3f);
    const Opponent black = to_ycxcz({0.0f, 0.0f, 0.0f});
    EXPECT_EQ(black.luminance, -16.0f);
    // L*a*b* of the primaries (any table of sRGB in CIELAB).
    const auto lab = [](const Rgb& rgb) {
        Opponent c = to_adjusted_lab(rgb);
        c.red_green /= 0.01f * c.luminance;
        c.blue_yellow /= 0.01f * c.luminance;
        return c;
    };
    const Opponent red = lab({1.0f, 0.0f, 0.0f});
    EXPECT_NEAR(red.luminance, 53.24f, 0.02f);
    EXPECT_NEAR(red.red_green, 80.09f, 0.05f);
    EXPECT_NEAR(red.blue_yellow, 67.20f, 0.05f);
    const Opponent blue = lab({0.0f, 0.0f, 1.0f});
    EXPECT_NEAR(blue.luminance, 32.30f, 0.02f);
    EXPECT_NEAR(blue.red_green, 79.19f, 0.05f);
    EXPECT_NEAR(blue.blue_yellow, -107.86f, 0.05f);
}

TEST(Flip, ColourSpacesLeadBack) {
    for (int i = 0; i < 200; ++i) {
        Rgb rgb{};
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(hash(i, static_cast<int>(c), 5)) / 255.0f;
        const Rgb back = from_ycxcz(to_ycxcz(rgb));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(back[c], rgb[c], 1e-5f);
    }
}

TEST(Flip, FiltersKeepFlatAreasAndSeeNoFeatureThere) {
    const auto sum = [](const Taps& taps) { return std::accumulate(taps.begin(), taps.end(), 0.0); };
    for (const double pixels_per_degree : {1.0, 30.0, default_pixels_per_degree, 1000.0}) {
        const ContrastSensitivity contrast = make_contrast_sensitivity(pixels_per_degree);
        for (const Taps& taps :
             {contrast.luminance, contrast.red_green, contrast.blue_yellow_wide, contrast.blue_yellow_narrow}) {
            EXPECT_EQ(taps.size(), static_cast<std::size_t>(2 * contrast.radius + 1));
            EXPECT_NEAR(sum(taps), 1.0, 1e-5);
        }
        const FeatureDetectors feature = make_feature_detectors(pixels_per_degree);
        EXPECT_NEAR(sum(feature.smooth), 1.0, 1e-5);
        EXPECT_NEAR(sum(feature.edge), 0.0, 1e-5);
        EXPECT_NEAR(sum(feature.point), 0.0, 1e-5);
    }
    EXPECT_EQ(make_contrast_sensitivity(default_pixels_per_degree).radius, 10);
    EXPECT_EQ(make_feature_detectors(default_pixels_per_degree).radius, 9);
}

TEST(Flip, IsZeroForAPictureAndItself) {
    const image::Image d = drawing(70, 50);
    for (const float error : flip_map(d, d, Backdrop::black))
        ASSERT_EQ(error, 0.0f);
}

TEST(Flip, IsSymmetric) {
    const image::Image a = drawing(90, 60);
    const image::Image b = noisy(a, 60);
    EXPECT_EQ(flip_map(a, b, Backdrop::black), flip_map(b, a, Backdrop::black));
}

TEST(Flip, DoesNotShowTheTiles) {
    // The same pixels far from any border, in another tile and at another place of it.
    const auto at = [](int shift) {
        const image::Image a = make_picture(600, 300, [&](int x, int y) -> Colour {
            return {hash(x + shift, y + shift, 1), hash(x + shift, y + shift, 2), 90, 255};
        });
        return flip_map(a, blurred(a, 1), Backdrop::black);
    };
    const std::vector<float> first = at(0);
    const std::vector<float> second = at(17);
    for (std::size_t y = 60; y < 200; ++y) {
        for (std::size_t x = 60; x < 500; ++x)
            ASSERT_EQ(first[(y + 17) * 600 + x + 17], second[y * 600 + x]) << x << ", " << y;
    }
}

TEST(Flip, GrowsWithNoiseAndBlur) {
    const image::Image d = drawing(160, 120);
    double last = 0.0;
    for (const int strength : {2, 5, 10, 20, 40, 80, 127}) {
        const double now = mean(flip_map(d, noisy(d, strength), Backdrop::black));
        EXPECT_GT(now, last) << strength;
        last = now;
    }
    last = 0.0;
    for (int radius = 1; radius < 6; ++radius) {
        const double now = mean(flip_map(d, blurred(d, radius), Backdrop::black));
        EXPECT_GT(now, last) << radius;
        last = now;
    }
}

TEST(Flip, StaysInItsRangeForEveryShape) {
    for (const auto& [width, height] :
         {std::pair{1u, 1u}, {1u, 40u}, {40u, 1u}, {2u, 3u}, {256u, 128u}, {257u, 129u}, {9u, 300u}}) {
        for (const double pixels_per_degree : {1.0, default_pixels_per_degree, 1000.0}) {
            const image::Image a = make_picture(width, height, [](int x, int y) -> Colour {
                return {hash(x, y, 1) & 128 ? 255 : 0, hash(x, y, 2) & 128 ? 255 : 0, hash(x, y, 3), 255};
            });
            const image::Image b = make_picture(width, height, [](int x, int y) -> Colour {
                return {hash(x, y, 4), hash(x, y, 5) & 128 ? 255 : 0, hash(x, y, 6) & 128 ? 255 : 0, 255};
            });
            if (pixels_per_degree == 1000.0 && width > 100) continue;
            const std::vector<float> map = flip_map(a, b, Backdrop::black, pixels_per_degree);
            ASSERT_EQ(map.size(), std::size_t{width} * height);
            for (const float error : map) {
                ASSERT_GE(error, 0.0f);
                ASSERT_LE(error, 1.0f);
            }
        }
    }
}

}  // namespace
}  // namespace tessera::test
