/* One scene on the command line, for the verbs that solve it: solve, compare and plot. */
#ifndef PO_SOLVE_LINE_H
#define PO_SOLVE_LINE_H

#include "po_options.h"
#include "po_request.h"
#include "po_result.h"
#include "po_scene_flags.h"

/* The options beside those of keys. */
enum {
  PO_LINE_WANT = PO_FLAG_NEXT,
  PO_LINE_CURVE,
  PO_LINE_PROFILE,
  PO_LINE_STAIRCASE,
  PO_LINE_SMOOTHED,
  PO_LINE_PLOT,
  PO_LINE_RUN,
  PO_LINE_THEORY,
  PO_LINE_PRELOAD_LOAD_N,
  PO_LINE_STIFFNESS_N_PER_M,
  PO_LINE_JSON
};

/* The options of the preload and the range of the trace in SI units, and their help. */
#define PO_SOLVE_LINE_SI_OPTIONS                                                                   \
  {"preload-load-n", required_argument, NULL, PO_LINE_PRELOAD_LOAD_N}, {                           \
    "stiffness-n-per-m", required_argument, NULL, PO_LINE_STIFFNESS_N_PER_M                        \
  }
#define PO_SOLVE_LINE_SI_HELP                                                                      \
  "  --preload-load-n F      with --from-physical, in place of --preload-load: the load in N\n"    \
  "  --stiffness-n-per-m K   with --from-physical, in place of --stiffness: the stiffness in "     \
  "N/m\n"

/* Rows of the options of solve and plot beside those of keys, and the end of the table. */
#define PO_SOLVE_LINE_OPTIONS                                                                      \
  {"want", required_argument, NULL, PO_LINE_WANT},                                                 \
      PO_LENGTH_OPTIONS("profile-approach", PO_LENGTH_PROFILE_APPROACH), PO_SOLVE_LINE_SI_OPTIONS, \
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
  po_scene_flags flags;
  bool given[PO_KEY_END];                  /* which keys beside those of `flags` were given */
  const char *curve, *profile, *staircase; /* files; NULL: none */
  const char *smoothed;                    /* file of the smoothed profile; NULL: none */
  const char *plot, *run;                  /* figure, and folder of records; NULL: none */
  double preload_n, stiffness_n_per_m;     /* with --from-physical; NAN: not given */
  const char *theory;                      /* the one to be compared; NULL: all */
  bool json;
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
