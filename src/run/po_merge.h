/* Merges the shards of a run. */
#ifndef PO_MERGE_H
#define PO_MERGE_H

#include "po_json_value.h"
#include "po_shard.h"

/* A shard that was found in a folder. */
typedef struct {
  char *folder;
  char *path; /* of shard-K-of-N.json in that folder */
  json_t *root;
  po_shard shard;
} po_merge_part;

typedef struct {
  po_merge_part *parts;
  size_t count;
} po_merge;

/* Finds the shards in some folders, in any order. A folder may contain several shards.
 * Status: PO_CANNOT_READ if a folder contains no shard or a shard is damaged; PO_BAD_INPUT if a
 * shard occurs twice or is missing, or if it differs from the first in the number of shards, the
 * program, the cases or their scenes. The message names the shard. */
po_status po_merge_open(char *const *folders, size_t count, po_merge *merge);
void po_merge_close(po_merge *merge);

/* Returned: the arguments that select the cases on a command line: *count strings in *names, which
 * po_names_free frees. */
po_status po_merge_cases(const po_merge *merge, char ***names, size_t *count);

/* Returned: the time limit that replaced those of the cases when the shards were solved; NAN: the
 * time limits of the cases were used. */
double po_merge_time_limit(const po_merge *merge);

/* Reads all points of the shards into the runs of the cases; po_run then compares them and writes
 * the records. A record has the environment of the shard that solved the first point of its case.
 * Status: PO_BAD_INPUT if the shards were computed by another program, or a case has other scenes;
 * PO_CANNOT_READ if a shard is incomplete, e.g. because it was interrupted. The message names the
 * shard. */
po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count);

#endif
