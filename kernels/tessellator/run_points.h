// The domain points of a run, made by the patch itself: what kernels that evaluate surfaces share.
#ifndef TESSERA_TESSELLATOR_RUN_POINTS_H
#define TESSERA_TESSELLATOR_RUN_POINTS_H

#include "tessellator/ring_window.h"

/// u and v of RUN points from `first` on, of which `valid` is the first that belongs to the patch.
#define RUN_POINTS(patch, valid, first, us, vs)                               \
    if (PATCH_HAS_RINGS(patch)) {                                             \
        const RingWindow window = POINT_WINDOW(patch, valid);                 \
        FOR_RUN(k) {                                                          \
            const DomainPoint point = RING_POINT(patch, window, (first) + k); \
            us[k] = point.u;                                                  \
            vs[k] = point.v;                                                  \
        }                                                                     \
    } else {                                                                  \
        FOR_RUN(k) {                                                          \
            const DomainPoint point = PLAIN_POINT(patch, (first) + k);        \
            us[k] = point.u;                                                  \
            vs[k] = point.v;                                                  \
        }                                                                     \
    }

#endif
