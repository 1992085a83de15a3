/* What the verbs that run cases share: options, choosing cases, running them. */
#ifndef PO_SESSION_H
#define PO_SESSION_H

#include <stdbool.h>

#include "po_catalog.h"
#include "po_options.h"
#include "po_run.h"
#include "po_shard.h"

typedef struct {
  const char *suites;              /* their names, separated by commas; NULL: see po_catalog.h */
  double time_limit;               /* instead of that of the cases; NAN: theirs */
  size_t first, last;              /* the points asked for, of each case */
  po_shard shard;                  /* or those of this shard */
  const po_arithmetic *arithmetic; /* what computed the points; NULL: this process does */
  po_run_options options;
  po_catalog catalog;
  po_case_run *runs; /* one a case of the catalog */
} po_session;

/* The options every such verb takes, for its table, and their values. */
enum {
  PO_SESSION_SUITE = 1,
  PO_SESSION_OUTPUT,
  PO_SESSION_JOBS,
  PO_SESSION_POINTS,
  PO_SESSION_TIME_LIMIT,
  PO_SESSION_FRESH,
  PO_SESSION_SHARD, /* of run alone */
  PO_SESSION_NEXT
};
// clang-format off
#define PO_SESSION_OPTIONS                                                                         \
  {"suite", required_argument, NULL, PO_SESSION_SUITE},                                            \
  {"output", required_argument, NULL, PO_SESSION_OUTPUT},                                          \
  {"jobs", required_argument, NULL, PO_SESSION_JOBS},                                              \
  {"points", required_argument, NULL, PO_SESSION_POINTS},                                          \
  {"time-limit", required_argument, NULL, PO_SESSION_TIME_LIMIT},                                  \
  {"fresh", no_argument, NULL, PO_SESSION_FRESH},                                                  \
  {"help", no_argument, NULL, PO_OPTION_HELP}

/* Those of a verb that looks at one case. */
#define PO_SESSION_CASE_OPTIONS                                                                    \
  {"output", required_argument, NULL, PO_SESSION_OUTPUT},                                          \
  {"jobs", required_argument, NULL, PO_SESSION_JOBS},                                              \
  {"time-limit", required_argument, NULL, PO_SESSION_TIME_LIMIT},                                  \
  {"fresh", no_argument, NULL, PO_SESSION_FRESH},                                                  \
  {"help", no_argument, NULL, PO_OPTION_HELP}
// clang-format on

/* A session with the defaults. */
po_session po_session_default(void);

/* The folder of the records; NULL: it is the default. */
const char *po_session_output(const po_session *session);

/* Takes one option of the table above into a po_session: a po_option_taker. Nothing is to be
 * cleared before the session is opened. Status: PO_BAD_INPUT. */
po_status po_session_option(void *session, int option);

/* Reads, checks and plans the cases named by the operands (or the suites), all before anything is
 * run; then runs them. Status: as po_run. */
po_status po_session_run(po_session *session, char *const *names, size_t count);

/* The same in two steps. For the verbs that look at one case the first reads and plans the case
 * that is the one operand left. */
po_status po_session_open(po_session *session, char *const *names, size_t count);
po_status po_session_open_one(po_session *session, const po_options *options);
po_status po_session_solve(po_session *session);

/* Solves that failed, and checks that do not pass, of all cases. */
size_t po_session_failures(const po_session *session);
size_t po_session_outside(const po_session *session);

/* Prints on standard output the summary of each case whose scenes are drawn at random.
 * Status: PO_NO_MEMORY. */
po_status po_session_summarise(const po_session *session);

/* Ends a verb that runs cases and judges nothing: the summaries, how many solves failed. Clears.
 * Returned: the exit code. */
int po_session_end(po_session *session, po_status status);

void po_session_clear(po_session *session);

#endif
