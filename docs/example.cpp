#include "tessera.hpp"

#include <cstdio>

int main() {
    using namespace tessera;
    const scene::Scene scene = scene::load_scene("assets/rabbit.glb");
    const patches::PatchSet patches = patches::make_patches(scene);
    TessellationOptions options;
    options.scheme = Scheme::pn;
    options.factors = PatchFactors{8, 8, 8, 8};
    const gpu::Device device = backends::open_device("reference");  // or "vulkan", "opencl": the same bits
    const RefinedMesh mesh = tessellate(device, patches, options);
    std::printf("%zu vertices, %zu triangles\n", mesh.vertices.size(), mesh.indices.size() / 3);
}
