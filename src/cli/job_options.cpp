#include "cli/job_options.hpp"

#include "base/error.hpp"
#include "tessellate/edge_factors.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace tessera::cli {
namespace {

std::optional<float> parse_float(const std::string& text) {
    char* end = nullptr;
    const float value = std::strtof(text.c_str(), &end);
    if (text.empty() || *end != '\0') {
        return std::nullopt;
    }
    return value;
}

Error bad_factor(const std::string& words, std::size_t wanted) {
    return {ErrorKind::usage,
            fmt::format("The factor \"{}\" is not understood; write one number, {} numbers separated by "
                        "commas (outer ones first), or for a model random:LEAST..GREATEST[:SEED].",
                        words, wanted)};
}

// "random:1..8" or "random:1..8:42"
std::vector<PatchFactors> random_factors(const std::string& words, const patches::PatchSet& patches) {
    const std::string range = words.substr(std::string("random:").size());
    const std::size_t dots = range.find("..");
    if (dots == std::string::npos) {
        throw bad_factor(words, 4);
    }
    const std::size_t colon = range.find(':', dots);
    const auto least = parse_float(range.substr(0, dots));
    const auto greatest = parse_float(range.substr(dots + 2, colon == std::string::npos ? colon : colon - dots - 2));
    const std::string seed = colon == std::string::npos ? "1" : range.substr(colon + 1);
    if (!least || !greatest || !std::isfinite(*least) || !std::isfinite(*greatest) || *least > *greatest ||
        seed.empty() || seed.find_first_not_of("0123456789") != std::string::npos || seed.size() > 18) {
        throw bad_factor(words, 4);
    }
    return random_edge_factors(patches, *least, *greatest, std::stoull(seed));
}

// Whose factors a list is. Triangles and quads take different ones, so a model of both takes one number or random ones.
Domain domain_of(const std::string& words, const patches::PatchSet& patches) {
    const bool has_triangles = !std::ranges::all_of(patches.corners, patches::is_quad);
    if (patches.has_quads && has_triangles && words.find(',') != std::string::npos) {
        throw Error(ErrorKind::usage,
                    fmt::format("The factors \"{}\" cannot hold for triangles and quads alike, and the model "
                                "has both; write one number or random:LEAST..GREATEST[:SEED].",
                                words));
    }
    return patches.has_quads ? Domain::quad : Domain::triangle;
}

}  // namespace

PatchFactors factors_from_words(const std::string& words, Domain domain) {
    const std::size_t wanted = domain == Domain::triangle ? 4 : (domain == Domain::quad ? 6 : 2);
    std::vector<float> numbers;
    std::size_t at = 0;
    while (at <= words.size()) {
        const std::size_t comma = std::min(words.find(',', at), words.size());
        const auto number = parse_float(words.substr(at, comma - at));
        if (!number || numbers.size() == wanted) {
            throw bad_factor(words, wanted);
        }
        numbers.push_back(*number);
        at = comma + 1;
    }
    if (numbers.size() == 1) {
        return {numbers[0], numbers[0], numbers[0], numbers[0], numbers[0], numbers[0]};
    }
    if (numbers.size() != wanted) {
        throw bad_factor(words, wanted);
    }
    PatchFactors factors{};
    std::ranges::copy(numbers, factors.begin());
    return factors;
}

void add_job_options(CLI::App& command, JobWords& words) {
    command
        .add_option("--scheme", words.scheme,
                    "Surface: linear, phong, pn or stpn (pn with the model's creases and tags)")
        ->capture_default_str();
    command.add_option("--normals", words.normals, "How normals vary: linear, quadratic, or true (the surface's own)")
        ->capture_default_str();
    command
        .add_option("--factor", words.factor,
                    "Tessellation factor: F, or all of a patch (4 for triangles, 6 for quads), or "
                    "random:LEAST..GREATEST[:SEED]")
        ->capture_default_str();
    command
        .add_option("--partitioning", words.partitioning, "integer, pow2, fractional_odd, fractional_even or uniform")
        ->capture_default_str();
    command
        .add_option("--alpha", words.alpha,
                    "Shape factor of phong where the model has none of its own, 0 flat to 1 full")
        ->capture_default_str();
    command
        .add_option("--memory-budget", words.memory_budget,
                    "Device memory for the job, such as 64M or 2G (default 512M)")
        ->transform(CLI::AsSizeValue(false));
}

CLI::Option* add_tangents_option(CLI::App& command, JobWords& words) {
    return command
        .add_option("--tangents", words.tangents,
                    "Tangent frames of the vertices: none, surface (along its derivatives) or uv (along the texture "
                    "coordinates, for normal maps)")
        ->capture_default_str();
}

TessellationOptions resolve(const JobWords& words, const patches::PatchSet& patches) {
    TessellationOptions options;
    options.scheme = scheme_from_name(words.scheme);
    options.normals = normals_from_name(words.normals);
    options.tangents = tangents_from_name(words.tangents);
    options.partitioning = partitioning_from_name(words.partitioning);
    options.alpha = words.alpha;
    options.memory_budget = words.memory_budget;
    if (words.factor.starts_with("random:")) {
        options.factors = random_factors(words.factor, patches);
    } else {
        options.factors = factors_from_words(words.factor, domain_of(words.factor, patches));
    }
    return options;
}

}  // namespace tessera::cli
