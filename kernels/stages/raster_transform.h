// Vertices -> screen vertices.
#include "raster/screen.h"

KERNELS_BEGIN

KERNEL3(raster_transform, READ(0, float, vertices), WRITE(1, uint, screen), UNIFORM(2, DrawParams, params)) {
    const DrawParams p = LOAD_UNIFORM(params);
    const uint i = ITEM;
    if (i >= p.vertex_count) {
        return;
    }
    const ScreenPoint s =
        to_screen(p, to_clip_space(p, vertices[i * 8u], vertices[i * 8u + 1u], vertices[i * 8u + 2u]));
    screen[i * SCREEN_VERTEX_WORDS] = to_uint(s.x);
    screen[i * SCREEN_VERTEX_WORDS + 1u] = to_uint(s.y);
    screen[i * SCREEN_VERTEX_WORDS + 2u] = float_bits(s.z);
    screen[i * SCREEN_VERTEX_WORDS + 3u] = s.code;
}

KERNELS_END
