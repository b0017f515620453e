// vector.h on the host: normalisation of vectors of any magnitude.
#include "vector.h"
#include "kernels/corners_gen.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace tessera::kernels {
namespace {

const Vector up = make_vector(0.0f, 0.0f, 1.0f);

double length(Vector v) {
    return std::sqrt(static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y + static_cast<double>(v.z) * v.z);
}

/// Under this size a vector counts as zero: see normalise_exponent().
constexpr float least_size = 0x1p-120f;

float largest_component(Vector v) {
    return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
}

/// A vector of random direction, each component within 10^power and now and then smaller by up to a factor of 2^40.
Vector random_vector(std::uint32_t seed, int power) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> mantissa(-1.0f, 1.0f);
    const auto component = [&] {
        return std::ldexp(mantissa(random), -static_cast<int>(random() % 4u == 0u ? random() % 40u : 0u));
    };
    const auto size = static_cast<float>(std::pow(10.0, power));
    return make_vector(component() * size, component() * size, component() * size);
}

RC_GTEST_PROP(Normalise, GivesUnitLengthAndDirection, ()) {
    const Vector v = random_vector(*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::inRange(-30, 31));
    RC_PRE(largest_component(v) >= least_size);
    const Vector n = normalise(v, up);
    const double size = length(v);
    RC_ASSERT(std::fabs(length(n) - 1.0) < 3e-7);
    RC_ASSERT(std::fabs(n.x - v.x / size) < 3e-7);
    RC_ASSERT(std::fabs(n.y - v.y / size) < 3e-7);
    RC_ASSERT(std::fabs(n.z - v.z / size) < 3e-7);
}

RC_GTEST_PROP(NormaliseExponent, IsSymmetric, ()) {
    const Vector v = random_vector(*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::inRange(-36, 38));
    const Vector a = normalise_exponent(v);
    const Vector b = normalise_exponent(make_vector(-v.x, -v.y, -v.z));
    RC_ASSERT(a.x == -b.x);
    RC_ASSERT(a.y == -b.y);
    RC_ASSERT(a.z == -b.z);
}

RC_GTEST_PROP(NormaliseExponent, IsExactAndBringsTheLargestIntoOneToTwo, ()) {
    const Vector v = random_vector(*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::inRange(-30, 31));
    const float largest = largest_component(v);
    RC_PRE(largest >= least_size);
    const Vector n = normalise_exponent(v);
    const int exponent = -std::ilogb(largest);
    const auto expected = [&](float x) {
        const float scaled = std::ldexp(x, exponent);
        return std::fabs(scaled) < 0x1p-60f ? 0.0f : scaled;
    };
    RC_ASSERT(n.x == expected(v.x));
    RC_ASSERT(n.y == expected(v.y));
    RC_ASSERT(n.z == expected(v.z));
}

TEST(Normalise, ZeroGivesTheFallback) {
    for (const float tiny : {0.0f, -0.0f, 0x1p-121f, bits_float(1u)}) {
        const Vector n = normalise(make_vector(tiny, -tiny, tiny), up);
        EXPECT_EQ(n.x, 0.0f);
        EXPECT_EQ(n.y, 0.0f);
        EXPECT_EQ(n.z, 1.0f);
    }
}

TEST(Normalise, ThresholdOfZero) {
    const Vector least = normalise_exponent(make_vector(least_size, 0.0f, 0.0f));
    EXPECT_EQ(least.x, 1.0f);
    const Vector under = normalise_exponent(make_vector(0x1.fffffep-121f, 0.0f, 0.0f));
    EXPECT_EQ(under.x, 0.0f);
}

TEST(Normalise, AxesAreExact) {
    for (const float size : {0x1p-100f, 0.3f, 1.0f, 7.0f, 0x1p100f}) {
        const Vector n = normalise(make_vector(0.0f, -size, 0.0f), up);
        EXPECT_EQ(float_bits(n.x), 0u);
        EXPECT_NEAR(n.y, -1.0f, 1.2e-7f);
        EXPECT_EQ(float_bits(n.z), 0u);
    }
}

}  // namespace
}  // namespace tessera::kernels
