#include "tessellate/job.hpp"

#include "base/error.hpp"
#include "layout.h"
#include "tessellate/launch_shape.hpp"
#include "tessellate/stage_clock.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tessera {
namespace {

using gpu::BufferUsage;

constexpr auto storage_usage = BufferUsage::storage | BufferUsage::copy_source | BufferUsage::copy_destination;
constexpr std::array<std::string_view, stage_count> stage_names{"factors", "control nets", "counts",
                                                                "scan",    "vertices",     "indices"};
constexpr std::array<std::string_view, 3> degree_names{"linear", "quadratic", "cubic"};

void check(const patches::PatchSet& patches, const TessellationOptions& options, const gpu::Limits& limits) {
    if (const auto* factors = std::get_if<std::vector<PatchFactors>>(&options.factors);
        factors != nullptr && factors->size() != patches.patch_count()) {
        throw Error(ErrorKind::usage, fmt::format("There are {} sets of tessellation factors for {} patches; give one "
                                                  "set, or one per patch.", factors->size(), patches.patch_count()));
    }
    if (!(options.alpha >= 0.0f && options.alpha <= 1.0f)) {
        throw Error(ErrorKind::usage, fmt::format("The shape factor alpha is {}; it must lie in [0, 1].", options.alpha));
    }
    const std::uint64_t bytes = patches.control_vertices.size() * sizeof(Vertex);
    if (bytes > limits.max_storage_binding_size) {
        throw Error(ErrorKind::usage, fmt::format("The model has {} control vertices ({} bytes), more than one binding "
                                                  "of the device holds ({} bytes); split the model.",
                                                  patches.control_vertices.size(), bytes,
                                                  limits.max_storage_binding_size));
    }
}

}  // namespace

std::string_view name(StageId stage) { return stage_names[static_cast<std::size_t>(stage)]; }

struct Job::State {
    gpu::Device device;
    const patches::PatchSet& patches;
    TessellationOptions options;
    JobPlan plan;
    ParameterRing parameters;
    PatchCounter counter;
    StageClock clock;
    gpu::Buffer control_vertices, patch_indices, nets, vertices, indices;
    Stage nets_stage, vertices_stage, indices_stage;
    std::size_t current_chunk = 0;
    std::vector<PatchOffset> offsets;
    std::vector<Batch> batches;
    Batch emitted;
    std::optional<std::uint32_t> poison;

    State(gpu::Device d, const patches::PatchSet& p, const TessellationOptions& o, const gpu::Limits& limits)
        : device(std::move(d)),
          patches(p),
          options(o),
          plan(plan_job(p.patch_count(), p.control_vertices.size() * sizeof(Vertex), o, limits)),
          parameters(device, PatchCounter::parameter_slots + 1),
          counter(device, plan.largest_chunk, factors_per_patch(), parameters),
          clock(device) {}

    bool factors_per_patch() const { return std::holds_alternative<std::vector<PatchFactors>>(options.factors); }

    gpu::Buffer storage(const char* label, std::uint64_t bytes) {
        return device.create_buffer({label, bytes, storage_usage});
    }

    std::string variant(const char* stage, std::string_view first) const {
        return fmt::format("{}_{}_{}", stage, first, name(options.normals));
    }

    void create_chunk_buffers() {
        control_vertices = storage("control vertices", patches.control_vertices.size() * sizeof(Vertex));
        patch_indices = storage("patch indices", std::uint64_t{plan.largest_chunk} * 12);
        nets = storage("control nets",
                       std::uint64_t{plan.largest_chunk} * net_floats(options.scheme, options.normals) * 4);
        nets_stage = Stage(device, variant("control_net", name(options.scheme)), {control_vertices, patch_indices, nets},
                           parameters);
        device.queue().write_buffer(control_vertices, 0, std::as_bytes(std::span(patches.control_vertices)));
    }

    void fill(gpu::CommandEncoder& encoder, std::initializer_list<gpu::Buffer> outputs) const {
        for (const gpu::Buffer& output : outputs) {
            if (poison) encoder.fill_buffer(output, 0, output.size(), *poison);
        }
    }

    // Output buffers grow to the largest batch seen; a job whose batches are alike allocates once.
    void reserve_output() {
        std::uint64_t vertex_bytes = 0;
        std::uint64_t index_bytes = 0;
        for (const Batch& batch : batches) {
            vertex_bytes = std::max(vertex_bytes, std::uint64_t{batch.vertex_count} * sizeof(Vertex));
            index_bytes = std::max(index_bytes, std::uint64_t{batch.index_count} * 4);
        }
        if (vertex_bytes > (vertices ? vertices.size() : 0)) {
            if (vertices) vertices.destroy();
            vertices = storage("vertices", vertex_bytes);
            const auto degree = degree_names[static_cast<std::size_t>(options.scheme)];
            vertices_stage = Stage(device, variant("vertices", degree),
                                   {nets, counter.records(), counter.offsets(), vertices}, parameters);
        }
        if (index_bytes > (indices ? indices.size() : 0)) {
            if (indices) indices.destroy();
            indices = storage("indices", index_bytes);
            indices_stage = Stage(device, "indices_triangle", {counter.records(), counter.offsets(), indices}, parameters);
        }
    }
};

