// The whole library. The pipeline, in the order data flows:
//   scene::load_scene     a file becomes meshes and materials
//   patches::make_patches meshes become patches over scaled control vertices
//   patches::make_hair    guide curves become hair patches between neighbouring guides
//   tessellate            patches become vertices and indices on any gpu::Device
//   tessellate_hair       hair patches become ribbons; SceneTessellator makes both
//   exporting, render,
//   raster                those become a file or a picture
//   compare::compare      two pictures become numbers
#pragma once

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "compare/verdict.hpp"
#include "export/mesh_writer.hpp"
#include "image/image.hpp"
#include "patches/hair.hpp"
#include "patches/patches.hpp"
#include "raster/portable_rasteriser.hpp"
#include "render/mesh_sinks.hpp"
#include "render/resident_mesh.hpp"
#include "scene/scene.hpp"
#include "tessellate/edge_factors.hpp"
#include "tessellate/pattern.hpp"
#include "tessellate/scene_tessellator.hpp"
#include "tessellate/tessellate.hpp"
#include "verify/compare_jobs.hpp"
