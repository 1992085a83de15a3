/* The shards of a run put together again. */
#ifndef PO_MERGE_H
#define PO_MERGE_H

#include "po_json_value.h"
#include "po_shard.h"

/* One shard as found in a folder. */
typedef struct {
  char *folder;
  char *path; /* of its shard-K-of-N.json */
  json_t *root;
  po_shard shard;
} po_merge_part;

typedef struct {
  po_merge_part *parts;
  size_t count;
} po_merge;

/* Finds the shards in folders, in any order; a folder may hold several.
 * Status: PO_CANNOT_READ when a folder holds none or one is damaged; PO_BAD_INPUT when one is there
 * twice, is of another number of shards, another program or other kernels of OpenBLAS, other cases
 * or another time limit than the first, or is missing: each named. */
po_status po_merge_open(char *const *folders, size_t count, po_merge *merge);
void po_merge_close(po_merge *merge);

/* The cases, as a command line calls them: *names of *count, to be given to po_names_free; and the
 * time limit the shards were solved with instead of that of the cases (NAN: theirs). */
po_status po_merge_cases(const po_merge *merge, char ***names, size_t *count);
double po_merge_time_limit(const po_merge *merge);

/* What all shards were computed with, to make the plans by. */
po_arithmetic po_merge_arithmetic(const po_merge *merge);

/* Takes over all points of the shards into the runs of these cases; po_run then compares and writes
 * the records. A record has the environment of the shard that solved the first point of its case.
 * The kernels of OpenBLAS in this process need not be those of the shards.
 * Status: PO_BAD_INPUT when the shards are of another program than this, or a case of other scenes;
 * PO_CANNOT_READ when a shard lacks a point, as one that was interrupted does: each named. */
po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count);

#endif
