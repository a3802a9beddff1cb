#pragma once

/// In front of a function whose loops are worth wider registers: compiled for AVX2 and for any
/// processor, chosen when the program starts. Both give the same bits, as nothing is contracted.
/// Sanitizers are not ready when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define AUTOSTEREO_VECTORISED [[gnu::target_clones("avx2", "default")]]
#else
#define AUTOSTEREO_VECTORISED
#endif
