#include "kernels/corners_gen.hpp"

namespace tessera::test {

using kernels::Vector;

kernels::Vector random_unit(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return kernels::normalise(kernels::make_vector(normal(random), normal(random), normal(random)),
                              kernels::make_vector(0.0f, 0.0f, 1.0f));
}

kernels::Corners random_corners(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-2.0f, 2.0f);
    const auto position = [&] {
        return kernels::make_vector(coordinate(random), coordinate(random), coordinate(random));
    };
    // Normals of one side: a common direction, bent by up to about 60 degrees.
    const Vector side = random_unit(random);
    const auto normal = [&] {
        return kernels::normalise(kernels::add(side, kernels::scale(random_unit(random), 0.85f)), side);
    };
    kernels::Corners corners;
    corners.p0 = position();
    corners.p1 = position();
    corners.p2 = position();
    corners.n0 = normal();
    corners.n1 = normal();
    corners.n2 = normal();
    return corners;
}

}  // namespace tessera::test
