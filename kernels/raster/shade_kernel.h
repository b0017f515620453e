// Visible triangles -> colours of samples, for opaque materials. An item owns pixels of a tile that has a list, runs of
// them; a triangle that neighbouring samples of a pixel see is shaded once. Leaves VISIBLE_NONE behind for the next
// draw.
//
// What is seen is listed first and then shaded in runs without branches, so that CPUs shade as many at a time as their
// vectors hold, and two such runs side by side, for the steps of one depend on each other.
//
// To be included by a kernel that defines SHADE_NAME and SHADE_SURFACE(colour, p, back, x, y), a sequence of the steps
// of shading.h after SHADE_CORNERS that sets `colour`.
#include "raster/shading.h"
#include "raster/tile.h"

#define SHADE_PIXELS (RUN > 1u ? 4u * RUN : 1u)  // that are listed together
#define SHADE_RUN (RUN > 1u ? 2u * RUN : 1u)

KERNELS_BEGIN

KERNEL8(SHADE_NAME, READ(0, uint, bins), WRITE(1, uint, visible), WRITE(2, uint, colours), READ(3, float, vertices),
        READ(4, uint, indices), READ(5, float, attributes), READ(6, uint, texels), UNIFORM(7, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = (ITEM >> p.spread_log2) * p.entry_count;
    if ((ITEM & ((1u << p.spread_log2) - 1u)) != 0u || begin >= p.tile_count * RASTER_TILE_PIXELS) {
        return;
    }
    const uint tile = bins[LISTED_TILES_AT(p) + (begin >> 8u)];
    const uint left = (p.tile_x + tile % p.tiles_x) << RASTER_TILE_LOG2;
    const uint top = (p.tile_y + tile / p.tiles_x) << RASTER_TILE_LOG2;
    const uint samples = 1u << p.axis_log2;
    for (uint pixel = begin & 255u; pixel < (begin & 255u) + p.entry_count; pixel = pixel + SHADE_PIXELS) {
        const uint first = (tile << (8u + p.axis_log2)) + pixel;
        uint seen_at[SHADE_PIXELS * 4u];  // by sample and pixel: what is seen, and whether it is new to the pixel
        uint fresh[SHADE_PIXELS * 4u];
        uint last[SHADE_PIXELS];
        for (uint k = 0u; k < SHADE_PIXELS; ++k) {
            last[k] = VISIBLE_NONE;
        }
        for (uint s = 0u; s < samples; ++s) {
            for (uint from = 0u; from < SHADE_PIXELS; from = from + RUN) {
                FOR_RUN(k) {
                    const uint seen = visible[RUN_AT(first + (s << 8u) + from, k)];
                    const uint before = last[RUN_AT(from, k)];
                    seen_at[RUN_AT(s * SHADE_PIXELS + from, k)] = seen;
                    fresh[RUN_AT(s * SHADE_PIXELS + from, k)] =
                        choose_bits(seen != VISIBLE_NONE, 1u, 0u) & choose_bits(seen != before, 1u, 0u);
                    last[RUN_AT(from, k)] = choose_bits(seen != VISIBLE_NONE, seen, before);
                }
            }
        }
        uint unseen = VISIBLE_NONE;
        for (uint k = 0u; k < SHADE_PIXELS; ++k) {
            unseen = unseen & last[k];
        }
        if (unseen == VISIBLE_NONE) {
            continue;
        }
        uint seen_by[SHADE_PIXELS * 4u];   // the triangles to shade, what is seen of them,
        uint pixel_of[SHADE_PIXELS * 4u];  // and the pixels where
        uint place_of[SHADE_PIXELS * 4u];  // by sample and pixel: where in this list it is
        uint codes[SHADE_PIXELS * 4u];
        uint count = 0u;
        for (uint k = 0u; k < SHADE_PIXELS; ++k) {
            last[k] = 0u;
        }
        for (uint s = 0u; s < samples; ++s) {
            for (uint k = 0u; k < SHADE_PIXELS; ++k) {  // without branches, which would be guessed wrong
                const uint at = s * SHADE_PIXELS + k;
                seen_by[count] = seen_at[at];
                pixel_of[count] = pixel + k;
                last[k] = choose_bits(fresh[at] != 0u, count, last[k]);
                place_of[at] = last[k];
                count = count + fresh[at];
            }
        }
        // The rest of the last run shades again what the first one has.
        for (uint rest = count; rest < SHADE_PIXELS * 4u && (rest & (SHADE_RUN - 1u)) != 0u; ++rest) {
            seen_by[rest] = seen_by[0];
            pixel_of[rest] = pixel_of[0];
        }
        for (uint run = 0u; run < count; run = run + SHADE_RUN) {
            uint run_seen[SHADE_RUN];  // compilers lose sight of arrays in the middle
            uint run_pixels[SHADE_RUN];
            uint run_codes[SHADE_RUN];
            float red[SHADE_RUN];
            float green[SHADE_RUN];
            float blue[SHADE_RUN];
            float beside[SHADE_RUN * 9u];  // weights and their steps, for wires
            for (uint k = 0u; k < SHADE_RUN; ++k) {
                run_seen[k] = seen_by[run + k];
                run_pixels[k] = pixel_of[run + k];
            }
            FOR_RUNS(k, SHADE_RUN) {
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
                beside[SHADE_RUN + k] = weights.b;
                beside[2u * SHADE_RUN + k] = weights.c;
                beside[3u * SHADE_RUN + k] = across.a;
                beside[4u * SHADE_RUN + k] = across.b;
                beside[5u * SHADE_RUN + k] = across.c;
                beside[6u * SHADE_RUN + k] = down.a;
                beside[7u * SHADE_RUN + k] = down.b;
                beside[8u * SHADE_RUN + k] = down.c;
            }
            if (p.wires != 0u) {  // not in the loop above, which would not become vector code any more
                FOR_RUNS(k, SHADE_RUN) {
                    const Colour colour = make_colour(red[k], green[k], blue[k]);
                    const Weights weights = make_weights(beside[k], beside[SHADE_RUN + k], beside[2u * SHADE_RUN + k]);
                    const Weights across = make_weights(beside[3u * SHADE_RUN + k], beside[4u * SHADE_RUN + k],
                                                        beside[5u * SHADE_RUN + k]);
                    const Weights down = make_weights(beside[6u * SHADE_RUN + k], beside[7u * SHADE_RUN + k],
                                                      beside[8u * SHADE_RUN + k]);
                    const Colour wired = wires_over(colour, beside_edges(weights, across, down));
                    red[k] = wired.red;
                    green[k] = wired.green;
                    blue[k] = wired.blue;
                }
            }
            FOR_RUNS(k, SHADE_RUN) {
                const Colour colour = make_colour(red[k], green[k], blue[k]);
                run_codes[k] = PACK_COLOUR(texels, colour);
            }
            for (uint k = 0u; k < SHADE_RUN; ++k) {
                codes[run + k] = run_codes[k];
            }
        }
        for (uint s = 0u; s < samples; ++s) {
            for (uint from = 0u; from < SHADE_PIXELS; from = from + RUN) {
                FOR_RUN(k) {
                    const int at = to_int(RUN_AT(first + (s << 8u) + from, k));
                    const uint before = colours[at];
                    const uint seen = seen_at[RUN_AT(s * SHADE_PIXELS + from, k)];
                    const uint code = codes[place_of[RUN_AT(s * SHADE_PIXELS + from, k)]];
                    colours[at] = choose_bits(seen != VISIBLE_NONE, code, before);
                    visible[at] = VISIBLE_NONE;
                }
            }
        }
    }
}

KERNELS_END

#undef SHADE_PIXELS
#undef SHADE_RUN
