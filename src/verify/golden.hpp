// Golden files of the fixed-function tessellator: one case per line, points and indices as hashes.
#pragma once

#include "gpu/device.hpp"
#include "tessellate/pattern.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tessera::verify {

/// One line of a golden file:
///   domain,partitioning(int|pow2|odd|even),topology(cw|ccw|line),factor bits (hex, | between),points,indices,hash,hash
struct GoldenCase {
    std::size_t line = 0;  ///< in the file, from 1
    Domain domain = Domain::triangle;
    Partitioning partitioning = Partitioning::integer;
    bool clockwise = true;
    PatchFactors factors{};
    std::uint64_t point_count = 0, index_count = 0;
    std::uint64_t point_hash = 0, index_hash = 0;
};

/// Reads a golden file. Throws Error(usage) with line and reason for anything malformed.
std::vector<GoldenCase> read_golden_file(const std::filesystem::path& path);

/// What a device made of a case that does not match.
struct GoldenMismatch {
    GoldenCase expected;
    std::uint64_t point_count = 0, index_count = 0;
    std::uint64_t point_hash = 0, index_hash = 0;
};

/// Recomputes every case on the device.
std::vector<GoldenMismatch> check_golden_cases(const gpu::Device& device, const std::vector<GoldenCase>& cases);

/// One sentence about a mismatch.
std::string describe(const GoldenMismatch& mismatch);

/// FNV-1a, 64 bits, over the little-endian bytes of 32-bit words.
std::uint64_t fnv1a64(std::span<const std::uint32_t> words);

}  // namespace tessera::verify
