#include "backends/device_suite.hpp"

#include "backends/vulkan/validation.hpp"

#include <map>
#include <random>

namespace tessera::backends {

namespace {

/// Devices opened so far. Closed by TearDown, for drivers may be gone when static objects are destroyed.
class OpenDevices : public testing::Environment {
public:
    gpu::Device get(const std::string& id) {
        auto found = devices_.find(id);
        if (found == devices_.end()) {
            found = devices_.emplace(id, open_device(id)).first;
        }
        return found->second;
    }
    void TearDown() override { devices_.clear(); }

private:
    std::map<std::string, gpu::Device> devices_;
};

OpenDevices* const open_devices = static_cast<OpenDevices*>(testing::AddGlobalTestEnvironment(new OpenDevices));

}  // namespace

const Inventory& machine() {
    static const Inventory inventory = list_devices();
    return inventory;
}

std::string test_name(const testing::TestParamInfo<gpu::DeviceInfo>& device) {
    std::string name = device.param.id;
    std::ranges::replace(name, ':', '_');
    return name;
}

std::vector<float> scaled(std::span<const float> input, float factor) {
    std::vector<float> result(input.size());
    std::ranges::transform(input, result.begin(), [=](float value) { return value * factor + 1.0f; });
    return result;
}

std::vector<float> noise(std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(-2.0f, 2.0f);
    std::vector<float> values(count);
    std::ranges::generate(values, [&] { return uniform(random); });
    return values;
}

DeviceTest::DeviceTest()
    : device(open_devices->get(GetParam().id)),
      queue(device.queue()),
      scale(device.create_compute_pipeline(gpu::find_kernel("scale_probe"))) {}

void DeviceTest::TearDown() {
    for (const std::string& message : vulkan::take_validation_messages()) {
        ADD_FAILURE() << message;
    }
}

}  // namespace tessera::backends
