// One small vocabulary with three meanings: GLSL, OpenCL C and C++.
//
// A kernel is written once, in the words below, and compiled three times: by glslang (TESSERA_GLSL), by an OpenCL
// driver (TESSERA_OPENCL) and by the host compiler (neither). Rules that the words cannot enforce:
//   - floats meet only + - x, comparisons and bit casts (kernels/exact.h has the rest); the build checks the SPIR-V;
//   - scalars and structs of scalars only: vector types keep PoCL from vectorising;
//   - a function never takes a buffer (GLSL has no pointers): kernels load, functions compute, kernels store;
//   - every item writes its own elements; no barriers, group memory or atomics;
//   - unsigned literals end in u, float literals in f.
#ifndef TESSERA_DIALECT_H
#define TESSERA_DIALECT_H

// Work items of one workgroup; WebGPU promises 256, SwiftShader has no more.
#define WORKGROUP_SIZE 64

// C++ wraps shared code in its namespace, and in one per instruction set where it is compiled for several; the other
// two have none.
#if defined(TESSERA_GLSL) || defined(TESSERA_OPENCL)
#define KERNELS_BEGIN
#define KERNELS_END
#elif defined(TESSERA_ISA)
#define KERNELS_BEGIN namespace tessera::kernels::TESSERA_ISA {
#define KERNELS_END }
#else
#define KERNELS_BEGIN namespace tessera::kernels {
#define KERNELS_END }
#endif

#if defined(TESSERA_GLSL)

layout(local_size_x = WORKGROUP_SIZE) in;

#define FUNCTION
#define STRUCT(name) struct name
#define float_bits(x) floatBitsToUint(x)
#define bits_float(x) uintBitsToFloat(x)
#define to_float(x) float(int(x))
#define to_uint(x) uint(x)
#define to_int(x) int(x)
#define RUN 1u
#define PATTERN_HAS_WEIGHTS 0  // for kernels that work in runs of several elements
#define FOR_RUN(k) for (uint k = 0u; k < RUN; ++k)
#define FOR_RUNS(k, count) for (uint k = 0u; k < (count); ++k)  // runs side by side: a long run that waits for itself
#define RUN_AT(first, k) ((first) + (k))                        // an index that does not wrap around within a run
// The statement for bit = 16, 8, 4, 2 and 1. Written out where runs are vectorised, for a loop in them prevents that;
// a loop here, for some drivers take minutes over long code.
#define FOR_BITS(bit, statement)                      \
    for (uint bit = 16u; bit > 0u; bit = bit >> 1u) { \
        statement;                                    \
    }

// Bindings of a kernel: READ and WRITE are storage buffers, UNIFORM is one struct of 32-bit scalars.
#define READ(slot, type, name)                                                       \
    layout(set = 0, binding = slot, std430) restrict readonly buffer name##_buffer { \
        type name[];                                                                 \
    };
#define WRITE(slot, type, name)                                             \
    layout(set = 0, binding = slot, std430) restrict buffer name##_buffer { \
        type name[];                                                        \
    };
#define UNIFORM(slot, type, name)                                   \
    layout(set = 0, binding = slot, std140) uniform name##_buffer { \
        type name;                                                  \
    };
#define LOAD_UNIFORM(name) name

#define KERNEL2(name, a, b) a b void main()
#define KERNEL3(name, a, b, c) a b c void main()
#define KERNEL4(name, a, b, c, d) a b c d void main()
#define KERNEL5(name, a, b, c, d, e) a b c d e void main()
#define KERNEL6(name, a, b, c, d, e, f) a b c d e f void main()
#define KERNEL7(name, a, b, c, d, e, f, g) a b c d e f g void main()
#define KERNEL8(name, a, b, c, d, e, f, g, h) a b c d e f g h void main()
#define KERNEL9(name, a, b, c, d, e, f, g, h, i) a b c d e f g h i void main()

