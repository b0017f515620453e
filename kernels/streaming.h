// How runs reach memory on CPUs: transposed from arrays into vertices by vector shuffles, and written past the caches
// where the processor can. Read by C++ (dialect.h) and put in front of every OpenCL source, for only the device's
// compiler knows what it has; TESSERA_RUN comes as a build option there. GLSL writes runs of one element directly.
#ifndef TESSERA_STREAMING_H
#define TESSERA_STREAMING_H

#if defined(__OPENCL_VERSION__)

#define TESSERA_GLOBAL __global
#ifdef __clang__
#define TESSERA_INLINE static inline __attribute__((always_inline))  // what is not inlined is not vectorised
#else
#define TESSERA_INLINE static inline
#endif
typedef float16 tessera_float16;
typedef float8 tessera_float8;
typedef uint16 tessera_uint16;
#ifdef __clang__
// A vload16 of a run that never was in memory is taken apart and put together again: six instructions for nothing.
typedef float16 tessera_unaligned_float16 __attribute__((aligned(4)));
typedef uint16 tessera_unaligned_uint16 __attribute__((aligned(4)));
#define TESSERA_LOAD16(words) (*(const tessera_unaligned_float16*)(words))
#define TESSERA_LOAD_WORDS(words) (*(const tessera_unaligned_uint16*)(words))
#else
#define TESSERA_LOAD16(words) vload16(0, words)
#define TESSERA_LOAD_WORDS(words) vload16(0, words)
#endif
#define TESSERA_LOAD8(words) vload8(0, words)
#define TESSERA_PREFETCH(pointer)
#ifdef __has_builtin
#if __has_builtin(__builtin_prefetch)
#undef TESSERA_PREFETCH
#define TESSERA_PREFETCH(pointer) __builtin_prefetch(pointer)
#endif
#if __has_builtin(__builtin_nontemporal_store)
#define TESSERA_STREAM(type, pointer, value) __builtin_nontemporal_store(value, (__global type*)(pointer))
#endif
#if __has_builtin(__builtin_ia32_sfence)
// The items of a group run in turns on one thread. A fence after each would wait for its stores: a third of the time.
#define TESSERA_STREAM_END                           \
    if (get_local_id(0) + 1u == get_local_size(0)) { \
        __builtin_ia32_sfence();                     \
    }
#endif
#if __has_builtin(__builtin_shufflevector)
#define TESSERA_SHUFFLES
#endif
#endif
#ifndef TESSERA_SHUFFLES  // no vectors to transpose: one element at a time
#undef TESSERA_RUN
#define TESSERA_RUN 1
#endif
#ifndef TESSERA_STREAM
#define TESSERA_STREAM(type, pointer, value) (*(__global type*)(pointer) = (value))
#endif
#ifndef TESSERA_STREAM_END
#define TESSERA_STREAM_END
#endif
#if defined(__clang__) && TESSERA_RUN > 1
#define TESSERA_FOR_RUN _Pragma("clang loop vectorize(enable) vectorize_width(16) unroll(disable)")
#define TESSERA_FOR_RUNS _Pragma("clang loop vectorize(enable) vectorize_width(16) interleave_count(2) unroll(disable)")
#else
#define TESSERA_FOR_RUN
#define TESSERA_FOR_RUNS
#endif

#else  // C++

#define TESSERA_RUN 16
#define TESSERA_GLOBAL
#define TESSERA_INLINE [[gnu::always_inline]] inline
KERNELS_BEGIN
typedef unsigned uint;
typedef float tessera_float16 __attribute__((vector_size(64)));
typedef float tessera_float8 __attribute__((vector_size(32)));
typedef uint tessera_uint16 __attribute__((vector_size(64)));
template <typename Vector, typename Word>
TESSERA_INLINE Vector load_vector(const Word* words) {
    Vector v;
    std::memcpy(&v, words, sizeof v);
    return v;
}
/// `to` lies on 16 bytes.
template <typename Vector>
TESSERA_INLINE void stream_vector(void* to, Vector v) {
#if defined(__AVX512F__)
    if constexpr (sizeof v == 64) {
        _mm512_stream_si512(static_cast<__m512i*>(to), reinterpret_cast<__m512i&>(v));
        return;
    }
#endif
#if defined(__SSE2__)
    __m128i parts[sizeof v / 16];
    std::memcpy(parts, &v, sizeof v);
    for (unsigned i = 0; i < sizeof v / 16; ++i)
        _mm_stream_si128(static_cast<__m128i*>(to) + i, parts[i]);
#else
    std::memcpy(to, &v, sizeof v);
#endif
}
#define TESSERA_PREFETCH(pointer) __builtin_prefetch(pointer)
#define TESSERA_LOAD16(words) load_vector<tessera_float16>(words)
#define TESSERA_LOAD_WORDS(words) load_vector<tessera_uint16>(words)
#define TESSERA_LOAD8(words) load_vector<tessera_float8>(words)
#define TESSERA_STREAM(type, pointer, value) stream_vector<type>(pointer, value)
/// After the last item of a range, by whoever runs ranges of items.
TESSERA_INLINE void end_streaming() {
#if defined(__SSE2__)
    _mm_sfence();
#endif
}

