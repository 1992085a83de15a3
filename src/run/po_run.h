/* Solves the points of cases, in parallel, and keeps a record of each case. */
#ifndef PO_RUN_H
#define PO_RUN_H

#include <signal.h>

#include "po_check_result.h"
#include "po_plan.h"

/* One case on its way through a run. */
typedef struct {
  po_plan *plan;
  po_result *results;        /* one a point */
  po_result *traces;         /* one a point: of those that are followed, and traced as well */
  double *seconds;           /* points x repeats, row after row: how long each solve took */
  double *processor_seconds; /* the same by the clock of the processor */
  bool *asked;               /* one a point: it is asked for; at first all are */
  size_t asked_count;
  bool *done;                     /* one a point: its result is there */
  size_t pending;                 /* points asked for and not solved yet */
  size_t resumed;                 /* points that an interrupted run left */
  bool kept;                      /* the results are those of an earlier run */
  bool finished;                  /* compared, and its record is written if it is to be */
  char old_key[PO_DIGEST_LENGTH]; /* of the record they were read from */
  po_check_results check_results;
  po_check_results measured; /* what the case measures: errors without a verdict */
  double elapsed;            /* seconds spent on its solves */
  char *environment;         /* where it was solved, as JSON; NULL: here */
} po_case_run;

typedef struct {
  const char *output; /* the folder of the run */
  int jobs;           /* threads; 0: all cores */
  bool fresh;         /* solve even what is there */
  bool brief; /* no line stays on a terminal for a case that is finished: an overview follows */
  const volatile sig_atomic_t *stop; /* nonzero: end soon */
} po_run_options;

/* Solves what is asked for and not there already, compares, writes the records. The solves of a
 * case that repeats them are timed: alone on the machine, and in rounds over the points, so that
 * what slows the machine for a while slows no point more than the others; a point is kept when its
 * last round is done. Of a case of which only some points are asked for, the checks are made on
 * these, and no record is written: its journal keeps them (po_journal.h) for a run of the whole.
 * Status: PO_INTERRUPTED: a case is not finished, and its solved points are kept (if all cases are
 * finished, `stop` has no effect); PO_CANNOT_WRITE; PO_CANNOT_READ (a
 * reference); PO_NO_MEMORY. A solve that fails is no failure of the run: see po_case_run_verdict.
 */
po_status po_run(po_case_run *runs, size_t count, const po_run_options *options);

/* Solves the line of points that begins with one, following minima from point to point; all of
 * them, whichever are there or asked for, as they depend on each other. Status: PO_NO_MEMORY,
 * PO_INTERRUPTED. */
po_status po_run_line(po_case_run *run, size_t first, const volatile sig_atomic_t *stop);

/* Asks only for the points from `first` to `last`, as far as there are. */
void po_case_run_ask(po_case_run *run, size_t first, size_t last);

/* Whether all points are asked for; whether those that are asked for are there. */
bool po_case_run_is_whole(const po_case_run *run);
bool po_case_run_is_done(const po_case_run *run);

/* Whether the solve of a point failed, and not as part of the share that a check lets fail. */
bool po_case_run_failed(const po_case_run *run, size_t point);

/* Of the points asked for: "within", "outside" (some check is, or could not be made), "failed"
 * (some solve did). */
const char *po_case_run_verdict(const po_case_run *run);
size_t po_case_run_failures(const po_case_run *run); /* such solves */
size_t po_case_run_outside(const po_case_run *run);  /* checks that do not pass */

/* Allocates what a run of this plan needs; takes the plan. */
po_status po_case_run_create(po_plan *plan, po_case_run *run);
void po_case_run_clear(po_case_run *run);

#endif
