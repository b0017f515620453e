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

TEST(MissingDevices, RenderingNeedsARasteriser) {
    const Folder folder;
    const Result result = run({"render", "shape:torus", "-o", folder.file("out.png")}, no_devices());
    EXPECT_EQ(result.code, 3) << result.errors;
    EXPECT_TRUE(folder.names().empty());
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
