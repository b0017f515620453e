// The table from which kernels read the inner points and triangles of triangle patches (kernels/tessellator/
// ring_table.h).
#pragma once

#include "gpu/device.hpp"

#include <cstdint>
#include <span>

namespace tessera {

/// The words of the table. `flip`: the patches that it is for have triangles of reversed winding.
std::span<const std::uint32_t> ring_table(bool flip);

/// A storage buffer that holds it.
gpu::Buffer make_ring_table(gpu::Device& device, bool flip);

/// The size of the buffer.
std::uint64_t ring_table_bytes();

}  // namespace tessera
