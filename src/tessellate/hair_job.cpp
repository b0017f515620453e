#include "tessellate/hair_job.hpp"

#include "base/error.hpp"
#include "layout.h"
#include "tessellate/launch_shape.hpp"
#include "tessellate/stage_clock.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace tessera {
namespace {

using gpu::BufferUsage;
using HairPatchWords = std::array<std::uint32_t, HAIR_PATCH_WORDS>;

constexpr std::uint32_t hairs_per_part = 64;  // lines of the densest isoline patch

// The largest part: 64 hairs of 64 segments.
constexpr std::uint64_t largest_part_vertices = std::uint64_t{RIBBON_VERTICES} * hairs_per_part * 65;
constexpr std::uint64_t largest_part_indices = std::uint64_t{RIBBON_INDICES} * hairs_per_part * 64;

// Bytes per part while a chunk is worked on: its words, factors, record, counts and offsets.
constexpr std::uint64_t part_bytes = (HAIR_PATCH_WORDS + PATCH_FACTORS + RECORD_WORDS + 2 * COUNT_WORDS) * 4 + 1;

/// Cuts like plan_job: a third of the free budget for the chunk, the rest for output.
JobPlan plan_hair(std::uint64_t parts, std::uint64_t shared_bytes, std::uint64_t budget, const gpu::Limits& limits) {
    constexpr std::uint64_t small_buffers = 64 << 10;
    constexpr std::uint64_t vertex_bytes = largest_part_vertices * sizeof(Vertex);
    constexpr std::uint64_t index_bytes = largest_part_indices * 4;
    const std::uint64_t least = shared_bytes + small_buffers + part_bytes + vertex_bytes + index_bytes;
    if (budget < least) {
        throw Error(ErrorKind::usage,
                    fmt::format("The memory budget of {} bytes is too small for this hair; it needs at least {}.",
                                budget, least));
    }
    const std::uint64_t binding = std::min(limits.max_storage_binding_size, limits.max_buffer_size);
    const std::uint64_t free_bytes = budget - shared_bytes - small_buffers;
    const std::uint64_t by_budget =
        std::max<std::uint64_t>(1, std::min(free_bytes / 3, free_bytes - vertex_bytes - index_bytes) / part_bytes);
    const std::uint64_t chunk = std::min<std::uint64_t>(
        {by_budget, binding / (HAIR_PATCH_WORDS * 4), 0xffffffffull / largest_part_indices, parts});
    JobPlan plan;
    for (std::uint64_t first = 0; first < parts; first += chunk)
        plan.chunks.push_back({first, static_cast<std::uint32_t>(std::min(chunk, parts - first))});
    plan.largest_chunk = static_cast<std::uint32_t>(chunk);
    const std::uint64_t output = free_bytes - chunk * part_bytes;
    const std::uint64_t vertex_share = std::clamp(output * 8 / 11, vertex_bytes, output - index_bytes);
    plan.vertex_buffer_bytes = std::min(binding, vertex_share) / sizeof(Vertex) * sizeof(Vertex);
    plan.index_buffer_bytes = std::min(binding, output - plan.vertex_buffer_bytes) / 12 * 12;
    return plan;
}

std::uint64_t curve_bytes(const patches::HairSet& hair) {
    return std::uint64_t{hair.segments.size()} * GUIDE_CURVE_FLOATS * 4;
}

std::uint64_t guide_bytes(const patches::HairSet& hair) {
    return hair.points.size() * sizeof(patches::GuidePoint) + hair.segments.size() * 4 + curve_bytes(hair);
}

void check_guides(const patches::HairSet& hair, const gpu::Limits& limits) {
    if (curve_bytes(hair) > std::min(limits.max_storage_binding_size, limits.max_buffer_size)) {
        throw Error(
            ErrorKind::usage,
            fmt::format("The guides of hair have {} segments ({} bytes of curves), more than one binding of the "
                        "device holds ({} bytes); split the model.",
                        hair.segments.size(), curve_bytes(hair), limits.max_storage_binding_size));
    }
}

/// Where a sequence of hairs begins: any function of the guides that tells patches apart.
std::uint32_t seed_of(const patches::HairPatch& patch) {
    std::uint32_t hash = 0x9e3779b9u;
    for (const std::uint32_t guide : patch) {
        hash = (hash ^ guide) * 0x85ebca6bu;
        hash ^= hash >> 15;
    }
    return hash;
}

float flush(float x) {
    return std::fabs(x) < 0x1p-30f ? 0.0f : x;
}

/// The eye in kernel space. Far beyond the model only its direction counts: it is brought near enough for floats.
glm::vec3 kernel_eye(const glm::dvec3& eye, int exponent) {
    constexpr double far_away = 0x1p30;
    glm::dvec3 scaled;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        scaled[axis] = std::scalbn(eye[axis], -exponent);
        largest = std::max(largest, std::abs(scaled[axis]));
    }
    if (largest > far_away) scaled *= far_away / largest;
    return {flush(static_cast<float>(scaled.x)), flush(static_cast<float>(scaled.y)),
            flush(static_cast<float>(scaled.z))};
}

