#include "po_random.h"

uint64_t po_random_mix(uint64_t x) {
  uint64_t z = x + UINT64_C(0x9e3779b97f4a7c15); /* 2^64/(golden ratio), rounded to odd */
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* The 64-bit FNV-1a hash (Fowler, Noll, Vo) with its offset basis and prime. */
static uint64_t hash_name(const char *name) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (const char *c = name; *c; ++c)
    hash = (hash ^ (unsigned char)*c) * UINT64_C(0x100000001b3);
  return hash;
}

double po_random_uniform(uint64_t seed, uint64_t index, const char *name) {
  const uint64_t word = po_random_mix(po_random_mix(po_random_mix(seed) ^ index) ^ hash_name(name));
  /* The upper 52 bits, at the midpoints of 2^52 equal cells: exact in a double, never 0 or 1. */
  return ((double)(word >> 12) + 0.5) * 0x1p-52;
}
