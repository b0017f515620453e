// Words on pictures, and pictures side by side.
#include "image/panels.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace tessera::image {
namespace {

Image flat(std::uint32_t width, std::uint32_t height, const Rgba& colour) {
    Image image{width, height, {}};
    for (std::uint32_t i = 0; i < width * height; ++i)
        image.rgba.insert(image.rgba.end(), colour.begin(), colour.end());
    return image;
}

Rgba at(const Image& image, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* p = &image.rgba.at((std::size_t{y} * image.width + x) * 4);
    return {p[0], p[1], p[2], p[3]};
}

std::size_t count(const Image& image, const Rgba& colour) {
    std::size_t found = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x)
            found += at(image, x, y) == colour ? 1 : 0;
    }
    return found;
}

constexpr Rgba white{255, 255, 255, 255}, black{0, 0, 0, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255};

TEST(Text, IsWrittenAndScaled) {
    Image small = flat(60, 20, white);
    draw_text(small, 2, 3, 1, "pn", black);
    Image large = flat(120, 40, white);
    draw_text(large, 4, 6, 2, "pn", black);
    EXPECT_GT(count(small, black), 10u);
    for (std::uint32_t y = 0; y < large.height; ++y) {
        for (std::uint32_t x = 0; x < large.width; ++x)
            ASSERT_EQ(at(large, x, y), at(small, x / 2, y / 2)) << x << ", " << y;
    }
    EXPECT_EQ(text_width(2, "pn"), 2 * text_width(1, "pn"));
    EXPECT_GT(text_width(1, "phong"), text_width(1, "pn"));
}

TEST(Text, StaysInsideItsWidthAndTheImage) {
    const std::string words = "The quick brown fox, 0123456789!";
    Image image = flat(text_width(1, words) + 20, 30, white);
    draw_text(image, 10, 5, 1, words, black);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < 10; ++x) {
            EXPECT_EQ(at(image, x, y), white);
            EXPECT_EQ(at(image, image.width - 1 - x, y), white);
        }
    }
    for (const std::int64_t place : {-1'000'000, -3, 5, 28, 1'000'000}) {
        Image cut = flat(30, 30, white);
        draw_text(cut, place, place, 3, words, black);
        EXPECT_LT(count(cut, black), 900u);
    }
}

TEST(Text, OfAnyBytesIsFine) {
    std::string bytes;
    for (int i = 0; i < 256; ++i)
        bytes += static_cast<char>(i);
    Image image = flat(64, 16, white);
    draw_text(image, 0, 0, 1, bytes, black);
    Image question = flat(64, 16, white), control = question;
    draw_text(question, 0, 0, 1, "?", black);
    draw_text(control, 0, 0, 1, "\x7f", black);
    EXPECT_EQ(question.rgba, control.rgba);
    EXPECT_EQ(text_width(1, ""), 0u);
}

TEST(Beside, KeepsEveryPixelAndAddsLabels) {
    const Image whole = beside({{flat(80, 40, red), "left"}, {flat(80, 40, blue), "right"}}, white);
    EXPECT_EQ(whole.width, 160u);
    ASSERT_GT(whole.height, 40u);
    EXPECT_EQ(count(whole, red), 80u * 40u);
    EXPECT_EQ(count(whole, blue), 80u * 40u);
    EXPECT_EQ(at(whole, 79, 39), red);
    EXPECT_EQ(at(whole, 80, 39), blue);
    EXPECT_EQ(at(whole, 0, whole.height - 1), white);
    EXPECT_LT(count(whole, white), 160u * (whole.height - 40u)) << "the labels are there";
    EXPECT_EQ(beside({{flat(80, 40, red), ""}}, white).rgba.size(), 80u * whole.height * 4u);
}

TEST(Beside, LabelsMayHaveLines) {
    const auto paper_rows = [](const std::string& label) {
        return beside({{flat(420, 400, red), label}, {flat(420, 400, red), ""}}, white).height - 400;
    };
    EXPECT_EQ(paper_rows("a\nb"), paper_rows("a") + 24);
    EXPECT_EQ(paper_rows("a\nb\nc"), paper_rows("a") + 48);
    const Image two = beside({{flat(420, 400, red), "one\none"}}, white);
    const Image one = beside({{flat(420, 400, red), "one"}}, white);
    EXPECT_EQ(count(two, {60, 62, 66, 255}), 2 * count(one, {60, 62, 66, 255}));
}

TEST(Beside, LettersShrinkUntilLabelsFit) {
    const auto ink_outside = [](const std::string& label) {
        // The label of the left panel must not reach into the right one.
        const Image whole = beside({{flat(420, 400, red), label}, {flat(420, 400, red), ""}}, white);
        std::size_t found = 0;
        for (std::uint32_t y = 400; y < whole.height; ++y) {
            for (std::uint32_t x = 420; x < whole.width; ++x)
                found += at(whole, x, y) != white ? 1 : 0;
        }
        return found;
    };
    EXPECT_EQ(ink_outside("pn, quadratic normals, 1234567 triangles"), 0u);
    EXPECT_EQ(ink_outside("pn"), 0u);
}

TEST(Beside, RefusesWhatDoesNotFit) {
    EXPECT_THROW(beside({}, white), Error);
    EXPECT_THROW(beside({{flat(8, 4, red), ""}, {flat(8, 5, red), ""}}, white), Error);
    EXPECT_THROW(beside({{flat(max_side, 1, red), ""}, {flat(max_side, 1, red), ""}}, white), Error);
}

}  // namespace
}  // namespace tessera::image
