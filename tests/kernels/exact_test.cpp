// exact.h on the host: errors against the true quotient over every mantissa, and each documented special value. The
// bounds are the measured maxima, rounded up in the third digit; the doc comments of exact.h give them too.
#include "exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace tessera::kernels {
namespace {

constexpr uint mantissas = 1u << 23;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

constexpr double reciprocal_bound = 1.25;
constexpr double rsqrt_bound = 1.22;
constexpr double divide_bound = 2.17;

float make_float(uint exponent, uint mantissa, uint sign = 0u) {
    return bits_float(sign << 31u | exponent << 23u | mantissa);
}

/// |found - truth| in units in the last place of a float near `truth`.
double ulps(float found, double truth) {
    return std::fabs(found - truth) / std::ldexp(1.0, std::ilogb(truth) - 23);
}

/// Floats between `found` and the correctly rounded `truth`.
uint steps(float found, double truth) {
    const uint a = float_bits(found);
    const uint b = float_bits(static_cast<float>(truth));
    return a > b ? a - b : b - a;
}

struct Worst {
    double error = 0.0;
    uint distance = 0;
    float argument = 0.0f;

    void see(float found, double truth, float x) {
        const double here = ulps(found, truth);
        // A NaN or an infinity fails every comparison: it must not pass as a small error.
        if (!(here <= error)) {
            error = here;
            argument = x;
        }
        distance = std::max(distance, steps(found, truth));
    }
};

class Reciprocal : public testing::TestWithParam<uint> {};

TEST_P(Reciprocal, ErrorOverEveryMantissa) {
    Worst worst;
    for (uint mantissa = 0; mantissa < mantissas; ++mantissa) {
        for (const uint sign : {0u, 1u}) {
            const float x = make_float(GetParam(), mantissa, sign);
            worst.see(exact_reciprocal(x), 1.0 / static_cast<double>(x), x);
        }
    }
    RecordProperty("ulps", std::to_string(worst.error));
    EXPECT_LE(worst.error, reciprocal_bound) << "at " << worst.argument;
    EXPECT_LE(worst.distance, 1u);
}

INSTANTIATE_TEST_SUITE_P(Exponents, Reciprocal, testing::Values(1u, 2u, 127u, 128u, 251u, 252u));

class ReciprocalSquareRoot : public testing::TestWithParam<uint> {};

TEST_P(ReciprocalSquareRoot, ErrorOverEveryMantissa) {
    Worst worst;
    for (uint mantissa = 0; mantissa < mantissas; ++mantissa) {
        const float x = make_float(GetParam(), mantissa);
        worst.see(exact_rsqrt(x), 1.0 / std::sqrt(static_cast<double>(x)), x);
    }
    RecordProperty("ulps", std::to_string(worst.error));
    EXPECT_LE(worst.error, rsqrt_bound) << "at " << worst.argument;
    EXPECT_LE(worst.distance, 1u);
}

INSTANTIATE_TEST_SUITE_P(Exponents, ReciprocalSquareRoot, testing::Values(1u, 2u, 127u, 128u, 253u, 254u));

TEST(Exact, ErrorsOverEveryExponent) {
    std::mt19937 random(7);
    Worst reciprocal;
    Worst rsqrt;
    for (uint exponent = 1; exponent <= 254; ++exponent) {
        for (int i = 0; i < 4096; ++i) {
            const uint mantissa = i == 0 ? 0u : (i == 1 ? mantissas - 1u : random() % mantissas);
            const float x = make_float(exponent, mantissa);
            if (x <= 0x1p126f) {
                reciprocal.see(exact_reciprocal(x), 1.0 / static_cast<double>(x), x);
                reciprocal.see(exact_reciprocal(-x), -1.0 / static_cast<double>(x), -x);
            }
            rsqrt.see(exact_rsqrt(x), 1.0 / std::sqrt(static_cast<double>(x)), x);
        }
    }
    EXPECT_LE(reciprocal.error, reciprocal_bound) << "at " << reciprocal.argument;
    EXPECT_LE(rsqrt.error, rsqrt_bound) << "at " << rsqrt.argument;
}

TEST(Exact, DivisionError) {
    std::mt19937 random(8);
    Worst worst;
    for (int i = 0; i < 20'000'000; ++i) {
        const float a = make_float(100u + random() % 55u, random() % mantissas, random() & 1u);
        const float b = make_float(100u + random() % 55u, random() % mantissas, random() & 1u);
        worst.see(exact_divide(a, b), static_cast<double>(a) / b, b);
    }
    RecordProperty("ulps", std::to_string(worst.error));
    EXPECT_LE(worst.error, divide_bound) << "dividing by " << worst.argument;
}

double relative_error(float b) {
    return std::fabs(exact_reciprocal(b) * static_cast<double>(b) - 1.0);
}

// Why the bound holds for every pair: the reciprocal's relative error is at most as many ULP of the quotient as it is
// units of 2^-24, and the product's rounding adds half a unit.
TEST(Exact, DivisionErrorIsBoundedForEveryPair) {
    double worst = 0.0;
    for (uint mantissa = 0; mantissa < mantissas; ++mantissa) {
        worst = std::max(worst, relative_error(make_float(127u, mantissa)));
    }
    EXPECT_LE(worst * 0x1p24 + 0.5, divide_bound);
}

TEST(Exact, DivisionByTheWorstDivisors) {
    Worst worst;
    int divisors = 0;
    for (uint mantissa = 0; mantissa < mantissas && divisors < 8; ++mantissa) {
        const float b = make_float(127u, mantissa);
        if (relative_error(b) < 1.6 * 0x1p-24) {
            continue;
        }
        ++divisors;
        for (uint numerator = 0; numerator < mantissas; ++numerator) {
            const float a = make_float(127u, numerator);
            worst.see(exact_divide(a, b), static_cast<double>(a) / b, b);
        }
    }
    EXPECT_EQ(divisors, 8);
    RecordProperty("ulps", std::to_string(worst.error));
    EXPECT_LE(worst.error, divide_bound) << "dividing by " << worst.argument;
}

TEST(Exact, PowersOfTwoAreExact) {
    for (int k = -126; k <= 126; ++k) {
        EXPECT_EQ(exact_reciprocal(std::ldexp(1.0f, k)), std::ldexp(1.0f, -k)) << k;
        EXPECT_EQ(exact_reciprocal(-std::ldexp(1.0f, k)), -std::ldexp(1.0f, -k)) << k;
        if (k >= -100 && k <= 100) {
            EXPECT_EQ(exact_divide(3.0f, std::ldexp(1.0f, k)), std::ldexp(3.0f, -k)) << k;
        }
    }
    for (int k = -63; k <= 63; ++k) {
        EXPECT_EQ(exact_rsqrt(std::ldexp(1.0f, 2 * k)), std::ldexp(1.0f, -k)) << k;
    }
}

void expect_bits(float found, float expected, const char* what) {
    if (std::isnan(expected)) {
        EXPECT_TRUE(std::isnan(found)) << what << " gives " << found;
    } else {
        EXPECT_EQ(float_bits(found), float_bits(expected)) << what << " gives " << found;
    }
}

TEST(Exact, SpecialReciprocals) {
    const float denormal = bits_float(1u);
    const float largest_denormal = bits_float(0x007fffffu);
    for (const float sign : {1.0f, -1.0f}) {
        expect_bits(exact_reciprocal(sign * 0.0f), sign * infinity, "1/0");
        expect_bits(exact_reciprocal(sign * denormal), sign * infinity, "1/denormal");
        expect_bits(exact_reciprocal(sign * largest_denormal), sign * infinity, "1/denormal");
        expect_bits(exact_reciprocal(sign * infinity), sign * 0.0f, "1/infinity");
        expect_bits(exact_reciprocal(sign * 0x1.000002p126f), sign * 0.0f, "1/2^126.01");
        expect_bits(exact_reciprocal(sign * std::numeric_limits<float>::max()), sign * 0.0f, "1/largest");
        expect_bits(exact_reciprocal(sign * nan_value), nan_value, "1/NaN");
    }
}

TEST(Exact, SpecialReciprocalSquareRoots) {
    expect_bits(exact_rsqrt(0.0f), infinity, "0");
    expect_bits(exact_rsqrt(bits_float(1u)), infinity, "a denormal");
    expect_bits(exact_rsqrt(infinity), 0.0f, "infinity");
    expect_bits(exact_rsqrt(-1.0f), nan_value, "-1");
    expect_bits(exact_rsqrt(-infinity), nan_value, "-infinity");
    expect_bits(exact_rsqrt(-std::numeric_limits<float>::min()), nan_value, "the least negative normal");
    expect_bits(exact_rsqrt(nan_value), nan_value, "NaN");
}

TEST(Exact, FlushTiny) {
    EXPECT_EQ(float_bits(flush_tiny(0x1.fffffep-61f)), 0u);
    EXPECT_EQ(float_bits(flush_tiny(-0x1.fffffep-61f)), 0u);
    EXPECT_EQ(float_bits(flush_tiny(-0.0f)), 0u);
    EXPECT_EQ(float_bits(flush_tiny(bits_float(0x80000001u))), 0u);
    EXPECT_EQ(flush_tiny(0x1p-60f), 0x1p-60f);
    EXPECT_EQ(flush_tiny(-0x1p-60f), -0x1p-60f);
    EXPECT_TRUE(std::isnan(flush_tiny(nan_value)));
    EXPECT_EQ(flush_tiny(-infinity), -infinity);
}

TEST(Exponential, ErrorOverItsRange) {
    Worst worst;
    constexpr int steps_per_unit = 1 << 16;
    for (int i = -126 * steps_per_unit; i < 128 * steps_per_unit; ++i) {
        const float x = static_cast<float>(i) / steps_per_unit;
        worst.see(exact_exp2(x), std::exp2(static_cast<double>(x)), x);
    }
    EXPECT_LE(worst.error, 1.14) << "at " << worst.argument;
    EXPECT_EQ(exact_exp2(0.0f), 1.0f);
    EXPECT_EQ(exact_exp2(10.0f), 1024.0f);
    EXPECT_EQ(exact_exp2(-126.5f), 0.0f);
    EXPECT_EQ(exact_exp2(-infinity), 0.0f);
    EXPECT_EQ(exact_exp2(128.0f), infinity);
    EXPECT_EQ(exact_exp2(infinity), infinity);
    EXPECT_TRUE(std::isnan(exact_exp2(nan_value)));
}

TEST(Logarithm, ErrorOverEveryMantissa) {
    Worst worst;
    for (const uint exponent : {1u, 60u, 126u, 127u, 128u, 254u}) {
        for (uint mantissa = 0; mantissa < mantissas; ++mantissa) {
            const float x = make_float(exponent, mantissa);
            if (x != 1.0f) worst.see(exact_log2(x), std::log2(static_cast<double>(x)), x);
        }
    }
    EXPECT_LE(worst.error, 2.2) << "at " << worst.argument;
    EXPECT_EQ(exact_log2(1.0f), 0.0f);
    EXPECT_EQ(exact_log2(0.125f), -3.0f);
}

TEST(Power, ErrorOverTheUnitInterval) {
    for (const float y : {0.5f, 1.0f, 5.0f, 150.0f, 600.0f, 10000.0f}) {
        double worst = 0.0;
        for (uint i = 1; i <= 1u << 20; ++i) {
            const float x = static_cast<float>(i) / (1u << 20);
            const double truth = std::pow(static_cast<double>(x), static_cast<double>(y));
            const float found = exact_power(x, y);
            if (truth < 1e-17) {
                ASSERT_LE(found, 1.1e-17f);
            } else {
                worst = std::max(worst, std::isnan(found) ? 1.0 : std::fabs(found - truth) / truth);
            }
        }
        EXPECT_LE(worst, 5e-6) << "exponent " << y;
    }
    EXPECT_EQ(exact_power(0.0f, 150.0f), 0.0f);
    EXPECT_EQ(exact_power(1.0f, 150.0f), 1.0f);
}

}  // namespace
}  // namespace tessera::kernels
