// Buffers, limits and parameters of the portable rasteriser, shared by its kernels and the host.
//
//   transform   vertices                        -> screen vertices: fixed-point place, depth, outcode
//   setup       screen vertices, indices        -> bounds and records, one of each per triangle
//   clip        vertices, indices, bounds       -> polygons of the triangles that are large or need clipping
//   count       bounds                          -> counts[block][tile]
//   columns     counts                          -> exclusive sums down each column; totals per tile
//   (the host reads the totals, finds where each list begins and which tiles have one)
//   fill        bounds, counts                  -> the lists: triangles in order, tile after tile
//   cover       lists, records                  -> depth and visible triangle per sample   (opaque materials)
//   shade_*     visible triangles, vertices     -> colours                                 (opaque materials)
//   forward     lists, records, vertices        -> depth and colours, in order             (masked and blended ones)
//   resolve     colours                         -> picture
//
// `vertices` and `indices` may be a tessellator's output as it lies on the device, or part of it; `attributes` has the
// colours and tangents of the same vertices (layout.h), or one record for draws without.
//
// `triangles` holds the bounds of all triangles of a batch, then their records, then their polygons.
//
// `bins` holds the starts of the tiles' lists and the end of the last one, the numbers of the tiles that have any
// triangle, and at `list_at` the lists.
//
// No order depends on timing: a tile's triangles are walked in the order in which they were drawn, and a sample goes to
// the first of those that are equally near.
#ifndef TESSERA_RASTER_LAYOUT_H
#define TESSERA_RASTER_LAYOUT_H

#include "dialect.h"

// Sub-pixel positions per pixel. Screen coordinates are integers in these units from the middle of the image, y down.
#define RASTER_SUBPIXELS_LOG2 8u
#define RASTER_SUBPIXELS 256
// Vertices lie in [-2^21, 2^21]: 8192 pixels to either side of the middle, so that an image of 8192 pixels has a guard
// band of half its width around it, and differences of two coordinates are exact as floats.
#define RASTER_GUARD 2097152
#define RASTER_GUARD_FLOAT 2097152.0f

// Tiles are squares of 16 pixels. Samples of a tile lie together, sample after sample, row after row:
//   index = (tile * samples + sample) * 256 + (y % 16) * 16 + x % 16.
#define RASTER_TILE_LOG2 4u
#define RASTER_TILE 16u
#define RASTER_TILE_PIXELS 256u

// Samples. Where a pixel has four, they are those of Direct3D and Vulkan, in units of a quarter pixel and from the
// middle of a quarter: (1, 0), (3, 1), (0, 2), (2, 3). Every quarter row of the image holds one sample per pixel, so
// "sample rows" and "sample columns" number quarters (whole pixels where there is one sample in the middle).
#define RASTER_COLUMNS_OF_4 0x8du  // two bits per sample: the column of the sample in row i

// Screen vertex: x and y (int), depth (float), outcode.
#define SCREEN_VERTEX_WORDS 4u
#define OUT_LEFT 1u
#define OUT_RIGHT 2u
#define OUT_TOP 4u
#define OUT_BOTTOM 8u
#define OUT_NEAR 16u
#define OUT_FAR 32u
#define OUT_MASK 63u
#define OUT_CLIP 64u      // behind the eye or beyond the guard band: x, y and depth mean nothing
#define OUT_INVALID 128u  // not finite or out of all measure: its triangles are dropped

// Record of a triangle, all words but the flags only where it is RECORD_SMALL (both sides of its box up to 64 pixels):
//   x0 y0, then x1 - x0 and y1 - y0, x2 - x0 and y2 - y0 in 16 bits each, depth at corner 0 and its slopes per
//   sub-pixel in x and y, flags. Corners are turned so that its doubled area is positive.
#define TRIANGLE_WORDS 8u
#define TRIANGLE_SMALL 1u
#define TRIANGLE_BACK 2u
// Where a small triangle's box held up to FEW_ROWS rows of up to two samples, the flags have two bits per row of the
// bounds for what it covers of them, and how far left of the bounds these samples begin. The bounds of such a triangle
// end with the samples that it covers; it has none where there is no such sample.
#define FEW_ROWS 8u
#define TRIANGLE_LEFT_SHIFT 2u
#define TRIANGLE_LEFT_MASK 7u
#define TRIANGLE_CLIPPED 32u  // not small, for it needs clipping
#define TRIANGLE_COVERED_SHIFT 16u
#define SMALL_EXTENT 16384

// Polygon of a triangle that is not small: number of corners, then x, y and depth of each.
#define POLYGON_CORNERS 8u
#define POLYGON_WORDS 25u

// Bounds of a triangle in sample columns and rows of the image, two words: first | last << 16 of each.
#define BOUNDS_WORDS 2u
#define BOUNDS_EMPTY 0x0000ffffu
#define BOUNDS_UNKNOWN 0x0001ffffu  // as columns of a triangle that is not small, until the clip stage

// What lies before the texels of a texture: sRGB codes as linear floats; a table from linear floats to codes (two
// floats per entry); where each mip level begins, in words of the buffer; the look of the picture and the material;
// maps and lights of metallic-roughness materials.
#define SRGB_DECODE_AT 0u
#define SRGB_ENCODE_AT 256u
#define SRGB_ENCODE_ENTRIES 104u
#define LEVELS_AT 464u
#define LEVELS_MAX 16u

