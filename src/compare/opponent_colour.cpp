#include "compare/opponent_colour.hpp"

#include <algorithm>
#include <cmath>

namespace tessera::compare {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr double determinant(const Matrix& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

constexpr Matrix inverse(const Matrix& m) {
    Matrix result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            result[row][column] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / determinant(m);
        }
    }
    return result;
}

constexpr std::array<double, 3> times(const Matrix& m, const std::array<double, 3>& v) {
    std::array<double, 3> result{};
    for (std::size_t row = 0; row < 3; ++row)
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return result;
}

// Linear sRGB to XYZ from the chromaticities of the primaries (ITU-R BT.709) and of CIE standard illuminant D65:
// columns are the primaries at the brightness that adds up to white.
constexpr Matrix rgb_to_xyz_matrix() {
    const std::array<double, 3> x{0.64, 0.30, 0.15}, y{0.33, 0.60, 0.06};
    Matrix primaries{};
    for (std::size_t i = 0; i < 3; ++i) {
        primaries[0][i] = x[i] / y[i];
        primaries[1][i] = 1.0;
        primaries[2][i] = (1.0 - x[i] - y[i]) / y[i];
    }
    const double white_x = 0.31271, white_y = 0.32902;
    const auto brightness = times(inverse(primaries), {white_x / white_y, 1.0, (1.0 - white_x - white_y) / white_y});
    for (auto& row : primaries) {
        for (std::size_t i = 0; i < 3; ++i)
            row[i] *= brightness[i];
    }
    return primaries;
}

constexpr Matrix rgb_to_xyz = rgb_to_xyz_matrix();
constexpr std::array<double, 3> white = times(rgb_to_xyz, {1.0, 1.0, 1.0});

// All spaces here count XYZ in units of white, so that division is part of the matrix.
using FloatMatrix = std::array<std::array<float, 3>, 3>;

constexpr FloatMatrix to_white_units() {
    FloatMatrix result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            result[row][column] = static_cast<float>(rgb_to_xyz[row][column] / white[row]);
    }
    return result;
}

constexpr FloatMatrix from_white_units() {
    const Matrix back = inverse(rgb_to_xyz);
    FloatMatrix result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            result[row][column] = static_cast<float>(back[row][column] * white[column]);
    }
    return result;
}

constexpr FloatMatrix rgb_to_white = to_white_units();
constexpr FloatMatrix white_to_rgb = from_white_units();

inline std::array<float, 3> times(const FloatMatrix& m, const std::array<float, 3>& v) {
    std::array<float, 3> result{};
    for (std::size_t row = 0; row < 3; ++row)
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return result;
}

/// CIE 15: a cube root, continued by its tangent near black.
inline float lightness(float t) {
    constexpr float delta = 6.0f / 29.0f;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

inline Opponent opponent_of(const std::array<float, 3>& v) {
    return {116.0f * v[1] - 16.0f, 500.0f * (v[0] - v[1]), 200.0f * (v[1] - v[2])};
}

}  // namespace

Opponent to_ycxcz(const Rgb& linear) {
    return opponent_of(times(rgb_to_white, linear));
}

Rgb from_ycxcz(const Opponent& colour) {
    const float y = (colour.luminance + 16.0f) / 116.0f;
    Rgb rgb = times(white_to_rgb, {y + colour.red_green / 500.0f, y, y - colour.blue_yellow / 200.0f});
    for (float& channel : rgb)
        channel = std::clamp(channel, 0.0f, 1.0f);
    return rgb;
}

Opponent to_adjusted_lab(const Rgb& linear) {
    const auto xyz = times(rgb_to_white, linear);
    Opponent lab = opponent_of({lightness(xyz[0]), lightness(xyz[1]), lightness(xyz[2])});
    lab.red_green *= 0.01f * lab.luminance;
    lab.blue_yellow *= 0.01f * lab.luminance;
    return lab;
}

float hyab(const Opponent& a, const Opponent& b) {
    const float red_green = a.red_green - b.red_green;
    const float blue_yellow = a.blue_yellow - b.blue_yellow;
    return std::abs(a.luminance - b.luminance) + std::sqrt(red_green * red_green + blue_yellow * blue_yellow);
}

}  // namespace tessera::compare
