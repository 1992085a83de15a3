#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_json.h"
#include "po_plot_scene.h"
#include "po_print.h"
#include "po_quote.h"
#include "po_si.h"
#include "po_solve_line.h"
#include "po_suggest.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff compare [OPTION]...\n"
    "Solves one scene, as pulloff solve does, and prints its pull-off force beside that of every\n"
    "theory: the force, its deviation from the computed one with the bound that the numerical "
    "error\n"
    "gives it, whether the assumptions of the theory hold, and the number that decides it. A "
    "theory\n"
    "may be near although its assumptions do not hold. A theory that does not exist for the scene\n"
    "is a row that says why. If the solve fails, the forces of the theories, which need no solve, "
    "are\n"
    "printed without a deviation, with what is known of their assumptions, and the exit status is "
    "3.\n"
    "\n"
    "Scene:\n"
    "@scene\n"
    "\n"
    "Preload and range of the trace:\n"
    "@trace\n"
    "\n"
    "Discretisation:\n"
    "@mesh\n"
    "\n"
    "Results:\n"
    "  --theory NAME           this theory only; it is an error if it cannot be evaluated. NAME "
    "is\n"
    "                          rigid, dmt, jkr, maugis, carpick-ogletree-salmeron,\n"
    "                          pietrement-troyon, schwarz, guduru, kesari-lew, persson-tosatti or\n"
    "                          rumpf-rabinowicz; of a viscoelastic body jkr, persson-brener,\n"
    "                          jkr-at-once or rigid-at-once\n"
    "  --plot FILE             draw the forces of the theories beside the computed one in FILE, "
    "which\n"
    "                          ends in .svg, .png or .pdf (needs gnuplot)\n"
    "  --json                  print the JSON document of pulloff solve --want theories\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff compare --tabor 3 --amplitude 1 --wavelength 20 --preload 1\n"
    "Example: pulloff compare --from-physical --modulus-pa 5e9 --work-j-per-m2 0.08 \\\n"
    "             --distance-m 3e-10 --radius-m 3e-8\n";

static const po_option OPTIONS[] = {
    PO_TEXT("theory", po_solve_line, theory, "the name of a theory"),
    PO_REFUSED_STIFFNESS,
    PO_SOLVE_LINE_OUTPUT,
    {0}};

/* The row of a theory; NULL if the body has none. */
static po_theory_row *row_of(const po_result *result, po_theory theory) {
  for (size_t k = 0; k < result->theory_count; ++k)
    if (result->theories[k].theory == theory)
      return &result->theories[k];
  return NULL;
}

/* Refuses a theory that cannot be evaluated for the scene. */
static po_status check_row(const po_result *result, const po_theory *only) {
  const po_theory_row *row = only ? row_of(result, *only) : NULL;
  if (only && !row)
    return po_fail(PO_BAD_INPUT, "theory %s cannot be evaluated: it is one of %s bodies",
                   PO_THEORIES[*only].name,
                   (int)*only < PO_THEORY_OF_RATE ? "elastic" : "viscoelastic");
  return row && isnan(row->force) ? po_fail(PO_BAD_INPUT, "theory %s cannot be evaluated: %s",
                                            PO_THEORIES[*only].name, row->reason)
                                  : PO_OK;
}

/* Leaves only the row of a theory, if one was named. Status: PO_NO_MEMORY. */
static po_status keep_theory(const po_request *request, po_result *result, const po_theory *only) {
  if (!only || !row_of(result, *only))
    return PO_OK;
  result->theories[0] = *row_of(result, *only);
  result->theory_count = 1;
  return po_request_find_parabola(request, result);
}

/* A number with its unit, or - if there is none. */
static const char *number_or_dash(const char *format, double value, char text[32]) {
  if (isnan(value))
    return "-";
  snprintf(text, 32, format, value);
  return text;
}

/* Given: whether the contact is so wide that the parabola, of which the theory holds, is no sphere.
 */
static void print_row(const po_theory_row *row, const po_si_unit *force, bool is_wide) {
  const char *const HOLDS[] = {"unknown", "no", is_wide ? "yes (1)" : "yes"};
  char deviation[32], error[32];
  printf("%-26s ", PO_THEORIES[row->theory].words);
  if (isnan(row->force)) {
    printf("not evaluated: %s\n", row->reason);
    return;
  }
  printf("%12.7g ", row->force);
  if (force)
    printf("%12.7g ", row->force * force->factor);
  printf("%11s %9s %-7s ", number_or_dash("%+.2f %%", 100.0 * row->deviation, deviation),
         number_or_dash("%.1e %%", 100.0 * row->deviation_error, error), HOLDS[row->holds]);
  char number[32];
  printf("%s %s, expected %s %g\n", PO_ASSUMPTIONS[row->decided_by],
         isnan(row->number) ? "unknown" : number_or_dash("%.4g", row->number, number),
         row->at_least ? "at least" : "at most", row->limit);
}

/* The number of theories whose assumptions hold, or do not, or are unknown. */
static size_t count_held(const po_result *result, po_holds holds) {
  size_t count = 0;
  for (size_t k = 0; k < result->theory_count; ++k)
    count += isfinite(result->theories[k].force) && result->theories[k].holds == holds;
  return count;
}

