// PNG and JPEG in and out, halving and differences.
#include "image/image.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <random>

namespace tessera::image {
namespace {

/// A JPEG of 16 x 16 pixels, quality 80, blocks of 8 x 8: top left (220, 200, 60), top right (20, 200, 60), bottom left
/// (220, 40, 60), bottom right (20, 40, 60).
constexpr std::string_view jpeg_hex =
    "ffd8ffe000104a46494600010100000100010000ffdb00840006040506050406060506070706080a100a0a09090a140e"
    "0f0c1017141818171416161a1d251f1a1b231c1616202c20232627292a29191f2d302d283025282928010707070a080a"
    "130a0a13281a161a28282828282828282828282828282828282828282828282828282828282828282828282828282828"
    "28282828282828282828ffc00011080010001003012200021101031101ffc401a2000001050101010101010000000000"
    "0000000102030405060708090a0b100002010303020403050504040000017d0102030004110512213141061351610722"
    "7114328191a1082342b1c11552d1f02433627282090a161718191a25262728292a3435363738393a434445464748494a"
    "535455565758595a636465666768696a737475767778797a838485868788898a92939495969798999aa2a3a4a5a6a7a8"
    "a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3d4d5d6d7d8d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9"
    "fa0100030101010101010101010000000000000102030405060708090a0b110002010204040304070504040001027700"
    "0102031104052131061241510761711322328108144291a1b1c109233352f0156272d10a162434e125f11718191a2627"
    "28292a35363738393a434445464748494a535455565758595a636465666768696a737475767778797a82838485868788"
    "898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3d4d5d6d7d8d9dae2"
    "e3e4e5e6e7e8e9eaf2f3f4f5f6f7f8f9faffda000c03010002110311003f00f53af2fae46bcc2be772ec93e2fde76e9e"
    "be66dc69c39fc0fde7f374ff000f99ffd9";

std::vector<std::byte> from_hex(std::string_view hex) {
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        bytes.push_back(static_cast<std::byte>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    }
    return bytes;
}

Image random_image(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    Image image{width, height, {}};
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < std::size_t{width} * height * 4; ++i) {
        image.rgba.push_back(static_cast<std::uint8_t>(random()));
    }
    return image;
}

Image filled(std::uint32_t width, std::uint32_t height, std::array<std::uint8_t, 4> colour) {
    Image image{width, height, {}};
    image.rgba.resize(std::size_t{width} * height * 4);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        image.rgba[i] = colour[i % 4];
    return image;
}

std::string refusal(const std::vector<std::byte>& bytes) {
    try {
        decode(bytes, "picture");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("'picture'"), std::string::npos) << error.what();
        return error.what();
    }
    return "";
}

/// A folder that is gone after the test.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("tessera-image-" + std::to_string(std::random_device{}()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

RC_GTEST_PROP(Png, ComesBackAsItWas, ()) {
    const auto width = *rc::gen::inRange<std::uint32_t>(1, 40);
    const auto height = *rc::gen::inRange<std::uint32_t>(1, 40);
    const Image image = random_image(width, height, *rc::gen::arbitrary<std::uint32_t>());
    const Image back = decode(encode_png(image), "back");
    RC_ASSERT(back.width == width);
    RC_ASSERT(back.height == height);
    RC_ASSERT(back.rgba == image.rgba);
}

