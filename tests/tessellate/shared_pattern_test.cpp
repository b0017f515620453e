// One set of factors for all patches makes one pattern that all share; the same factors given per patch do not. Both
// ways give the same bits.
#include "tessellate/shared_pattern.hpp"
#include "models.hpp"
#include "support/devices.hpp"
#include "tessellate/job.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace tessera {
namespace {

TEST(SharedPattern, ChangesNothing) {
    for (const gpu::Device& device : test::open_every_device()) {
        const patches::PatchSet set = test::load_patches("shape:sphere:5");
        for (const float factor : {-1.0f, 1.0f, 2.0f, 3.0f, 6.5f, 17.0f}) {
            for (const Partitioning partitioning :
                 {Partitioning::integer, Partitioning::fractional_odd, Partitioning::uniform}) {
                SCOPED_TRACE(fmt::format("{} factor {} {}", device.info().id, factor, name(partitioning)));
                const PatchFactors factors{factor, factor, factor, factor, factor, factor};
                TessellationOptions options;
                options.partitioning = partitioning;
                options.factors = factors;
                const RefinedMesh shared = tessellate(device, set, options);
                options.factors = std::vector<PatchFactors>(set.patch_count(), factors);
                const RefinedMesh own = tessellate(device, set, options);
                EXPECT_EQ(shared.indices, own.indices);
                ASSERT_EQ(shared.vertices.size(), own.vertices.size());
                if (own.vertices.empty()) continue;  // culled
                EXPECT_EQ(
                    std::memcmp(shared.vertices.data(), own.vertices.data(), own.vertices.size() * sizeof(Vertex)), 0);
            }
        }
    }
}

TEST(SharedPattern, IsMadeForManyPatchesOfOneSetOfFactors) {
    const gpu::Device device = test::open_device("reference");
    TessellationOptions options;
    options.factors = PatchFactors{3, 3, 3, 3, 3, 3};
    EXPECT_GT(make_shared_pattern(device, Domain::triangle, options, 1000).stride, 0u);
    EXPECT_EQ(make_shared_pattern(device, Domain::triangle, options, 1).stride, 0u);
    options.factors = std::vector<PatchFactors>(1000);
    EXPECT_EQ(make_shared_pattern(device, Domain::triangle, options, 1000).stride, 0u);
    options.factors = PatchFactors{-1, 3, 3, 3, 3, 3};
    EXPECT_EQ(make_shared_pattern(device, Domain::triangle, options, 1000).stride, 0u)
        << "a culled patch has no points";
}

// The host need not wait for the scan then, so it had better know.
TEST(SharedPattern, TellsWhatTheScanFinds) {
    const gpu::Device device = test::open_device("reference");
    patches::PatchSet set = test::load_patches("shape:sphere:5");
    set.has_quads = true;
    for (std::size_t i = 0; i < set.corners.size(); i += 3)
        set.corners[i][3] = set.corners[i][0];  // every third a quad, of some form
    TessellationOptions options;
    options.factors = PatchFactors{5, 5, 5, 5, 5, 5};
    Job job(device, set, options, device.limits());
    job.poison_outputs(0xdeadbeef);
    const std::vector<PatchOffset> known = job.count(0);
    const std::vector<StageView> views = job.prepared_views();
    const auto scan = std::ranges::find(views, StageId::scan, &StageView::stage);
    ASSERT_NE(scan, views.end());
    std::vector<PatchOffset> found(scan->bytes / sizeof(PatchOffset));
    gpu::Device(device).queue().read_buffer(scan->buffer, 0, std::as_writable_bytes(std::span(found)));
    ASSERT_EQ(known.size(), found.size());
    ASSERT_EQ(known.size(), set.patch_count() + 1);
    EXPECT_EQ(std::memcmp(known.data(), found.data(), found.size() * sizeof(PatchOffset)), 0);
    EXPECT_NE(known[1].vertex - known[0].vertex, known[2].vertex - known[1].vertex) << "quads and triangles";
}

}  // namespace
}  // namespace tessera
