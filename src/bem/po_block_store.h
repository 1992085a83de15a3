/* Blocks of influence coefficients that are kept from mesh to mesh, found by a key. */
#ifndef PO_BLOCK_STORE_H
#define PO_BLOCK_STORE_H

#include <stddef.h>
#include <stdint.h>

typedef struct {
  uint64_t first, second; /* first: not 0 */
} po_block_key;

typedef struct {
  size_t count, room; /* keys stored, and places for keys: a power of 2 */
  po_block_key *key;  /* room: first is 0 for an empty place */
  double **block;     /* room */
  double **chunk;     /* memory of the blocks */
  size_t chunks, chunk_room;
  size_t used; /* values of the last chunk that belong to blocks */
} po_block_store;

/* Finds the block of a key. Given: key; size, the number of its values, the same at every call
 * with this key. Returned: the block; *is_new, whether it was added by this call, with undefined
 * values. NULL if memory runs out. A block stays where it is until the store is cleared. */
double *po_block_store_find(po_block_store *store, po_block_key key, size_t size, int *is_new);

/* Removes all blocks. */
void po_block_store_clear(po_block_store *store);

#endif
