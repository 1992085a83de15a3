#include <stdio.h>
#include <stdlib.h>

#include "po_explain.h"
#include "po_memory.h"
#include "po_print.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff explain [OPTION]... CASE\n"
    "Solves the points of a case that have no valid record; with --point, an external solver is\n"
    "asked for the chosen points only. Then prints, for each check whose verdict is not within:\n"
    "the value obtained and the value expected, their difference relative to the tolerance, the\n"
    "place on the curve, the side that is probably wrong and why, the reason for the tolerance,\n"
    "and the command that repeats the solve. The exit code is 3 if a solve of the chosen points\n"
    "failed, and otherwise 1 if a check of them does not pass.\n"
    "\n"
    "  --point P         explain only this point; P is its number, counted from 0, or words of\n"
    "                    its label, such as \"tabor=1\" (default: all points)\n"
    "  --all             explain also the checks whose verdict is within\n"
    "  --json            print one JSON document and nothing else\n"
    "  --output DIR      folder of the records (default build/run)\n" PO_SESSION_JOBS_HELP
        PO_SESSION_SOLVE_HELP "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff explain fig03 --point tabor=1 --all\n";

typedef struct {
  po_session session;
  const char *point; /* NULL: all */
  bool all, json;
} explain_line;

static const po_option OPTIONS[] = {PO_SESSION_CASE_OPTIONS,
                                    PO_TEXT("point", explain_line, point, NULL),
                                    PO_FLAG("all", explain_line, all),
                                    PO_FLAG("json", explain_line, json),
                                    {0}};

/* The points that --point selects. Status: PO_BAD_INPUT if it selects none. */
static po_status choose_points(const po_case *kase, const char *text, bool **points) {
  *points = po_allocate(kase->point_count, sizeof **points);
  if (!*points)
    return PO_NO_MEMORY;
  size_t meant = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    (*points)[i] = !text || po_explain_means(&kase->points[i], text);
    meant += (*points)[i];
  }
  if (meant)
    return PO_OK;
  char expected[200];
  snprintf(expected, sizeof expected, "a number below %zu, or words of a label such as %s",
           kase->point_count, kase->points[0].label);
  return po_options_refuse("point", text, expected);
}

static po_status print_explanation(const po_case_run *run, const po_explain_choice *choice,
                                   bool json) {
  if (json)
    return po_print_document(po_explain_json(run, choice));
  po_text text = {0};
  po_explain_text(run, choice, &text);
  return po_text_print(&text);
}

static int code_of(const po_case_run *run, const po_explain_choice *choice) {
  int code = PO_EXIT_OK;
  for (po_finding f = {0}; po_finding_next(run, &f);)
    if (!f.passes && po_explain_concerns(run, choice, &f))
      code = f.item ? PO_EXIT_OUTSIDE : PO_EXIT_SOLVE; /* failed solves are the last ones */
  return code;
}

int po_verb_explain(int argc, char **argv) {
  const po_options options = {"explain", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  explain_line line = {.session = po_session_default()};
  po_session *session = &line.session;
  bool *points = NULL;
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  status = po_session_open_one(session, &options);
  if (!status)
    status = choose_points(session->catalog.cases[0], line.point, &points);
  if (!status && line.point && session->solvers[0]) /* an external solver may take long */
    session->options.needed = points;
  if (!status)
    status = po_session_solve(session);
  const po_explain_choice choice = {
      .all = line.all, .points = points, .output = po_session_output(session)};
  if (!status)
    status = print_explanation(&session->runs[0], &choice, line.json);
  int code = po_options_end(status);
  if (!status)
    code = code_of(&session->runs[0], &choice);
  free(points);
  po_session_clear(session);
  return code;
}
