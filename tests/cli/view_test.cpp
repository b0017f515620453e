// The views of render that have legends, and sequences of pictures.
#include "cli/progress.hpp"
#include "cli/run.hpp"
#include "image/image.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <span>

namespace tessera::test {
namespace {

class Views : public testing::Test {
protected:
    /// A picture of 64 x 64 pixels of an icosahedron by the reference; empty where that failed.
    image::Image render(const std::vector<std::string>& words) {
        std::vector<std::string> call{
            "render", "shape:icosahedron", "-o", folder.file("picture.png"), "--size", "64x64", "-q"};
        call.insert(call.end(), words.begin(), words.end());
        const Result result = run(call);
        EXPECT_EQ(result.code, 0) << result.errors;
        if (result.code != 0) return {};
        const std::string bytes = read_file(folder.file("picture.png"));
        return image::decode(std::as_bytes(std::span(bytes)), "picture");
    }

    /// The bytes of one panel, without what is under it.
    static std::vector<std::uint8_t> panel(const image::Image& picture, std::size_t which) {
        std::vector<std::uint8_t> bytes;
        for (std::size_t y = 0; y < 64; ++y) {
            const auto row = picture.rgba.begin() + static_cast<std::ptrdiff_t>((y * picture.width + which * 64) * 4);
            bytes.insert(bytes.end(), row, row + 256);
        }
        return bytes;
    }

    void expect_refusal(std::vector<std::string> words, const std::string& said) {
        words.insert(words.begin(), {"render", "shape:cube", "--size", "16x16"});
        const Result result = run(words);
        EXPECT_EQ(result.code, 2) << result.errors;
        EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
        EXPECT_NE(result.errors.find(said), std::string::npos) << result.errors;
        EXPECT_TRUE(folder.names().empty()) << result.errors;
    }

    const Folder folder;
};

TEST_F(Views, HaveALegendUnderThePicture) {
    for (const char* view : {"factors", "scheme-difference", "silhouette"}) {
        const image::Image picture = render({"--view", view});
        EXPECT_EQ(picture.width, 64u) << view;
        EXPECT_GT(picture.height, 70u) << view;
        EXPECT_NE(panel(picture, 0), panel(render({}), 0)) << view;
    }
}

TEST_F(Views, FactorsAreThoseOfTheJob) {
    const auto shown = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"--view", "factors", "--range", "1..9"};
        all.insert(all.end(), words.begin(), words.end());
        return panel(render(all), 0);
    };
    EXPECT_NE(shown({"--factor", "3"}), shown({"--factor", "7"}));
    EXPECT_NE(shown({"--factor", "3"}), shown({"--factor", "3,3,5,3"}));
    EXPECT_NE(shown({"--factor", "3"}), shown({"--factor", "random:1..9"}));
    // One factor for all has the middle of its own scale, whatever it is.
    EXPECT_EQ(panel(render({"--view", "factors", "--scheme", "linear", "--factor", "4"}), 0),
              panel(render({"--view", "factors", "--scheme", "linear", "--factor", "4", "--range", "0..8"}), 0));
}

TEST_F(Views, ComparedHaveOneScale) {
    // Pictures are framed together: a camera of our own tells scales apart.
    const std::vector<std::string> camera{"--camera",          "eye=0,0,4,fovy=40", "--view",
                                          "scheme-difference", "--factor",          "5"};
    const auto seen = [&](std::vector<std::string> words) {
        words.insert(words.end(), camera.begin(), camera.end());
        return render(words);
    };
    const image::Image together = seen({"--compare", "phong,pn"});
    const bool phong_is_larger = panel(together, 0) == panel(seen({"--scheme", "phong"}), 0);
    const bool pn_is_larger = panel(together, 1) == panel(seen({"--scheme", "pn"}), 0);
    EXPECT_NE(phong_is_larger, pn_is_larger) << "the larger one's scale holds for both";
    EXPECT_EQ(together.width, 128u);
}

TEST_F(Views, NormalsMayDifferBetweenPanels) {
    const image::Image picture = render({"--compare", "linear:true,pn:linear,pn:quadratic", "--view", "normals"});
    ASSERT_EQ(picture.width, 192u);
    EXPECT_NE(panel(picture, 1), panel(picture, 2));
    const image::Image same = render({"--compare", "pn,pn:quadratic", "--view", "normals"});
    EXPECT_EQ(panel(same, 0), panel(same, 1));
}