#endif

#if TESSERA_RUN == 1

#define TESSERA_STREAM_VERTICES(buffer, start, first, count, run) \
    TESSERA_STREAM(tessera_float8, buffer + 8u * (start + (first)), TESSERA_LOAD8(run))
#define TESSERA_STREAM_WORDS(pointer, run) (*(pointer) = (run)[0])
#define TESSERA_STREAM_TRIANGLES(pointer, run) \
    (pointer)[0] = (run)[0];                   \
    (pointer)[1] = (run)[1];                   \
    (pointer)[2] = (run)[2]

#else

// A transposition in three steps, each of which joins twice as many words of a vertex. First words 0, 1, 4, 5... or 2,
// 3, 6, 7... of two rows of 16 in turns: vertices 0, 1, 4, 5... or 2, 3, 6, 7....
#define TESSERA_LOW(a, b) __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29)
#define TESSERA_HIGH(a, b) __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31)
/// Then pairs of words: of the first four vertices that two such rows have, or of the last four.
#define TESSERA_FIRST(a, b) __builtin_shufflevector(a, b, 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23)
#define TESSERA_LAST(a, b) __builtin_shufflevector(a, b, 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31)
/// Then fours of words: two whole vertices.
#define TESSERA_PAIR(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23)
#define TESSERA_NEXT_PAIR(a, b) \
    __builtin_shufflevector(a, b, 8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31)

/// Two vertices, of which those below `count` are written. Half a cache line waits in the processor's buffer for the
/// other half, which the same thread writes next, where it goes on with the neighbouring patch.
TESSERA_INLINE void tessera_stream_pair(TESSERA_GLOBAL float* buffer, uint start, uint i, uint count,
                                        tessera_float16 pair) {
    if (i < count && i + 1u < count) {
        TESSERA_STREAM(tessera_float16, buffer + 8u * (start + i), pair);
    } else if (i < count) {
        TESSERA_STREAM(tessera_float8, buffer + 8u * (start + i),
                       __builtin_shufflevector(pair, pair, 0, 1, 2, 3, 4, 5, 6, 7));
    } else if (i + 1u < count) {
        TESSERA_STREAM(tessera_float8, buffer + 8u * (start + i + 1u),
                       __builtin_shufflevector(pair, pair, 8, 9, 10, 11, 12, 13, 14, 15));
    }
}

/// Vertices first..first + 15 of a patch, those below `count`, to a buffer in which the patch begins at vertex `start`;
/// start + first is even. `run` holds 16 of each of a vertex's eight words.
TESSERA_INLINE void tessera_stream_vertices(TESSERA_GLOBAL float* buffer, uint start, uint first, uint count,
                                            const float* run) {
    const tessera_float16 r0 = TESSERA_LOAD16(run), r1 = TESSERA_LOAD16(run + 16);
    const tessera_float16 r2 = TESSERA_LOAD16(run + 32), r3 = TESSERA_LOAD16(run + 48);
    const tessera_float16 r4 = TESSERA_LOAD16(run + 64), r5 = TESSERA_LOAD16(run + 80);
    const tessera_float16 r6 = TESSERA_LOAD16(run + 96), r7 = TESSERA_LOAD16(run + 112);
    const tessera_float16 l01 = TESSERA_LOW(r0, r1), h01 = TESSERA_HIGH(r0, r1);
    const tessera_float16 l23 = TESSERA_LOW(r2, r3), h23 = TESSERA_HIGH(r2, r3);
    const tessera_float16 l45 = TESSERA_LOW(r4, r5), h45 = TESSERA_HIGH(r4, r5);
    const tessera_float16 l67 = TESSERA_LOW(r6, r7), h67 = TESSERA_HIGH(r6, r7);
    const tessera_float16 a0 = TESSERA_FIRST(l01, l23), b0 = TESSERA_FIRST(l45, l67);  // vertices 0, 1, 4, 5
    const tessera_float16 a2 = TESSERA_FIRST(h01, h23), b2 = TESSERA_FIRST(h45, h67);  // 2, 3, 6, 7
    const tessera_float16 a8 = TESSERA_LAST(l01, l23), b8 = TESSERA_LAST(l45, l67);    // 8, 9, 12, 13
    const tessera_float16 a10 = TESSERA_LAST(h01, h23), b10 = TESSERA_LAST(h45, h67);  // 10, 11, 14, 15
    const tessera_float16 p0 = TESSERA_PAIR(a0, b0), p4 = TESSERA_NEXT_PAIR(a0, b0);
    const tessera_float16 p2 = TESSERA_PAIR(a2, b2), p6 = TESSERA_NEXT_PAIR(a2, b2);
    const tessera_float16 p8 = TESSERA_PAIR(a8, b8), p12 = TESSERA_NEXT_PAIR(a8, b8);
    const tessera_float16 p10 = TESSERA_PAIR(a10, b10), p14 = TESSERA_NEXT_PAIR(a10, b10);
    const uint i = first;
    if (i < count && count - i >= 16u) {
        TESSERA_GLOBAL float* at = buffer + 8u * (start + i);
        TESSERA_STREAM(tessera_float16, at, p0);
        TESSERA_STREAM(tessera_float16, at + 16, p2);
        TESSERA_STREAM(tessera_float16, at + 32, p4);
        TESSERA_STREAM(tessera_float16, at + 48, p6);
        TESSERA_STREAM(tessera_float16, at + 64, p8);
        TESSERA_STREAM(tessera_float16, at + 80, p10);
        TESSERA_STREAM(tessera_float16, at + 96, p12);
        TESSERA_STREAM(tessera_float16, at + 112, p14);
        return;
    }
    tessera_stream_pair(buffer, start, i, count, p0);
    tessera_stream_pair(buffer, start, i + 2u, count, p2);
    tessera_stream_pair(buffer, start, i + 4u, count, p4);
    tessera_stream_pair(buffer, start, i + 6u, count, p6);
    tessera_stream_pair(buffer, start, i + 8u, count, p8);
    tessera_stream_pair(buffer, start, i + 10u, count, p10);
    tessera_stream_pair(buffer, start, i + 12u, count, p12);
    tessera_stream_pair(buffer, start, i + 14u, count, p14);
}

