#include "support/devices.hpp"

#include "backends/vulkan/validation.hpp"
#include "support/environment.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace tessera::test {
namespace {

/// Drivers may be gone when static objects are destroyed, so devices are closed by TearDown.
class OpenDevices : public testing::Environment {
public:
    gpu::Device get(const std::string& id) {
        auto found = devices_.find(id);
        if (found == devices_.end()) {
            found = devices_.emplace(id, backends::open_device(id)).first;
        }
        return found->second;
    }
    void SetUp() override {
        for (const gpu::DeviceInfo& info : machine().devices) {
            fmt::print("[ DEVICE   ] {} ({})\n", info.id, info.name);
        }
    }
    void TearDown() override {
        devices_.clear();
        for (const std::string& message : backends::vulkan::take_validation_messages()) {
            ADD_FAILURE() << message;
        }
    }

private:
    std::map<std::string, gpu::Device> devices_;
};

OpenDevices* const open_devices = static_cast<OpenDevices*>(testing::AddGlobalTestEnvironment(new OpenDevices));

/// Fails where everything is required, skips elsewhere, when no device of the backend has `part` in its name.
void expect_device(const std::string& backend, const std::string& part) {
    const bool there = std::ranges::any_of(machine().devices, [&](const gpu::DeviceInfo& info) {
        return info.backend == backend && info.name.find(part) != std::string::npos;
    });
    if (!there && everything_required()) {
        FAIL() << backend << " device '" << part << "' is required but missing";
    }
    if (!there) {
        GTEST_SKIP() << backend << " device '" << part << "' is missing: nothing here ran on it";
    }
}

TEST(Machine, HasReference) {
    expect_device("reference", "");
}
TEST(Machine, HasLavapipe) {
    expect_device("vulkan", "llvmpipe");
}
TEST(Machine, HasSwiftShader) {
    expect_device("vulkan", "SwiftShader");
}
TEST(Machine, HasOpenCl) {
    expect_device("opencl", "");
}

}  // namespace

const backends::Inventory& machine() {
    static const backends::Inventory inventory = backends::list_devices();
    return inventory;
}

gpu::Device open_device(const std::string& id) {
    return open_devices->get(id);
}

std::vector<gpu::Device> open_every_device() {
    std::vector<gpu::Device> devices;
    for (const gpu::DeviceInfo& info : machine().devices) {
        devices.push_back(open_device(info.id));
    }
    return devices;
}

std::string device_test_name(const testing::TestParamInfo<gpu::DeviceInfo>& device) {
    std::string name = device.param.id;
    std::ranges::replace(name, ':', '_');
    return name;
}

}  // namespace tessera::test
