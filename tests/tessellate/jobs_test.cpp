// Jobs: every element of every stage is written, options that do not fit are refused.
#include "base/error.hpp"
#include "layout.h"
#include "support/devices.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/job.hpp"
#include "tessellate/models.hpp"

#include <algorithm>
#include <limits>

namespace tessera {
namespace {

constexpr std::uint32_t sentinel = 0xa5a5a5a5u;

std::size_t sentinels(gpu::Device& device, const std::vector<StageView>& views) {
    std::size_t count = 0;
    for (const StageView& view : views) {
        std::vector<std::uint32_t> words(view.bytes / 4);
        device.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(words)));
        count += static_cast<std::size_t>(std::ranges::count(words, sentinel));
        EXPECT_FALSE(words.empty()) << name(view.stage);
    }
    return count;
}

class Jobs : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(Jobs, WriteEveryElementOfEveryStage) {
    gpu::Device device = test::open_device(GetParam().id);
    const patches::PatchSet set = test::load_patches("shape:sphere:6");
    for (const Partitioning partitioning :
         {Partitioning::integer, Partitioning::fractional_odd, Partitioning::uniform}) {
        for (const Scheme scheme : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn}) {
            for (const Normals normals : {Normals::linear, Normals::quadratic, Normals::surface}) {
                TessellationOptions options;
                options.scheme = scheme;
                options.normals = normals;
                options.partitioning = partitioning;
                options.factors = random_edge_factors(set, 1.0f, 12.0f, 5);
                options.memory_budget = 2 << 20;
                Job job(device, set, options, device.limits());
                job.poison_outputs(sentinel);
                for (std::size_t chunk = 0; chunk < job.chunk_count(); ++chunk) {
                    job.count(chunk);
                    const std::vector<Batch>& batches = job.prepare();
                    EXPECT_EQ(sentinels(device, job.prepared_views()), 0u);
                    for (const Batch& batch : batches) {
                        job.emit(batch, 0);
                        EXPECT_EQ(sentinels(device, job.emitted_views()), 0u);
                    }
                }
            }
        }
    }
}

// The scan has levels of 256; chunks around each size of a level, on every device.
TEST_P(Jobs, ScanChunksOfAnySize) {
    gpu::Device device = test::open_device(GetParam().id);
    const patches::PatchSet whole = test::load_patches("shape:sphere:92");  // 67,712 patches
    for (const std::size_t count : {1u, 2u, 255u, 256u, 257u, 511u, 513u, 65535u, 65536u, 65537u}) {
        patches::PatchSet set = whole;
        set.corners.resize(count);
        TessellationOptions options;
        options.factors = random_edge_factors(set, 0.5f, 4.0f, 5);
        Job job(device, set, options, device.limits());
        ASSERT_EQ(job.chunk_count(), 1u);
        const std::vector<PatchOffset> offsets = job.count(0);
        ASSERT_EQ(offsets.size(), count + 1);
        std::vector<PatchOffset> counts(count);
        const StageView view = job.prepared_views()[2];
        ASSERT_EQ(view.stage, StageId::counts);
        device.queue().read_buffer(view.buffer, 0, std::as_writable_bytes(std::span(counts)));
        PatchOffset sum;
        for (std::size_t i = 0; i <= count; ++i) {
            ASSERT_EQ(offsets[i].vertex, sum.vertex) << "patch " << i << " of " << count;
            ASSERT_EQ(offsets[i].index, sum.index) << "patch " << i << " of " << count;
            if (i < count) {
                sum.vertex += counts[i].vertex;
                sum.index += counts[i].index;
            }
        }
    }
}

TESSERA_ON_EVERY_DEVICE(Jobs);

void expect_refused(const TessellationOptions& options, const patches::PatchSet& set, const std::string& part) {
    try {
        Job(test::open_device("reference"), set, options, {});
        ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(JobOptions, OnesThatDoNotFitAreRefused) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    TessellationOptions options;
    options.factors = std::vector<PatchFactors>(191);
    expect_refused(options, set, "191");
    options = {};
    for (const float alpha : {-0.01f, 1.01f, std::numeric_limits<float>::quiet_NaN()}) {
        options.alpha = alpha;
        expect_refused(options, set, "alpha");
    }
    options = {};
    options.memory_budget = 100'000;
    expect_refused(options, set, "100000");
}

TEST(JobOptions, TooManyControlVerticesForABindingAreRefused) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    gpu::Limits limits;
    limits.max_storage_binding_size = set.control_vertices.size() * sizeof(Vertex) - 1;
    try {
        Job(test::open_device("reference"), set, {}, limits);
        ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

TEST(Names, RoundTrip) {
    for (const Scheme s : {Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn})
        EXPECT_EQ(scheme_from_name(name(s)), s);
    for (const Normals n : {Normals::linear, Normals::quadratic, Normals::surface})
        EXPECT_EQ(normals_from_name(name(n)), n);
    for (std::uint32_t p = 0; p < 5; ++p) {
        EXPECT_EQ(partitioning_from_name(name(static_cast<Partitioning>(p))), static_cast<Partitioning>(p));
    }
    EXPECT_THROW(scheme_from_name("PN"), Error);
    EXPECT_THROW(normals_from_name(""), Error);
    EXPECT_THROW(partitioning_from_name("odd"), Error);
}

}  // namespace
}  // namespace tessera
