/* A shard of a run: the part that one of several machines solves. */
#ifndef PO_SHARD_H
#define PO_SHARD_H

#include "po_run.h"

typedef struct {
  size_t number, count; /* this one, from 1, of so many; count 0: no shard */
} po_shard;

/* The most there may be of them. */
enum { PO_MOST_SHARDS = 1000000 };

/* Asks of all runs only for the points of one shard. What depends on each other stays together: a
 * line of followed scenes, and a case that is timed. These parts are dealt out in turn over all
 * cases, in an order that looks random and is the same everywhere, so that neither the steep end of
 * a sweep nor every n-th value of it falls to one shard.
 * Status: PO_NO_MEMORY. */
po_status po_shard_deal(po_case_run *runs, size_t count, po_shard shard);

/* Writes <output>/shard-K-of-N.json: which part of what was solved by which program and where, for
 * po_merge.h. `time_limit`: instead of that of the cases; NAN: theirs.
 * Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_shard_write(const po_case_run *runs, size_t count, po_shard shard, double time_limit,
                         int jobs, const char *output);

#define PO_SHARD_SCHEMA "pulloff-shard/1"

#endif
