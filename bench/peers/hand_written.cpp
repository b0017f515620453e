#include "bench/peers/hand_written.hpp"

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "base/host_memory.hpp"
#include "bench/peers/hand_written_loops_api.hpp"
#include "bench/sanity.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/tessellate.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace tessera::peers {
namespace {

using glm::vec3;

template <typename T>
class Aligned {
public:
    explicit Aligned(std::size_t count) : count_(count), memory_(count * sizeof(T)) {}
    T* data() { return reinterpret_cast<T*>(memory_.data()); }
    std::size_t size() const { return count_; }

private:
    std::size_t count_;
    HostMemory memory_;
};

Loops choose_loops() {
    if (__builtin_cpu_supports("avx512f")) return avx512_loops();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_loops();
    throw Error(ErrorKind::device_unavailable,
                "The hand-written evaluator needs AVX-512, or AVX2 with FMA, and this CPU has neither.");
}

// Vlachos et al. 2001, sections 3.2 and 3.3.
vec3 edge_point(vec3 p, vec3 n, vec3 q) {
    return (2.0f * p + q - glm::dot(q - p, n) * n) / 3.0f;
}

vec3 edge_normal(vec3 p, vec3 n, vec3 q, vec3 m) {
    const vec3 d = q - p;
    const float squared = glm::dot(d, d);
    const vec3 h = n + m - (squared > 0.0f ? 2.0f * glm::dot(d, n + m) / squared : 0.0f) * d;
    const float length = glm::length(h);
    return length > 0.0f ? h / length : vec3(0.0f);
}

void make_net(const Vertex& a, const Vertex& b, const Vertex& c, float* out) {
    const auto position = [](const Vertex& v) { return vec3(v.position[0], v.position[1], v.position[2]); };
    const auto normal = [](const Vertex& v) { return vec3(v.normal[0], v.normal[1], v.normal[2]); };
    const vec3 p0 = position(a), p1 = position(b), p2 = position(c);
    const vec3 n0 = normal(a), n1 = normal(b), n2 = normal(c);
    const vec3 p01 = edge_point(p0, n0, p1), p10 = edge_point(p1, n1, p0), p12 = edge_point(p1, n1, p2);
    const vec3 p21 = edge_point(p2, n2, p1), p20 = edge_point(p2, n2, p0), p02 = edge_point(p0, n0, p2);
    const vec3 mean = (p01 + p10 + p12 + p21 + p20 + p02) / 6.0f;
    const vec3 centre = mean + (mean - (p0 + p1 + p2) / 3.0f) * 0.5f;
    const vec3 all[16] = {p0,
                          p1,
                          p2,
                          p01,
                          p10,
                          p12,
                          p21,
                          p20,
                          p02,
                          centre,
                          n0,
                          n1,
                          n2,
                          edge_normal(p0, n0, p1, n1),
                          edge_normal(p1, n1, p2, n2),
                          edge_normal(p2, n2, p0, n0)};
    for (int i = 0; i < 16; ++i) {
        out[3 * i] = all[i].x;
        out[3 * i + 1] = all[i].y;
        out[3 * i + 2] = all[i].z;
    }
    const Vertex* corners[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i) {
        out[48 + 2 * i] = corners[i]->uv[0];
        out[48 + 2 * i + 1] = corners[i]->uv[1];
    }
}

void make_weights(DomainPoint point, float* out, std::size_t stride) {
    const float u = static_cast<float>(point.u) / 65536.0f, v = static_cast<float>(point.v) / 65536.0f;
    const float w = 1.0f - u - v;
    const float all[weight_rows] = {u * u * u,
                                    v * v * v,
                                    w * w * w,
                                    3 * u * u * v,
                                    3 * v * v * u,
                                    3 * v * v * w,
                                    3 * w * w * v,
                                    3 * w * w * u,
                                    3 * u * u * w,
                                    6 * u * v * w,
                                    u * u,
                                    v * v,
                                    w * w,
                                    u * v,
                                    v * w,
                                    w * u,
                                    u,
                                    v,
                                    w};
    for (std::size_t i = 0; i < weight_rows; ++i) {
        out[i * stride] = all[i];
    }
}

class HandWritten final : public bench::Peer {
public:
    HandWritten(const bench::Workload& workload, Pattern pattern)
        : workload_(workload),
          loops_(choose_loops()),
          pattern_(std::move(pattern)),
          patches_(static_cast<std::uint32_t>(workload.patches.patch_count())),
          nets_(std::size_t{patches_} * net_floats),
          weights_{Aligned<float>(weight_count(0)), Aligned<float>(weight_count(1))},
          vertices_(std::size_t{patches_} * pattern_.points.size() * 8),
          indices_(std::size_t{patches_} * pattern_.indices.size()) {
        fill_weights(0);
        fill_weights(1);
    }

