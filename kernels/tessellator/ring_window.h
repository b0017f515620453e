// Which ring an element of a patch lies on, for runs of neighbouring elements: the first one's ring is searched once
// per run, and the others are on it or on one of the next three.
#ifndef TESSERA_TESSELLATOR_RING_WINDOW_H
#define TESSERA_TESSELLATOR_RING_WINDOW_H

#include "dialect.h"

KERNELS_BEGIN

/// Number of a ring (of points, or of triangles), and at which elements it and the next three begin. Rings grow by six
/// elements at least, so that a run of 16 meets no more than three.
STRUCT(RingWindow) {
    uint ring;
    uint start0;
    uint start1;
    uint start2;
    uint start3;
};

/// Beyond the last ring nothing begins.
#define NO_RING_START 0xffffffffu

FUNCTION RingWindow make_ring_window(uint ring, uint start0, uint start1, uint start2, uint start3) {
    RingWindow w;
    w.ring = ring;
    w.start0 = start0;
    w.start1 = start1;
    w.start2 = start2;
    w.start3 = start3;
    return w;
}

/// The window of a run whose first element is `at`. START(ring) tells where a ring begins; `ring` is the first ring's
/// number and becomes that of the window.
#define FIND_RING_WINDOW(window, first_ring, last, at, START)                                       \
    uint ring = first_ring;                                                                         \
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) {                                               \
        ring = ring + bit <= (last) && START(ring + bit) <= (at) ? ring + bit : ring;               \
    }                                                                                               \
    const RingWindow window =                                                                       \
        make_ring_window(ring, START(ring), ring + 1u <= (last) ? START(ring + 1u) : NO_RING_START, \
                         ring + 2u <= (last) ? START(ring + 2u) : NO_RING_START,                    \
                         ring + 3u <= (last) ? START(ring + 3u) : NO_RING_START)

/// The ring of element `at`, and where that ring begins. Where a run is one element it is the window's first.
FUNCTION uint ring_of(RingWindow w, uint at) {
    return RUN == 1u ? w.ring
                     : w.ring + (at >= w.start1 ? 1u : 0u) + (at >= w.start2 ? 1u : 0u) + (at >= w.start3 ? 1u : 0u);
}

FUNCTION uint ring_start_of(RingWindow w, uint at) {
    const uint later = at >= w.start3 ? w.start3 : (at >= w.start2 ? w.start2 : w.start1);
    return RUN == 1u || at < w.start1 ? w.start0 : later;
}

KERNELS_END

#endif
