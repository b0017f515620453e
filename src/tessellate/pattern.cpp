#include "tessellate/pattern.hpp"

#include "layout.h"
#include "tessellate/launch_shape.hpp"
#include "tessellate/patch_counter.hpp"
#include "tessellate/ring_table.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <numeric>

namespace tessera {
namespace {

using gpu::BufferUsage;

// At the largest patch of 4225 points and 8192 triangles, 1,024 patterns take 35 MB of points and 101 MB of indices.
constexpr std::size_t patterns_per_run = 1024;

void append_run(gpu::Device& device, Domain domain, Partitioning partitioning, bool clockwise,
                std::span<const PatchFactors> factors, std::vector<Pattern>& patterns) {
    const auto count = static_cast<std::uint32_t>(factors.size());
    ParameterRing parameters(device, PatchCounter::parameter_slots + 2);
    PatchCounter counter(device, count, true, parameters);
    counter.upload_factors(device, factors);
    gpu::CommandEncoder encoder = device.create_command_encoder();
    gpu::ComputePass pass = encoder.begin_compute_pass();
    counter.record_factors(pass, count, domain, partitioning, !clockwise);
    counter.record_counts(pass, count);
    counter.record_scan(pass, count);
    pass.end();
    parameters.upload(device);
    device.queue().submit(encoder.finish());
    const std::vector<PatchOffset> offsets = counter.read_offsets(device, count);
    const PatchOffset total = offsets.back();

    std::vector<std::uint32_t> points(std::size_t{total.vertex} * 2);  // all u, then all v
    std::vector<std::uint32_t> indices(total.index);
    if (total.vertex > 0) {
        const auto usage = BufferUsage::storage | BufferUsage::copy_source;
        std::vector<std::uint32_t> every(count);
        std::iota(every.begin(), every.end(), 0u);
        const gpu::Buffer list = device.create_buffer(
            {"patch list", std::uint64_t{count} * 4, BufferUsage::storage | BufferUsage::copy_destination});
        device.queue().write_buffer(list, 0, std::as_bytes(std::span(every)));
        const gpu::Buffer point_buffer =
            device.create_buffer({"domain points", std::uint64_t{total.vertex} * 8, usage});
        const gpu::Buffer index_buffer = device.create_buffer({"indices", std::uint64_t{total.index} * 4, usage});
        const Stage points_stage(device, fmt::format("domain_points_{}", name(domain)),
                                 {counter.records(), counter.offsets(), list, point_buffer}, parameters);
        std::vector<gpu::Buffer> index_bindings{counter.records(), counter.offsets(), list, index_buffer};
        if (domain == Domain::triangle) index_bindings.push_back(make_ring_table(device, !clockwise));
        const Stage indices_stage(device, fmt::format("indices_{}", name(domain)), index_bindings, parameters);
        const std::uint32_t lanes = lanes_log2(device.info(), count, total.vertex);
        parameters.reset();
        const std::uint32_t emit_points =
            parameters.push(kernels::EmitParams{0, count, lanes, 0, 0, 0, 0, total.vertex, 0});
        const std::uint32_t emit_indices = parameters.push(kernels::EmitParams{0, count, lanes, 0, 0, 0, 0, 0, 0});
        parameters.upload(device);
        encoder = device.create_command_encoder();
        pass = encoder.begin_compute_pass();
        points_stage.record(pass, emit_points, std::uint64_t{count} << lanes);
        indices_stage.record(pass, emit_indices, std::uint64_t{count} << lanes);
        pass.end();
        device.queue().submit(encoder.finish());
        device.queue().read_buffer(point_buffer, 0, std::as_writable_bytes(std::span(points)));
        device.queue().read_buffer(index_buffer, 0, std::as_writable_bytes(std::span(indices)));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        Pattern pattern;
        for (std::uint32_t at = offsets[i].vertex; at < offsets[i + 1].vertex; ++at) {
            pattern.points.push_back({points[at], points[total.vertex + at]});
        }
        pattern.indices.assign(indices.begin() + offsets[i].index, indices.begin() + offsets[i + 1].index);
        for (std::uint32_t& index : pattern.indices) {
            index -= offsets[i].vertex;
        }
        patterns.push_back(std::move(pattern));
    }
}

}  // namespace

std::vector<Pattern> make_patterns(gpu::Device device, Domain domain, Partitioning partitioning, bool clockwise,
                                   std::span<const PatchFactors> factors) {
    std::vector<Pattern> patterns;
    patterns.reserve(factors.size());
    for (std::size_t first = 0; first < factors.size(); first += patterns_per_run) {
        append_run(device, domain, partitioning, clockwise,
                   factors.subspan(first, std::min(patterns_per_run, factors.size() - first)), patterns);
    }
    return patterns;
}

}  // namespace tessera
