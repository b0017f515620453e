// The pipeline cache on disk: guarded, replaced whole, and never in the way.
#include "backends/vulkan/pipeline_cache.hpp"

#include <fstream>

#include "backends/vulkan/suitability.hpp"
#include "vulkan/each_device.hpp"
#include "vulkan/scoped_variable.hpp"

namespace tessera::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> some_bytes(std::size_t count) {
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i)
        bytes[i] = static_cast<std::byte>(i * 37 + 11);
    return bytes;
}

fs::path fresh_folder() {
    const fs::path folder = fs::temp_directory_path() / ("tessera-cache-test-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

TEST(VulkanPipelineCache, SealedDataComesBack) {
    for (const std::size_t size : {0u, 1u, 1000u}) {
        EXPECT_EQ(vulkan::unseal(vulkan::seal(some_bytes(size))), some_bytes(size));
    }
}

TEST(VulkanPipelineCache, AnyChangeIsSeen) {
    const std::vector<std::byte> file = vulkan::seal(some_bytes(40));
    for (std::size_t i = 0; i < file.size(); ++i) {
        std::vector<std::byte> altered = file;
        altered[i] ^= std::byte{4};
        EXPECT_FALSE(vulkan::unseal(altered)) << "byte " << i;
        EXPECT_FALSE(vulkan::unseal(std::span(file).first(i))) << "cut to " << i;
    }
}

TEST(VulkanPipelineCache, OnlyDataOfThisDriverIsTaken) {
    vk::PhysicalDeviceProperties properties;
    properties.vendorID = 7;
    properties.deviceID = 9;
    VkPipelineCacheHeaderVersionOne header{32, VK_PIPELINE_CACHE_HEADER_VERSION_ONE, 7, 9, {}};
    const auto taken = [&] { return vulkan::made_by(std::as_bytes(std::span(&header, 1)), properties); };
    EXPECT_TRUE(taken());
    header.deviceID = 10;
    EXPECT_FALSE(taken());
    header = {33, VK_PIPELINE_CACHE_HEADER_VERSION_ONE, 7, 9, {}};
    EXPECT_FALSE(taken());
    header = {32, VK_PIPELINE_CACHE_HEADER_VERSION_ONE, 7, 9, {1}};
    EXPECT_FALSE(taken());
}

/// Opens a device, compiles a kernel, closes it again.
void use_a_kernel(std::size_t index) {
    Opened on(index, vulkan::HostAccess::automatic);
    on.device.create_compute_pipeline(gpu::find_kernel("scale_probe"));
}

TEST(VulkanPipelineCache, AFilePerDeviceIsWrittenAndSurvivesDamage) {
    const auto devices = vulkan::list().devices;
    if (devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const fs::path folder = fresh_folder();
    const ScopedVariable cache("XDG_CACHE_HOME", folder.string());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const fs::path file = vulkan::cache_file(vulkan::create_context(i)).value();
        use_a_kernel(i);
        ASSERT_TRUE(fs::is_regular_file(file)) << file;
        const auto size = fs::file_size(file);
        std::ofstream(file, std::ios::binary | std::ios::trunc) << "not a cache";
        use_a_kernel(i);
        EXPECT_EQ(fs::file_size(file), size) << "a damaged file is ignored and replaced";
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "tessera"), fs::directory_iterator()),
              static_cast<std::ptrdiff_t>(devices.size()))
        << "a file each, and no temporary ones";
    fs::remove_all(folder);
    expect_no_messages();
}

TEST(VulkanPipelineCache, AFolderThatCannotBeMadeIsNoError) {
    const auto devices = vulkan::list().devices;
    if (devices.empty()) GTEST_SKIP() << "needs a Vulkan device";
    const fs::path folder = fresh_folder();
    std::ofstream(folder / "file") << "in the way";
    const ScopedVariable cache("XDG_CACHE_HOME", (folder / "file").string());
    EXPECT_NO_THROW(use_a_kernel(0));
    fs::remove_all(folder);
    expect_no_messages();
}

}  // namespace
}  // namespace tessera::test
