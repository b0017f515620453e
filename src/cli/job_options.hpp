// The options that render, tessellate and verify share.
#pragma once

#include "patches/patches.hpp"
#include "tessellate/options.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of the command line; resolve() makes a job of them.
struct JobWords {
    std::string scheme = "pn";
    std::string normals = "quadratic";
    std::string tangents = "none";
    std::string partitioning = "fractional_odd";
    std::string factor = "4";
    float alpha = 0.75f;
    std::uint64_t memory_budget = 512ull << 20;
};

void add_job_options(CLI::App& command, JobWords& words);
/// For the commands that do something with tangents.
CLI::Option* add_tangents_option(CLI::App& command, JobWords& words);

/// Options for a job over `patches`. Throws Error(usage) for words that make no sense.
TessellationOptions resolve(const JobWords& words, const patches::PatchSet& patches);

/// Factors of a domain from "F" (all of them) or as many numbers as it has, separated by commas: 4 for triangles, 6 for
/// quads, 2 for isolines. Infinities and "nan" are allowed: the tessellator knows what to do.
PatchFactors factors_from_words(const std::string& words, Domain domain);

}  // namespace tessera::cli
