/* Functions that are compiled for several widths of vector registers; the one that fits the
 * processor is chosen when the program is loaded, which is before the thread sanitizer can be
 * called. The order of their operations, and so their results, are the same. */
#ifndef PO_WIDTHS_H
#define PO_WIDTHS_H

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_THREAD__)
#define PO_FOR_ALL_WIDTHS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PO_FOR_ALL_WIDTHS
#endif
/* Whether functions may use vectors of 32 bytes: on Windows GCC does not align those that it keeps
 * on the stack (GCC bug 54412). */
#if defined(__x86_64__) && !defined(_WIN32)
#define PO_WIDE_VECTORS 1
#else
#define PO_WIDE_VECTORS 0
#endif
/* A function that becomes part of each of them. */
#define PO_INLINE static inline __attribute__((always_inline))

#endif
