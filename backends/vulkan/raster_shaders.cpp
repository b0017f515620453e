#include "backends/vulkan/raster_shaders.hpp"

// Arrays that glslangValidator wrote, of the same names in a namespace of their own.
namespace tessera::backends::vulkan::shaders {
namespace {
#include "raster_mesh_frag.inc"
#include "raster_mesh_vert.inc"
#include "raster_resolve_frag.inc"
#include "raster_resolve_vert.inc"
}  // namespace

std::span<const std::uint32_t> mesh_vertex() {
    return raster_mesh_vert;
}
std::span<const std::uint32_t> mesh_fragment() {
    return raster_mesh_frag;
}
std::span<const std::uint32_t> resolve_vertex() {
    return raster_resolve_vert;
}
std::span<const std::uint32_t> resolve_fragment() {
    return raster_resolve_frag;
}

}  // namespace tessera::backends::vulkan::shaders
