#include "tessellate/shared_pattern.hpp"

#include "layout.h"
#include "tessellate/pattern.hpp"

namespace tessera {
namespace {

constexpr std::uint64_t fewest_patches = 64;
constexpr std::size_t margin = PATTERN_MARGIN;

gpu::Buffer upload(gpu::Device& device, const char* label, const std::vector<std::uint32_t>& words) {
    const auto usage = gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination;
    gpu::Buffer buffer = device.create_buffer({label, words.size() * 4, usage});
    device.queue().write_buffer(buffer, 0, std::as_bytes(std::span(words)));
    return buffer;
}

}  // namespace

SharedPattern make_shared_pattern(gpu::Device device, Domain domain, const TessellationOptions& options,
                                  std::uint64_t patch_count) {
    Pattern pattern;
    if (const auto* factors = std::get_if<PatchFactors>(&options.factors);
        factors != nullptr && patch_count >= fewest_patches) {
        pattern = make_patterns(device, domain, options.partitioning, true, std::span(factors, 1)).front();
    }
    SharedPattern shared;
    const std::size_t count = pattern.points.size();
    if (count == 0) {
        return shared;
    }
    const std::size_t stride = margin + count + margin;
    std::vector<std::uint32_t> points(2 * stride + margin);
    for (std::size_t i = 0; i < count; ++i) {
        points[margin + i] = pattern.points[i].u;
        points[margin + stride + i] = pattern.points[i].v;
    }
    shared.stride = static_cast<std::uint32_t>(stride);
    shared.size = {static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(pattern.indices.size())};
    shared.points = upload(device, "shared domain points", points);
    shared.indices = upload(device, "shared indices", pattern.indices);
    return shared;
}

}  // namespace tessera