#define TESSERA_STREAM_VERTICES(buffer, start, first, count, run) \
    tessera_stream_vertices(buffer, start, first, count, run)
#define TESSERA_STREAM_WORDS(pointer, run) TESSERA_STREAM(tessera_uint16, pointer, TESSERA_LOAD_WORDS(run))
/// First and second corners of 16 triangles in the places that they have among words 0 to 15, 16 to 31 or 32 to 47 of a
/// list of triangles; then the third corners between them.
#define TESSERA_AB0(a, b) __builtin_shufflevector(a, b, 0, 16, -1, 1, 17, -1, 2, 18, -1, 3, 19, -1, 4, 20, -1, 5)
#define TESSERA_ABC0(ab, c) __builtin_shufflevector(ab, c, 0, 1, 16, 3, 4, 17, 6, 7, 18, 9, 10, 19, 12, 13, 20, 15)
#define TESSERA_AB1(a, b) __builtin_shufflevector(a, b, 21, -1, 6, 22, -1, 7, 23, -1, 8, 24, -1, 9, 25, -1, 10, 26)
#define TESSERA_ABC1(ab, c) __builtin_shufflevector(ab, c, 0, 21, 2, 3, 22, 5, 6, 23, 8, 9, 24, 11, 12, 25, 14, 15)
#define TESSERA_AB2(a, b) __builtin_shufflevector(a, b, -1, 11, 27, -1, 12, 28, -1, 13, 29, -1, 14, 30, -1, 15, 31, -1)
#define TESSERA_ABC2(ab, c) __builtin_shufflevector(ab, c, 26, 1, 2, 27, 4, 5, 28, 7, 8, 29, 10, 11, 30, 13, 14, 31)

/// 16 triangles to a multiple of 16 words. `run` holds all first corners, then all second, then all third ones.
TESSERA_INLINE void tessera_stream_triangles(TESSERA_GLOBAL uint* to, const uint* run) {
    const tessera_uint16 a = TESSERA_LOAD_WORDS(run);
    const tessera_uint16 b = TESSERA_LOAD_WORDS(run + 16);
    const tessera_uint16 c = TESSERA_LOAD_WORDS(run + 32);
    const tessera_uint16 ab0 = TESSERA_AB0(a, b), ab1 = TESSERA_AB1(a, b), ab2 = TESSERA_AB2(a, b);
    TESSERA_STREAM(tessera_uint16, to, TESSERA_ABC0(ab0, c));
    TESSERA_STREAM(tessera_uint16, to + 16, TESSERA_ABC1(ab1, c));
    TESSERA_STREAM(tessera_uint16, to + 32, TESSERA_ABC2(ab2, c));
}

#define TESSERA_STREAM_TRIANGLES(pointer, run) tessera_stream_triangles(pointer, run)

#endif

#if !defined(__OPENCL_VERSION__)
KERNELS_END
#endif

#endif
