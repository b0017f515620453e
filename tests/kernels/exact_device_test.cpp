// exact.h on every device: equal bits with the host over four million arguments of every kind.
#include "exact.h"
#include "gpu/kernel_catalog.hpp"
#include "layout.h"
#include "support/devices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

namespace tessera::kernels {
namespace {

constexpr std::uint32_t sample = 1u << 22;

struct Inputs {
    std::vector<float> numerators, arguments;
};

/// Arguments with random bits, denormals, infinities and NaN among them. Numerators are chosen so that no quotient is
/// denormal: such a product is a device's own affair, and the kernels never make one.
Inputs make_inputs() {
    constexpr std::array<uint, 16> special{0x00000000u, 0x80000000u, 0x00000001u, 0x80000001u, 0x007fffffu, 0x00800000u,
                                           0x3f800000u, 0xbf800000u, 0x7e800000u, 0x7e800001u, 0x7f7fffffu, 0xff7fffffu,
                                           0x7f800000u, 0xff800000u, 0x7fc00000u, 0x40000000u};
    std::mt19937 random(3);
    Inputs inputs;
    for (std::uint32_t i = 0; i < sample; ++i) {
        const uint bits = i < special.size() ? special[i] : static_cast<uint>(random());
        const uint exponent = bits >> 23u & 0xffu;
        const uint wanted = std::clamp(exponent + static_cast<uint>(random() % 81u), 41u, 294u) - 40u;
        inputs.arguments.push_back(bits_float(bits));
        inputs.numerators.push_back(bits_float(wanted << 23u | (random() & 0x807fffffu)));
    }
    return inputs;
}

/// Devices may choose the sign and payload of a NaN.
float canonical(float x) {
    return std::isnan(x) ? bits_float(0x7fc00000u) : x;
}

class ExactProbe : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(ExactProbe, GivesTheBitsOfTheHost) {
    using gpu::BufferUsage;
    gpu::Device device = test::open_device(GetParam().id);
    gpu::Queue queue = device.queue();
    const Inputs inputs = make_inputs();
    const auto upload = [&](const char* label, BufferUsage usage, std::span<const std::byte> bytes) {
        gpu::Buffer buffer = device.create_buffer({label, bytes.size(), usage | BufferUsage::copy_destination});
        queue.write_buffer(buffer, 0, bytes);
        return buffer;
    };
    const CountsParams params{sample};
    const gpu::Buffer numerators =
        upload("numerators", BufferUsage::storage, std::as_bytes(std::span(inputs.numerators)));
    const gpu::Buffer arguments = upload("arguments", BufferUsage::storage, std::as_bytes(std::span(inputs.arguments)));
    const gpu::Buffer uniform = upload("parameters", BufferUsage::uniform, std::as_bytes(std::span(&params, 1)));
    const gpu::Buffer results =
        device.create_buffer({"results", std::uint64_t{sample} * 24, BufferUsage::storage | BufferUsage::copy_source});

    const gpu::ComputePipeline pipeline = device.create_compute_pipeline(gpu::find_kernel("exact_probe"));
    gpu::CommandEncoder encoder = device.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(pipeline);
    pass.set_bind_group(device.create_bind_group(pipeline, {{numerators}, {arguments}, {results}, {uniform}}));
    pass.dispatch_workgroups(1024, sample / 1024 / gpu::workgroup_size);
    pass.end();
    queue.submit(encoder.finish());

    std::vector<float> found(std::size_t{6} * sample);
    queue.read_buffer(results, 0, std::as_writable_bytes(std::span(found)));
    std::ranges::transform(found, found.begin(), canonical);
    std::vector<float> expected;
    expected.reserve(found.size());
    for (std::uint32_t i = 0; i < sample; ++i) {
        expected.push_back(canonical(exact_reciprocal(inputs.arguments[i])));
        expected.push_back(canonical(exact_rsqrt(inputs.arguments[i])));
        expected.push_back(canonical(exact_divide(inputs.numerators[i], inputs.arguments[i])));
        expected.push_back(canonical(exact_exp2(inputs.arguments[i])));
        expected.push_back(canonical(exact_log2(inputs.arguments[i])));
        expected.push_back(exact_power(bits_float(0x3f7fffffu - (i << 4u)), to_float(i & 1023u) + 0.5f));
    }
    if (std::memcmp(found.data(), expected.data(), found.size() * sizeof(float)) != 0) {
        const auto differs = [](float a, float b) { return float_bits(a) != float_bits(b); };
        const auto at =
            static_cast<std::size_t>(std::ranges::mismatch(found, expected, std::not_fn(differs)).in1 - found.begin());
        FAIL() << "result " << at % 6 << " of argument " << inputs.arguments[at / 6] << ", numerator "
               << inputs.numerators[at / 6] << ": " << found[at] << " instead of " << expected[at];
    }
}

TESSERA_ON_EVERY_DEVICE(ExactProbe);

}  // namespace
}  // namespace tessera::kernels