// A run of vertices to their place: those of vertices first..first + RUN - 1 that are below `count`, of a patch that
// begins at vertex `start`; `run` holds RUN of each of a vertex's eight words. STREAM_WORDS writes RUN words to a
// multiple of RUN, STREAM_TRIANGLES 3 RUN likewise. Where a device can, both go past its caches. STREAM_END comes after
// an item's last, and where it has none.
#define STREAM_GROUP 1u  // start + first must be a multiple of this
#define STREAM_VERTICES(buffer, start, first, count, run)    \
    for (uint word = 0u; word < 8u; ++word) {                \
        buffer[8u * ((start) + (first)) + word] = run[word]; \
    }
#define STREAM_WORDS(buffer, at, run) buffer[at] = run[0]
#define STREAM_TRIANGLES(buffer, at, run) \
    buffer[at] = run[0];                  \
    buffer[(at) + 1u] = run[1];           \
    buffer[(at) + 2u] = run[2]
#define STREAM_END
#define PREFETCH(buffer, at)  // the cache line that holds a word, wanted soon

// Index of the work item over both dimensions of the dispatch.
#define ITEM (gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * uint(WORKGROUP_SIZE)))

#elif defined(TESSERA_OPENCL)

_Pragma("OPENCL FP_CONTRACT OFF")

#define FUNCTION TESSERA_INLINE
#define STRUCT(name)          \
    typedef struct name name; \
    struct name
#define float_bits(x) as_uint(x)
#define bits_float(x) as_float(x)
#define to_float(x) ((float)(int)(x))
#define to_uint(x) ((uint)(x))
#define to_int(x) ((int)(x))
#define RUN TESSERA_RUN  // kernels/streaming.h
#define PATTERN_HAS_WEIGHTS 1
#define FOR_RUN(k) TESSERA_FOR_RUN for (uint k = 0u; k < RUN; ++k)
#define FOR_RUNS(k, count) TESSERA_FOR_RUNS for (uint k = 0u; k < (count); ++k)
#define RUN_AT(first, k) ((ulong)(first) + (ulong)(k))  // wide, so that the compiler sees neighbours
#define FOR_BITS FOR_BITS_WRITTEN_OUT

#define READ(slot, type, name) __global const type* restrict name
#define WRITE(slot, type, name) __global type* restrict name
#define UNIFORM(slot, type, name) __global const type* restrict name
#define LOAD_UNIFORM(name) (*name)

#define KERNEL2(name, a, b) __kernel void name(a, b)
#define KERNEL3(name, a, b, c) __kernel void name(a, b, c)
#define KERNEL4(name, a, b, c, d) __kernel void name(a, b, c, d)
#define KERNEL5(name, a, b, c, d, e) __kernel void name(a, b, c, d, e)
#define KERNEL6(name, a, b, c, d, e, f) __kernel void name(a, b, c, d, e, f)
#define KERNEL7(name, a, b, c, d, e, f, g) __kernel void name(a, b, c, d, e, f, g)
#define KERNEL8(name, a, b, c, d, e, f, g, h) __kernel void name(a, b, c, d, e, f, g, h)
#define KERNEL9(name, a, b, c, d, e, f, g, h, i) __kernel void name(a, b, c, d, e, f, g, h, i)

#define STREAM_GROUP (TESSERA_RUN > 1 ? 2u : 1u)
#define STREAM_VERTICES TESSERA_STREAM_VERTICES
#define STREAM_WORDS(buffer, at, run) TESSERA_STREAM_WORDS(buffer + (at), run)
#define STREAM_TRIANGLES(buffer, at, run) TESSERA_STREAM_TRIANGLES(buffer + (at), run)
#define STREAM_END TESSERA_STREAM_END
#define PREFETCH(buffer, at) TESSERA_PREFETCH(buffer + (at))

#define ITEM ((uint)get_global_id(0) + (uint)get_global_id(1) * (uint)get_global_size(0))

