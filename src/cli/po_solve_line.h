/* One scene on the command line, for the verbs that solve it: solve, compare and plot. */
#ifndef PO_SOLVE_LINE_H
#define PO_SOLVE_LINE_H

#include "po_options.h"
#include "po_plot_scene.h"
#include "po_request.h"
#include "po_result.h"

typedef struct {
  po_scene_options scene;
  po_request request;
  const char *curve, *profile, *staircase, *loop, *history; /* files; NULL: none */
  const char *smoothed;             /* file of the smoothed profile; NULL: none */
  const char *plot, *of_case, *run; /* figure; case and folder of records of plot; NULL: none */
  const char *theory;               /* the one to be compared; NULL: all */
  int tables;                       /* that are written to standard output: see po_solve_line_end */
  bool json, warned; /* the latter: whether _end need not warn of lengths that look like metres */
} po_solve_line;

// clang-format off
/* Rows of the options of solve and plot, and those that compare has, too. */
#define PO_SOLVE_LINE_OUTPUT PO_TAKEN("plot", po_solve_line, plot, po_plot_take_file), PO_FLAG("json", po_solve_line, json)
#define PO_SOLVE_LINE_OPTIONS \
  PO_TAKEN("want", po_solve_line, request.want, po_solve_line_take_want), \
  PO_TEXT("profile-approach", po_solve_line, scene.given.text[PO_KEY_PROFILE_APPROACH], "a finite number"), \
  PO_TEXT("profile-approach-m", po_solve_line, scene.given.text[PO_KEY_PROFILE_APPROACH_M], "a finite number"), \
  PO_TEXT("profile-load", po_solve_line, scene.given.text[PO_KEY_PROFILE_LOAD], "a finite number"), \
  PO_TEXT("profile-load-n", po_solve_line, scene.given.text[PO_KEY_PROFILE_LOAD_N], "a finite number"), \
  PO_TEXT("curve", po_solve_line, curve, "the name of a file"), \
  PO_TEXT("profile-csv", po_solve_line, profile, "the name of a file"), \
  PO_TEXT("staircase", po_solve_line, staircase, "the name of a file"), \
  PO_TEXT("loop", po_solve_line, loop, "the name of a file"), \
  PO_TEXT("history", po_solve_line, history, "the name of a file"), \
  PO_TEXT("smoothed", po_solve_line, smoothed, "the name of a file"), PO_SOLVE_LINE_OUTPUT
// clang-format on

po_solve_line po_solve_line_begin(void);

/* Take --want (po_option_taker), and an option of the scene (po_options.take_key). */
po_status po_solve_line_take_want(const char *name, void *want);
po_status po_solve_line_take_key(void *line, int option);

/* Adds the results that the files need to those that are wanted. */
void po_solve_line_add_wants(po_solve_line *line);

/* Completes the request and checks it. */
po_status po_solve_line_end(po_solve_line *line);

/* Solves the scene; a solve of more than a second shows its progress on a terminal. Returned: the
 * result, to be cleared whatever the status; its reason is that of a failure. */
po_status po_solve_line_solve(po_solve_line *line, po_result *result);

#endif
