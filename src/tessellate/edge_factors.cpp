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
        const patches::PatchCorners& corners = patches.corners[i];
        std::array<std::uint64_t, 4> corner{};
        for (std::size_t k = 0; k < (patches::is_quad(corners) ? 4u : 3u); ++k) {
            corner[k] = position_hash(patches.control_vertices[corners[k]], seed);
        }
        // The sum does not depend on the direction of the edge.
        const auto edge = [&](std::size_t a, std::size_t b) {
            return factor_from(mix(corner[a] + corner[b]), least, greatest);
        };
        const float inside = factor_from(mix(seed ^ mix(i)), least, greatest);
        if (patches::is_quad(corners)) {
            // Edge U=0 joins corners 3 and 0, V=0 joins 0 and 1, U=1 joins 1 and 2, V=1 joins 2 and 3.
            const float inside_v = factor_from(mix(seed ^ mix(~i)), least, greatest);
            factors[i] = {edge(3, 0), edge(0, 1), edge(1, 2), edge(2, 3), inside, inside_v};
        } else {
            // Edge U=0 joins corners 1 and 2, V=0 joins 2 and 0, W=0 joins 0 and 1.
            factors[i] = {edge(1, 2), edge(2, 0), edge(0, 1), inside, 0, 0};
        }
    }
    return factors;
}

}  // namespace tessera