glm::vec3 unit_direction(const glm::vec3& direction) {
    const glm::vec3 unit(glm::normalize(glm::dvec3(direction)));
    return {flush(unit.x), flush(unit.y), flush(unit.z)};
}

}  // namespace

struct HairJob::State {
    gpu::Device device;
    const patches::HairSet& hair;
    HairOptions options;
    glm::vec3 eye;  // in kernel space
    std::uint32_t parts_per_patch;
    JobPlan plan;
    ParameterRing parameters;
    PatchCounter counter;
    StageClock clock;
    gpu::Buffer points, segments, curves, hair_patches, vertices, indices;
    Stage curves_stage, vertices_stage, indices_stage;
    bool curves_made = false;
    std::size_t current_chunk = 0;
    std::vector<PatchOffset> offsets;
    std::vector<Batch> batches;
    Batch emitted;
    std::optional<std::uint32_t> poison;

    State(gpu::Device d, const patches::HairSet& h, const HairOptions& o, const gpu::Limits& limits)
        : device(std::move(d)),
          hair(h),
          options(o),
          eye(kernel_eye(o.eye, h.exponent)),
          parts_per_patch((o.hairs + hairs_per_part - 1) / hairs_per_part),
          plan(plan_hair(h.patches.size() * parts_per_patch, guide_bytes(h), o.memory_budget, limits)),
          parameters(device, PatchCounter::parameter_slots + 1),
          counter(device, plan.largest_chunk, true, parameters),
          clock(device, o.time_stages),
          points(storage("guide points", h.points.size() * sizeof(patches::GuidePoint))),
          segments(storage("guide segments", h.segments.size() * 4)),
          curves(storage("guide curves", curve_bytes(h))),
          hair_patches(storage("hair patches", std::uint64_t{plan.largest_chunk} * HAIR_PATCH_WORDS * 4)),
          curves_stage(device, "guide_curves", {points, segments, curves}, parameters) {
        device.queue().write_buffer(points, 0, std::as_bytes(std::span(hair.points)));
        device.queue().write_buffer(segments, 0, std::as_bytes(std::span(hair.segments)));
    }

    gpu::Buffer storage(const char* label, std::uint64_t bytes) {
        return device.create_buffer({label, bytes, storage_usage});
    }

    /// Hairs between the guides of a patch: one where there is but one guide.
    std::uint32_t hairs_of(const patches::HairPatch& patch) const {
        return patch[1] == patches::no_guide ? 1 : options.hairs;
    }

