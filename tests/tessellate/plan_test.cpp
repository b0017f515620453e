// Plans: every patch once and in order, buffers within their limits, budgets kept.
#include "tessellate/plan.hpp"

#include "base/error.hpp"
#include "layout.h"
#include "tessellate/launch_shape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

namespace tessera {
namespace {

TessellationOptions with_budget(std::uint64_t bytes, Scheme scheme = Scheme::pn) {
    TessellationOptions options;
    options.scheme = scheme;
    options.memory_budget = bytes;
    return options;
}

/// The least budget, out of the refusal of a smaller one.
std::uint64_t least_budget(std::uint64_t shared_bytes, const TessellationOptions& options, bool has_quads = false,
                           std::uint64_t attribute_bytes = 0) {
    try {
        TessellationOptions poor = options;
        poor.memory_budget = 1;
        plan_job(10, has_quads, shared_bytes, poor, {}, attribute_bytes);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        const std::string sentence = error.what();
        return std::stoull(sentence.substr(sentence.rfind(' ') + 1));
    }
    ADD_FAILURE() << "a budget of one byte was accepted";
    return 0;
}

TEST(PlanJob, TheLeastBudgetNamedWorksAndOneByteLessDoesNot) {
    for (const std::uint64_t shared : {0ull, 4096ull, 100'000'000ull}) {
        const std::uint64_t least = least_budget(shared, with_budget(0));
        EXPECT_NO_THROW(plan_job(10, false, shared, with_budget(least), {}));
        EXPECT_THROW(plan_job(10, false, shared, with_budget(least - 1), {}), Error);
    }
}

RC_GTEST_PROP(PlanJob, ChunksCoverEveryPatchWithinTheLimits, ()) {
    const auto patch_count = *rc::gen::inRange<std::uint64_t>(1, 3'000'000);
    const auto shared = *rc::gen::inRange<std::uint64_t>(0, 50'000'000);
    const auto scheme = *rc::gen::element(Scheme::linear, Scheme::phong, Scheme::pn, Scheme::stpn);
    gpu::Limits limits;
    limits.max_storage_binding_size = *rc::gen::inRange<std::uint64_t>(1 << 20, 1 << 30);
    const auto has_quads = *rc::gen::arbitrary<bool>();
    const auto tangents = *rc::gen::element(Tangents::none, Tangents::surface, Tangents::uv);
    const auto attribute_bytes = *rc::gen::element<std::uint64_t>(0, 128);
    TessellationOptions any_budget = with_budget(0, scheme);
    any_budget.tangents = tangents;
    const std::uint64_t least = least_budget(shared, any_budget, has_quads, attribute_bytes);
    // Near the least budget the largest patch takes most of it.
    const auto extra = *rc::gen::inRange<std::uint64_t>(0, *rc::gen::element(10'000, 1'000'000, 2'000'000'000));
    TessellationOptions options = with_budget(least + extra, scheme);
    options.tangents = tangents;
    const JobPlan plan = plan_job(patch_count, has_quads, shared, options, limits, attribute_bytes);
    std::uint64_t next = 0;
    for (const Chunk& chunk : plan.chunks) {
        RC_ASSERT(chunk.first_patch == next);
        RC_ASSERT(chunk.patch_count > 0u);
        RC_ASSERT(chunk.patch_count <= plan.largest_chunk);
        next += chunk.patch_count;
    }
    RC_ASSERT(next == patch_count);
    const std::uint64_t net_bytes = std::uint64_t{net_stride(options, has_quads)} * 4;
    RC_ASSERT(plan.largest_chunk * net_bytes <= limits.max_storage_binding_size);
    RC_ASSERT(plan.largest_chunk * 3ull * 8192 <= 0xffffffffull);
    RC_ASSERT(plan.vertex_buffer_bytes <= limits.max_storage_binding_size);
    RC_ASSERT(plan.index_buffer_bytes <= limits.max_storage_binding_size);
    RC_ASSERT(plan.vertex_buffer_bytes >= 4225 * sizeof(Vertex));
    RC_ASSERT(plan.index_buffer_bytes >= 8192u * 12u);
    const std::uint64_t vertex_buffers = tangents == Tangents::none ? 1 : 2;
    RC_ASSERT(shared + plan.largest_chunk * net_bytes + vertex_buffers * plan.vertex_buffer_bytes +
                  plan.index_buffer_bytes <=
              options.memory_budget);
}

/// Offsets of patches of random sizes, some of them culled.
std::vector<PatchOffset> random_offsets(std::mt19937& random, std::size_t patch_count, std::uint32_t largest) {
    std::vector<PatchOffset> offsets{{0, 0}};
    for (std::size_t i = 0; i < patch_count; ++i) {
        const std::uint32_t vertices = random() % 4 == 0 ? 0u : 3u + static_cast<std::uint32_t>(random() % largest);
        offsets.push_back(
            {offsets.back().vertex + vertices, offsets.back().index + (vertices == 0 ? 0u : 3u * (vertices - 2u))});
    }
    return offsets;
}

RC_GTEST_PROP(PlanBatches, CoverEveryPatchWithOutputOnceInOrder, ()) {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto patch_count = *rc::gen::inRange<std::size_t>(0, 300);
    const std::vector<PatchOffset> offsets = random_offsets(random, patch_count, 50);
    JobPlan plan;
    plan.vertex_buffer_bytes = sizeof(Vertex) * (53 + random() % 500);
    plan.index_buffer_bytes = 12 * (51 + random() % 500);
    const std::vector<Batch> batches = plan_batches(offsets, plan);
    std::uint32_t next = 0;
    for (const Batch& batch : batches) {
        // Skipped patches have no output.
        RC_ASSERT(batch.first_patch >= next);
        RC_ASSERT(offsets[batch.first_patch].vertex == offsets[next].vertex);
        next = batch.first_patch + batch.patch_count;
        RC_ASSERT(next <= patch_count);
        RC_ASSERT(batch.first_vertex == offsets[batch.first_patch].vertex);
        RC_ASSERT(batch.first_vertex + batch.vertex_count == offsets[next].vertex);
        RC_ASSERT(batch.first_index == offsets[batch.first_patch].index);
        RC_ASSERT(batch.first_index + batch.index_count == offsets[next].index);
        RC_ASSERT(batch.vertex_count > 0u);
        RC_ASSERT(batch.vertex_count * sizeof(Vertex) <= plan.vertex_buffer_bytes);
        RC_ASSERT(batch.index_count * 4ull <= plan.index_buffer_bytes);
    }
    RC_ASSERT(offsets[next].vertex == offsets.back().vertex);
}

TEST(PlanBatches, FillABufferToTheLastByte) {
    JobPlan plan;
    plan.vertex_buffer_bytes = 6 * sizeof(Vertex);
    plan.index_buffer_bytes = 6 * 4;
    const std::vector<PatchOffset> offsets{{0, 0}, {3, 3}, {6, 6}, {9, 9}};
    const std::vector<Batch> batches = plan_batches(offsets, plan);
    ASSERT_EQ(batches.size(), 2u);
    EXPECT_EQ(batches[0].patch_count, 2u);
    EXPECT_EQ(batches[1].first_patch, 2u);
}

TEST(PlanBatches, APatchTooLargeIsRefused) {
    JobPlan plan;
    plan.vertex_buffer_bytes = 2 * sizeof(Vertex);
    plan.index_buffer_bytes = 1 << 20;
    const std::vector<PatchOffset> offsets{{0, 0}, {3, 3}};
    EXPECT_THROW(plan_batches(offsets, plan), Error);
}

TEST(PlanBatches, NothingGivesNothing) {
    JobPlan plan;
    plan.vertex_buffer_bytes = plan.index_buffer_bytes = 1 << 20;
    EXPECT_TRUE(plan_batches({}, plan).empty());
    const std::vector<PatchOffset> culled{{0, 0}, {0, 0}, {0, 0}};
    EXPECT_TRUE(plan_batches(culled, plan).empty());
}

TEST(LaunchShape, LanesAreBoundedByTheWork) {
    gpu::DeviceInfo cpu;
    cpu.software = true;
    cpu.compute_units = 4;
    EXPECT_EQ(lanes_log2(cpu, 0, 0), 0u);
    EXPECT_EQ(lanes_log2(cpu, 100'000, 10'000'000), 0u);
    EXPECT_EQ(lanes_log2(cpu, 1, 3000), 6u);
    EXPECT_EQ(lanes_log2(cpu, 1, 3), 1u);
    gpu::DeviceInfo gpu;
    EXPECT_EQ(lanes_log2(gpu, 1000, 1000 * 256), 6u);
    EXPECT_EQ(lanes_log2(gpu, 1000, 1000 * 16), 2u);
    EXPECT_EQ(lanes_log2(gpu, 1000, 1000), 0u);
}

}  // namespace
}  // namespace tessera
