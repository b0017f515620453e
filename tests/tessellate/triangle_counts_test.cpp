// The triangle counts of Ni (Direct3D 11 Tessellation, GDC 2010, slide "Tessellation Patterns") for factors 1 to 64 on
// all edges and inside, on every device.
#include "support/devices.hpp"
#include "tessellate/pattern.hpp"

namespace tessera {
namespace {

std::size_t triangles_of_ni(std::size_t lod) {
    std::size_t sum = 0;
    for (std::size_t i = 1; i <= lod / 2; ++i)
        sum += lod % 2 == 1 ? 2 * i : 2 * i - 1;
    return 6 * sum + lod % 2;
}

class TriangleCounts : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(TriangleCounts, AreThoseOfNi) {
    std::vector<PatchFactors> factors;
    for (std::size_t n = 1; n <= 64; ++n) {
        factors.emplace_back();
        factors.back().fill(static_cast<float>(n));
    }
    const gpu::Device device = test::open_device(GetParam().id);
    // Fractional partitionings have the same pattern at the integers of their parity.
    for (const auto& [partitioning, first, step] :
         {std::tuple{Partitioning::integer, 1u, 1u}, std::tuple{Partitioning::fractional_odd, 1u, 2u},
          std::tuple{Partitioning::fractional_even, 2u, 2u}}) {
        const auto triangles = make_patterns(device, Domain::triangle, partitioning, true, factors);
        const auto quads = make_patterns(device, Domain::quad, partitioning, true, factors);
        for (std::size_t n = first; n <= 64; n += step) {
            EXPECT_EQ(triangles[n - 1].indices.size() / 3, triangles_of_ni(n)) << name(partitioning) << " " << n;
            EXPECT_EQ(quads[n - 1].indices.size() / 3, 2 * n * n) << name(partitioning) << " " << n;
        }
    }
}

TESSERA_ON_EVERY_DEVICE(TriangleCounts);

}  // namespace
}  // namespace tessera
