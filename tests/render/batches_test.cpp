// Batches cover every triangle once, in order, and never upload more than three vertices for each.
#include "render/triangle_batches.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "base/error.hpp"

namespace tessera::render {
namespace {

TEST(Batches, CoverEveryTriangleInOrder) {
    std::vector<std::uint32_t> indices(3 * (2 * TriangleBatch::max_triangles + 5));
    std::iota(indices.begin(), indices.end(), 7u);
    std::span<const std::uint32_t> rest = indices;
    std::vector<std::uint32_t> seen;
    while (!rest.empty()) {
        const TriangleBatch batch = take_batch(rest, indices.size() + 7);
        ASSERT_LE(batch.indices.size(), 3 * TriangleBatch::max_triangles);
        ASSERT_TRUE(batch.is_local());
        std::vector<std::uint32_t> local(batch.indices.size());
        write_local_indices(batch, local.data());
        for (const std::uint32_t index : local) {
            ASSERT_LT(index, batch.vertex_count);
            seen.push_back(index + batch.first_vertex);
        }
        rest = rest.subspan(batch.indices.size());
    }
    EXPECT_EQ(seen, indices);
}

RC_GTEST_PROP(Batches, AreNarrowOrCutIntoCorners, ()) {
    const auto vertex_count = *rc::gen::inRange<std::uint32_t>(1, 200);
    const auto triangles = *rc::gen::inRange<std::size_t>(1, 20);
    const auto indices = *rc::gen::container<std::vector<std::uint32_t>>(
        triangles * 3, rc::gen::inRange<std::uint32_t>(0, vertex_count));
    std::vector<Vertex> vertices(vertex_count);
    for (std::uint32_t i = 0; i < vertex_count; ++i)
        vertices[i].position[0] = static_cast<float>(i);
    const TriangleBatch batch = take_batch(indices, vertex_count);
    RC_ASSERT(batch.indices.size() == indices.size());
    RC_ASSERT(batch.first_vertex + batch.vertex_count <= vertex_count);
    std::vector<std::uint32_t> local(indices.size());
    std::vector<Vertex> corners(indices.size());
    write_local_indices(batch, local.data());
    write_corners(batch, std::span<const Vertex>(vertices), corners.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        RC_ASSERT(local[i] + batch.first_vertex == indices[i]);
        RC_ASSERT(corners[i].position[0] == static_cast<float>(indices[i]));
    }
    RC_ASSERT(batch.is_local() == (batch.vertex_count <= indices.size()));
}

TEST(Batches, RefuseAnIndexBeyondTheVertices) {
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 9, 1};
    EXPECT_THROW(take_batch(indices, 9), Error);
    EXPECT_EQ(take_batch(indices, 10).vertex_count, 10u);
}

}  // namespace
}  // namespace tessera::render
