// Vertices -> screen vertices, runs of them. The last run of a draw repeats its last vertex: screen vertices have room
// for whole runs.
#include "raster/screen.h"

KERNELS_BEGIN

KERNEL3(raster_transform, READ(0, float, vertices), WRITE(1, uint, screen), UNIFORM(2, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint begin = ITEM * p.entry_count;
    const uint end = begin + p.entry_count < p.vertex_count ? begin + p.entry_count : p.vertex_count;
    for (uint first = begin; first < end; first = first + RUN) {
        uint run[RUN * SCREEN_VERTEX_WORDS];
        FOR_RUN(k) {
            const uint at = (p.first_vertex + (first + k < end ? first + k : end - 1u)) * 8u;
            const ScreenPoint s = to_screen(p, to_clip_space(p, vertices[at], vertices[at + 1u], vertices[at + 2u]));
            run[k * SCREEN_VERTEX_WORDS] = to_uint(s.x);
            run[k * SCREEN_VERTEX_WORDS + 1u] = to_uint(s.y);
            run[k * SCREEN_VERTEX_WORDS + 2u] = float_bits(s.z);
            run[k * SCREEN_VERTEX_WORDS + 3u] = s.code;
        }
        for (uint word = 0u; word < RUN * SCREEN_VERTEX_WORDS; ++word) {
            screen[first * SCREEN_VERTEX_WORDS + word] = run[word];
        }
    }
}

KERNELS_END
