// Stage 6, the kernel of every domain with triangles: records and offsets -> triangles, three indices each. An
// including file names the kernel by INDICES_KERNEL and includes triangle_domain.h or quad_domain.h first. No include
// guard: every variant includes it once.
KERNELS_BEGIN

#if RING_TABLE
KERNEL6(INDICES_KERNEL, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), READ(4, uint, ring_table), UNIFORM(5, EmitParams, params)) {
#else
KERNEL5(INDICES_KERNEL, READ(0, uint, records), READ(1, uint, offsets), READ(2, uint, patch_list),
        WRITE(3, uint, index_buffer), UNIFORM(4, EmitParams, params)) {
#endif
    const EmitParams p = LOAD_UNIFORM(params);
    const EmissionItem e = make_emission_item(p, ITEM);
    if (e.has_patch == 0u) {
        STREAM_END;
        return;
    }
    const uint patch_index = patch_list[e.entry];
    const uint base = p.vertex_base + VERTEX_START(p, offsets, patch_index);
    const uint start = INDEX_START(p, offsets, patch_index);
    const uint words = INDEX_COUNT(offsets, patch_index);
    const PATCH_TYPE t = LOAD_PATCH(records, patch_index);
    const bool flip = (t.flags & RECORD_FLIP) != 0u;
    const bool rings = PATCH_HAS_RINGS(t);
    const uint count = words / 3u;
    const uint outer = rings ? OUTER_COUNT(t) : count;
    // Row 1, or a patch without rings; then, where no table has them, the other rows.
    const uint parts = RING_TABLE == 1 ? 1u : 2u;
    for (uint part = 0u; part < parts; ++part) {
        const uint begin = part == 0u ? 0u : outer;
        const uint end = part == 0u ? outer : count;
        // Runs begin on whole cache lines of the buffer: the first and the last may hold triangles that are not of this
        // part, which are made and not written.
        const uint shift = (start / 3u + begin) & (RUN - 1u);
        const uint size = end == begin ? 0u : end - begin + shift;
        for (uint at = e.first; at < size; at = at + e.step) {
            const uint first = begin + at - shift;
            uint run[RUN * 3u];
#if !RING_TABLE
            if (part != 0u) {
                const RingWindow window = ROW_WINDOW(t, at < shift ? begin : first);
                FOR_RUN(k) {
                    const Triangle corners = INNER_TRIANGLE(t, window, first + k);
                    PUT_TRIANGLE(run, k, base, flip, corners);
                }
            } else
#endif
                if (rings) {
#if RING_TABLE
                FOR_RUN(k) {
                    const OuterPlace at_row = triangle_outer_place(t, first + k);
                    const uint step = ring_step(t, at_row);
                    const Triangle corners =
                        triangle_outer_stepped(t, at_row, ring_step_of(ring_table[to_int(ring_step_word(step))], step));
                    PUT_TRIANGLE(run, k, base, flip, corners);
                }
#else
                FOR_RUN(k) {
                    const Triangle corners = OUTER_TRIANGLE(t, first + k);
                    PUT_TRIANGLE(run, k, base, flip, corners);
                }
#endif
            } else {
                FOR_RUN(k) {
                    const Triangle corners = PLAIN_TRIANGLE(t, first + k);
                    PUT_TRIANGLE(run, k, base, flip, corners);
                }
            }
            if (at >= shift && first + RUN <= end) {
                STREAM_TRIANGLES(index_buffer, start + 3u * first, run);
            } else {
                const uint skipped = at < shift ? shift - at : 0u;
                const uint made = run_length(first, end);
                for (uint word = 3u * skipped; word < 3u * made; ++word) {
                    index_buffer[start + 3u * first + word] = run[word % 3u * RUN + word / 3u];
                }
            }
        }
    }
#if RING_TABLE
    // The other rows: whole runs that begin on a multiple of RUN words are streamed; the first lane adds what
    // is left at both ends. The table has the patch's winding.
    const RingPlace place = ring_place(t);
    const uint inner_base = base + place.base;
    const uint begin = 3u * outer;
    const uint table_at = place.triangles - begin;  // wraps around
    const WholeRuns whole = whole_runs(start, begin, words);
    uint word = whole.begin + e.first;
    COPY_INDEX_RUNS(index_buffer, start, word, whole.end, e.step, inner_base, ring_table, table_at)
    if (e.first == 0u) {
        COPY_INDICES(index_buffer, start, begin, whole.begin, inner_base, ring_table, table_at)
        COPY_INDICES(index_buffer, start, whole.end, words, inner_base, ring_table, table_at)
    }
#endif
    STREAM_END;
}

KERNELS_END

#undef INDICES_KERNEL
#include "tessellator/end_domain.h"
