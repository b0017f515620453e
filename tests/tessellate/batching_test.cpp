// The result does not depend on how the work is cut: into chunks and batches, or into lanes.
#include "base/error.hpp"
#include "support/devices.hpp"
#include "support/wrapped_backend.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/models.hpp"
#include "tessellate/tessellate.hpp"

#include <cstring>

namespace tessera {
namespace {

struct Counted : RefinedMesh {
    std::size_t batches = 0;
    void append(const MeshBatch& batch) override {
        ++batches;
        EXPECT_EQ(batch.first_vertex, vertices.size());
        EXPECT_EQ(batch.first_index, indices.size());
        for (const std::uint32_t index : batch.indices) {
            // Every batch is closed.
            ASSERT_GE(index, batch.first_vertex);
            ASSERT_LT(index, batch.first_vertex + batch.vertices.size());
        }
        RefinedMesh::append(batch);
    }
};

TessellationOptions options_for(const patches::PatchSet& set, std::uint64_t budget) {
    TessellationOptions options;
    options.factors = random_edge_factors(set, 0.5f, 24.0f, 3);
    // Some patches are culled, so that batches begin and end at patches without output.
    auto& factors = std::get<std::vector<PatchFactors>>(options.factors);
    for (std::size_t i = 0; i < factors.size(); i += 7)
        factors[i][0] = 0.0f;
    options.memory_budget = budget;
    return options;
}

std::uint64_t least_budget(const patches::PatchSet& set) {
    try {
        Job(test::open_device("reference"), set, options_for(set, 1), {});
    } catch (const Error& error) {
        const std::string sentence = error.what();
        return std::stoull(sentence.substr(sentence.rfind(' ') + 1));
    }
    return 0;
}

void expect_equal(const RefinedMesh& a, const RefinedMesh& b) {
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    ASSERT_EQ(a.indices.size(), b.indices.size());
    EXPECT_EQ(std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vertex)), 0);
    EXPECT_EQ(a.indices, b.indices);
}

class Batching : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(Batching, DoesNotChangeTheResultAndKeepsTheBudget) {
    const patches::PatchSet set = test::load_patches("shape:sphere:10");
    gpu::Device device = test::open_device(GetParam().id);
    const RefinedMesh expected = tessellate(device, set, options_for(set, 512ull << 20));
    ASSERT_GT(expected.vertices.size(), 10'000u);
    const std::uint64_t least = least_budget(set);
    std::size_t most_batches = 0;
    for (const std::uint64_t budget : {least, least + 50'000, least + 1'000'000}) {
        SCOPED_TRACE(budget);
        const TessellationOptions options = options_for(set, budget);
        Tessellator tessellator(device, set, options);
        Counted found;
        tessellator.run(found);
        most_batches = std::max(most_batches, found.batches);
        expect_equal(found, expected);
        EXPECT_LE(tessellator.device_bytes(), budget);
        // Once more, from the same tessellator.
        Counted again;
        tessellator.run(again);
        expect_equal(again, expected);
    }
    EXPECT_GT(most_batches, 10u);
}

TESSERA_ON_EVERY_DEVICE(Batching);

TEST(Batching, TheLeastBudgetWorksWithTheLargestPatches) {
    const patches::PatchSet set = test::load_patches("shape:icosahedron");
    TessellationOptions options;
    options.factors = PatchFactors{64, 64, 64, 64, 0, 0};
    options.partitioning = Partitioning::integer;
    const RefinedMesh expected = tessellate(test::open_device("reference"), set, options);
    options.memory_budget = least_budget(set);
    EXPECT_GT(options.memory_budget, 0u);
    // The least budget depends on the scheme only, and random factors take more than one set.
    expect_equal(tessellate(test::open_device("reference"), set, options), expected);
    options.memory_budget -= 1;
    EXPECT_THROW(tessellate(test::open_device("reference"), set, options), Error);
}

TEST(Batching, ALargeBudgetIsKept) {
    const patches::PatchSet set = test::load_patches("shape:sphere:60");
    TessellationOptions options;
    options.factors = PatchFactors{7, 7, 7, 7, 0, 0};
    for (const std::uint64_t mebibytes : {4, 16, 64}) {
        options.memory_budget = mebibytes << 20;
        Tessellator tessellator(test::open_device("reference"), set, options);
        RefinedMesh mesh;
        tessellator.run(mesh);
        EXPECT_LE(tessellator.device_bytes(), options.memory_budget);
        EXPECT_EQ(mesh.vertices.size(), tessellator.totals().vertex_count);
    }
}

/// The reference with another idea of its own hardware, on which the number of lanes depends.
class OtherHardware : public test::WrappedBackend {
public:
    OtherHardware(bool software, std::uint32_t compute_units) {
        changeable_info().software = software;
        changeable_info().compute_units = compute_units;
    }
};

TEST(Lanes, DoNotChangeTheResult) {
    const patches::PatchSet set = test::load_patches("shape:torus");
    const TessellationOptions options = options_for(set, 512ull << 20);
    const RefinedMesh expected =
        tessellate(gpu::Device(std::make_unique<OtherHardware>(true, 1)), set, options);  // one lane
    expect_equal(tessellate(gpu::Device(std::make_unique<OtherHardware>(true, 8)), set, options), expected);
    expect_equal(tessellate(gpu::Device(std::make_unique<OtherHardware>(true, 100'000)), set, options), expected);
    expect_equal(tessellate(gpu::Device(std::make_unique<OtherHardware>(false, 0)), set, options), expected);
}

}  // namespace
}  // namespace tessera
