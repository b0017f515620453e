// The options about hair that render, tessellate and verify share.
#pragma once

#include "patches/hair.hpp"
#include "tessellate/hair_options.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tessera::cli {

/// Raw words of the command line; resolve_hair() makes a job of them.
struct HairWords {
    std::uint32_t hairs = 16, segments = 16;
    std::optional<float> width;
    float taper = 0.9f, variation = 0.0f;
    std::string ribbons;  // empty: what suits the command
    std::vector<float> eye;
};

/// `default_ribbons` completes the help text.
void add_hair_options(CLI::App& command, HairWords& words, const std::string& default_ribbons);

/// The patches of a scene's faces; none, instead of an error, where it consists of hair alone.
patches::PatchSet surface_patches(const scene::Scene& scene);

/// Options for a job of hair; `memory_budget` as in JobWords. Throws Error(usage) for words that make no sense.
HairOptions resolve_hair(const HairWords& words, Ribbons default_ribbons, std::uint64_t memory_budget);

}  // namespace tessera::cli
