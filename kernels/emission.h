// How the work items of an emitting kernel share out the patches of a list: 2^lanes_log2 items, the lanes, take turns
// on a patch, a run of RUN elements at a time. CPUs have long runs, made by branch-free loops of constant length that
// compilers turn into vector code; elsewhere a run is one element.
#ifndef TESSERA_EMISSION_H
#define TESSERA_EMISSION_H

#include "layout.h"

KERNELS_BEGIN

STRUCT(EmissionItem) {
    uint has_patch;  // 0: the item is beyond the last patch
    uint entry;      // of the patch list
    uint first;      // the first element this item makes
    uint step;       // from one run of its elements to the next
};

FUNCTION EmissionItem make_emission_item(EmitParams p, uint item) {
    EmissionItem e;
    const uint lanes = 1u << p.lanes_log2;
    e.first = (item & (lanes - 1u)) * RUN;
    e.step = lanes * RUN;
    e.entry = p.first + (item >> p.lanes_log2);
    e.has_patch = (item >> p.lanes_log2) < p.count ? 1u : 0u;
    return e;
}

/// Where a patch's vertices and indices begin in the buffers of a batch, and how many there are.
#define VERTEX_START(p, offsets, patch_index) (offsets[(patch_index)*COUNT_WORDS] - (p).first_vertex)
#define VERTEX_COUNT(offsets, patch_index) \
    (offsets[((patch_index) + 1u) * COUNT_WORDS] - offsets[(patch_index)*COUNT_WORDS])
#define INDEX_START(p, offsets, patch_index) (offsets[(patch_index)*COUNT_WORDS + 1u] - (p).first_index)
#define INDEX_COUNT(offsets, patch_index) \
    (offsets[((patch_index) + 1u) * COUNT_WORDS + 1u] - offsets[(patch_index)*COUNT_WORDS + 1u])

/// Elements of a run that begins at `first` of `count`.
FUNCTION uint run_length(uint first, uint count) {
    return count - first < RUN ? count - first : RUN;
}

/// Puts the point indices of triangle k into a run: all first corners, then all second, then all third ones; `flip`
/// turns its winding round.
#define PUT_TRIANGLE(run, k, base, flip, corners)                   \
    run[k] = (base) + (corners).a;                                  \
    run[RUN + (k)] = (base) + ((flip) ? (corners).c : (corners).b); \
    run[2u * RUN + (k)] = (base) + ((flip) ? (corners).b : (corners).c)

/// Of words [begin, end) of a patch's indices, which lie from word `start` of the buffer on: whole runs that begin on a
/// multiple of RUN words.
STRUCT(WholeRuns) {
    uint begin;
    uint end;
};

FUNCTION WholeRuns whole_runs(uint start, uint begin, uint end) {
    const uint aligned = begin + ((0u - (start + begin)) & (RUN - 1u));
    WholeRuns whole;
    whole.begin = aligned < end ? aligned : end;
    whole.end = whole.begin + ((end - whole.begin) & ~(RUN - 1u));
    return whole;
}

/// Copies indices to a patch's place, `base` added: every `step`-th run from `word` on that begins before `until`; and
/// words [begin, end).
#define COPY_INDEX_RUNS(index_buffer, start, word, until, step, base, table, table_at) \
    for (; word < (until); word = word + (step)) {                                     \
        uint indices[RUN];                                                             \
        FOR_RUN(k) {                                                                   \
            indices[k] = (base) + table[RUN_AT((table_at) + word, k)];                 \
        }                                                                              \
        STREAM_WORDS(index_buffer, (start) + word, indices);                           \
    }
#define COPY_INDICES(index_buffer, start, begin, end, base, table, table_at) \
    for (uint at = begin; at < (end); ++at) {                                \
        index_buffer[(start) + at] = (base) + table[(table_at) + at];        \
    }

KERNELS_END

#endif
