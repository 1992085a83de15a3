/* Shards: the parts of a run that several machines solve. */
#ifndef PO_SHARD_H
#define PO_SHARD_H

#include "po_case_run.h"

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

/* Writes <output>/shard-K-of-N.json, which describes the shard for po_merge.h: its number, the
 * cases and their scenes, the program, and the environment.
 * Given: `time_limit`, which replaces those of the cases; NAN: it does not.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output);

#define PO_SHARD_SCHEMA "pulloff-shard/1"

#endif
