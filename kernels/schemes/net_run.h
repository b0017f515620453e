// How control nets of several patches are made at once: on CPUs one item in RUN takes RUN neighbouring patches, word by
// word, so that compilers make vector code; elsewhere every item takes its own.
#ifndef TESSERA_SCHEMES_NET_RUN_H
#define TESSERA_SCHEMES_NET_RUN_H

#include "emission.h"
#include "vector.h"

KERNELS_BEGIN

/// The patches of a run, from place `at` of a list on, `valid` of them; the rest are the first one once more.
#define LOAD_NET_PATCHES(patches, patch_list, at, valid)        \
    FOR_RUN(k) {                                                \
        patches[k] = patch_list[(at) + (k < (valid) ? k : 0u)]; \
    }

/// Word `word` of net k of a run: all first words lie together, then all second ones.
#define PUT_NET(run, word, k, value) run[(word)*RUN + (k)] = value
#define PUT_NET_VECTOR(run, word, k, v)  \
    PUT_NET(run, word, k, (v).x);        \
    PUT_NET(run, (word) + 1u, k, (v).y); \
    PUT_NET(run, (word) + 2u, k, (v).z)

/// Writes the `valid` first nets of a run, `words` long each; what is left of the stride is zero.
#define STORE_NETS(nets, stride, run, words, patches, valid) \
    for (uint net = 0u; net < (valid); ++net) {              \
        const uint at = patches[net] * (stride);             \
        for (uint word = 0u; word < (words); ++word) {       \
            nets[at + word] = run[word * RUN + net];         \
        }                                                    \
        for (uint word = (words); word < (stride); ++word) { \
            nets[at + word] = 0.0f;                          \
        }                                                    \
    }

KERNELS_END

#endif
