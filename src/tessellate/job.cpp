#include "tessellate/job.hpp"

#include "layout.h"
#include "tessellate/attribute_stage.hpp"
#include "tessellate/job_input.hpp"
#include "tessellate/launch_shape.hpp"
#include "tessellate/ring_table.hpp"
#include "tessellate/shared_pattern.hpp"
#include "tessellate/stage_clock.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace tessera {
namespace {

constexpr std::array<std::string_view, stage_count> stage_names{"factors",  "control nets", "counts",   "scan",
                                                                "vertices", "indices",      "tangents", "attributes"};
constexpr std::array<std::string_view, 3> degree_names{"linear", "quadratic", "cubic"};

static_assert(sizeof(Tangent) == TANGENT_FLOATS * sizeof(float));

}  // namespace

std::string_view name(StageId stage) {
    return stage_names[static_cast<std::size_t>(stage)];
}

// The stages that are made for one domain, and the chunk's patches of that domain: their numbers in order, and where
// their list begins in the buffer of lists.
struct DomainStages {
    Domain domain = Domain::triangle;
    Stage nets, vertices, indices, tangents;
    SharedPattern pattern;
    std::vector<std::uint32_t> patches;
    std::uint32_t list_start = 0;

    bool has_pattern() const { return pattern.stride != 0; }

    /// The entries of the list that lie in a range of patches: first and count.
    std::pair<std::uint32_t, std::uint32_t> entries(std::uint32_t first_patch, std::uint32_t patch_count) const {
        const auto begin = std::ranges::lower_bound(patches, first_patch);
        const auto end = std::ranges::lower_bound(patches, first_patch + patch_count);
        return {list_start + static_cast<std::uint32_t>(begin - patches.begin()),
                static_cast<std::uint32_t>(end - begin)};
    }
};

struct Job::State {
    gpu::Device device;
    const patches::PatchSet& patches;
    TessellationOptions options;
    JobPlan plan;
    ParameterRing parameters;
    gpu::Buffer patch_corners, patch_list;
    PatchCounter counter;
    StageClock clock;
    AttributeStage attributes;
    gpu::Buffer control_vertices, vertex_tag_buffer, corner_tag_buffer, nets, vertices, indices, tangents;
    gpu::Buffer rings;  // ring_table.hpp; where a stage makes points of triangle patches
    std::uint32_t tag_stride = 0;
    std::array<DomainStages, 2> domains;  // triangles, quads
    std::size_t current_chunk = 0;
    std::optional<std::size_t> uploaded_chunk;  // whose patches and factors the device has
    std::vector<PatchOffset> offsets;
    std::vector<Batch> batches;
    Batch emitted;
    std::optional<std::uint32_t> poison;

    State(gpu::Device d, const patches::PatchSet& p, const TessellationOptions& o, const gpu::Limits& limits)
        : device(std::move(d)),
          patches(p),
          options(o),
          plan(plan_job(p.patch_count(), p.has_quads, shared_bytes(p, o), o, limits,
                        AttributeStage::bytes_per_patch(p))),
          parameters(device, PatchCounter::parameter_slots + 1),
          patch_corners(storage("patch corners", std::uint64_t{plan.largest_chunk} * PATCH_CORNERS * 4)),
          patch_list(storage("patch list", std::uint64_t{plan.largest_chunk} * 4)),
          counter(device, plan.largest_chunk, factors_per_patch(), parameters, patch_corners),
          clock(device, o.time_stages),
          attributes(device, p, parameters, plan.largest_chunk) {}

    bool factors_per_patch() const { return std::holds_alternative<std::vector<PatchFactors>>(options.factors); }

    gpu::Buffer storage(const char* label, std::uint64_t bytes) {
        return device.create_buffer({label, bytes, storage_usage});
    }

    std::uint32_t stride() const { return net_stride(options, patches.has_quads); }

    bool has_tangents() const { return options.tangents != Tangents::none; }

    /// Where the texture coordinates lie in the nets of a domain: last (kernels/layout.h).
    std::uint32_t uvs_of(Domain domain) const {
        const bool quad = domain == Domain::quad;
        return net_stride(options, quad) - 2 * (quad ? 4u : 3u);
    }

    template <typename Body>
    void for_used_domains(Body&& body) {
        for (DomainStages& d : domains) {
            if (d.domain == Domain::triangle || patches.has_quads) body(d);
        }
    }

