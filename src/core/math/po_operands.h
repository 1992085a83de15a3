/* Kernels whose operands the address sanitizer looks at as a whole, once a call, and not at each
 * access: its solves then take a sixth less time. PO_WHOLE_OPERANDS stands before such a function,
 * which calls po_expect_doubles for each array that it is given. Without it both are nothing. */
#ifndef PO_OPERANDS_H
#define PO_OPERANDS_H

#include <stddef.h>

#if defined(__SANITIZE_ADDRESS__)
#define PO_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PO_ADDRESS_SANITIZER 1
#endif
#endif

#ifdef PO_ADDRESS_SANITIZER
#include <stdint.h>
#include <string.h>

#define PO_WHOLE_OPERANDS __attribute__((no_sanitize("address")))

void *__asan_region_is_poisoned(void *begin, size_t size);
void __asan_get_shadow_mapping(size_t *scale, size_t *offset);

static size_t po_shadow; /* where its bytes are */
static __attribute__((constructor)) void po_find_shadow(void) {
  size_t scale;
  __asan_get_shadow_mapping(&scale, &po_shadow);
}

/* Reads the first byte of an array that may not be read; the sanitizer looks at this function. */
static __attribute__((noinline)) void po_report(size_t size, const double *values) {
  const volatile char *bad = __asan_region_is_poisoned((void *)values, size);
  if (bad)
    (void)*bad;
}

/* Reports the first byte of an array that the program may not read. The sanitizer keeps a byte for
 * each 8 of memory, which is 0 where all of them may be read. */
PO_WHOLE_OPERANDS static inline __attribute__((always_inline)) void
po_expect_doubles(size_t count, const double *values) {
  const unsigned char *shadow = (const unsigned char *)(((uintptr_t)values >> 3) + po_shadow);
  uint32_t found = (uintptr_t)values % sizeof *values;
  size_t k = 0;
  for (uint32_t word; k + sizeof word <= count; k += sizeof word) {
    memcpy(&word, shadow + k, sizeof word);
    found |= word;
  }
  for (; k < count; ++k)
    found |= shadow[k];
  if (__builtin_expect(found != 0, 0))
    po_report(count * sizeof *values, values);
}
#else
#define PO_WHOLE_OPERANDS
static inline void po_expect_doubles(size_t count, const double *values) {
  (void)count;
  (void)values;
}
#endif

#endif
