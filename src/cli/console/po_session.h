/* What the verbs that run cases have in common: their options, the choice of cases, the run. */
#ifndef PO_SESSION_H
#define PO_SESSION_H

#include <stdbool.h>

#include "po_catalog.h"
#include "po_options.h"
#include "po_run.h"
#include "po_shard.h"
#include "po_solver.h"

enum { PO_MOST_MANIFESTS = 16, PO_MOST_SOLVERS = 128, PO_MOST_RANGES = 64 };

typedef struct {
  const char *suites; /* their names, separated by commas; NULL: see po_catalog.h */
  double time_limit;  /* of each solve, in seconds; NAN: that of its case */
  po_point_range ranges[PO_MOST_RANGES]; /* the selected points of each case */
  size_t range_count;                    /* 0: all points */
  po_shard shard;                        /* the shard to solve, if .count > 0 */
  const char *summary;                   /* of run: the file of the summary; NULL: none */
  po_run_options options;
  const char *manifests[PO_MOST_MANIFESTS]; /* of --solver: "MANIFEST", "MANIFEST@VALUE", or
                                               "pulloff" for this program */
  size_t manifest_count;
  const char *knob;                    /* of --knob; NULL: not given */
  po_solver *solvers[PO_MOST_SOLVERS]; /* NULL: this program */
  size_t solver_count;                 /* without --solver 1, this program */
  po_catalog catalog;
  po_case_run *runs; /* one a solver and case; those of a solver are neighbours */
  size_t run_count;
} po_session;

/* The options of these verbs, as rows of their tables. The session is the first member of their
 * lines. Before it is opened, a session owns nothing that has to be cleared. */
po_option_taker po_session_take_jobs, po_session_take_points, po_session_take_shard,
    po_session_take_solver;
// clang-format off
#define PO_SESSION_SUITE PO_TEXT("suite", po_session, suites, "names of suites")
#define PO_SESSION_OUTPUT PO_OUTPUT(po_session, options.output, "the name of a folder")
#define PO_SESSION_SOLVER_OPTIONS \
  {.name = "solver", .kind = PO_OPTION_IS_TAKEN, .take = po_session_take_solver}, \
  PO_TEXT("knob", po_session, knob, "a value of the knob")

/* Of a verb that takes results of this program only, of one that takes one case, and of one that
 * takes all. */
#define PO_SESSION_OWN_OPTIONS \
  PO_SESSION_OUTPUT, \
  {.name = "jobs", .kind = PO_OPTION_IS_TAKEN, .place = offsetof(po_session, options.jobs), \
   .take = po_session_take_jobs, .letter = 'j'}, \
  PO_NUMBER("time-limit", po_session, time_limit, 0.0, "a finite number > 0"), PO_FLAG("fresh", po_session, options.fresh)
#define PO_SESSION_CASE_OPTIONS PO_SESSION_SOLVER_OPTIONS, PO_SESSION_OWN_OPTIONS
#define PO_SESSION_OPTIONS \
  PO_SESSION_CASE_OPTIONS, PO_SESSION_SUITE, {.name = "points", .kind = PO_OPTION_IS_TAKEN, .take = po_session_take_points}
// clang-format on

/* A session with the defaults. */
po_session po_session_default(void);

/* The lines in the help of a verb: of --jobs; of --points; of --time-limit, --solver, --knob and
 * --fresh. */
#define PO_SESSION_JOBS_HELP                                                                       \
  "  -j, --jobs N      number of points solved in parallel; 0 means all cores (default 0); the\n"  \
  "                    results do not depend on it\n"
#define PO_SESSION_POINTS_HELP                                                                     \
  "  --points A[-B][,C[-D]]...  solve only points A to B, C to D of each case, counted from 0\n"   \
  "                    (default: all; at most 64 ranges, with A at most B and less than the\n"     \
  "                    number of points of the case); a later run of all points reuses them\n"
#define PO_SESSION_TIME_HELP                                                                       \
  "  --time-limit S    limit of the processor time of each solve, in seconds (default: the\n"      \
  "                    limit in the case file, if any)\n"
#define PO_SESSION_FRESH_HELP                                                                      \
  "  --fresh           solve all points again, even those with a valid record\n"
#define PO_SESSION_SOLVE_HELP                                                                      \
  PO_SESSION_TIME_HELP                                                                             \
  "  --solver MANIFEST ask this external solver (doc/solvers.md) instead; may be given several\n"  \
  "                    times; pulloff is this program. Its records are in DIR/solvers/NAME.\n"     \
  "                    MANIFEST@VALUE names a value of its knob\n"                                 \
  "  --knob VALUE      value of the knob of the external solver (default: the last one of its\n"   \
  "                    manifest); run and verify: all, each value as a "                           \
  "solver\n" PO_SESSION_FRESH_HELP

/* The folder of the records; NULL: it is the default. */
const char *po_session_output(const po_session *session);

/* Reads, checks and plans the cases that the operands (or the suites) name, and then runs them. No
 * case is run if one of them is wrong. Status: as po_run. */
po_status po_session_run(po_session *session, char *const *names, size_t count);

/* Refuses several solvers, or several values of a knob. Status: PO_BAD_INPUT. */
po_status po_session_check_one(const po_session *session, const po_options *options);

/* The same in two steps. po_session_open_one expects one operand, for the verbs that take one case.
 */
po_status po_session_open(po_session *session, char *const *names, size_t count);
po_status po_session_open_one(po_session *session, const po_options *options);
po_status po_session_solve(po_session *session);

/* The number of solves that failed, and of checks that do not pass, in all cases. */
size_t po_session_failures(const po_session *session);

/* Prints on standard output the summary of each case whose scenes are drawn at random.
 * Status: PO_NO_MEMORY. */
po_status po_session_summarise(const po_session *session);

/* Ends a verb that runs cases and prints no verdicts: prints the summaries and the number of solves
 * that failed, and clears the session. Returned: the exit code. */
int po_session_end(po_session *session, po_status status);

void po_session_clear(po_session *session);

#endif
