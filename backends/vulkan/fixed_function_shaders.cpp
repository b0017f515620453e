#include "backends/vulkan/fixed_function_shaders.hpp"

#include <cassert>

// Arrays that glslangValidator wrote, of the same names in a namespace of their own.
namespace tessera::backends::vulkan::shaders {
namespace {
#include "fixed_function_control.inc"
#include "fixed_function_control_surface.inc"
#include "fixed_function_isolines.inc"
#include "fixed_function_quads.inc"
#include "fixed_function_triangles.inc"
#include "fixed_function_triangles_surface.inc"
#include "fixed_function_vertex.inc"
#include "timed_draw_control.inc"
#include "timed_draw_evaluation.inc"
#include "timed_draw_fragment.inc"
}  // namespace

std::span<const std::uint32_t> oracle_vertex() {
    return fixed_function_vertex;
}

std::span<const std::uint32_t> oracle_control(bool surface) {
    if (surface) return fixed_function_control_surface;
    return fixed_function_control;
}

std::span<const std::uint32_t> oracle_evaluation(Domain domain, bool surface) {
    assert(!surface || domain == Domain::triangle);
    if (surface) return fixed_function_triangles_surface;
    if (domain == Domain::triangle) return fixed_function_triangles;
    if (domain == Domain::quad) return fixed_function_quads;
    return fixed_function_isolines;
}

std::span<const std::uint32_t> timed_control() {
    return timed_draw_control;
}

std::span<const std::uint32_t> timed_evaluation() {
    return timed_draw_evaluation;
}

std::span<const std::uint32_t> timed_fragment() {
    return timed_draw_fragment;
}

}  // namespace tessera::backends::vulkan::shaders
