// Models of any size: tiny and huge copies are the same job to the kernels, and come out at their own size.
#include "scene/shapes.hpp"
#include "support/devices.hpp"
#include "tessellate/models.hpp"
#include "tessellate/tessellate.hpp"

#include <cmath>
#include <cstring>

namespace tessera {
namespace {

patches::PatchSet scaled_torus(double factor) {
    scene::Scene scene = scene::make_shape("shape:torus");
    for (glm::vec3& p : scene.meshes[0].positions) {
        for (int k = 0; k < 3; ++k) {
            // The sine of pi is not quite 0; what it gives would be denormal in a tiny copy.
            p[k] = std::fabs(p[k]) < 1e-6f ? 0.0f : static_cast<float>(p[k] * factor);
        }
    }
    return patches::make_patches(scene);
}

RefinedMesh run(const std::string& device, const patches::PatchSet& set, Space space) {
    TessellationOptions options;
    options.factors = PatchFactors{3, 4.5f, 5, 6, 0, 0};
    Tessellator tessellator(test::open_device(device), set, options);
    RefinedMesh mesh;
    tessellator.run(mesh, space);
    return mesh;
}

class Scale : public testing::TestWithParam<gpu::DeviceInfo> {};

// 2^-100 is about 1e-30.
TEST_P(Scale, PowersOfTwoGiveTheSameBitsInKernelSpace) {
    const RefinedMesh expected = run(GetParam().id, scaled_torus(1.0), Space::kernel);
    for (const int power : {-100, 100}) {
        const patches::PatchSet set = scaled_torus(std::ldexp(1.0, power));
        EXPECT_EQ(set.exponent, power);
        const RefinedMesh found = run(GetParam().id, set, Space::kernel);
        ASSERT_EQ(found.vertices.size(), expected.vertices.size());
        EXPECT_EQ(std::memcmp(found.vertices.data(), expected.vertices.data(), found.vertices.size() * sizeof(Vertex)),
                  0);
        EXPECT_EQ(found.indices, expected.indices);
    }
}

TEST_P(Scale, TinyAndHugeModelsKeepTheirSize) {
    const RefinedMesh expected = run(GetParam().id, scaled_torus(1.0), Space::model);
    for (const double factor : {1e-30, 1e30, 2e-38, 1e38}) {
        const RefinedMesh found = run(GetParam().id, scaled_torus(factor), Space::model);
        ASSERT_EQ(found.vertices.size(), expected.vertices.size());
        for (std::size_t i = 0; i < found.vertices.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_NEAR(found.vertices[i].position[k] / factor, expected.vertices[i].position[k], 2e-6) << factor;
                ASSERT_TRUE(std::isfinite(found.vertices[i].normal[k]));
            }
        }
    }
}

TESSERA_ON_EVERY_DEVICE(Scale);

}  // namespace
}  // namespace tessera
