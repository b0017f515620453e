#include "tessellate/options.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

namespace tessera {
namespace {

constexpr std::array<std::string_view, 3> domain_names{"triangle", "quad", "isoline"};
constexpr std::array<std::string_view, 4> scheme_names{"linear", "phong", "pn", "stpn"};
constexpr std::array<std::string_view, 3> normals_names{"linear", "quadratic", "true"};
constexpr std::array<std::string_view, 3> tangents_names{"none", "surface", "uv"};
constexpr std::array<std::string_view, 5> partitioning_names{"integer", "pow2", "fractional_odd", "fractional_even",
                                                             "uniform"};
constexpr std::array<std::string_view, 2> topology_names{"triangles", "quads"};

std::size_t index_of(std::span<const std::string_view> names, std::string_view name, const char* what) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) {
            return i;
        }
    }
    throw Error(ErrorKind::usage,
                fmt::format("There is no {} named \"{}\"; choose one of {}.", what, name, fmt::join(names, ", ")));
}

}  // namespace

std::uint32_t degree(Scheme scheme) {
    constexpr std::array<std::uint32_t, scheme_names.size()> degrees{1, 2, 3, 3};
    return degrees.at(static_cast<std::size_t>(scheme));
}

std::string_view name(Domain domain) {
    return domain_names.at(static_cast<std::size_t>(domain));
}
std::string_view name(Scheme scheme) {
    return scheme_names.at(static_cast<std::size_t>(scheme));
}
std::string_view name(Normals normals) {
    return normals_names.at(static_cast<std::size_t>(normals));
}
std::string_view name(Tangents tangents) {
    return tangents_names.at(static_cast<std::size_t>(tangents));
}
std::string_view name(Partitioning partitioning) {
    return partitioning_names.at(static_cast<std::size_t>(partitioning));
}
std::string_view name(Topology topology) {
    return topology_names.at(static_cast<std::size_t>(topology));
}

Domain domain_from_name(std::string_view name) {
    return static_cast<Domain>(index_of(domain_names, name, "domain"));
}
Scheme scheme_from_name(std::string_view name) {
    return static_cast<Scheme>(index_of(scheme_names, name, "scheme"));
}
Normals normals_from_name(std::string_view name) {
    return static_cast<Normals>(index_of(normals_names, name, "kind of normals"));
}
Tangents tangents_from_name(std::string_view name) {
    return static_cast<Tangents>(index_of(tangents_names, name, "kind of tangents"));
}
Partitioning partitioning_from_name(std::string_view name) {
    return static_cast<Partitioning>(index_of(partitioning_names, name, "partitioning"));
}
Topology topology_from_name(std::string_view name) {
    return static_cast<Topology>(index_of(topology_names, name, "topology"));
}

}  // namespace tessera
