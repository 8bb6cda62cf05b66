/**
 * VFM_CLONES compiles a function twice, with and without AVX2; the processor selects
 * one at run time.
 */
#pragma once

// Both versions omit fused multiply-add, so their results are bitwise identical. ThreadSanitizer is
// excluded: the version is selected at load time, before its runtime is ready. Clang cannot inline
// functions of lanes into both versions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define VFM_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define VFM_CLONES
#endif
#define VFM_INLINE inline __attribute__((always_inline))
