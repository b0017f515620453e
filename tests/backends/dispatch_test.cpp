// Dispatches: every item runs once, sees its bindings, and writes nothing beside its output.
#include "backends/device_suite.hpp"

namespace tessera::backends {
namespace {

using gpu::BufferUsage;

class DispatchTest : public DeviceTest {
protected:
    /// `count` floats of output between sentinels; returns what was between them after checking the sentinels.
    std::vector<float> between_sentinels(const gpu::Buffer& buffer, std::uint64_t offset, std::size_t count) {
        const auto words = download<std::uint32_t>(buffer, buffer.size() / 4);
        const std::size_t first = offset / 4;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if ((i < first || i >= first + count) && words[i] != sentinel) {
                ADD_FAILURE() << "word " << i << " outside of the output is " << words[i];
                break;
            }
        }
        std::vector<float> values(count);
        std::transform(words.begin() + first, words.begin() + first + count, values.begin(),
                       std::bit_cast<float, std::uint32_t>);
        return values;
    }
    gpu::Buffer sentinels(std::size_t count) { return upload("out", std::vector<std::uint32_t>(count, sentinel)); }
};

TEST_P(DispatchTest, GivesTheBitsOfTheHost) {
    constexpr std::uint32_t count = 100'003;
    const std::vector<float> input = noise(count);
    const gpu::Buffer out = sentinels(count + 61);
    run_scale(device.create_bind_group(scale, {{upload("in", input)}, {out}, {parameters(count, 1.1f)}}), count);
    EXPECT_TRUE(between_sentinels(out, 0, count) == scaled(input, 1.1f));
}

TEST_P(DispatchTest, TakesSmallCounts) {
    const std::vector<float> input = noise(130);
    for (const std::uint32_t count : {1u, 63u, 64u, 65u, 128u, 129u}) {
        const gpu::Buffer out = sentinels(200);
        run_scale(device.create_bind_group(scale, {{upload("in", input)}, {out}, {parameters(count, 0.3f)}}), count);
        EXPECT_EQ(between_sentinels(out, 0, count), scaled(std::span(input).first(count), 0.3f)) << count;
    }
}

TEST_P(DispatchTest, BindsAtOffsets) {
    const std::uint32_t step = device.limits().storage_offset_alignment;
    const std::uint32_t uniform_step = device.limits().uniform_offset_alignment;
    constexpr std::uint32_t count = 100;
    const std::vector<float> input = noise(4 * step / 4 + count);
    const gpu::Buffer in = upload("in", input);
    const gpu::Buffer out = sentinels(4 * step / 4 + 2 * count);
    const gpu::Buffer uniform = make("parameters", 3 * uniform_step, BufferUsage::uniform);
    write<ScaleProbeParams>(uniform, {{count, 7.7f}}, 2 * uniform_step);
    run_scale(device.create_bind_group(
                  scale, {{in, 3 * step, count * 4}, {out, 2 * step, count * 4}, {uniform, 2 * uniform_step}}),
              count);
    EXPECT_EQ(between_sentinels(out, 2 * step, count), scaled(std::span(input).subspan(3 * step / 4, count), 7.7f));
}

TEST_P(DispatchTest, AddsTheDynamicUniformOffset) {
    const std::uint32_t step = device.limits().uniform_offset_alignment;
    constexpr std::uint32_t count = 70;
    constexpr std::uint32_t variants = 5;
    const std::vector<float> input = noise(count);
    const gpu::Buffer in = upload("in", input);
    const gpu::Buffer uniform = make("parameters", (variants + 1) * step, BufferUsage::uniform);
    std::vector<gpu::Buffer> outputs;
    gpu::CommandEncoder encoder = device.create_command_encoder();
    for (std::uint32_t i = 0; i < variants; ++i) {
        // The binding starts one step in: binding offset and dynamic offset must both count.
        write<ScaleProbeParams>(uniform, {{count, static_cast<float>(i) + 0.1f}}, (i + 1) * step);
        outputs.push_back(sentinels(128));
        record_scale(encoder, device.create_bind_group(scale, {{in}, {outputs[i]}, {uniform, step}}), count, i * step);
    }
    queue.submit(encoder.finish());
    for (std::uint32_t i = 0; i < variants; ++i) {
        EXPECT_EQ(between_sentinels(outputs[i], 0, count), scaled(input, static_cast<float>(i) + 0.1f)) << i;
    }
}

TEST_P(DispatchTest, CountsItemsOverTwoDimensions) {
    constexpr std::uint32_t count = 3 * 5 * gpu::workgroup_size - 7;
    const std::vector<float> input = noise(count);
    const gpu::Buffer out = sentinels(count + 64);
    gpu::CommandEncoder encoder = device.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(scale);
    pass.set_bind_group(device.create_bind_group(scale, {{upload("in", input)}, {out}, {parameters(count, 9.9f)}}));
    pass.dispatch_workgroups(3, 5);
    pass.end();
    queue.submit(encoder.finish());
    EXPECT_EQ(between_sentinels(out, 0, count), scaled(input, 9.9f));
}

TEST_P(DispatchTest, TakesGroupCountsFromABuffer) {
    constexpr std::uint32_t count = 6 * gpu::workgroup_size;
    const std::vector<float> input = noise(count);
    const gpu::Buffer in = upload("in", input);
    const gpu::Buffer all = sentinels(count);
    const gpu::Buffer some = sentinels(count);
    const gpu::Buffer none = sentinels(count);
    const gpu::Buffer uniform = parameters(count, 2.5f);
    // The counts reach their buffer by a copy in the same commands, so that a device which reads them early is seen.
    const gpu::Buffer source = upload<std::uint32_t>("source", {99, 3, 2, 1, 2, 1, 1, 0, 1, 1});
    const gpu::Buffer arguments = make("arguments", 40, BufferUsage::indirect);
    gpu::CommandEncoder encoder = device.create_command_encoder();
    encoder.copy_buffer_to_buffer(source, 0, arguments, 0, 40);
    gpu::ComputePass pass = encoder.begin_compute_pass();
    pass.set_pipeline(scale);
    pass.set_bind_group(device.create_bind_group(scale, {{in}, {all}, {uniform}}));
    pass.dispatch_workgroups_indirect(arguments, 4);
    pass.set_bind_group(device.create_bind_group(scale, {{in}, {some}, {uniform}}));
    pass.dispatch_workgroups_indirect(arguments, 16);
    pass.set_bind_group(device.create_bind_group(scale, {{in}, {none}, {uniform}}));
    pass.dispatch_workgroups_indirect(arguments, 28);
    pass.end();
    queue.submit(encoder.finish());
    EXPECT_EQ(between_sentinels(all, 0, count), scaled(input, 2.5f));
    constexpr std::uint32_t part = 2 * gpu::workgroup_size;
    EXPECT_EQ(between_sentinels(some, 0, part), scaled(std::span(input).first(part), 2.5f));
    between_sentinels(none, 0, 0);
}

TESSERA_ON_EVERY_DEVICE(DispatchTest);

}  // namespace
}  // namespace tessera::backends