Job::Job(gpu::Device device, const patches::PatchSet& patches, const TessellationOptions& options,
         const gpu::Limits& limits) {
    check(patches, options, limits);
    state_ = std::make_unique<State>(std::move(device), patches, options, limits);
    state_->create_chunk_buffers();
}

Job::~Job() = default;

void Job::poison_outputs(std::uint32_t word) { state_->poison = word; }

std::size_t Job::chunk_count() const { return state_->plan.chunks.size(); }
const Chunk& Job::chunk(std::size_t index) const { return state_->plan.chunks.at(index); }

const std::vector<PatchOffset>& Job::count(std::size_t index) {
    State& s = *state_;
    const Chunk& chunk = s.plan.chunks.at(index);
    s.current_chunk = index;
    if (const auto* factors = std::get_if<std::vector<PatchFactors>>(&s.options.factors)) {
        s.counter.upload_factors(s.device, std::span(*factors).subspan(chunk.first_patch, chunk.patch_count));
    } else {
        s.counter.upload_factors(s.device, std::span(&std::get<PatchFactors>(s.options.factors), 1));
    }
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
    record(StageId::factors,
           [&](gpu::ComputePass& p) { s.counter.record_factors(p, chunk.patch_count, Domain::triangle, s.options.partitioning, false); });
    record(StageId::counts, [&](gpu::ComputePass& p) { s.counter.record_counts(p, chunk.patch_count); });
    record(StageId::scan, [&](gpu::ComputePass& p) { s.counter.record_scan(p, chunk.patch_count); });
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    s.offsets = s.counter.read_offsets(s.device, chunk.patch_count);
    return s.offsets;
}

const std::vector<Batch>& Job::prepare() {
    State& s = *state_;
    const Chunk& chunk = s.plan.chunks[s.current_chunk];
    const std::span indices = std::span(s.patches.indices).subspan(chunk.first_patch * 3, chunk.patch_count * 3ull);
    s.device.queue().write_buffer(s.patch_indices, 0, std::as_bytes(indices));
    s.parameters.reset();
    const std::uint32_t offset = s.parameters.push(kernels::ControlNetsParams{chunk.patch_count, s.options.alpha});
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.nets});
    s.clock.begin(encoder);
    gpu::ComputePass pass = encoder.begin_compute_pass();
    s.nets_stage.record(pass, offset, chunk.patch_count);
    pass.end();
    s.clock.mark(encoder, StageId::control_nets);
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    s.batches = plan_batches(s.offsets, s.plan);
    s.reserve_output();
    return s.batches;
}

void Job::emit(const Batch& batch, std::uint32_t vertex_base) {
    State& s = *state_;
    s.parameters.reset();
    const auto params = [&](std::uint32_t lanes) {
        return kernels::EmitParams{batch.first_patch, batch.patch_count, lanes,
                                   batch.first_vertex, batch.first_index, vertex_base};
    };
    const std::uint32_t vertex_lanes = lanes_log2(s.device.info(), batch.patch_count, batch.vertex_count);
    const std::uint32_t index_lanes = lanes_log2(s.device.info(), batch.patch_count, batch.index_count / 3);
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.vertices, s.indices});
    s.clock.begin(encoder);
    gpu::ComputePass pass = encoder.begin_compute_pass();
    s.vertices_stage.record(pass, s.parameters.push(params(vertex_lanes)),
                            std::uint64_t{batch.patch_count} << vertex_lanes);
    pass.end();
    s.clock.mark(encoder, StageId::vertices);
    pass = encoder.begin_compute_pass();
    s.indices_stage.record(pass, s.parameters.push(params(index_lanes)),
                           std::uint64_t{batch.patch_count} << index_lanes);
    pass.end();
    s.clock.mark(encoder, StageId::indices);
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    s.emitted = batch;
}

std::vector<StageView> Job::prepared_views() const {
    const State& s = *state_;
    const std::uint64_t patches = s.plan.chunks[s.current_chunk].patch_count;
    return {
        {StageId::factors, s.counter.records(), patches * RECORD_WORDS * 4, false},
        {StageId::control_nets, s.nets, patches * net_floats(s.options.scheme, s.options.normals) * 4, true},
        {StageId::counts, s.counter.counts(), patches * COUNT_WORDS * 4, false},
        {StageId::scan, s.counter.offsets(), (patches + 1) * COUNT_WORDS * 4, false},
    };
}

std::vector<StageView> Job::emitted_views() const {
    const State& s = *state_;
    return {
        {StageId::vertices, s.vertices, std::uint64_t{s.emitted.vertex_count} * sizeof(Vertex), true},
        {StageId::indices, s.indices, std::uint64_t{s.emitted.index_count} * 4, false},
    };
}

const StageTimes& Job::times() { return state_->clock.times(); }

std::uint64_t Job::device_bytes() const {
    const State& s = *state_;
    std::uint64_t bytes = s.parameters.buffer().size() + s.counter.device_bytes();
    for (const gpu::Buffer* buffer : {&s.control_vertices, &s.patch_indices, &s.nets, &s.vertices, &s.indices}) {
        bytes += *buffer ? buffer->size() : 0;
    }
    return bytes;
}

}  // namespace tessera
