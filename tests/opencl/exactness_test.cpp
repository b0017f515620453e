// What the exactness law asks of an OpenCL driver: no contraction, and denormals as announced.
#include "opencl/opencl_fixture.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace tessera::test {
namespace {

// Shapes in which drivers like to contract: within an expression, across statements, through a function, in a loop.
constexpr std::string_view shapes_source =
    "#pragma OPENCL FP_CONTRACT OFF\n"
    "static inline float product(float a, float b) { return a * b; }\n"
    "__kernel void shapes(__global const float* restrict in, __global float* restrict out) {\n"
    "    uint i = get_global_id(0);\n"
    "    float a = in[3u * i], b = in[3u * i + 1u], c = in[3u * i + 2u];\n"
    "    out[4u * i] = a * b + c;\n"
    "    float d = a * b;\n"
    "    float e = c - d;\n"
    "    out[4u * i + 1u] = e;\n"
    "    out[4u * i + 2u] = product(a, c) - product(b, c);\n"
    "    float sum = 0.0f;\n"
    "    for (uint k = 0u; k < 3u; ++k) sum = sum + in[3u * i + k] * in[3u * i + (k + 1u) % 3u];\n"
    "    out[4u * i + 3u] = sum;\n"
    "}\n";

TEST_F(OpenClTest, NothingIsContracted) {
    constexpr std::uint32_t groups = 512, count = groups * 64;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> range(-2.0f, 2.0f);
    std::vector<float> in(3 * count);
    std::generate(in.begin(), in.end(), [&] { return range(random); });

    const Object pipeline = device->create_pipeline(opencl_kernel(
        "shapes", {{0, BindingKind::read_storage, 4}, {1, BindingKind::write_storage, 4}}, shapes_source));
    const Object from = buffer_of(in), to = buffer(4 * count * sizeof(float));
    const Object group = bind(pipeline, {{from.get(), 0, 12 * count}, {to.get(), 0, 16 * count}});
    submit({gpu::Dispatch{pipeline.get(), group.get(), 0, groups, 1}});
    const std::vector<std::uint32_t> out = read<std::uint32_t>(to, 4 * count);

    std::uint32_t telling = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float a = in[3 * i], b = in[3 * i + 1], c = in[3 * i + 2];
        const float ab = a * b, bc = b * c, ca = c * a;
        const float expected[] = {ab + c, c - ab, ca - bc, 0.0f + ab + bc + ca};
        for (std::uint32_t shape = 0; shape < 4; ++shape) {
            ASSERT_EQ(out[4 * i + shape], std::bit_cast<std::uint32_t>(expected[shape]))
                << "shape " << shape << " of a = " << a << ", b = " << b << ", c = " << c << ": "
                << std::bit_cast<float>(out[4 * i + shape]) << " instead of " << expected[shape];
        }
        telling += std::fma(a, b, c) != expected[0];
    }
    EXPECT_GT(telling, count / 10) << "the inputs would not show contraction";
}

TEST_F(OpenClTest, DenormalsAreTreatedAsAnnounced) {
    constexpr std::string_view source =
        "#pragma OPENCL FP_CONTRACT OFF\n"
        "__kernel void halve(__global const float* restrict in, __global float* restrict out) {\n"
        "    uint i = get_global_id(0);\n"
        "    out[i] = in[i] * 0.5f;\n"
        "}\n";
    std::vector<float> in(64, std::numeric_limits<float>::min());
    in[1] = 3 * std::numeric_limits<float>::denorm_min();
    const Object pipeline = device->create_pipeline(
        opencl_kernel("halve", {{0, BindingKind::read_storage, 4}, {1, BindingKind::write_storage, 4}}, source));
    const Object from = buffer_of(in), to = buffer(256);
    const Object group = bind(pipeline, {{from.get(), 0, 256}, {to.get(), 0, 256}});
    submit({gpu::Dispatch{pipeline.get(), group.get(), 0, 1, 1}});
    const std::vector<float> out = read<float>(to, 64);

    const bool kept =
        out[0] == std::numeric_limits<float>::min() / 2 && out[1] == 2 * std::numeric_limits<float>::denorm_min();
    RecordProperty("denormals", kept ? "kept" : "flushed");
    const gpu::FloatControls& controls = device->info().float_controls;
    if (controls.preserves_denormals == true) {
        EXPECT_TRUE(kept) << out[0] << " " << out[1];
    }
    if (controls.flushes_denormals == true) {
        EXPECT_EQ(out[0], 0.0f);
        EXPECT_EQ(out[1], 0.0f);
    }
}

}  // namespace
}  // namespace tessera::test
