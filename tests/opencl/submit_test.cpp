// Recorded commands: order, shapes of dispatches, indirect dispatches and timestamps.
#include "opencl/opencl_fixture.hpp"

#include "base/error.hpp"

namespace tessera::test {
namespace {

class OpenClSubmitTest : public OpenClTest {
protected:
    static constexpr std::uint32_t count = 6 * 64;

    void SetUp() override {
        OpenClTest::SetUp();
        if (!device) {
            return;
        }
        pipeline = device->create_pipeline(scale_kernel());
        a = buffer_of(std::vector<float>(count, 1.0f));
        b = buffer(4 * count);
        uniforms = buffer_of(std::vector<ScaleParams>{{count, 2.0f}});
        forth = bind(pipeline, {{a.get(), 0, 4 * count}, {b.get(), 0, 4 * count}, {uniforms.get(), 0, 8}});
        back = bind(pipeline, {{b.get(), 0, 4 * count}, {a.get(), 0, 4 * count}, {uniforms.get(), 0, 8}});
    }
    gpu::Command dispatch(const Object& group, std::uint32_t x, std::uint32_t y = 1) {
        return gpu::Dispatch{pipeline.get(), group.get(), 0, x, y};
    }
    gpu::Command indirect(const Object& arguments, std::uint64_t offset) {
        return gpu::DispatchIndirect{pipeline.get(), forth.get(), 0, arguments.get(), offset};
    }
    // How many elements of b were written, which are always the first ones.
    std::ptrdiff_t written() {
        const std::vector<float> out = read<float>(b, count);
        const auto end = std::find(out.begin(), out.end(), 0.0f);
        EXPECT_EQ(std::count(end, out.end(), 0.0f), out.end() - end);
        return end - out.begin();
    }

    Object pipeline, a, b, uniforms, forth, back;
};

TEST_F(OpenClSubmitTest, EachCommandSeesTheOnesBefore) {
    // x -> 2x + 1 six times from 1, written to in between.
    submit({dispatch(forth, 6), dispatch(back, 6), dispatch(forth, 6), dispatch(back, 6)});
    write(uniforms, 0, std::vector<ScaleParams>{{count, 3.0f}});
    submit({dispatch(forth, 6)});
    EXPECT_EQ(read<float>(b, count), std::vector<float>(count, 31.0f * 3.0f + 1.0f));
}

TEST_F(OpenClSubmitTest, DispatchesHaveTwoDimensions) {
    submit({dispatch(forth, 2, 2)});
    EXPECT_EQ(written(), 4 * 64);
    submit({dispatch(forth, 3, 2)});
    EXPECT_EQ(written(), 6 * 64);
}

TEST_F(OpenClSubmitTest, NoGroupsDoNothing) {
    submit({dispatch(forth, 0), dispatch(forth, 6, 0)});
    EXPECT_EQ(written(), 0);
}

TEST_F(OpenClSubmitTest, IndirectDispatchesReadTheirArguments) {
    const Object arguments = buffer_of(std::vector<std::uint32_t>{9, 0, 1, 1, 2, 2, 1});
    submit({indirect(arguments, 4)});  // 0 x 1 x 1
    EXPECT_EQ(written(), 0);
    submit({indirect(arguments, 16)});  // 2 x 2 x 1
    EXPECT_EQ(written(), 4 * 64);
    // Arguments that the same submission makes.
    submit({gpu::FillBuffer{arguments.get(), 20, 4, 3u}, indirect(arguments, 16)});
    EXPECT_EQ(written(), 6 * 64);
}

TEST_F(OpenClSubmitTest, IndirectArgumentsBeyondTheLimitsAreRefused) {
    const std::vector<std::uint32_t> refused[] = {{65536, 1, 1}, {1, 65536, 1}, {1, 1, 2}};
    for (const auto& groups : refused) {
        const Object arguments = buffer_of(groups);
        try {
            submit({indirect(arguments, 0)});
            ADD_FAILURE() << "ran " << groups[0] << " x " << groups[1] << " x " << groups[2];
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_NE(std::string(error.what()).find(std::to_string(groups[0]) + " x " + std::to_string(groups[1])),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(written(), 0);
}

TEST_F(OpenClSubmitTest, TimestampsGrowAndAreZeroWhereNotWritten) {
    if (!device->info().timestamps) {
        GTEST_SKIP() << "the device has no timestamps";
    }
    const Object queries = device->create_query_set(4);
    const Object times = buffer(40);
    for (int round = 0; round < 2; ++round) {  // the second one writes the same queries again
        submit({gpu::WriteTimestamp{queries.get(), 0}, dispatch(forth, 6), gpu::WriteTimestamp{queries.get(), 1},
                dispatch(back, 6), gpu::WriteTimestamp{queries.get(), 3}});
        submit({gpu::ResolveQuerySet{queries.get(), 0, 4, times.get(), 8}});
        const auto read_times = read<std::uint64_t>(times, 5);
        EXPECT_EQ(read_times[0], 0u);
        EXPECT_GT(read_times[1], 0u);
        EXPECT_GT(read_times[2], read_times[1]);
        EXPECT_EQ(read_times[3], 0u);
        EXPECT_GT(read_times[4], read_times[2]);
    }
}

}  // namespace
}  // namespace tessera::test
