#include "tessellate/shared_pattern.hpp"

#include "layout.h"
#include "schemes/pattern_weights.h"
#include "tessellate/pattern.hpp"

#include <cstring>

namespace tessera {
namespace {

constexpr std::uint64_t fewest_patches = 64;
constexpr std::size_t margin = PATTERN_MARGIN;

/// Adds the weights of a triangle pattern's points, which are already there.
void append_weights(std::vector<std::uint32_t>& words, const Pattern& pattern, std::uint32_t stride) {
    static_assert(sizeof(kernels::PatternWeights) == PATTERN_WEIGHTS * 4);
    const auto count = static_cast<std::uint32_t>(pattern.points.size());
    const std::uint32_t begin = PATTERN_WEIGHTS_AT(stride);
    const std::uint32_t size = PATTERN_RUNS(count) * PATTERN_RUN;  // points of either kind of patches
    words.resize(begin + std::size_t{2} * size * PATTERN_WEIGHTS);
    for (std::uint32_t shift = 0; shift < 2; ++shift) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const kernels::PatternWeights weights = kernels::pattern_weights(pattern.points[i].u, pattern.points[i].v);
            std::uint32_t bits[PATTERN_WEIGHTS];
            std::memcpy(bits, &weights, sizeof bits);
            const std::uint32_t at = i + shift;
            std::uint32_t* run =
                words.data() + begin + std::size_t{shift * size + at / PATTERN_RUN * PATTERN_RUN} * PATTERN_WEIGHTS;
            for (std::uint32_t w = 0; w < PATTERN_WEIGHTS; ++w)
                run[w * PATTERN_RUN + at % PATTERN_RUN] = bits[w];
        }
    }
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
    if (domain == Domain::triangle && degree(options.scheme) == 3 && options.normals == Normals::quadratic)
        append_weights(points, pattern, shared.stride);
    shared.size = {static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(pattern.indices.size())};
    shared.points = gpu::create_filled_buffer(device, "shared domain points", std::as_bytes(std::span(points)));
    shared.indices = gpu::create_filled_buffer(device, "shared indices", std::as_bytes(std::span(pattern.indices)));
    return shared;
}

}  // namespace tessera
