/* Pseudorandom numbers that are the same on every machine. */
#ifndef PO_RANDOM_H
#define PO_RANDOM_H

#include <stdint.h>

/* The first output of SplitMix64 seeded with `x`: a bijection of 64 bits in which every bit of the
 * result depends on every bit of x. Source: G. L. Steele, D. Lea, C. H. Flood, Fast Splittable
 * Pseudorandom Number Generators, OOPSLA 2014, with the constants of S. Vigna's splitmix64.c. */
uint64_t po_random_mix(uint64_t x);

/* Returned: a number uniformly distributed in the open interval (0, 1), determined by seed, index
 * and name alone. The generator has no state, so any number of the sequence can be computed without
 * the ones before it. */
double po_random_uniform(uint64_t seed, uint64_t index, const char *name);

#endif
