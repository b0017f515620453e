#include "gpu/null_device.hpp"

namespace tessera::gpu {
namespace {

class BindGroupTest : public NullDeviceTest {
protected:
    void refused(std::initializer_list<Binding> bindings, std::initializer_list<std::string_view> parts) {
        expect_refused([&] { device.create_bind_group(pipeline, bindings); }, parts);
        EXPECT_TRUE(log.bound.empty());
    }

    ComputePipeline pipeline = device.create_compute_pipeline(scale_kernel());
    Buffer in = storage("in");
    Buffer out = storage("out");
    Buffer parameters = uniform("parameters");
};

TEST_F(BindGroupTest, HandsResolvedRangesToTheBackend) {
    device.create_bind_group(pipeline, {{in, 256}, {out, 512, 64}, {parameters, 256}});
    ASSERT_EQ(log.bound.size(), 1u);
    const std::vector<BoundBuffer>& bound = log.bound[0];
    ASSERT_EQ(bound.size(), 3u);
    EXPECT_NE(bound[0].buffer, bound[1].buffer);
    EXPECT_EQ(bound[0].offset, 256u);
    EXPECT_EQ(bound[0].size, 768u) << "storage without a size goes to the end";
    EXPECT_EQ(bound[1].offset, 512u);
    EXPECT_EQ(bound[1].size, 64u);
    EXPECT_EQ(bound[2].offset, 256u);
    EXPECT_EQ(bound[2].size, 8u) << "a uniform without a size is the kernel's struct";
}

TEST_F(BindGroupTest, RefusesNullsAndStrangers) {
    refused({{Buffer()}, {out}, {parameters}}, {"'scale'", "slot 0", "null"});
    const Buffer foreign = other_device.create_buffer({"foreign", 64, BufferUsage::storage});
    refused({{foreign}, {out}, {parameters}}, {"'foreign'", "another device"});
    expect_refused([&] { device.create_bind_group(ComputePipeline(), {{in}, {out}, {parameters}}); }, {"null"});
    expect_refused([&] { Device().create_bind_group(pipeline, {{in}, {out}, {parameters}}); }, {"null"});
    const ComputePipeline elsewhere = other_device.create_compute_pipeline(scale_kernel());
    expect_refused(
        [&] {
            device.create_bind_group(elsewhere, {{in}, {out}, {parameters}});
        },
        {"'scale'", "another device"});
    out.destroy();
    refused({{in}, {out}, {parameters}}, {"slot 1", "'out'", "destroyed"});
}

TEST_F(BindGroupTest, RefusesAWrongNumberOfBindings) {
    refused({{in}, {out}}, {"'scale'", "2 bindings", "has 3"});
    refused({{in}, {out}, {parameters}, {in}}, {"'scale'", "4 bindings", "has 3"});
}

TEST_F(BindGroupTest, RefusesAWrongKindOfBuffer) {
    refused({{parameters}, {out}, {parameters}}, {"slot 0", "usage storage", "'parameters'"});
    refused({{in}, {out}, {in}}, {"slot 2", "usage uniform", "'in'"});
}

TEST_F(BindGroupTest, RefusesMisalignedOffsets) {
    refused({{in, 128}, {out}, {parameters}}, {"'in'", "slot 0", "offset 128", "256"});
    refused({{in}, {out}, {parameters, 64}}, {"'parameters'", "slot 2", "offset 64", "256"});
}

TEST_F(BindGroupTest, RefusesRangesOutsideTheBuffer) {
    refused({{in, 256, 772}, {out}, {parameters}}, {"'in'", "772 bytes", "offset 256", "1024"});
    refused({{in, 2048}, {out}, {parameters}}, {"'in'", "offset 2048", "1024"});
    refused({{in, 1024}, {out}, {parameters}}, {"'in'", "0 bytes"});
    refused({{in, 256, ~std::uint64_t{3}}, {out}, {parameters}}, {"'in'", "1024"});
    refused({{in, ~std::uint64_t{255}, 256}, {out}, {parameters}}, {"'in'", "1024"});
    refused({{in}, {out}, {parameters, 1024}}, {"'parameters'", "offset 1024"});
}

TEST_F(BindGroupTest, RefusesSizesThatDoNotFit) {
    refused({{in, 0, 6}, {out}, {parameters}}, {"'in'", "6 bytes", "multiple of 4"});
    refused({{in}, {out}, {parameters, 0, 4}}, {"'parameters'", "4 bytes", "at least 8"});
    refused({{storage("large", 8192)}, {out}, {parameters}}, {"'large'", "8192", "4096"});
    refused({{in}, {out}, {uniform("wide", 2048), 0, 1028}}, {"'wide'", "1028", "1024"});
    EXPECT_NO_THROW(device.create_bind_group(pipeline, {{storage("l", 8192), 4096}, {out}, {uniform("w", 2048)}}));
}

TEST_F(BindGroupTest, RefusesABufferBoundTwiceWithAWrite) {
    refused({{in}, {in}, {parameters}}, {"'in'", "slots 0 and 1", "written"});
    refused({{in, 0, 256}, {in, 512, 256}, {parameters}}, {"'in'", "slots 0 and 1", "written"});
    const Buffer both = buffer("both", 64, BufferUsage::storage | BufferUsage::uniform);
    refused({{in}, {both}, {both}}, {"'both'", "slots 1 and 2", "written"});
    EXPECT_NO_THROW(device.create_bind_group(pipeline, {{both}, {out}, {both}}));
}

}  // namespace
}  // namespace tessera::gpu
