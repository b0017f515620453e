// What a job reads besides the corners of its patches: tags, and the checks of all input.
#pragma once

#include "gpu/types.hpp"
#include "layout.h"
#include "patches/patches.hpp"
#include "tessellate/options.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tessera {

/// Throws Error(usage) where factors or tags do not fit the patches, the shape factor is not in [0, 1], or the control
/// vertices do not fit one binding of the device.
void check_job(const patches::PatchSet& patches, const TessellationOptions& options, const gpu::Limits& limits);

/// The tags that the scheme reads, of each control vertex or one for all; none where it reads none. Every alpha is set.
std::vector<patches::VertexTags> vertex_tags(const patches::PatchSet& patches, const TessellationOptions& options);

/// The corner tags of a patch of a model that has no creases.
std::array<patches::CornerTags, PATCH_CORNERS> smooth_corners(const patches::PatchSet& patches, std::uint64_t patch);

/// Bytes that a job holds besides what belongs to a chunk.
std::uint64_t shared_bytes(const patches::PatchSet& patches, const TessellationOptions& options);

}  // namespace tessera
