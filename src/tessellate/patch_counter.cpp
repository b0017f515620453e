#include "tessellate/patch_counter.hpp"

#include "layout.h"

namespace tessera {
namespace {

gpu::Buffer storage_buffer(gpu::Device& device, const char* label, std::uint64_t words) {
    return device.create_buffer({label, words * 4, storage_usage});
}

std::uint64_t blocks(std::uint64_t count) {
    return (count + SCAN_BLOCK - 1) / SCAN_BLOCK;
}

}  // namespace

PatchCounter::PatchCounter(gpu::Device& device, std::uint32_t capacity, bool factors_per_patch,
                           ParameterRing& parameters, const gpu::Buffer& patch_corners)
    : parameters_(parameters),
      factors_per_patch_(factors_per_patch),
      domain_per_patch_(static_cast<bool>(patch_corners)),
      factors_(storage_buffer(device, "factors", std::uint64_t{factors_per_patch ? capacity : 1} * PATCH_FACTORS)),
      records_(storage_buffer(device, "patch records", std::uint64_t{capacity} * RECORD_WORDS)),
      zero_(storage_buffer(device, "scan base", COUNT_WORDS)) {
    std::uint64_t count = capacity;
    do {
        Level level;
        level.capacity = count;
        level.values = storage_buffer(device, "counts", count * COUNT_WORDS);
        level.offsets = storage_buffer(device, "offsets", (count + 1) * COUNT_WORDS);
        levels_.push_back(std::move(level));
        count = blocks(count);
    } while (levels_.back().capacity > SCAN_BLOCK);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool top = i + 1 == levels_.size();
        if (!top) {
            levels_[i].sums = Stage(device, "scan_sums", {levels_[i].values, levels_[i + 1].values}, parameters);
        }
        levels_[i].spread =
            Stage(device, "scan_offsets", {levels_[i].values, top ? zero_ : levels_[i + 1].offsets, levels_[i].offsets},
                  parameters);
    }
    factors_stage_ = Stage(device, "factors", {factors_, patch_corners ? patch_corners : zero_, records_}, parameters);
    counts_stage_ = Stage(device, "counts", {records_, counts()}, parameters);
}

void PatchCounter::upload_factors(gpu::Device& device, std::span<const PatchFactors> factors) {
    device.queue().write_buffer(factors_, 0, std::as_bytes(factors));
}

void PatchCounter::record_factors(gpu::ComputePass& pass, std::uint32_t patch_count, Domain domain,
                                  Partitioning partitioning, bool flip) {
    const std::uint32_t domain_word = domain_per_patch_ ? DOMAIN_PER_PATCH : static_cast<std::uint32_t>(domain);
    const kernels::FactorsParams params{patch_count, static_cast<std::uint32_t>(partitioning), domain_word,
                                        flip ? 1u : 0u, factors_per_patch_ ? 1u : 0u};
    factors_stage_.record(pass, parameters_.push(params), patch_count);
}

void PatchCounter::record_counts(gpu::ComputePass& pass, std::uint32_t patch_count) {
    counts_stage_.record(pass, parameters_.push(kernels::CountsParams{patch_count}), patch_count);
}

void PatchCounter::record_scan(gpu::ComputePass& pass, std::uint32_t patch_count) {
    // A chunk smaller than the capacity may not need every level, but the same levels give the same sums.
    std::vector<std::uint32_t> counts{patch_count};
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
        levels_[i].sums.record(pass, parameters_.push(kernels::ScanParams{counts[i]}), blocks(counts[i]));
        counts.push_back(static_cast<std::uint32_t>(blocks(counts[i])));
    }
    for (std::size_t i = levels_.size(); i-- > 0;) {
        levels_[i].spread.record(pass, parameters_.push(kernels::ScanParams{counts[i]}), blocks(counts[i]));
    }
}

std::vector<PatchOffset> PatchCounter::read_offsets(gpu::Device& device, std::uint32_t patch_count) const {
    std::vector<PatchOffset> read(std::size_t{patch_count} + 1);
    device.queue().read_buffer(offsets(), 0, std::as_writable_bytes(std::span(read)));
    return read;
}

std::uint64_t PatchCounter::device_bytes() const {
    std::uint64_t bytes = factors_.size() + records_.size() + zero_.size();
    for (const Level& level : levels_) {
        bytes += level.values.size() + level.offsets.size();
    }
    return bytes;
}

}  // namespace tessera
