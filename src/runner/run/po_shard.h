/* Shards: the parts of a run that several machines solve, and their merge. */
#ifndef PO_SHARD_H
#define PO_SHARD_H

#include "po_case_run.h"
#include "po_json_value.h"

typedef struct {
  size_t number, count; /* shard `number`, from 1, of `count`; count 0: the whole run */
} po_shard;

/* Requests, in all runs, only the points of one shard, and numbers the shards of all points. Points
 * that depend on each other belong to the same shard: a series in parameter continuation, and all
 * points of a case that is timed. These groups are assigned to the shards in turn, in a
 * pseudo-random order that is the same on all machines. So no shard gets the expensive end of a
 * sweep, or every n-th value of it. Status: PO_NO_MEMORY. */
po_status po_shard_deal(po_case_run *runs, size_t count, po_shard shard);

/* Writes <output>/shard-K-of-N.json, which says for the merge to which run the shard belongs: the
 * cases and their scenes, the program, the number of shards; and the environment.
 * Given: `time_limit`, which replaces those of the cases; NAN: it does not.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output);

/* A shard that was found in a folder. */
typedef struct {
  const char *folder; /* as it was given */
  po_file_path path;  /* of shard-K-of-N.json in that folder */
  json_t *root;
} po_merge_part;

typedef struct {
  po_merge_part *parts;
  size_t count, of; /* found shards, and those of the run */
  char **cases;     /* the arguments that select the cases on a command line */
  size_t case_count;
  double time_limit; /* that replaced those of the cases; NAN: none did */
} po_merge;

/* Finds the shards in some folders, in any order. A folder may contain several shards. Given: the
 * folders, which must outlive the merge.
 * Status: PO_CANNOT_READ if a folder contains no shard or the description of one is damaged;
 * PO_BAD_INPUT if a shard differs from the first in the number of shards, the program, the cases,
 * their scenes or their time limit. The message names the shard. */
po_status po_merge_open(char *const *folders, size_t count, po_merge *merge);
void po_merge_close(po_merge *merge);

/* Reads all points of the cases from the stores in the folders; po_run then stores them, compares
 * them and writes the records. A record has the environment of the shard that has the first point
 * of its case. Status: PO_BAD_INPUT if the shards were computed by another program, or a case has
 * other scenes; PO_CANNOT_READ if points are lacking, because a shard is missing, was interrupted
 * or was altered; the message names the shards. */
po_status po_merge_fill(const po_merge *merge, po_case_run *runs, size_t count);

#endif