    void create_chunk_buffers() {
        control_vertices = storage("control vertices", patches.control_vertices.size() * sizeof(Vertex));
        nets = storage("control nets", std::uint64_t{plan.largest_chunk} * stride() * 4);
        std::vector<gpu::Buffer> bindings{control_vertices, patch_corners, patch_list};
        if (const auto tags = vertex_tags(patches, options); !tags.empty()) {
            tag_stride = tags.size() == 1 ? 0 : VERTEX_TAG_FLOATS;
            vertex_tag_buffer = storage("vertex tags", tags.size() * sizeof(patches::VertexTags));
            device.queue().write_buffer(vertex_tag_buffer, 0, std::as_bytes(std::span(tags)));
            bindings.push_back(vertex_tag_buffer);
        }
        if (options.scheme == Scheme::stpn) {
            corner_tag_buffer =
                storage("corner tags", std::uint64_t{plan.largest_chunk} * PATCH_CORNERS * sizeof(patches::CornerTags));
            bindings.push_back(corner_tag_buffer);
        }
        bindings.push_back(nets);
        domains[1].domain = Domain::quad;
        // Nets for true normals carry the corners' own for where the surface has none.
        const auto net_normals = name(options.normals == Normals::quadratic ? Normals::quadratic : Normals::linear);
        for_used_domains([&](DomainStages& d) {
            d.nets =
                Stage(device, fmt::format("control_net_{}_{}_{}", name(options.scheme), net_normals, name(d.domain)),
                      bindings, parameters);
            d.pattern = make_shared_pattern(device, d.domain, options, patches.patch_count());
        });
        if (!domains[0].has_pattern() || has_tangents() || attributes.is_wanted())
            rings = make_ring_table(device, false);
        device.queue().write_buffer(control_vertices, 0, std::as_bytes(std::span(patches.control_vertices)));
    }

    // Uploads the factors and corners of a chunk, and its patches by domain.
    void upload_chunk(const Chunk& chunk) {
        if (const auto* factors = std::get_if<std::vector<PatchFactors>>(&options.factors)) {
            counter.upload_factors(device, std::span(*factors).subspan(chunk.first_patch, chunk.patch_count));
        } else {
            counter.upload_factors(device, std::span(&std::get<PatchFactors>(options.factors), 1));
        }
        const std::span corners = std::span(patches.corners).subspan(chunk.first_patch, chunk.patch_count);
        device.queue().write_buffer(patch_corners, 0, std::as_bytes(corners));
        if (corner_tag_buffer) upload_corner_tags(chunk);
        attributes.upload(chunk.first_patch, chunk.patch_count);
        for (DomainStages& d : domains) {
            d.patches.clear();
        }
        for (std::uint32_t i = 0; i < chunk.patch_count; ++i) {
            domains[patches::is_quad(corners[i]) ? 1 : 0].patches.push_back(i);
        }
        if (all_share_patterns()) sum_pattern_sizes(corners);
        std::uint32_t start = 0;
        for (DomainStages& d : domains) {
            d.list_start = start;
            if (!d.patches.empty()) {
                device.queue().write_buffer(patch_list, std::uint64_t{start} * 4, std::as_bytes(std::span(d.patches)));
            }
            start += static_cast<std::uint32_t>(d.patches.size());
        }
    }

    /// With shared patterns the host knows what the scan will find, and need not wait for it.
    bool all_share_patterns() const {
        return domains[0].has_pattern() && (!patches.has_quads || domains[1].has_pattern());
    }