    HairPatchWords words_of(const patches::HairPatch& patch, std::uint32_t part) const {
        HairPatchWords words{};
        std::uint32_t guides = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            // Guides that are not there get the weight 0: any curve will do.
            const patches::GuideRange& range = hair.guides[patch[i] == patches::no_guide ? patch[0] : patch[i]];
            words[2 * i] = range.first_segment;
            words[2 * i + 1] = range.segment_count;
            guides += patch[i] == patches::no_guide ? 0 : 1;
        }
        words[6] = guides;
        words[7] = part * hairs_per_part;
        words[8] = hairs_of(patch);
        words[9] = seed_of(patch);
        return words;
    }

    void upload_chunk(const Chunk& chunk) {
        std::vector<HairPatchWords> words;
        std::vector<PatchFactors> factors;
        words.reserve(chunk.patch_count);
        factors.reserve(chunk.patch_count);
        for (std::uint64_t i = chunk.first_patch; i < chunk.first_patch + chunk.patch_count; ++i) {
            const patches::HairPatch& patch = hair.patches[i / parts_per_patch];
            const auto part = static_cast<std::uint32_t>(i % parts_per_patch);
            const std::uint32_t first = part * hairs_per_part;
            const std::uint32_t left = hairs_of(patch) > first ? hairs_of(patch) - first : 0;  // 0: culled
            words.push_back(words_of(patch, part));
            factors.push_back({static_cast<float>(std::min(left, hairs_per_part)), static_cast<float>(options.segments),
                               0.0f, 0.0f, 0.0f, 0.0f});
        }
        device.queue().write_buffer(hair_patches, 0, std::as_bytes(std::span(words)));
        counter.upload_factors(device, factors);
    }

    void fill(gpu::CommandEncoder& encoder, std::initializer_list<gpu::Buffer> outputs) const {
        for (const gpu::Buffer& output : outputs) {
            if (poison && output) encoder.fill_buffer(output, 0, output.size(), *poison);
        }
    }

    void reserve_output() {
        std::uint64_t vertex_bytes = 0;
        std::uint64_t index_bytes = 0;
        for (const Batch& batch : batches) {
            vertex_bytes = std::max(vertex_bytes, std::uint64_t{batch.vertex_count} * sizeof(Vertex));
            index_bytes = std::max(index_bytes, std::uint64_t{batch.index_count} * 4);
        }
        if (vertex_bytes > (vertices ? vertices.size() : 0)) {
            if (vertices) vertices.destroy();
            vertices = storage("ribbon vertices", vertex_bytes);
            vertices_stage = Stage(device, "vertices_hair",
                                   {curves, hair_patches, counter.records(), counter.offsets(), vertices}, parameters);
        }
        if (index_bytes > (indices ? indices.size() : 0)) {
            if (indices) indices.destroy();
            indices = storage("ribbon indices", index_bytes);
            indices_stage = Stage(device, "indices_hair", {counter.records(), counter.offsets(), indices}, parameters);
        }
    }

    kernels::RibbonParams ribbon_params(const Batch& batch, std::uint32_t lanes, std::uint32_t vertex_base) const {
        const bool camera = options.ribbons == Ribbons::camera;
        const glm::vec3 target = camera ? eye : unit_direction(options.direction);
        return {batch.first_patch,
                batch.patch_count,
                lanes,
                batch.first_vertex,
                batch.first_index,
                vertex_base,
                static_cast<std::uint32_t>(options.ribbons),
                flush(options.taper),
                static_cast<std::uint32_t>(options.variation * 65536.0f),
                target.x,
                target.y,
                target.z};
    }
};

HairJob::HairJob(gpu::Device device, const patches::HairSet& hair, const HairOptions& options,
                 const gpu::Limits& limits) {
    assert(!hair.empty());
    check(options);
    check_guides(hair, limits);
    state_ = std::make_unique<State>(std::move(device), hair, options, limits);
}

HairJob::~HairJob() = default;

void HairJob::poison_outputs(std::uint32_t word) {
    state_->poison = word;
}

void HairJob::face(const glm::vec3& eye) {
    HairOptions options = state_->options;
    options.ribbons = Ribbons::camera;
    options.eye = eye;
    check(options);
    state_->options.ribbons = Ribbons::camera;
    state_->eye = kernel_eye(eye, 0);
}

std::uint32_t HairJob::parts_per_patch() const {
    return state_->parts_per_patch;
}
std::size_t HairJob::chunk_count() const {
    return state_->plan.chunks.size();
}
const Chunk& HairJob::chunk(std::size_t index) const {
    return state_->plan.chunks.at(index);
}

