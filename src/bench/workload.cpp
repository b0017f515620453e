#include "bench/workload.hpp"

#include "base/error.hpp"
#include "scene/scene.hpp"
#include "tessellate/edge_factors.hpp"

#include <fmt/format.h>

namespace tessera::bench {
namespace {

constexpr std::uint64_t memory_budget = 1ull << 30;
constexpr std::uint64_t seed = 1;

std::string model(const WorkloadSource& source, const char* path) {
    if (source.models.empty()) {
        throw Error(ErrorKind::usage,
                    fmt::format("The model {} is not here; set TESSERA_SHARED to the folder that holds models/{}.",
                                path, path));
    }
    return (source.models / path).string();
}

Workload make(const std::string& id, const std::string& description, const std::string& scene,
              Partitioning partitioning, float factor) {
    Workload workload{id, description, patches::make_patches(scene::load_scene(scene)), {}, factor};
    workload.options.scheme = Scheme::pn;
    workload.options.normals = Normals::quadratic;
    workload.options.partitioning = partitioning;
    workload.options.factors = equal_factors(factor);
    workload.options.memory_budget = memory_budget;
    return workload;
}

}  // namespace

PatchFactors equal_factors(float factor) {
    return {factor, factor, factor, factor, factor, factor};
}

std::vector<std::string> job_workloads() {
    return {"W1", "W1-64", "W2", "W3", "W3-1", "W4"};
}

Workload make_workload(const std::string& id, const WorkloadSource& source) {
    const char* sphere = source.quick ? "shape:sphere:5" : "shape:sphere:50";
    const char* count = source.quick ? "200" : "20,000";
    if (id == "W1") {
        return make(id, fmt::format("{} PN patches, factor 16, integer", count), sphere, Partitioning::integer, 16.0f);
    }
    if (id == "W1-64") {
        return make(id, fmt::format("{} PN patches, factor 64, integer", count), sphere, Partitioning::integer, 64.0f);
    }
    if (id == "W2") {
        Workload workload = make(id, fmt::format("{} PN patches, random factors 1..64 per edge, fractional_odd", count),
                                 sphere, Partitioning::fractional_odd, 1.0f);
        workload.options.factors = random_edge_factors(workload.patches, 1.0f, 64.0f, seed);
        workload.uniform_factor.reset();
        return workload;
    }
    if (id == "W3" || id == "W3-1") {
        const float factor = id == "W3" ? 4.0f : 1.0f;
        const char* path = source.quick ? "spot/spot_control_mesh.obj" : "HugeSpot/spot_cc5.glb";
        return make(id, fmt::format("{}, factor {}, integer", path, factor), model(source, path), Partitioning::integer,
                    factor);
    }
    if (id == "W4") {
        return make(id, "quads of rook, factor 32, integer", model(source, "opensubdiv/catmark_rook.obj"),
                    Partitioning::integer, 32.0f);
    }
    throw Error(ErrorKind::usage,
                fmt::format("There is no workload named \"{}\"; choose W1, W2, W3, W4, W5, W6 or W7.", id));
}

}  // namespace tessera::bench