// The look, floats but for what is said to be a number.
#define LOOK_AT 480u
#define LOOK_HALF_VECTOR 480u  // number: 1 for Blinn's half vector, 0 for Phong's reflected ray
#define LOOK_REFLECTION 481u   // ambient, diffuse, specular
#define LOOK_SHININESS 484u
#define LOOK_LIGHT 485u           // direction to the light, or its place, in camera space
#define LOOK_LIGHT_IS_PLACE 488u  // number: 1 for a place, from the model's origin
#define LOOK_HAS_COLOUR 489u      // number: 1 where the colour that follows replaces the materials'
#define LOOK_COLOUR 490u
#define LOOK_DEPTH 493u       // distance that is white; reciprocal of the range to black
#define LOOK_TONE_CURVE 495u  // number
#define LOOK_EXPOSURE 496u
#define LOOK_MAPS 497u    // number of maps
#define LOOK_LIGHTS 498u  // number of lights
#define LOOK_UNLIT 499u   // number: 1 for KHR_materials_unlit
#define LOOK_EMISSIVE 500u
#define LOOK_METALLIC 503u
#define LOOK_ROUGHNESS 504u
#define LOOK_ZENITH 505u  // light of the sky, three colours
#define LOOK_HORIZON 508u
#define LOOK_GROUND 511u

#define TONE_NONE 0u
#define TONE_ACES 1u

// Maps: kind, width, height and levels, how coordinates wrap in u and v (numbers); the rows (a, b, t) of the map from
// the vertices' coordinates to its own; strength; where each of 16 levels begins.
#define MAPS_AT 528u
#define MAPS_MAX 5u
#define MAP_WORDS 32u
#define MAP_TRANSFORM 6u
#define MAP_STRENGTH 12u
#define MAP_LEVELS 16u
#define MAP_BASE_COLOUR 0u
#define MAP_METALLIC_ROUGHNESS 1u
#define MAP_NORMAL 2u
#define MAP_OCCLUSION 3u
#define MAP_EMISSIVE 4u
#define WRAP_REPEAT 0u
#define WRAP_CLAMP 1u
#define WRAP_MIRROR 2u

// Lights: kind (number), whether fixed to the camera (number), direction to the light or place, colour times intensity,
// reciprocal of the range (0 for none), direction of a spot, scale and offset of its cone.
#define LIGHTS_AT 688u
#define LIGHTS_MAX 16u
#define LIGHT_WORDS 16u
#define LIGHT_PLACE 2u
#define LIGHT_COLOUR 5u
#define LIGHT_RANGE 8u
#define LIGHT_SPOT 9u
#define LIGHT_CONE 12u
#define LIGHT_DIRECTIONAL 0u
#define LIGHT_POINT 1u
#define LIGHT_SPOTTED 2u

#define TEXELS_AT 944u

#define SHADING_PHONG 0u
#define SHADING_NORMALS 1u
#define SHADING_WIREFRAME 2u
#define SHADING_REFLECTION 3u
#define SHADING_PBR 4u
#define SHADING_DEPTH 5u
#define SHADING_UV 6u

KERNELS_BEGIN

// One draw of up to RASTER_CHUNK triangles of one material into one window of the image: what every stage but the
// binning takes.
STRUCT(DrawParams) {
    uint vertex_count;
    uint triangle_count;
    // Clip space from model space, a row each for x, y, z and w.
    float xx, xy, xz, xt;
    float yx, yy, yz, yt;
    float zx, zy, zz, zt;
    float wx, wy, wz, wt;
    // Camera space from model space without its translation, rows right, up, back; and its scale's reciprocal.
    float rx, ry, rz, rt;
    float ux, uy, uz, ut;
    float bx, by, bz, bt;
    float unscale;
    // The image.
    float half_width, half_height;  // sub-pixels
    float guard_x, guard_y;         // guard band over half the image
    float pixel_x, pixel_y;         // size of a pixel in the units of x / w and y / w
    uint columns, rows;             // sample columns and rows
    uint axis_log2;                 // log2 of sample columns per pixel: 0 or 2
    uint column_of_row;             // RASTER_COLUMNS_OF_4, or 0 for one sample
    // The window: its first tile in the image, and its size in tiles.
    uint tile_x, tile_y;
    uint tiles_x, tiles_y;
    // The material.
    uint cull;         // 1: back faces are dropped
    uint keeps_alpha;  // 0: drawn opaque
    float red, green, blue, alpha;
    float cutoff;  // pixels with less alpha are dropped; 0 for none
    uint texture_width, texture_height, texture_levels;
    uint shading;
    uint wires;  // 1: edges of triangles over the shading
    // The draw's first vertex in `vertices` and `attributes`, and the index that names it.
    uint first_vertex, index_base;
    uint index_at;          // first word of the batch in `indices`
    uint attribute_stride;  // words from one vertex's attributes to the next; 0 where all share one record
    // How items share out the work.
    uint tile_count;   // tiles that have a list
    uint list_at;      // first word of the lists in `bins`
    uint first_entry;  // of each list
    uint entry_count;  // of each list; in stages without lists the vertices, triangles or pixels of an item
    uint records_at;   // first word of the records in `triangles`
    uint polygons_at;  // first word of the polygons in `triangles`
    uint spread_log2;  // every 2^n-th item has (a part of) a tile
    uint parts_log2;   // 2^n items share a tile, a band of rows each
};

STRUCT(BinParams) {
    uint first_triangle;
    uint triangle_count;
    uint block;        // triangles per item
    uint spread_log2;  // every 2^n-th item has a block
    uint blocks;
    uint tile_x, tile_y;
    uint tiles_x, tiles_y;
    uint tile_shift;  // log2 of sample columns per tile
    uint list_at;
};

STRUCT(ResolveParams) {
    uint tiles_x;
    uint width, height;  // of the window, pixels
    uint samples;
    uint item_pixels;  // of a row, that an item makes
};

KERNELS_END

#endif
