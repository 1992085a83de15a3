/* A case in a run: what is asked, and the results so far. */
#ifndef PO_CASE_RUN_H
#define PO_CASE_RUN_H

#include "po_ask.h"
#include "po_compare.h"
#include "po_plan.h"

/* How much of a case an external solver covers. */
typedef struct {
  size_t points, asked; /* points of the case, and requested ones within its manifest */
  size_t checks, made;  /* pairs of a check and a point, and those that were compared */
  size_t not_reachable; /* of these, the ones whose expected value it cannot see */
} po_coverage;

/* Number of solves in a process of a timed round, unless the first one takes long. */
enum { PO_ROUND_SOLVES = 2 };

/* Seconds of one round of a point (po_job.h). NAN: not solved, or unknown. */
typedef struct {
  double seconds, processor_seconds; /* of the solve; 0 until then */
  /* Of an external solver that is timed. `seconds` is then the second solve, as reported; without
   * one the first. */
  double first;                       /* the first solve, as reported */
  double reported;                    /* sum of all times that the process reports */
  double wall, processor;             /* of the process */
  double start_wall, start_processor; /* of the process that was asked nothing */
} po_round;

/* A point of a case in a run. */
typedef struct {
  po_result result;
  po_result trace;  /* of a point of a series that is also traced */
  po_round *rounds; /* one a repetition of the solve */
  bool asked;       /* the point is requested; initially all are */
  bool done;        /* its result is known */
  bool beyond;      /* the manifest of an external solver excludes the point */
  bool interleaved; /* this program was timed in the same rounds as an external solver */
  size_t shard;     /* number of the shard to which it belongs, from 1; 0: none */
  char checksum[PO_DIGEST_LENGTH]; /* of its line in the store; "": it has none */
} po_point_run;

typedef struct {
  po_plan *plan;
  po_file_path folder; /* of its records and its store; "": see po_case_run_place */
  po_point_run *points;
  po_round *rounds; /* of all points */
  size_t asked_count;
  size_t pending; /* number of requested points that are not solved yet */
  size_t at_work; /* number of jobs that threads do at present (po_job.h) */
  size_t resumed; /* number of points that were read from the store */
  size_t altered; /* number of stored results that were altered and are solved again */
  bool untidy;    /* the store has lines that belong to no result of the case */
  bool damaged;   /* the record or a table beside it was altered; they are written again */
  bool current;   /* the record and the tables are those of the results, and are not written */
  bool kept;      /* all results were read from the store */
  bool finished;  /* the checks were made, and the record, if any, is written */
  po_check_results check_results;
  po_check_results measured; /* the measurements: errors without a verdict */
  double elapsed;            /* seconds that the solves took */
  json_t *environment;       /* of the solves; NULL: that of this process */
  /* Of an external solver. */
  size_t chunks; /* number of shares into which the points are divided */
  po_coverage coverage;
  po_ask_process *processes; /* those that were run */
  size_t process_count;
  po_round *starts; /* one a round: the times of a process that is asked nothing; NULL: not timed */
} po_case_run;

/* A range of numbers of points. */
typedef struct {
  size_t first, last;
} po_point_range;

/* Allocates the run of a case and takes ownership of the plan. Points that the manifest of an
 * external solver excludes are marked as beyond it, and done. Status: PO_NO_MEMORY. */
po_status po_case_run_create(po_plan *plan, po_case_run *run);
void po_case_run_clear(po_case_run *run);

/* Reports whether `pulloff solve` does not repeat the result of a point, which is of an external
 * solver, or was followed along a series. */
bool po_case_run_needs_rerun(const po_case_run *run, size_t point);

/* Sets the folder of the records to OUTPUT/CASE, unless it is set. */
void po_case_run_place(po_case_run *run, const char *output);

/* Marks a point as beyond an external solver, which is not asked for it. Given: `why`, the reason.
 */
void po_case_run_exclude(po_case_run *run, size_t point, const char *why);

/* Requests only the existing points with numbers in these ranges. */
void po_case_run_ask(po_case_run *run, const po_point_range *ranges, size_t count);

/* Reports whether all points are requested. */
bool po_case_run_is_whole(const po_case_run *run);

/* Returned: the number of requested points whose results are not known. */
size_t po_case_run_lacking(const po_case_run *run);

/* Reports whether the solve of a point failed, and no check on solved_share permits the failure. */
bool po_case_run_failed(const po_case_run *run, size_t point);

/* A finding of a run: the result of a check, or a solve that failed. */
typedef struct {
  const po_check_result *item; /* NULL: a failed solve */
  size_t point;                /* of the result or the solve; an example if item->whole */
  const char *label;           /* of the point; NULL: the result belongs to all points together */
  bool passes, plain;          /* see po_compare.h; a failed solve does neither */
  size_t next;
} po_finding;

/* Finds the next finding, first the results of the checks, then the failed solves of requested
 * points (po_case_run_failed). Given: *finding is {0} before the first one, else the previous one.
 * Returned: whether there is one. */
bool po_finding_next(const po_case_run *run, po_finding *finding);

/* Returned: for the requested points, "failed" if a solve failed, else "outside" if a check does
 * not pass, else "within". */
const char *po_case_run_verdict(const po_case_run *run);

/* Returned: the number of failed solves, as po_case_run_failed; the number of checks that do not
 * pass. */
size_t po_case_run_failures(const po_case_run *run);
size_t po_case_run_outside(const po_case_run *run);

#endif