    void sum_pattern_sizes(std::span<const patches::PatchCorners> corners) {
        offsets.resize(corners.size() + 1);
        PatchOffset sum{};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            offsets[i] = sum;
            const PatchOffset& size = domains[patches::is_quad(corners[i]) ? 1 : 0].pattern.size;
            sum.vertex += size.vertex;
            sum.index += size.index;
        }
        offsets[corners.size()] = sum;
    }

    void upload_corner_tags(const Chunk& chunk) {
        if (!patches.corner_tags.empty()) {
            const std::span tags = std::span(patches.corner_tags).subspan(chunk.first_patch, chunk.patch_count);
            device.queue().write_buffer(corner_tag_buffer, 0, std::as_bytes(tags));
            return;
        }
        std::vector<std::array<patches::CornerTags, PATCH_CORNERS>> tags(chunk.patch_count);
        for (std::uint32_t i = 0; i < chunk.patch_count; ++i)
            tags[i] = smooth_corners(patches, chunk.first_patch + i);
        device.queue().write_buffer(corner_tag_buffer, 0, std::as_bytes(std::span(tags)));
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
        const bool more_vertices = vertex_bytes > (vertices ? vertices.size() : 0);
        const bool more_indices = index_bytes > (indices ? indices.size() : 0);
        if (more_vertices) replace(vertices, "vertices", vertex_bytes);
        if (more_indices) replace(indices, "indices", index_bytes);
        if (more_vertices || more_indices) for_used_domains([&](DomainStages& d) { make_emission(d); });
        if (more_vertices) {
            if (has_tangents()) reserve_tangents(vertex_bytes);
            attributes.reserve(vertex_bytes, counter.records(), counter.offsets(), patch_list, rings);
        }
    }

    void replace(gpu::Buffer& buffer, const char* label, std::uint64_t bytes) {
        if (buffer) buffer.destroy();
        buffer = storage(label, bytes);
    }

    // With a shared pattern one stage writes vertices and indices.
    void make_emission(DomainStages& d) {
        const std::string kernel = fmt::format("vertices_{}_{}_{}", degree_names[degree(options.scheme) - 1],
                                               name(options.normals), name(d.domain));
        if (d.has_pattern()) {
            d.vertices =
                Stage(device, kernel + "_shared",
                      {nets, d.pattern.points, counter.offsets(), patch_list, vertices, d.pattern.indices, indices},
                      parameters);
            return;
        }
        d.vertices =
            Stage(device, kernel,
                  with_rings(d.domain, {nets, counter.records(), counter.offsets(), patch_list, vertices}), parameters);
        d.indices =
            Stage(device, fmt::format("indices_{}", name(d.domain)),
                  with_rings(d.domain, {counter.records(), counter.offsets(), patch_list, indices}), parameters);
    }

    // What kernels of a domain bind that work with rings of their own.
    std::vector<gpu::Buffer> with_rings(Domain domain, std::vector<gpu::Buffer> bindings) const {
        if (domain == Domain::triangle) bindings.push_back(rings);
        return bindings;
    }

    // Beside new vertices, whose normals the stage reads.
    void reserve_tangents(std::uint64_t bytes) {
        replace(tangents, "tangents", bytes);
        for_used_domains([&](DomainStages& d) {
            d.tangents = Stage(
                device,
                fmt::format("tangents_{}_{}_{}", degree_names[degree(options.scheme) - 1], name(options.tangents),
                            name(d.domain)),
                with_rings(d.domain, {nets, counter.records(), counter.offsets(), patch_list, vertices, tangents}),
                parameters);
        });
    }
};

Job::Job(gpu::Device device, const patches::PatchSet& patches, const TessellationOptions& options,
         const gpu::Limits& limits) {
    check_job(patches, options, limits);
    state_ = std::make_unique<State>(std::move(device), patches, options, limits);
    state_->create_chunk_buffers();
}

Job::~Job() = default;

void Job::poison_outputs(std::uint32_t word) {
    state_->poison = word;
}

std::size_t Job::chunk_count() const {
    return state_->plan.chunks.size();
}
const Chunk& Job::chunk(std::size_t index) const {
    return state_->plan.chunks.at(index);
}

