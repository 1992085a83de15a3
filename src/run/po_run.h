/* Solves the points of cases in parallel, and writes a record of each case. */
#ifndef PO_RUN_H
#define PO_RUN_H

#include <signal.h>

#include "po_ask.h"
#include "po_check_result.h"
#include "po_plan.h"

/* How much of a case an external solver covers. */
typedef struct {
  size_t points, asked; /* points of the case, and requested ones within its manifest */
  size_t checks, made;  /* pairs of a check and a point, and those that were compared */
  size_t not_reachable; /* of these, the ones whose expected value it cannot see */
} po_coverage;

/* A case in a run. */
typedef struct {
  po_plan *plan;
  const char *output; /* the folder of its records; NULL: po_run_options.output */
  po_result *results; /* one a point */
  po_result *traces;  /* one a point; filled for points of a series that are also traced */
  double *seconds;    /* wall time of each solve; `repeats` values a point, NAN: not solved */
  double *processor_seconds; /* processor time of each solve, in the same order */
  bool *asked;               /* one a point: the point is requested; initially all are */
  size_t asked_count;
  bool *done;     /* one a point: its result is known */
  size_t pending; /* number of requested points that are not solved yet */
  size_t resumed; /* number of points that were read from the journal */
  size_t altered; /* number of stored results that were altered and are solved again */
  bool damaged;   /* something else in the record was altered; it is written again */
  bool kept;      /* the results were read from an earlier record */
  bool finished;  /* the checks were made, and the record, if any, is written */
  char old_key[PO_DIGEST_LENGTH]; /* po_plan.key of that record */
  po_check_results check_results;
  po_check_results measured; /* the measurements: errors without a verdict */
  double elapsed;            /* seconds that the solves took */
  char *environment;         /* of the solves, as JSON; NULL: that of this process */
  /* Of an external solver (po_run_solver.h). */
  bool *beyond;       /* one a point: its manifest excludes the point; NULL: none */
  size_t chunks;      /* number of shares into which the points are divided */
  size_t shares_left; /* number of shares whose process has not ended */
  po_coverage coverage;
  po_ask_process *processes; /* those that were run */
  size_t process_count;
  struct po_round
      *rounds; /* times of the solves (po_rounds.h), `repeats` a point; NULL: not timed */
  struct po_round *starts; /* one a round: the times of a process that is asked nothing */
  bool *interleaved;       /* one a point: this program was timed in the same rounds */
  char *kept_folder;       /* of a process that did not end as it should; NULL: none */
} po_case_run;

typedef struct {
  const char *output; /* the output folder of the run */
  int jobs;           /* number of threads; 0: one for each core */
  bool fresh;         /* solve points again whose results are known */
  const bool *needed; /* one a point of the only case: the others are used if their results are
                         known, and not solved; NULL: all are needed */
  bool brief;         /* print no line for a finished case on a terminal; a summary follows */
  const volatile sig_atomic_t *stop; /* the run ends soon after this becomes nonzero */
} po_run_options;

/* Solves the requested points whose results are not known, makes the checks and writes the records.
 *
 * If a case repeats its solves, they are timed: one solve at a time, in rounds over all points and
 * all solvers, so that a temporary load of the machine does not slow one more than the others. A
 * point whose solves have taken a quarter of a second of processor time together is not repeated
 * again. Such a point is stored after the last round. If only some points of a case are requested,
 * the checks are made on these, and the journal keeps the points for a later run (po_journal.h). A
 * record is written only for an external solver, with another name, for the report
 * (po_record_write_part).
 *
 * Status: PO_INTERRUPTED (a case is not finished; its solved points are stored; if all cases are
 * finished, `stop` has no effect), PO_CANNOT_WRITE, PO_CANNOT_READ (a reference), PO_NO_MEMORY. A
 * failed solve does not change the status, see po_case_run_verdict. */
po_status po_run(po_case_run *runs, size_t count, const po_run_options *options);

/* Solves the series of scenes that begins with point `first` by parameter continuation. All its
 * points are solved, even if they are not requested or their results are known, because each result
 * depends on its predecessors. Status: PO_NO_MEMORY, PO_INTERRUPTED. */
po_status po_run_series(po_case_run *run, size_t first, const volatile sig_atomic_t *stop);

/* A range of numbers of points. */
typedef struct {
  size_t first, last;
} po_point_range;

/* Requests only the existing points with numbers in these ranges. */
void po_case_run_ask(po_case_run *run, const po_point_range *ranges, size_t count);

/* Reports whether all points are requested; whether the results of all requested points are known.
 */
bool po_case_run_is_whole(const po_case_run *run);
bool po_case_run_is_done(const po_case_run *run);

/* Returned: the number of requested points whose results are not known. */
size_t po_case_run_lacking(const po_case_run *run);

/* Reports whether the solve of a point failed, and no check on solved_share permits the failure. */
bool po_case_run_failed(const po_case_run *run, size_t point);

/* Returned: for the requested points, "failed" if a solve failed, else "outside" if a check does
 * not pass, else "within". */
const char *po_case_run_verdict(const po_case_run *run);

/* Returned: the number of failed solves, as po_case_run_failed; the number of checks that do not
 * pass. */
size_t po_case_run_failures(const po_case_run *run);
size_t po_case_run_outside(const po_case_run *run);

/* Allocates the run of a case and takes ownership of the plan. Status: PO_NO_MEMORY. */
po_status po_case_run_create(po_plan *plan, po_case_run *run);
void po_case_run_clear(po_case_run *run);

#endif
