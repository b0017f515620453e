// What the tests of the device room share: two null devices, kernels, and a check of refusals.
#pragma once

#include "base/error.hpp"
#include "gpu/device.hpp"
#include "gpu/null_backend.hpp"

#include <gtest/gtest.h>

namespace tessera::gpu {

/// Expects that `action` throws Error(usage) with a sentence that contains every one of `parts`.
template <typename Action>
void expect_refused(const Action& action, std::initializer_list<std::string_view> parts) {
    try {
        action();
        ADD_FAILURE() << "was not refused; expected a sentence with '" << *parts.begin() << "'";
    } catch (const Error& error) {
        const std::string sentence = error.what();
        EXPECT_EQ(error.kind(), ErrorKind::usage) << sentence;
        EXPECT_TRUE(sentence.ends_with('.')) << sentence;
        for (const std::string_view part : parts) {
            EXPECT_NE(sentence.find(part), std::string::npos) << "no '" << part << "' in: " << sentence;
        }
    }
}

inline Kernel kernel_of(std::string name, std::vector<KernelBinding> bindings) {
    Kernel kernel;
    kernel.name = std::move(name);
    kernel.bindings = std::move(bindings);
    return kernel;
}

/// Reads slot 0, writes slot 1, takes a uniform of 8 bytes in slot 2.
inline Kernel scale_kernel(std::string name = "scale") {
    return kernel_of(
        std::move(name),
        {{0, BindingKind::read_storage, 4}, {1, BindingKind::write_storage, 4}, {2, BindingKind::uniform, 8}});
}

inline DeviceInfo null_info() {
    DeviceInfo info;
    info.id = "null:0";
    info.backend = "null";
    info.name = "no device";
    info.timestamps = true;
    info.limits.max_storage_binding_size = 4096;
    info.limits.max_uniform_binding_size = 1024;
    info.limits.max_buffer_size = 8192;
    info.limits.max_workgroups_per_dimension = 1000;
    return info;
}

class NullDeviceTest : public testing::Test {
protected:
    Buffer buffer(std::string label, std::uint64_t size, BufferUsage usage) {
        return device.create_buffer({std::move(label), size, usage});
    }
    Buffer storage(std::string label, std::uint64_t size = 1024) {
        return buffer(std::move(label), size,
                      BufferUsage::storage | BufferUsage::copy_source | BufferUsage::copy_destination);
    }
    Buffer uniform(std::string label, std::uint64_t size = 1024) {
        return buffer(std::move(label), size, BufferUsage::uniform | BufferUsage::copy_destination);
    }
    /// The recorded command `index` as a T; fails the test where it is something else.
    template <typename T>
    T command(std::size_t index) {
        if (index >= log.commands.size() || !std::holds_alternative<T>(log.commands[index])) {
            ADD_FAILURE() << "command " << index << " of " << log.commands.size() << " is not of that kind";
            return {};
        }
        return std::get<T>(log.commands[index]);
    }

    NullLog log;
    NullLog other_log;
    Device device{std::make_unique<NullBackend>(log, null_info())};
    Device other_device{std::make_unique<NullBackend>(other_log, null_info())};
};

}  // namespace tessera::gpu
