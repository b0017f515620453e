#include "oracle/factor_sets.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace tessera::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::array oddities{
    nan,    infinity, -infinity, 0.0f,  -0.0f,           -3.0f,           std::numeric_limits<float>::denorm_min(),
    1e-30f, 0.5f,     1e30f,     64.5f, 1.0f + 0x1p-17f, 1.0f + 0x1p-16f, 63.0f + 0x1p-10f};

std::size_t factor_count(Domain domain) {
    return domain == Domain::triangle ? 4 : (domain == Domain::quad ? 6 : 2);
}

PatchFactors same(float factor) {
    return {factor, factor, factor, factor, factor, factor};
}

}  // namespace

std::vector<PatchFactors> systematic_factors(Domain domain) {
    std::vector<PatchFactors> sets;
    for (int n = 1; n <= 64; ++n) {
        const auto factor = static_cast<float>(n);
        sets.push_back(same(factor));
        PatchFactors one = same(5.0f);
        one[static_cast<std::size_t>(n) % factor_count(domain)] = factor;
        sets.push_back(one);
        for (const float offset : {-0x1p-16f, 0x1p-16f, 0.5f}) {
            if (n <= 8 || n == 63) {
                sets.push_back(same(factor + offset));
            }
        }
    }
    for (const float odd : oddities) {
        for (std::size_t place = 0; place < factor_count(domain); ++place) {
            PatchFactors one = same(3.0f);
            one[place] = odd;
            sets.push_back(one);
        }
    }
    return sets;
}

std::vector<PatchFactors> random_factor_sets(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t bound) { return random() % bound; };
    const auto unit = [&] { return static_cast<float>(random() >> 40) * 0x1p-24f; };
    std::vector<PatchFactors> sets(count);
    for (PatchFactors& set : sets) {
        const std::uint64_t kind = below(4);
        for (float& factor : set) {
            const float small = 0.5f * std::pow(132.0f, unit());
            if (kind == 0) {
                factor = std::ceil(small);
            } else if (kind == 1) {
                factor = std::round(small) + (static_cast<float>(below(33)) - 16.0f) * 0x1p-17f;
            } else if (kind == 2 && below(3) == 0) {
                factor = 0.5f + 65.5f * unit();
            } else {
                factor = small;
            }
        }
        if (below(16) == 0) {
            set[below(set.size())] = oddities[below(oddities.size())];
        }
    }
    return sets;
}

std::size_t random_set_count() {
    const char* asked = std::getenv("TESSERA_ORACLE_SETS");
    return asked != nullptr ? std::strtoul(asked, nullptr, 10) : 500;
}

}  // namespace tessera::test
