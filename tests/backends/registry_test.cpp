// What `--device` takes, and what it refuses.
#include "backends/device_suite.hpp"
#include "base/error.hpp"

namespace tessera::backends {
namespace {

template <typename Action>
void expect_error(ErrorKind kind, const Action& action, std::initializer_list<std::string> parts) {
    try {
        action();
        ADD_FAILURE() << "was not refused";
    } catch (const Error& error) {
        const std::string sentence = error.what();
        EXPECT_EQ(error.kind(), kind) << sentence;
        for (const std::string& part : parts) {
            EXPECT_NE(sentence.find(part), std::string::npos) << "no '" << part << "' in: " << sentence;
        }
    }
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

TEST(Registry, OpensEveryListedDeviceByItsId) {
    for (const gpu::DeviceInfo& info : machine().devices) {
        EXPECT_EQ(open_device(info.id).info().id, info.id);
    }
}

TEST(Registry, OpensTheFirstDeviceOfABackend) {
    for (const std::string backend : {"reference", "vulkan", "opencl"}) {
        const auto first = std::ranges::find(machine().devices, backend, &gpu::DeviceInfo::backend);
        if (first != machine().devices.end()) {
            EXPECT_EQ(open_device(backend).info().id, first->id);
            EXPECT_EQ(open_device(upper(backend)).info().id, first->id);
        }
    }
}

TEST(Registry, OpensByPartOfANameInAnyCase) {
    for (const gpu::DeviceInfo& info : machine().devices) {
        if (info.name.size() < 6) {
            continue;
        }
        const std::string part = info.name.substr(0, 5);
        if (std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c) != 0; })) {
            continue;  // would be an index
        }
        for (const std::string& id : {info.backend + ":" + part, info.backend + ":" + upper(part)}) {
            const gpu::Device opened = open_device(id);
            EXPECT_EQ(opened.info().backend, info.backend) << id;
            EXPECT_NE(upper(opened.info().name).find(upper(part)), std::string::npos) << id;
        }
    }
}

TEST(Registry, RefusesWordsThatNameNoBackend) {
    for (const std::string id : {"", "metal", "vulkan1", "refer", " reference", ":0", "0"}) {
        expect_error(ErrorKind::usage, [&] { open_device(id); }, {"'" + id + "'", "reference, vulkan or opencl"});
    }
    for (const std::string id : {"reference:", "vulkan:", "opencl:"}) {
        expect_error(ErrorKind::usage, [&] { open_device(id); }, {"'" + id + "'", "after its colon"});
    }
    expect_error(ErrorKind::usage, [] { open_rasteriser("metal"); }, {"'metal'"});
}

TEST(Registry, TellsWhatWasFoundInstead) {
    for (const std::string id : {"vulkan:99", "opencl:no such device", "reference:1", "vulkan:99999999999999999999"}) {
        expect_error(ErrorKind::device_unavailable, [&] { open_device(id); },
                     {"'" + id + "'", "reference (" + machine().devices[0].name + ")"});
    }
    for (const gpu::UnusableDevice& missing : machine().unusable) {
        expect_error(ErrorKind::device_unavailable, [] { open_device("vulkan:99"); }, {missing.id, missing.reason});
    }
}

TEST(Registry, OpensARasteriserWhereThereIsOne) {
    const bool draws = std::ranges::any_of(machine().devices, &gpu::DeviceInfo::rasteriser);
    if (!draws) {
        expect_error(ErrorKind::device_unavailable, [] { open_rasteriser(); }, {"draws triangles", "reference ("});
        return;
    }
    EXPECT_NE(open_rasteriser(), nullptr);
    EXPECT_NE(open_rasteriser("reference"), nullptr) << "a device that cannot draw leaves it to the first that can";
    expect_error(ErrorKind::device_unavailable, [] { open_rasteriser("vulkan:99"); }, {"'vulkan:99'"});
}

}  // namespace
}  // namespace tessera::backends