TEST(Png, IsRenamedIntoPlaceAndLeavesNothingElse) {
    const Folder folder;
    const Image first = random_image(5, 3, 1);
    const Image second = random_image(7, 2, 2);
    write_png(first, folder.path / "a.png");
    write_png(second, folder.path / "a.png");
    std::ifstream file(folder.path / "a.png", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(decode(std::as_bytes(std::span(text)), "a.png").rgba, second.rgba);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

TEST(Png, ThatCannotBeWrittenIsAnOutputErrorAndLeavesNothing) {
    const Folder folder;
    std::filesystem::create_directory(folder.path / "taken.png");
    for (const auto& target : {folder.path / "missing" / "a.png", folder.path / "taken.png"}) {
        try {
            write_png(random_image(2, 2, 1), target);
            ADD_FAILURE() << target << " was written";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::output);
            EXPECT_NE(std::string(error.what()).find(target.string()), std::string::npos) << error.what();
        }
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

TEST(Png, RefusesAnImageThatIsNotWhatItSays) {
    EXPECT_THROW(encode_png({0, 4, {}}), Error);
    EXPECT_THROW(encode_png({max_side + 1, 1, std::vector<std::uint8_t>((max_side + 1) * 4)}), Error);
    EXPECT_THROW(encode_png({2, 2, std::vector<std::uint8_t>(15)}), Error);
}

TEST(Jpeg, IsDecodedTopRowFirst) {
    const Image image = decode(from_hex(jpeg_hex), "jpeg");
    ASSERT_EQ(image.width, 16u);
    ASSERT_EQ(image.height, 16u);
    const auto expect_colour = [&](std::size_t x, std::size_t y, std::array<int, 4> colour) {
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(image.rgba[(y * 16 + x) * 4 + c], colour[c], 8) << x << ", " << y << ", channel " << c;
        }
    };
    expect_colour(2, 2, {220, 200, 60, 255});
    expect_colour(13, 2, {20, 200, 60, 255});
    expect_colour(2, 13, {220, 40, 60, 255});
    expect_colour(13, 13, {20, 40, 60, 255});
}

TEST(Decode, RefusesWhatIsNoImage) {
    EXPECT_NE(refusal({}).find("empty"), std::string::npos);
    EXPECT_NE(refusal(from_hex("00112233445566778899")), "");
    std::vector<std::byte> cut = encode_png(random_image(20, 20, 1));
    cut.resize(cut.size() / 2);
    EXPECT_NE(refusal(cut), "");
}

TEST(Decode, RefusesLargeSidesBeforeItAllocates) {
    // A sound header that claims 16385 x 1 pixels, then 2^31 - 1 squared.
    std::vector<std::byte> png = encode_png(random_image(1, 1, 1));
    png[18] = std::byte{0x40};
    png[19] = std::byte{0x01};
    EXPECT_NE(refusal(png).find("16384"), std::string::npos);
    for (std::size_t i = 16; i < 24; ++i)
        png[i] = std::byte{i % 4 == 0 ? std::uint8_t{0x7f} : std::uint8_t{0xff}};
    EXPECT_NE(refusal(png).find("16384"), std::string::npos);
}

TEST(Jpeg, WithAnOverfullHuffmanTableIsRefused) {
    // Sixteen counts that add up to 257, in the header and again between scans.
    const std::string overfull =
        "ffc4011400"
        "ff020000000000000000000000000000" +
        std::string(257 * 2, '0');
    const std::string jpeg(jpeg_hex);
    EXPECT_NE(refusal(from_hex("ffd8" + overfull + jpeg.substr(4))).find("256 codes"), std::string::npos);
    const std::string without_end = jpeg.substr(0, jpeg.size() - 4);
    EXPECT_NE(refusal(from_hex(without_end + overfull + "ffd9")).find("256 codes"), std::string::npos);
}

TEST(Decode, SurvivesDamage) {
    // TESSERA_FUZZ_ROUNDS asks for more than the usual.
    const char* asked = std::getenv("TESSERA_FUZZ_ROUNDS");
    const int rounds = asked != nullptr ? std::stoi(asked) : 3000;
    std::mt19937 random(static_cast<std::uint32_t>(rounds));
    std::vector<std::byte> progressive = from_hex(jpeg_hex);
    for (std::size_t i = 0; i + 1 < progressive.size(); ++i) {
        if (progressive[i] == std::byte{0xff} && progressive[i + 1] == std::byte{0xc0})
            progressive[i + 1] |= std::byte{2};
    }
    for (const std::vector<std::byte>& sound : {encode_png(random_image(12, 9, 3)), from_hex(jpeg_hex), progressive}) {
        for (int round = 0; round < rounds; ++round) {
            std::vector<std::byte> bytes = sound;
            for (int hits = 1 + static_cast<int>(random() % 4); hits > 0; --hits) {
                bytes[random() % bytes.size()] = static_cast<std::byte>(random());
            }
            if (random() % 4 == 0) bytes.resize(random() % bytes.size());
            try {
                const Image image = decode(bytes, "damaged");
                EXPECT_EQ(image.rgba.size(), std::size_t{image.width} * image.height * 4);
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::usage);
            }
        }
    }
}

TEST(Halve, KeepsEveryFlatColour) {
    for (int step = 0; step < 256; ++step) {
        const auto s = static_cast<std::uint8_t>(step);
        const std::array<std::uint8_t, 4> colour{s, static_cast<std::uint8_t>(255 - step), s, 255};
        EXPECT_EQ(halve(filled(5, 3, colour)).rgba, filled(2, 1, colour).rgba) << step;
    }
}

TEST(Halve, AveragesInLinearLight) {
    Image image = filled(2, 1, {0, 0, 0, 255});
    std::fill_n(image.rgba.begin(), 3, std::uint8_t{255});
    // Half the light of white is 188 in sRGB.
    EXPECT_EQ(halve(image).rgba, filled(1, 1, {188, 188, 188, 255}).rgba);
}

TEST(Halve, HidesColoursOfTransparentPixels) {
    Image image = filled(2, 2, {200, 10, 10, 255});
    for (std::size_t i = 0; i < 2; ++i) {
        image.rgba[i * 4] = 0;
        image.rgba[i * 4 + 1] = 255;
        image.rgba[i * 4 + 3] = 0;
    }
    EXPECT_EQ(halve(image).rgba, filled(1, 1, {200, 10, 10, 128}).rgba);
}

TEST(Halve, CoversOddSidesToTheLastPixel) {
    Image image = filled(1, 3, {0, 0, 0, 255});
    image.rgba[8] = 255;  // red in the last row
    const Image half = halve(image);
    EXPECT_EQ(half.width, 1u);
    EXPECT_EQ(half.height, 1u);
    EXPECT_NEAR(half.rgba[0], 156, 1);  // a third of the light
}

TEST(Difference, CountsPixelsAndChannels) {
    const Image a = filled(4, 2, {10, 20, 30, 40});
    Image b = a;
    EXPECT_EQ(difference(a, b).max, 0u);
    b.rgba[0] = 13;
    b.rgba[1] = 15;
    b.rgba[31] = 41;
    const Difference all = difference(a, b);
    EXPECT_EQ(all.max, 5u);
    EXPECT_EQ(all.count_over, 2u);
    EXPECT_DOUBLE_EQ(all.mean, 9.0 / 32.0);
    EXPECT_EQ(difference(a, b, 1).count_over, 1u);
    EXPECT_THROW(difference(a, filled(2, 4, {10, 20, 30, 40})), Error);
}

}  // namespace
}  // namespace tessera::image
