// OROGEN_CLONES: compile a loop also for AVX2 and AVX-512 and choose at run time. Without
// contraction (-ffp-contract=off) all versions give the same bits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define OROGEN_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define OROGEN_CLONES
#endif
