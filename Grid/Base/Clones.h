/**
 * Functions compiled once for machines with AVX2 and once for all.
 */
#pragma once

// The same source for machines with and without AVX2; no fused multiply-add, so both give the same bits.
// ThreadSanitizer cannot choose between them: it is not there yet when the program is loaded.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_THREAD__)
#define VFM_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define VFM_CLONES
#endif
#define VFM_INLINE inline __attribute__((always_inline))
