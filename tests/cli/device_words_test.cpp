// Devices that are not there.
#include "cli/run.hpp"

#include <gtest/gtest.h>

namespace tessera::test {
namespace {

TEST(MissingDevices, ExitWithThree) {
    const Folder folder;
    for (const char* device : {"vulkan", "vulkan:0", "vulkan:voodoo", "opencl", "opencl:7"}) {
        const Result result =
            run({"tessellate", "shape:torus", "-o", folder.file("out.glb"), "--device", device}, no_devices());
        EXPECT_EQ(result.code, 3) << device << ": " << result.errors;
        // A sentence, then what there is instead and why the rest is not usable.
        EXPECT_TRUE(result.errors.starts_with(std::string("tessera: Device '") + device + "' is not there"))
            << result.errors;
        EXPECT_NE(result.errors.find("reference"), std::string::npos) << result.errors;
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(MissingDevices, UnknownWordsAreAMatterOfUsage) {
    for (const char* device : {"quantum", "", "vulcan"}) {
        const Result result = run({"pattern", "--factors", "3", "--device", device}, no_devices());
        EXPECT_EQ(result.code, 2) << device << ": " << result.errors;
        EXPECT_TRUE(is_one_sentence(result.errors)) << result.errors;
    }
}

/// Without a Vulkan loader, without any OpenCL platform.
const std::vector<std::string> no_vulkan{"TESSERA_VULKAN_LOADER=/nonexistent"};
const std::vector<std::string> no_opencl{"OCL_ICD_VENDORS=/nonexistent"};

TEST(MissingDevices, RenderingWorksWithoutThem) {
    const Folder folder;
    const auto render = [&](const std::string& name, const std::string& device,
                            const std::vector<std::string>& environment, const std::string& raster = "auto") {
        const Result result = run({"render", "shape:torus", "-o", folder.file(name), "--device", device, "--size",
                                   "90x70", "--raster", raster},
                                  environment);
        EXPECT_EQ(result.code, 0) << name << ": " << result.errors;
        return read_file(folder.file(name));
    };
    const std::string reference = render("reference.png", "reference", no_devices());
    EXPECT_FALSE(reference.empty());
    EXPECT_EQ(render("hidden.png", "reference", no_vulkan), reference);
    EXPECT_EQ(render("opencl.png", "opencl", no_vulkan), reference);
    EXPECT_FALSE(render("vulkan.png", "vulkan", no_opencl).empty());
    EXPECT_EQ(render("portable.png", "vulkan", no_opencl, "portable"), reference);
}

TEST(Raster, IsChosenByWords) {
    const Folder folder;
    const auto render = [&](const std::string& name, std::vector<std::string> words) {
        words.insert(words.begin(), {"render", "shape:torus", "-o", folder.file(name), "--size", "90x70"});
        const Result result = run(words);
        EXPECT_EQ(result.code, 0) << name << ": " << result.errors;
        return read_file(folder.file(name));
    };
    const std::string portable = render("a.png", {"--raster", "portable"});
    EXPECT_EQ(render("b.png", {"--raster", "portable", "--device", "vulkan"}), portable);
    EXPECT_NE(render("c.png", {"--raster", "device", "--device", "vulkan"}), portable);
    const std::string single = render("d.png", {"--samples", "1", "--device", "vulkan"});  // portable, for it can
    EXPECT_EQ(render("e.png", {"--samples", "1"}), single);
    EXPECT_NE(single, portable);
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--raster", "device"},
                                                  {"--samples", "3"},
                                                  {"--raster", "hand"},
                                                  {"--raster", "device", "--device", "vulkan", "--samples", "1"}}) {
        std::vector<std::string> words{"render", "shape:torus", "-o", folder.file("no.png")};
        words.insert(words.end(), wrong.begin(), wrong.end());
        EXPECT_EQ(run(words).code, 2) << wrong[1];
    }
}

TEST(MissingDevices, VerifyFailsWhereARequiredBackendIsMissing) {
    const Result without = run({"verify", "shape:cube", "--require", "opencl"}, {"OCL_ICD_VENDORS=/nonexistent"});
    EXPECT_EQ(without.code, 3) << without.errors;
    EXPECT_NE(without.errors.find("opencl"), std::string::npos);
    const Result nothing = run({"verify", "shape:cube", "--require", "vulkan,opencl"}, no_devices());
    EXPECT_EQ(nothing.code, 3);
    EXPECT_EQ(run({"verify", "shape:cube", "--require", "reference"}, no_devices()).code, 0);
}

TEST(MissingDevices, VerifySaysWhatIsLeftOut) {
    const Result result = run({"verify", "shape:cube"}, no_devices());
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.errors.find("left out"), std::string::npos) << result.errors;
}

}  // namespace
}  // namespace tessera::test