    void run() override {
        const Emission emission{nets_.data(),
                                {weights_[0].data(), weights_[1].data()},
                                static_cast<std::uint32_t>(pattern_.points.size()),
                                pattern_.indices.data(),
                                static_cast<std::uint32_t>(pattern_.indices.size()),
                                vertices_.data(),
                                indices_.data()};
        const patches::PatchSet& set = workload_.patches;
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::uint32_t>(0, patches_, 32), [&](const auto& range) {
            for (std::uint32_t i = range.begin(); i < range.end(); ++i) {
                const patches::PatchCorners& c = set.corners[i];
                make_net(set.control_vertices[c[0]], set.control_vertices[c[1]], set.control_vertices[c[2]],
                         nets_.data() + std::size_t{i} * net_floats);
            }
            loops_.emit(emission, range.begin(), range.end());
        });
    }

    bench::OutputSize size() const override {
        return {patches_ * std::uint64_t{pattern_.points.size()},
                patches_ * std::uint64_t{pattern_.indices.size()} / 3};
    }

    std::string note() const override {
        return fmt::format("{}, fused multiply-adds, non-temporal stores, one precomputed pattern", loops_.name);
    }

    // Held against the reference: the same triangles, and floats within 1e-5.
    std::string check() override {
        std::fill_n(reinterpret_cast<std::uint32_t*>(vertices_.data()), vertices_.size(), bench::sentinel);
        std::fill_n(indices_.data(), indices_.size(), bench::sentinel);
        run();
        struct Sink : MeshSink {
            HandWritten& self;
            double worst = 0.0;
            bool same = true;
            explicit Sink(HandWritten& s) : self(s) {}
            void append(const MeshBatch& batch) override {
                const float* mine = self.vertices_.data() + batch.first_vertex * 8;
                const auto* theirs = reinterpret_cast<const float*>(batch.vertices.data());
                for (std::size_t i = 0; i < batch.vertices.size() * 8; ++i) {
                    const double difference = std::abs(static_cast<double>(mine[i]) - theirs[i]);
                    worst = difference <= 1e9 ? std::max(worst, difference) : 1e9;  // NaN is far off
                }
                same = same && std::ranges::equal(batch.indices, std::span(self.indices_.data() + batch.first_index,
                                                                           batch.indices.size()));
            }
        } sink(*this);
        Tessellator tessellator(backends::open_device("reference"), workload_.patches, workload_.options);
        tessellator.run(sink, Space::kernel);
        if (!sink.same) return "Its triangles differ from those of the reference.";
        if (sink.worst > 1e-5) return fmt::format("Its vertices are {:.3g} off those of the reference.", sink.worst);
        return {};
    }

private:
    std::size_t groups(std::size_t lead) const {
        const auto width = static_cast<std::size_t>(loops_.width);
        return (pattern_.points.size() + lead + width - 1) / width;
    }
    std::size_t weight_count(std::size_t lead) const {
        return groups(lead) * weight_rows * static_cast<std::size_t>(loops_.width);
    }

    void fill_weights(std::size_t lead) {
        const auto width = static_cast<std::size_t>(loops_.width);
        for (std::size_t group = 0; group < groups(lead); ++group) {
            for (std::size_t slot = 0; slot < width; ++slot) {
                const std::size_t place =
                    group * width + static_cast<std::size_t>(loops_.point_of_slot(static_cast<int>(slot)));
                const std::size_t last = pattern_.points.size() - 1;
                const std::size_t point = std::min(place < lead ? 0 : place - lead, last);
                make_weights(pattern_.points[point], weights_[lead].data() + group * weight_rows * width + slot, width);
            }
        }
    }

    const bench::Workload& workload_;
    Loops loops_;
    Pattern pattern_;
    std::uint32_t patches_;
    Aligned<float> nets_;
    std::array<Aligned<float>, 2> weights_;
    Aligned<float> vertices_;
    Aligned<std::uint32_t> indices_;
};

}  // namespace

std::unique_ptr<bench::Peer> make_hand_written(const bench::Workload& workload) {
    const TessellationOptions& options = workload.options;
    if (!workload.uniform_factor || *workload.uniform_factor < 2.0f || workload.patches.has_quads ||
        options.scheme != Scheme::pn || options.normals != Normals::quadratic) {
        return nullptr;
    }
    const PatchFactors factors = bench::equal_factors(*workload.uniform_factor);
    Pattern pattern = make_patterns(backends::open_device("reference"), Domain::triangle, options.partitioning, true,
                                    std::span(&factors, 1))
                          .front();
    return std::make_unique<HandWritten>(workload, std::move(pattern));
}

}  // namespace tessera::peers