TEST_F(Views, FramesAreNumbered) {
    const auto write = [&](const std::vector<std::string>& words) {
        std::vector<std::string> call{"render", "shape:cube", "--size", "16x16", "--factor", "1", "--turntable", "3"};
        call.insert(call.end(), words.begin(), words.end());
        const Result result = run(call);
        EXPECT_EQ(result.code, 0) << result.errors;
    };
    const auto names_in = [&](const std::string& name) {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.file(name)))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    };
    write({"--frames", folder.file("new/frames")});
    EXPECT_EQ(names_in("new/frames"), (std::vector<std::string>{"0000.png", "0001.png", "0002.png"}));
    write({"--frames", folder.file("other/f%02d.png"), "-o", folder.file("turn.apng")});
    EXPECT_EQ(names_in("other"), (std::vector<std::string>{"f00.png", "f01.png", "f02.png"}));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"new", "other", "turn.apng"}));
    EXPECT_EQ(read_file(folder.file("other/f01.png")), read_file(folder.file("new/frames/0001.png")));
}

TEST_F(Views, BadWordsAreRefused) {
    const std::string out = folder.file("x.png");
    expect_refusal({"-o", out, "--view", "nice"}, "choose shaded");
    expect_refusal({"-o", out, "--view", "factors", "--against", "pn"}, "--against");
    expect_refusal({"-o", out, "--view", "scheme-difference", "--against", "bezier"}, "\"bezier\"");
    expect_refusal({"-o", out, "--view", "depth", "--range", "0..1"}, "--range");
    for (const char* range : {"3..1", "1..1", "1", "..", "a..b", "0..nan", "0..2x"})
        expect_refusal({"-o", out, "--view", "factors", "--range", range}, range);
    expect_refusal({"-o", out, "--compare", "pn:odd"}, "\"odd\"");
    expect_refusal({"-o", out, "--compare", "pn,:linear"}, "\"\"");
    expect_refusal({}, "-o FILE.png");
    expect_refusal({"--frames", folder.file("f")}, "--turntable N");
    expect_refusal({"-o", out, "--turntable", "2", "--frames", folder.file("f")}, "twice");
    expect_refusal({"--turntable", "2", "--frames", folder.file("%q")}, "%d");
}

TEST_F(Views, FramesThatCannotBeWrittenEndWithFour) {
    write_file(folder.file("file"), "");
    const Result result =
        run({"render", "shape:cube", "--size", "16x16", "--turntable", "2", "--frames", folder.file("file/frames")});
    EXPECT_EQ(result.code, 4) << result.errors;
    EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
}

TEST_F(Views, HairIsShownOrLeftOut) {
    const std::string out = folder.file("x.png");
    const auto draw = [&](const char* view) {
        return run({"render", "assets/furball.glb", "-o", out, "--size", "32x32", "--hairs", "1", "--view", view});
    };
    EXPECT_EQ(draw("factors").code, 0);
    EXPECT_EQ(draw("scheme-difference").code, 0);
    const Result silhouette = draw("silhouette");
    EXPECT_EQ(silhouette.code, 0);
    EXPECT_NE(silhouette.errors.find("leaves the hair out"), std::string::npos) << silhouette.errors;
}

TEST(Progress, IsABarThatFits) {
    EXPECT_EQ(cli::progress_line("drawing", 0.5, 24), "drawing [####----]  50 %");
    EXPECT_EQ(cli::progress_line("drawing", 0.0, 24), "drawing [--------]   0 %");
    EXPECT_EQ(cli::progress_line("drawing", 1.2, 24), "drawing [########] 100 %");
    EXPECT_EQ(cli::progress_line("drawing", 0.5, 18), "drawing  50 %");
    EXPECT_EQ(cli::progress_line("drawing", 0.5, 5), "drawi");
    EXPECT_LE(cli::progress_line("drawing", 0.5, 200).size(), 60u) << "no longer than needed";
}

}  // namespace
}  // namespace tessera::test
