// Visible triangles -> colours of samples, for opaque materials. An item owns pixels of a tile that has a list, runs of
// them; a triangle that neighbouring samples of a pixel see is shaded once. Leaves VISIBLE_NONE behind for the next
// draw.
//
// What is seen is listed first and then shaded in runs without branches, so that CPUs shade as many at a time as their
// vectors hold.
//
// To be included by a kernel that defines SHADE_NAME and SHADE_SURFACE(colour, p, back, x, y), a sequence of the steps
// of shading.h after SHADE_CORNERS that sets `colour`.
#include "raster/shading.h"
#include "raster/tile.h"

KERNELS_BEGIN

KERNEL8(SHADE_NAME, READ(0, uint, bins), WRITE(1, uint, visible), WRITE(2, uint, colours), READ(3, float, vertices),
        READ(4, uint, indices), READ(5, float, attributes), READ(6, uint, texels), UNIFORM(7, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.entry_count;
    if (begin >= p.tile_count * RASTER_TILE_PIXELS) {
        return;
    }
    const uint tile = bins[LISTED_TILES_AT(p) + (begin >> 8u)];
    const uint left = (p.tile_x + tile % p.tiles_x) << RASTER_TILE_LOG2;
    const uint top = (p.tile_y + tile / p.tiles_x) << RASTER_TILE_LOG2;
    const uint sample_end = 256u << p.axis_log2;
    for (uint pixel = begin & 255u; pixel < (begin & 255u) + p.entry_count; pixel = pixel + RUN) {
        const uint first = (tile << (8u + p.axis_log2)) + pixel;
        uint unseen_by[RUN];
        FOR_RUN(k) {
            unseen_by[k] = visible[RUN_AT(first, k)];
        }
        for (uint sample_at = 256u; sample_at < sample_end; sample_at = sample_at + 256u) {
            FOR_RUN(k) {
                unseen_by[k] = unseen_by[k] & visible[RUN_AT(first + sample_at, k)];
            }
        }
        uint unseen = VISIBLE_NONE;
        for (uint k = 0u; k < RUN; ++k) {
            unseen = unseen & unseen_by[k];
        }
        if (unseen == VISIBLE_NONE) {
            continue;
        }
        uint seen_by[RUN * 4u];   // the triangles to shade, what is seen of them,
        uint pixel_of[RUN * 4u];  // and the pixels where
        uint codes[RUN * 4u];
        uint count = 0u;
        for (uint k = 0u; k < RUN; ++k) {
            uint last = VISIBLE_NONE;
            for (uint sample_at = 0u; sample_at < sample_end; sample_at = sample_at + 256u) {
                const uint seen = visible[first + sample_at + k];
                if (seen != VISIBLE_NONE && seen != last) {
                    seen_by[count] = seen;
                    pixel_of[count] = pixel + k;
                    count = count + 1u;
                    last = seen;
                }
            }
        }
        // The rest of the last run shades again what the first one has.
        for (uint rest = count; rest < RUN * 4u && (rest & (RUN - 1u)) != 0u; ++rest) {
            seen_by[rest] = seen_by[0];
            pixel_of[rest] = pixel_of[0];
        }
        for (uint run = 0u; run < count; run = run + RUN) {
            uint run_seen[RUN];  // compilers lose sight of arrays in the middle
            uint run_pixels[RUN];
            uint run_codes[RUN];
            float red[RUN];
            float green[RUN];
            float blue[RUN];
            float beside[RUN * 9u];  // weights and their steps, for wires
            for (uint k = 0u; k < RUN; ++k) {
                run_seen[k] = seen_by[run + k];
                run_pixels[k] = pixel_of[run + k];
            }
            FOR_RUN(k) {
                const uint seen = run_seen[k];
                const uint place = run_pixels[k];
                const uint x = left + (place & 15u);
                const uint y = top + (place >> 4u);
                const uint triangle = seen & ~VISIBLE_BACK;
                Colour colour;
                SHADE_CORNERS(p, triangle, x, y)
                SHADE_SURFACE(colour, p, (seen & VISIBLE_BACK) != 0u, x, y)
                red[k] = colour.red;
                green[k] = colour.green;
                blue[k] = colour.blue;
                beside[k] = weights.a;
                beside[RUN + k] = weights.b;
                beside[2u * RUN + k] = weights.c;
                beside[3u * RUN + k] = across.a;
                beside[4u * RUN + k] = across.b;
                beside[5u * RUN + k] = across.c;
                beside[6u * RUN + k] = down.a;
                beside[7u * RUN + k] = down.b;
                beside[8u * RUN + k] = down.c;
            }
            if (p.wires != 0u) {  // not in the loop above, which would not become vector code any more
                FOR_RUN(k) {
                    const Colour colour = make_colour(red[k], green[k], blue[k]);
                    const Weights weights = make_weights(beside[k], beside[RUN + k], beside[2u * RUN + k]);
                    const Weights across =
                        make_weights(beside[3u * RUN + k], beside[4u * RUN + k], beside[5u * RUN + k]);
                    const Weights down = make_weights(beside[6u * RUN + k], beside[7u * RUN + k], beside[8u * RUN + k]);
                    const Colour wired = wires_over(colour, beside_edges(weights, across, down));
                    red[k] = wired.red;
                    green[k] = wired.green;
                    blue[k] = wired.blue;
                }
            }
            FOR_RUN(k) {
                const Colour colour = make_colour(red[k], green[k], blue[k]);
                run_codes[k] = PACK_COLOUR(texels, colour);
            }
            for (uint k = 0u; k < RUN; ++k) {
                codes[run + k] = run_codes[k];
            }
        }
        uint shaded = 0u;
        for (uint k = 0u; k < RUN; ++k) {
            uint last = VISIBLE_NONE;
            for (uint sample_at = 0u; sample_at < sample_end; sample_at = sample_at + 256u) {
                const uint at = first + sample_at + k;
                const uint seen = visible[at];
                if (seen != VISIBLE_NONE) {
                    shaded = seen != last ? shaded + 1u : shaded;
                    last = seen;
                    visible[at] = VISIBLE_NONE;
                    colours[at] = codes[shaded - 1u];
                }
            }
        }
    }
}

KERNELS_END
