// The domain points of a run, made by the patch itself: what kernels that evaluate surfaces share. They bind the ring
// table where the domain has one.
#ifndef TESSERA_TESSELLATOR_RUN_POINTS_H
#define TESSERA_TESSELLATOR_RUN_POINTS_H

#include "tessellator/ring_table.h"
#include "tessellator/ring_window.h"

#define PUT_POINT(us, vs, k, made)      \
    {                                   \
        const DomainPoint point = made; \
        us[k] = point.u;                \
        vs[k] = point.v;                \
    }

/// u and v of RUN points from `first` on, of which `valid` is the first that belongs to the patch.
#define RUN_POINTS(patch, ring_table, valid, first, us, vs)       \
    if (PATCH_HAS_RINGS(patch)) {                                 \
        RING_RUN_POINTS(patch, ring_table, valid, first, us, vs)  \
    } else {                                                      \
        FOR_RUN(k) {                                              \
            PUT_POINT(us, vs, k, PLAIN_POINT(patch, (first) + k)) \
        }                                                         \
    }

/// By their index alone.
#define WINDOW_RUN_POINTS(patch, ring_table, valid, first, us, vs)   \
    const RingWindow window = POINT_WINDOW(patch, valid);            \
    FOR_RUN(k) {                                                     \
        PUT_POINT(us, vs, k, RING_POINT(patch, window, (first) + k)) \
    }

/// By the table. The outer ring's points, and those of the few runs that lead from it to the next, are worked out.
#define TABLE_RUN_POINTS(patch, ring_table, valid, first, us, vs)                                          \
    const RingPlace place = ring_place(patch);                                                             \
    const uint point_at = place.points + (first)-patch.outer_points;                                       \
    if ((valid) >= patch.outer_points) {                                                                   \
        FOR_RUN(k) {                                                                                       \
            PUT_POINT(us, vs, k, inner_point(patch.inside, ring_table[RUN_AT(point_at, k)] - place.shift)) \
        }                                                                                                  \
    } else {                                                                                               \
        FOR_RUN(k) {                                                                                       \
            PUT_POINT(us, vs, k, outer_point(patch, (first) + k))                                          \
        }                                                                                                  \
        for (uint k = patch.outer_points - (first); k < RUN; ++k) {                                        \
            PUT_POINT(us, vs, k, inner_point(patch.inside, ring_table[point_at + k] - place.shift))        \
        }                                                                                                  \
    }

#endif