const std::vector<PatchOffset>& HairJob::count(std::size_t index) {
    State& s = *state_;
    const Chunk& chunk = s.plan.chunks.at(index);
    s.current_chunk = index;
    s.upload_chunk(chunk);
    s.parameters.reset();
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.counter.records(), s.counter.counts(), s.counter.offsets()});
    s.clock.begin(encoder);
    const auto record = [&](StageId stage, auto&& body) {
        gpu::ComputePass pass = encoder.begin_compute_pass();
        body(pass);
        pass.end();
        s.clock.mark(encoder, stage);
    };
    const Partitioning partitioning =
        s.options.partitioning == Partitioning::uniform ? Partitioning::integer : s.options.partitioning;
    record(StageId::factors, [&](gpu::ComputePass& p) {
        s.counter.record_factors(p, chunk.patch_count, Domain::isoline, partitioning, false);
    });
    record(StageId::counts, [&](gpu::ComputePass& p) { s.counter.record_counts(p, chunk.patch_count); });
    record(StageId::scan, [&](gpu::ComputePass& p) { s.counter.record_scan(p, chunk.patch_count); });
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    s.offsets = s.counter.read_offsets(s.device, chunk.patch_count);
    for (PatchOffset& offset : s.offsets) {
        offset.vertex *= RIBBON_VERTICES;
        offset.index *= RIBBON_INDICES / 2;  // the scan counts two indices per segment
    }
    return s.offsets;
}

const std::vector<Batch>& HairJob::prepare() {
    State& s = *state_;
    if (!s.curves_made) {
        s.parameters.reset();
        gpu::CommandEncoder encoder = s.device.create_command_encoder();
        s.fill(encoder, {s.curves});
        s.clock.begin(encoder);
        gpu::ComputePass pass = encoder.begin_compute_pass();
        const auto count = static_cast<std::uint32_t>(s.hair.segments.size());
        s.curves_stage.record(pass, s.parameters.push(kernels::GuideCurvesParams{count}), count);
        pass.end();
        s.clock.mark(encoder, StageId::control_nets);
        s.clock.finish(encoder);
        s.parameters.upload(s.device);
        s.device.queue().submit(encoder.finish());
        s.clock.collect(s.device);
        s.curves_made = true;
    }
    s.batches = plan_batches(s.offsets, s.plan);
    s.reserve_output();
    return s.batches;
}

void HairJob::emit(const Batch& batch, std::uint32_t vertex_base) {
    State& s = *state_;
    s.parameters.reset();
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.vertices, s.indices});
    s.clock.begin(encoder);
    const auto record = [&](StageId id, const Stage& stage, std::uint64_t elements) {
        const std::uint32_t lanes = lanes_log2(s.device.info(), batch.patch_count, elements);
        const std::uint32_t slot = s.parameters.push(s.ribbon_params(batch, lanes, vertex_base));
        gpu::ComputePass pass = encoder.begin_compute_pass();
        stage.record(pass, slot, std::uint64_t{batch.patch_count} << lanes);
        pass.end();
        s.clock.mark(encoder, id);
    };
    record(StageId::vertices, s.vertices_stage, batch.vertex_count / RIBBON_VERTICES);
    record(StageId::indices, s.indices_stage, batch.index_count / RIBBON_INDICES);
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    s.emitted = batch;
}

std::vector<StageView> HairJob::prepared_views() const {
    const State& s = *state_;
    const std::uint64_t patches = s.plan.chunks[s.current_chunk].patch_count;
    return {
        {StageId::factors, s.counter.records(), patches * RECORD_WORDS * 4, false},
        {StageId::control_nets, s.curves, curve_bytes(s.hair), true},
        {StageId::counts, s.counter.counts(), patches * COUNT_WORDS * 4, false},
        {StageId::scan, s.counter.offsets(), (patches + 1) * COUNT_WORDS * 4, false},
    };
}

std::vector<StageView> HairJob::emitted_views() const {
    const State& s = *state_;
    return {
        {StageId::vertices, s.vertices, std::uint64_t{s.emitted.vertex_count} * sizeof(Vertex), true},
        {StageId::indices, s.indices, std::uint64_t{s.emitted.index_count} * 4, false},
    };
}

const StageTimes& HairJob::times() {
    return state_->clock.times();
}

std::uint64_t HairJob::device_bytes() const {
    const State& s = *state_;
    std::uint64_t bytes = s.parameters.buffer().size() + s.counter.device_bytes();
    for (const gpu::Buffer* buffer : {&s.points, &s.segments, &s.curves, &s.hair_patches, &s.vertices, &s.indices}) {
        bytes += *buffer ? buffer->size() : 0;
    }
    return bytes;
}

}  // namespace tessera
