#include "tessellate/edge_factors.hpp"

#include <array>
#include <bit>

namespace tessera {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the input reaches every bit of the output.
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

std::uint64_t position_hash(const Vertex& vertex, std::uint64_t seed) {
    std::uint64_t hash = mix(seed);
    for (const float coordinate : vertex.position) {
        hash = mix(hash ^ std::bit_cast<std::uint32_t>(coordinate));
    }
    return hash;
}

float factor_from(std::uint64_t hash, float least, float greatest) {
    const double unit = static_cast<double>(hash >> 11) * 0x1p-53;
    return static_cast<float>(least + unit * (static_cast<double>(greatest) - least));
}

}  // namespace

std::vector<PatchFactors> random_edge_factors(const patches::PatchSet& patches, float least, float greatest,
                                              std::uint64_t seed) {
    std::vector<PatchFactors> factors(patches.patch_count());
    for (std::size_t i = 0; i < factors.size(); ++i) {
        std::array<std::uint64_t, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = position_hash(patches.control_vertices[patches.indices[3 * i + k]], seed);
        }
        // Edge U=0 joins corners 1 and 2, V=0 joins 2 and 0, W=0 joins 0 and 1; the sum does not depend on direction.
        const auto edge = [&](std::size_t a, std::size_t b) {
            return factor_from(mix(corner[a] + corner[b]), least, greatest);
        };
        factors[i] = {edge(1, 2), edge(2, 0), edge(0, 1), factor_from(mix(seed ^ mix(i)), least, greatest), 0, 0};
    }
    return factors;
}

}  // namespace tessera