#else  // C++: a kernel is a function whose parameter types carry slot and access, so that the host can read them.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "streaming.h"

KERNELS_BEGIN

struct Item {
    uint index;
};
template <unsigned Slot, typename T>
struct Read {
    const T* data;
    const T& operator[](uint i) const { return data[i]; }
    const T& operator[](int i) const { return data[i]; }
    const T& operator[](std::size_t i) const { return data[i]; }
};
template <unsigned Slot, typename T>
struct Write {
    T* data;
    T& operator[](uint i) const { return data[i]; }
};
template <unsigned Slot, typename T>
struct Uniform {
    const T* data;
    const T& operator*() const { return *data; }
};

KERNELS_END

#define FUNCTION inline
#define STRUCT(name) struct name
#define float_bits(x) std::bit_cast<uint>(x)
#define bits_float(x) std::bit_cast<float>(static_cast<uint>(x))
#define to_float(x) static_cast<float>(static_cast<int>(x))
#define to_uint(x) static_cast<uint>(x)
#define to_int(x) static_cast<int>(x)
#define RUN 16u
#define PATTERN_HAS_WEIGHTS 1
#define FOR_RUN(k) for (uint k = 0u; k < RUN; ++k)
#define FOR_RUNS(k, count) for (uint k = 0u; k < (count); ++k)
#define RUN_AT(first, k) (std::size_t{first} + (k))  // wide, as in OpenCL
#define FOR_BITS FOR_BITS_WRITTEN_OUT

// Kernels made of one pattern share a signature, and some have no use for all of it.
#define READ(slot, type, name) [[maybe_unused]] Read<slot, type> name
#define WRITE(slot, type, name) Write<slot, type> name
#define UNIFORM(slot, type, name) Uniform<slot, type> name
#define LOAD_UNIFORM(name) (*name)

#define KERNEL2(name, a, b) inline void name(Item dispatched, a, b)
#define KERNEL3(name, a, b, c) inline void name(Item dispatched, a, b, c)
#define KERNEL4(name, a, b, c, d) inline void name(Item dispatched, a, b, c, d)
#define KERNEL5(name, a, b, c, d, e) inline void name(Item dispatched, a, b, c, d, e)
#define KERNEL6(name, a, b, c, d, e, f) inline void name(Item dispatched, a, b, c, d, e, f)
#define KERNEL7(name, a, b, c, d, e, f, g) inline void name(Item dispatched, a, b, c, d, e, f, g)
#define KERNEL8(name, a, b, c, d, e, f, g, h) inline void name(Item dispatched, a, b, c, d, e, f, g, h)
#define KERNEL9(name, a, b, c, d, e, f, g, h, i) inline void name(Item dispatched, a, b, c, d, e, f, g, h, i)

#define STREAM_GROUP 2u
#define STREAM_VERTICES(buffer, start, first, count, run) tessera_stream_vertices(buffer.data, start, first, count, run)
#define STREAM_WORDS(buffer, at, run) TESSERA_STREAM_WORDS(buffer.data + (at), run)
#define STREAM_TRIANGLES(buffer, at, run) TESSERA_STREAM_TRIANGLES(buffer.data + (at), run)
#define STREAM_END  // the loop over items does it: end_streaming()
#define PREFETCH(buffer, at) TESSERA_PREFETCH(buffer.data + (at))

#define ITEM dispatched.index

#endif

#define FOR_BITS_WRITTEN_OUT(bit, statement) \
    {                                        \
        const uint bit = 16u;                \
        statement;                           \
    }                                        \
    {                                        \
        const uint bit = 8u;                 \
        statement;                           \
    }                                        \
    {                                        \
        const uint bit = 4u;                 \
        statement;                           \
    }                                        \
    {                                        \
        const uint bit = 2u;                 \
        statement;                           \
    }                                        \
    {                                        \
        const uint bit = 1u;                 \
        statement;                           \
    }

#endif
