/* Shards: the parts of a run that several machines solve, and their merge. */
#ifndef PO_SHARD_H
#define PO_SHARD_H

#include "po_case_run.h"
#include "po_json_value.h"

typedef struct {
  size_t number, count; /* shard `number`, from 1, of `count`; count 0: the whole run */
} po_shard;

/* Largest number of shards. */
enum { PO_MOST_SHARDS = 1000000 };

/* Requests, in all runs, only the points of one shard. Points that depend on each other belong to
 * the same shard: a series in parameter continuation, and all points of a case that is timed. These
 * groups are assigned to the shards in turn, in a pseudo-random order that is the same on all
 * machines. So no shard gets the expensive end of a sweep, or every n-th value of it.
 * Status: PO_NO_MEMORY. */
po_status po_shard_deal(po_case_run *runs, size_t count, po_shard shard);

/* Writes <output>/shard-K-of-N.json, which describes the shard for the merge: its number, the
 * cases and their scenes, the program, and the environment.
 * Given: `time_limit`, which replaces those of the cases; NAN: it does not.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output);

/* A shard that was found in a folder. */
typedef struct {
  const char *folder; /* as it was given */
  po_file_path path;  /* of shard-K-of-N.json in that folder */
  json_t *root;
  po_shard shard;
} po_merge_part;

typedef struct {
  po_merge_part *parts;
  size_t count;
  char **cases; /* the arguments that select the cases on a command line; of the first document */
  size_t case_count;
  double time_limit; /* that replaced those of the cases; NAN: none did */
} po_merge;

/* Finds the shards in some folders, in any order. A folder may contain several shards. Given: the
 * folders, which must outlive the merge.
 * Status: PO_CANNOT_READ if a folder contains no shard or a shard is damaged; PO_BAD_INPUT if a
 * shard occurs twice or is missing, or if it differs from the first in the number of shards, the
 * program, the cases or their scenes. The message names the shard. */
po_status po_merge_open(char *const *folders, size_t count, po_merge *merge);
void po_merge_close(po_merge *merge);

/* Reads all points of the shards into the runs of the cases; po_run then compares them and writes
 * the records. A record has the environment of the shard that solved the first point of its case.
 * Status: PO_BAD_INPUT if the shards were computed by another program, or a case has other scenes;
 * PO_CANNOT_READ if a shard is incomplete, e.g. because it was interrupted. The message names the
 * shard. */
po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count);

#endif
