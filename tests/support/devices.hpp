// The devices of this machine for tests of every room: listed once, opened once, closed before the process ends.
#pragma once

#include "backends/registry.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

namespace tessera::gpu {

/// What GoogleTest prints for a device.
inline void PrintTo(const DeviceInfo& info, std::ostream* out) {
    *out << info.id << " (" << info.name << ")";
}

}  // namespace tessera::gpu

namespace tessera::test {

/// Every usable device and why others are not; looked up once.
const backends::Inventory& machine();

/// A device that stays open for all tests of the binary.
gpu::Device open_device(const std::string& id);

/// Every usable device, open; the reference first.
std::vector<gpu::Device> open_every_device();

/// "vulkan_1" for "vulkan:1": what a test is called on that device.
std::string device_test_name(const testing::TestParamInfo<gpu::DeviceInfo>& device);

}  // namespace tessera::test

/// Instantiates the suite `name`, parametrised over gpu::DeviceInfo, for every device.
#define TESSERA_ON_EVERY_DEVICE(name)                                                       \
    INSTANTIATE_TEST_SUITE_P(On, name, testing::ValuesIn(tessera::test::machine().devices), \
                             tessera::test::device_test_name)
