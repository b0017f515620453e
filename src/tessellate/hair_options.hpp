// What a hair job may be asked for.
#pragma once

#include "tessellate/options.hpp"

#include <glm/glm.hpp>

namespace tessera {

/// Which way the ribbons of hair face. The values are those of the kernels (kernels/layout.h).
enum class Ribbons : std::uint32_t {
    camera = 0,  ///< towards the eye
    flat = 1,    ///< their breadth lies as near to a fixed direction as the hair allows
};

inline constexpr std::uint32_t most_hairs_per_patch = 4096;
inline constexpr std::uint32_t most_hair_segments = 64;

struct HairOptions {
    std::uint32_t hairs = 16;     ///< per patch of neighbouring guides, [1, most_hairs_per_patch]
    std::uint32_t segments = 16;  ///< along a hair, [1, most_hair_segments]
    /// How `segments` becomes points along a hair; uniform counts as integer. Hairs are always a whole number.
    Partitioning partitioning = Partitioning::integer;
    float taper = 0.9f;  ///< share of the width that is lost at the tip, [0, 1]
    /// Share of the length that the shortest hair lacks, [0, 1]; every hair has a length of its own, spread evenly. At
    /// 0 all hairs reach as far as their guides.
    float variation = 0.0f;
    Ribbons ribbons = Ribbons::flat;
    glm::vec3 eye{0.0f};                    ///< for Ribbons::camera; in the model's units
    glm::vec3 direction{1.0f, 0.0f, 0.0f};  ///< for Ribbons::flat; any length but zero
    /// Bytes of device memory a job may take; outputs larger than that are made in batches.
    std::uint64_t memory_budget = 512ull << 20;
    /// Measure each stage on the device (HairJob::times). Costs a wait after every submission.
    bool time_stages = false;
};

std::string_view name(Ribbons ribbons);
/// Throws Error(usage) with the list of names.
Ribbons ribbons_from_name(std::string_view name);

/// Throws Error(usage) for a number out of its range.
void check(const HairOptions& options);

}  // namespace tessera
