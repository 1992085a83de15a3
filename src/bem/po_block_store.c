#include "po_block_store.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

/* Values of one allocation, and places of the first table. */
enum { CHUNK_VALUES = 1 << 14, FIRST_PLACES = 1024 };

static bool is_key(const po_block_key *a, po_block_key b) {
  return a->first == b.first && a->second == b.second;
}

/* Returned: the place of the key, or the empty place where it belongs. */
static size_t place_of(const po_block_store *s, po_block_key key) {
  static const uint64_t MIX = 0x9e3779b97f4a7c15U; /* 2^64 over the golden ratio (Knuth) */
  const uint64_t mixed = (key.first * MIX ^ key.second) * MIX;
  size_t place = (size_t)(mixed >> 20) & (s->room - 1);
  while (s->key[place].first != 0 && !is_key(&s->key[place], key))
    place = (place + 1) & (s->room - 1);
  return place;
}

static int enlarge(po_block_store *s) {
  po_block_store larger = *s;
  larger.room = s->room ? 2 * s->room : FIRST_PLACES;
  larger.key = po_allocate(larger.room, sizeof *larger.key);
  larger.block = po_allocate(larger.room, sizeof *larger.block);
  if (!larger.key || !larger.block) {
    free(larger.key);
    free(larger.block);
    return 0;
  }
  for (size_t k = 0; k < s->room; ++k)
    if (s->key[k].first != 0) {
      const size_t place = place_of(&larger, s->key[k]);
      larger.key[place] = s->key[k];
      larger.block[place] = s->block[k];
    }
  free(s->key);
  free(s->block);
  *s = larger;
  return 1;
}

static double *new_block(po_block_store *s, size_t size) {
  if (s->chunks == 0 || s->used + size > CHUNK_VALUES) {
    double **chunk = po_grow(s->chunk, s->chunks, &s->chunk_room, sizeof *chunk);
    if (!chunk)
      return NULL;
    s->chunk = chunk;
    s->chunk[s->chunks] = po_reserve(CHUNK_VALUES, sizeof(double));
    if (!s->chunk[s->chunks])
      return NULL;
    ++s->chunks;
    s->used = 0;
  }
  s->used += size;
  return s->chunk[s->chunks - 1] + s->used - size;
}

double *po_block_store_find(po_block_store *s, po_block_key key, size_t size, int *is_new) {
  *is_new = 0;
  if (2 * s->count >= s->room && !enlarge(s))
    return NULL;
  const size_t place = place_of(s, key);
  if (is_key(&s->key[place], key))
    return s->block[place];
  double *block = new_block(s, size);
  if (!block)
    return NULL;
  ++s->count;
  s->key[place] = key;
  s->block[place] = block;
  *is_new = 1;
  return block;
}

void po_block_store_clear(po_block_store *s) {
  for (size_t k = 0; k < s->chunks; ++k)
    free(s->chunk[k]);
  free(s->chunk);
  free(s->key);
  free(s->block);
  *s = (po_block_store){0};
}
