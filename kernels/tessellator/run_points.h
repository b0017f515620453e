// The domain points of a run, made by the patch itself: what kernels that evaluate surfaces share. They bind the ring
// table where the domain has one.
#ifndef TESSERA_TESSELLATOR_RUN_POINTS_H
#define TESSERA_TESSELLATOR_RUN_POINTS_H

#include "tessellator/ring_table.h"
#include "tessellator/ring_window.h"

/// u and v of RUN points from `first` on, of which `valid` is the first that belongs to the patch.
#define RUN_POINTS(patch, ring_table, valid, first, us, vs)            \
    if (PATCH_HAS_RINGS(patch)) {                                      \
        RING_RUN_POINTS(patch, ring_table, valid, first, us, vs)       \
    } else {                                                           \
        FOR_RUN(k) {                                                   \
            const DomainPoint point = PLAIN_POINT(patch, (first) + k); \
            us[k] = point.u;                                           \
            vs[k] = point.v;                                           \
        }                                                              \
    }

/// By their index alone.
#define WINDOW_RUN_POINTS(patch, ring_table, valid, first, us, vs)        \
    const RingWindow window = POINT_WINDOW(patch, valid);                 \
    FOR_RUN(k) {                                                          \
        const DomainPoint point = RING_POINT(patch, window, (first) + k); \
        us[k] = point.u;                                                  \
        vs[k] = point.v;                                                  \
    }

/// By the table. The outer ring's points, and those of the few runs that lead from it to the next, are worked out.
#define TABLE_RUN_POINTS(patch, ring_table, valid, first, us, vs)                                               \
    const RingPlace place = ring_place(patch);                                                                  \
    const uint point_at = place.points + (first)-patch.outer_points;                                            \
    if ((valid) >= patch.outer_points) {                                                                        \
        FOR_RUN(k) {                                                                                            \
            const DomainPoint point = inner_point(patch.inside, ring_table[RUN_AT(point_at, k)] - place.shift); \
            us[k] = point.u;                                                                                    \
            vs[k] = point.v;                                                                                    \
        }                                                                                                       \
    } else {                                                                                                    \
        FOR_RUN(k) {                                                                                            \
            const DomainPoint point = outer_point(patch, (first) + k);                                          \
            us[k] = point.u;                                                                                    \
            vs[k] = point.v;                                                                                    \
        }                                                                                                       \
        for (uint k = patch.outer_points - (first); k < RUN; ++k) {                                             \
            const DomainPoint point = inner_point(patch.inside, ring_table[point_at + k] - place.shift);        \
            us[k] = point.u;                                                                                    \
            vs[k] = point.v;                                                                                    \
        }                                                                                                       \
    }

#endif