const std::vector<PatchOffset>& Job::count(std::size_t index) {
    State& s = *state_;
    const Chunk& chunk = s.plan.chunks.at(index);
    s.current_chunk = index;
    if (s.uploaded_chunk != index) {
        s.upload_chunk(chunk);
        s.uploaded_chunk = index;
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
    record(StageId::factors, [&](gpu::ComputePass& p) {
        s.counter.record_factors(p, chunk.patch_count, Domain::triangle, s.options.partitioning, false);
    });
    record(StageId::counts, [&](gpu::ComputePass& p) { s.counter.record_counts(p, chunk.patch_count); });
    record(StageId::scan, [&](gpu::ComputePass& p) { s.counter.record_scan(p, chunk.patch_count); });
    s.clock.finish(encoder);
    s.parameters.upload(s.device);
    s.device.queue().submit(encoder.finish());
    s.clock.collect(s.device);
    if (!s.all_share_patterns()) s.offsets = s.counter.read_offsets(s.device, chunk.patch_count);
    return s.offsets;
}

const std::vector<PatchOffset>& Job::offsets() const {
    return state_->offsets;
}

const std::vector<Batch>& Job::prepare() {
    State& s = *state_;
    const Chunk& chunk = s.plan.chunks[s.current_chunk];
    s.parameters.reset();
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.nets});
    s.clock.begin(encoder);
    gpu::ComputePass pass = encoder.begin_compute_pass();
    for (const DomainStages& d : s.domains) {
        const auto [first, count] = d.entries(0, chunk.patch_count);
        if (count == 0) continue;
        const kernels::ControlNetsParams params{first, count, s.stride(), s.tag_stride};
        d.nets.record(pass, s.parameters.push(params), count);
    }
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
    gpu::CommandEncoder encoder = s.device.create_command_encoder();
    s.fill(encoder, {s.vertices, s.indices});
    if (s.has_tangents()) s.fill(encoder, {s.tangents});
    if (s.attributes.is_wanted()) s.fill(encoder, {s.attributes.output()});
    s.clock.begin(encoder);
    // `dispatch` records a stage of a domain: pass, domain, parameters, items.
    const auto record = [&](StageId id, std::uint64_t elements, const auto& dispatch) {
        const std::uint32_t lanes = lanes_log2(s.device.info(), batch.patch_count, elements);
        gpu::ComputePass pass = encoder.begin_compute_pass();
        for (const DomainStages& d : s.domains) {
            const auto [first, count] = d.entries(batch.first_patch, batch.patch_count);
            if (count == 0 || (id == StageId::indices && d.has_pattern())) continue;
            const kernels::EmitParams params{first,
                                             count,
                                             lanes,
                                             batch.first_vertex,
                                             batch.first_index,
                                             vertex_base,
                                             s.stride(),
                                             d.pattern.stride,
                                             s.uvs_of(d.domain)};
            dispatch(pass, d, s.parameters.push(params), std::uint64_t{count} << lanes);
        }
        pass.end();
        s.clock.mark(encoder, id);
    };
    const auto of_domain = [](const Stage DomainStages::*stage) {
        return [stage](gpu::ComputePass& pass, const DomainStages& d, std::uint32_t parameters, std::uint64_t items) {
            (d.*stage).record(pass, parameters, items);
        };
    };
    record(StageId::vertices, batch.vertex_count, of_domain(&DomainStages::vertices));
    // A stage of its own only where some domain has no shared pattern.
    if (!s.all_share_patterns()) record(StageId::indices, batch.index_count / 3, of_domain(&DomainStages::indices));
    if (s.has_tangents()) record(StageId::tangents, batch.vertex_count, of_domain(&DomainStages::tangents));
    if (s.attributes.is_wanted()) {
        record(StageId::attributes, batch.vertex_count,
               [&s](gpu::ComputePass& pass, const DomainStages& d, std::uint32_t parameters, std::uint64_t items) {
                   s.attributes.record(pass, d.domain, parameters, items);
               });
    }
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
        {StageId::control_nets, s.nets, patches * s.stride() * 4, true},
        {StageId::counts, s.counter.counts(), patches * COUNT_WORDS * 4, false},
        {StageId::scan, s.counter.offsets(), (patches + 1) * COUNT_WORDS * 4, false},
    };
}

std::vector<StageView> Job::emitted_views() const {
    const State& s = *state_;
    std::vector<StageView> views{
        {StageId::vertices, s.vertices, std::uint64_t{s.emitted.vertex_count} * sizeof(Vertex), true},
        {StageId::indices, s.indices, std::uint64_t{s.emitted.index_count} * 4, false},
    };
    if (s.has_tangents()) {
        views.push_back({StageId::tangents, s.tangents, std::uint64_t{s.emitted.vertex_count} * sizeof(Tangent), true});
    }
    if (s.attributes.is_wanted()) {
        views.push_back({StageId::attributes, s.attributes.output(),
                         std::uint64_t{s.emitted.vertex_count} * sizeof(VertexAttributes), true});
    }
    return views;
}

const StageTimes& Job::times() {
    return state_->clock.times();
}

std::uint64_t Job::device_bytes() const {
    const State& s = *state_;
    std::uint64_t bytes = s.parameters.buffer().size() + s.counter.device_bytes() + s.attributes.device_bytes();
    for (const gpu::Buffer* buffer : {&s.control_vertices, &s.vertex_tag_buffer, &s.corner_tag_buffer, &s.patch_corners,
                                      &s.patch_list, &s.nets, &s.vertices, &s.indices, &s.tangents, &s.rings}) {
        bytes += *buffer ? buffer->size() : 0;
    }
    for (const DomainStages& d : s.domains) {
        bytes += d.has_pattern() ? d.pattern.device_bytes() : 0;
    }
    return bytes;
}

}  // namespace tessera
