/* One scene on the command line, for the verbs that solve it: solve, compare and plot. */
#ifndef PO_SOLVE_LINE_H
#define PO_SOLVE_LINE_H

#include "po_options.h"
#include "po_request.h"
#include "po_result.h"
#include "po_scene_options.h"

/* The options beside those of keys. */
enum {
  PO_LINE_WANT = PO_OPTION_NEXT,
  PO_LINE_CURVE,
  PO_LINE_PROFILE,
  PO_LINE_STAIRCASE,
  PO_LINE_SMOOTHED,
  PO_LINE_PLOT,
  PO_LINE_RUN,
  PO_LINE_THEORY,
  PO_LINE_JSON
};

/* Rows of the options of solve and plot beside those of keys, and the end of the table. */
#define PO_SOLVE_LINE_OPTIONS                                                                      \
  {"want", required_argument, NULL, PO_LINE_WANT},                                                 \
      {"profile-approach", required_argument, NULL, PO_OPTION_KEYS + PO_KEY_PROFILE_APPROACH},     \
      {"profile-approach-m", required_argument, NULL, PO_OPTION_KEYS + PO_KEY_PROFILE_APPROACH_M}, \
      {"curve", required_argument, NULL, PO_LINE_CURVE},                                           \
      {"profile-csv", required_argument, NULL, PO_LINE_PROFILE},                                   \
      {"staircase", required_argument, NULL, PO_LINE_STAIRCASE},                                   \
      {"smoothed", required_argument, NULL, PO_LINE_SMOOTHED},                                     \
      {"plot", required_argument, NULL, PO_LINE_PLOT}, {"json", no_argument, NULL, PO_LINE_JSON},  \
      {"help", no_argument, NULL, PO_OPTION_HELP}, {                                               \
    NULL, 0, NULL, 0                                                                               \
  }

typedef struct {
  po_request request;
  po_scene_options scene;
  const char *curve, *profile, *staircase; /* files; NULL: none */
  const char *smoothed;                    /* file of the smoothed profile; NULL: none */
  const char *plot, *run;                  /* figure, and folder of records; NULL: none */
  const char *theory;                      /* the one to be compared; NULL: all */
  bool json, warned; /* the latter: whether _end need not warn of lengths that look like metres */
} po_solve_line;

po_solve_line po_solve_line_begin(void);

/* Takes one option of the command line (po_option_taker). */
po_status po_solve_line_take(void *line, int option);

/* Completes the request and checks it. */
po_status po_solve_line_end(po_solve_line *line);

/* The number of tables that are written to standard output. */
int po_solve_line_tables(const po_solve_line *line);

/* Solves the scene; a solve of more than a second shows its progress on a terminal. Returned: the
 * result, to be cleared whatever the status; its reason is that of a failure. */
po_status po_solve_line_observe(po_solve_line *line, po_result *result);

#endif