/* Prints the names of the theories whose assumptions hold, or are unknown. */
static void print_held(const po_result *result, po_holds holds, const char *what) {
  const size_t named = count_held(result, holds);
  if (!named && holds == PO_HOLDS_UNKNOWN)
    return;
  printf("%-26s ", what);
  for (size_t k = 0, next = 0; k < result->theory_count; ++k)
    if (isfinite(result->theories[k].force) && result->theories[k].holds == holds)
      printf("%s%s", next++ ? ", " : "", PO_THEORIES[result->theories[k].theory].words);
  printf("%s\n", named ? "" : "none");
}

/* Says that theories hold of the parabola alone, and the number that decides it. A theory of the
 * parabola is exact for the body that was solved; that this body is a sphere is an assumption of
 * the user. */
static void print_note(const po_request *request, const po_result *result) {
  const double R = result->parabola.sphere * (request->in_si ? request->units.length : 1.0);
  printf("%-26s they hold for the parabola r^2/(2R), which was solved, not for a sphere of this R: "
         "contact radius over R %.3g, expected at most %g; --profile exact_sphere:%.6g is the "
         "sphere\n",
         "(1)", result->parabola.wide, result->parabola.limit, R);
}

/* Prints the table of the theories and their sources, with a column in N for a scene in SI units.
 */
static void print_theories(const po_request *request, const po_result *result) {
  const po_units *units = request->in_si ? &request->units : NULL;
  const bool is_wide = result->parabola.theory_count > 0;
  double greatest = 0;
  for (size_t k = 0; k < result->theory_count; ++k)
    po_si_take(&greatest, result->theories[k].force);
  const po_si_unit unit =
      units ? po_si_readable(units, PO_DIMENSION_LOAD, greatest) : (po_si_unit){0};
  char head[32] = "";
  if (units)
    snprintf(head, sizeof head, "%*s%s ", 12 - (int)strlen(unit.name), "force/", unit.text);
  printf("%-26s %12s %s%11s %9s %-7s %s\n", "theory", "force", head, "deviation", "error", "holds",
         "decided by");
  for (size_t k = 0; k < result->theory_count; ++k)
    print_row(&result->theories[k], units ? &unit : NULL, is_wide);
  print_held(result, PO_HOLDS_YES, is_wide ? "assumptions hold (1)" : "assumptions hold");
  if (is_wide)
    print_note(request, result);
  print_held(result, PO_HOLDS_UNKNOWN,
             result->has_pull_off ? "not decided by the solve" : "only a solve decides");
  printf("%-26s %s\n", "theory", "source");
  for (size_t k = 0; k < result->theory_count; ++k)
    printf("%-26s %s\n", PO_THEORIES[result->theories[k].theory].words, result->theories[k].source);
}

static po_status print(const po_solve_line *line, const po_result *result) {
  if (line->json)
    return po_print_json(&line->request, &line->scene.given, result);
  po_print_summary(&line->request, result);
  if (line->request.in_si)
    po_print_physical_pull_off(&line->request.units, result);
  print_theories(&line->request, result);
  return po_print_digest(po_json_document(&line->request, result));
}

static int compare_line(po_solve_line *line, const po_theory *only) {
  po_result result = {0};
  line->request.want |= PO_WANT_THEORIES;
  const po_status solved = po_solve_line_solve(line, &result);
  po_status status = solved ? PO_OK : check_row(&result, only);
  if (!status)
    status = keep_theory(&line->request, &result, only);
  if (!status)
    status = print(line, &result);
  if (!status && !solved && line->plot)
    status = po_plot_show(po_plot_of_theories(&line->request, &result), line->plot);
  if (!status && solved)
    status = po_fail(solved, "the solve failed: %s", result.reason);
  po_result_clear(&result);
  return po_options_end(status);
}

/* Finds the theory with a name. Returned: false if there is none. */
static bool find_theory(const char *name, po_theory *theory) {
  for (int k = 0; k < PO_THEORY_COUNT; ++k)
    if (strcmp(name, PO_THEORIES[k].name) == 0) {
      *theory = (po_theory)k;
      return true;
    }
  return false;
}

int po_verb_compare(int argc, char **argv) {
  const po_options options = {
      "compare", HELP, OPTIONS, argc, argv, 0, NULL, PO_FOR_COMPARE, po_solve_line_take_key};
  po_solve_line line = po_solve_line_begin();
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  po_theory theory = PO_THEORY_RIGID;
  char shown[PO_QUOTE_LENGTH];
  if (line.theory && !find_theory(line.theory, &theory))
    status = po_suggest(po_fail(PO_BAD_INPUT, "no theory is named %s: expected one of %s",
                                po_quote(line.theory, shown), PO_THEORY_NAMES),
                        line.theory, PO_THEORY_NAMES);
  if (!status)
    status = po_solve_line_end(&line);
  return status ? po_options_end(status) : compare_line(&line, line.theory ? &theory : NULL);
}
