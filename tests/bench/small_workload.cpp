#include "bench/small_workload.hpp"

#include "scene/scene.hpp"
#include "tessellate/edge_factors.hpp"

namespace tessera::test {

bench::Workload small_workload(const std::string& shape, float factor) {
    bench::Workload workload{"W1", "small", patches::make_patches(scene::load_scene(shape)), {}, factor};
    workload.options.partitioning = Partitioning::integer;
    workload.options.factors = bench::equal_factors(factor);
    workload.options.memory_budget = 64ull << 20;
    return workload;
}

bench::Workload uneven_workload() {
    bench::Workload workload = small_workload("shape:torus", 1.0f);
    workload.uniform_factor.reset();
    workload.options.partitioning = Partitioning::fractional_odd;
    workload.options.factors = random_edge_factors(workload.patches, 1.0f, 40.0f, 7);
    return workload;
}

}  // namespace tessera::test
