// The project's own kernels: all build, and one runs with the bits of the reference.
#include "gpu/kernel_catalog.hpp"

#include "opencl/opencl_fixture.hpp"

#include <random>

namespace tessera::test {
namespace {

TEST_F(OpenClTest, EveryKernelOfTheProjectBuildsWithoutContraction) {
    for (const gpu::Kernel& kernel : gpu::all_kernels()) {
        EXPECT_NO_THROW(device->create_pipeline(kernel)) << kernel.name;
        EXPECT_NE(kernel.opencl_source.find("#pragma OPENCL FP_CONTRACT OFF"), std::string_view::npos) << kernel.name;
    }
}

TEST_F(OpenClTest, ScaleProbeHasTheBitsOfTheReference) {
    constexpr std::uint32_t groups = 100, items = groups * 64, count = items - 17;
    const gpu::Kernel& kernel = gpu::find_kernel("scale_probe");
    std::mt19937 random(11);
    std::uniform_real_distribution<float> range(-3.0f, 3.0f);
    std::vector<float> in(items), expected(items);
    std::generate(in.begin(), in.end(), [&] { return range(random); });
    std::vector<ScaleParams> params{{count, 1.7f}};
    std::byte* slots[] = {reinterpret_cast<std::byte*>(in.data()), reinterpret_cast<std::byte*>(expected.data()),
                          reinterpret_cast<std::byte*>(params.data())};
    kernel.reference(0, items, slots);

    const Object from = buffer_of(in), to = buffer(4 * items), uniforms = buffer_of(params);
    const Object pipeline = device->create_pipeline(kernel);
    const Object group = bind(pipeline, {{from.get(), 0, 4 * items}, {to.get(), 0, 4 * items}, {uniforms.get(), 0, 8}});
    submit({gpu::Dispatch{pipeline.get(), group.get(), 0, groups / 4, 4}});
    EXPECT_EQ(read<float>(to, items), expected);
    EXPECT_NE(expected[count - 1], 0.0f);
}

}  // namespace
}  // namespace tessera::test
