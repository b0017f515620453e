#include "bench/peers/opensubdiv_peer.hpp"

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "tessellate/pattern.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/cpuPatchTable.h>

#include <array>
#include <cmath>
#include <map>

namespace tessera::peers {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Osd = OpenSubdiv::Osd;

struct Point {
    std::array<float, 3> at{};
    void Clear(void* = nullptr) { at = {}; }
    void AddWithWeight(const Point& other, float weight) {
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] += weight * other.at[k];
        }
    }
};

// Corners of the workload's triangles, welded by position.
struct Cage {
    std::vector<Point> points;
    std::vector<int> indices;
};

Cage weld(const patches::PatchSet& set) {
    Cage cage;
    std::map<std::array<float, 3>, int> known;
    for (const patches::PatchCorners& corners : set.corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float* p = set.control_vertices[corners[k]].position;
            const std::array<float, 3> at{p[0], p[1], p[2]};
            const auto [found, is_new] = known.try_emplace(at, static_cast<int>(cage.points.size()));
            if (is_new) cage.points.push_back({at});
            cage.indices.push_back(found->second);
        }
    }
    return cage;
}

std::unique_ptr<Far::TopologyRefiner> refine(const Cage& cage, const Far::PatchTableFactory::Options& options) {
    const std::vector<int> three(cage.indices.size() / 3, 3);
    Far::TopologyDescriptor topology;
    topology.numVertices = static_cast<int>(cage.points.size());
    topology.numFaces = static_cast<int>(three.size());
    topology.numVertsPerFace = three.data();
    topology.vertIndicesPerFace = cage.indices.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    OpenSubdiv::Sdc::Options edges;
    edges.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(topology, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, edges)));
    if (!refiner) throw Error(ErrorKind::usage, "OpenSubdiv does not take the topology of this mesh.");
    refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
    return refiner;
}

class OpenSubdivPeer final : public bench::Peer {
public:
    OpenSubdivPeer(const bench::Workload& workload, const Pattern& pattern) {
        Far::PatchTableFactory::Options options(3);
        options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
        const Cage cage = weld(workload.patches);
        const auto refiner = refine(cage, options);
        const std::unique_ptr<Far::PatchTable> table(Far::PatchTableFactory::Create(*refiner, options));
        points_ = cage.points;
        const int refined = refiner->GetNumVerticesTotal();
        points_.resize(static_cast<std::size_t>(refined + table->GetNumLocalPoints()));
        const Far::PrimvarRefiner primvars(*refiner);
        Point* source = points_.data();
        for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
            Point* target = source + refiner->GetLevel(level - 1).GetNumVertices();
            primvars.Interpolate(level, source, target);
            source = target;
        }
        if (table->GetNumLocalPoints() > 0) table->ComputeLocalPointValues(points_.data(), points_.data() + refined);
        const Far::PatchMap map(*table);
        const auto faces = static_cast<int>(workload.patches.patch_count());
        for (int face = 0; face < faces; ++face) {
            for (const DomainPoint& p : pattern.points) {
                const float s = static_cast<float>(p.u) / 65536.0f, t = static_cast<float>(p.v) / 65536.0f;
                const Far::PatchTable::PatchHandle* handle = map.FindPatch(face, s, t);
                if (handle == nullptr)
                    throw Error(ErrorKind::usage, "OpenSubdiv has no patch for a face of this mesh.");
                coordinates_.emplace_back(*handle, s, t);
            }
        }
        table_ = std::make_unique<Osd::CpuPatchTable>(table.get());
        output_.resize(coordinates_.size() * output_floats);
    }

    void run() override {
        constexpr std::size_t block = 4096;
        const std::size_t blocks = (coordinates_.size() + block - 1) / block;
        oneapi::tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
            const std::size_t first = b * block;
            const std::size_t count = std::min(block, coordinates_.size() - first);
            float* out = output_.data() + first * output_floats;
            const Osd::BufferDescriptor place(0, 3, output_floats);
            Osd::CpuEvaluator::EvalPatches(points_.front().at.data(), Osd::BufferDescriptor(0, 3, 3), out, place,
                                           out + 3, place, out + 6, place, static_cast<int>(count),
                                           coordinates_.data() + first, table_->GetPatchArrayBuffer(),
                                           table_->GetPatchIndexBuffer(), table_->GetPatchParamBuffer());
        });
    }

    bench::OutputSize size() const override { return {coordinates_.size(), 0}; }
    std::uint64_t bytes() const override { return output_.size() * sizeof(float); }

    std::string check() override {
        std::fill(output_.begin(), output_.end(), std::nanf(""));
        run();
        for (const float x : output_) {
            if (!std::isfinite(x)) return "Some of its points were not written.";
        }
        return {};
    }

    std::string note() const override {
        return "Loop limit surface, position and two derivatives in 36 bytes, no triangles; refinement is not timed";
    }

private:
    static constexpr int output_floats = 9;

    std::vector<Point> points_;
    std::vector<Osd::PatchCoord> coordinates_;
    std::unique_ptr<Osd::CpuPatchTable> table_;
    std::vector<float> output_;
};

}  // namespace

std::unique_ptr<bench::Peer> make_opensubdiv(const bench::Workload& workload) {
    constexpr std::uint64_t most_patches = 100000;
    if (!workload.uniform_factor || *workload.uniform_factor < 2.0f || workload.patches.has_quads ||
        workload.patches.patch_count() > most_patches) {
        return nullptr;
    }
    const PatchFactors factors = bench::equal_factors(*workload.uniform_factor);
    const Pattern pattern = make_patterns(backends::open_device("reference"), Domain::triangle,
                                          workload.options.partitioning, true, std::span(&factors, 1))
                                .front();
    return std::make_unique<OpenSubdivPeer>(workload, pattern);
}

}  // namespace tessera::peers
