// Factors of every kind for property tests.
#pragma once

#include <bit>
#include <cstdint>
#include <random>

namespace tessera::test {

/// The float that lies so many steps above (or below) x.
inline float steps_from(float x, int steps) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(steps));
}

/// Integers, fractions, values just beside an integer, values outside the range; always positive.
inline float random_factor(std::mt19937& random) {
    const float whole = static_cast<float>(1 + random() % 64);
    switch (random() % 6) {
        case 0:
            return whole;
        case 1:
            return steps_from(whole, static_cast<int>(random() % 700u));
        case 2:
            return steps_from(whole, -static_cast<int>(random() % 700u));
        case 3:
            return 1e-3f * static_cast<float>(1 + random() % 100000);
        default:
            return std::uniform_real_distribution<float>(1.0f, 64.0f)(random);
    }
}

}  // namespace tessera::test
