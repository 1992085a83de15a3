#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_deadline.h"
#include "po_memory.h"
#include "po_print.h"
#include "po_solve_line.h"
#include "po_tables.h"
#include "po_uncertain.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff solve [OPTION]...\n"
    "Solves one scene: traces the branch of equilibria from bodies far apart into contact and\n"
    "prints the pull-off force, the folds at which the surfaces jump, the extrema of the load,\n"
    "and their numerical errors. Lengths are in units of the equilibrium distance epsilon, loads\n"
    "in pi w R (w: work of adhesion), or in pi w epsilon for a profile without a radius. The\n"
    "approach is positive when the bodies are pressed together, the load when it is compressive.\n"
    "\n"
    "Scene:\n"
    "@scene\n"
    "\n"
    "Preload and range of the trace:\n"
    "@trace\n"
    "Without --preload, --preload-load, --approach-end and --want, the trace continues beyond the\n"
    "preload to find out whether a harder preload gives a greater pull-off force. It stops when\n"
    "this is certain, or after as much work as it took to reach the preload and some tenths of a\n"
    "second more. Work is counted, so that the result does not depend on the machine.\n"
    "\n"
    "Discretisation:\n"
    "@mesh\n";

static const char MORE_HELP[] =
    "\n"
    "Uncertain inputs:\n"
    "  A number of the scene, in SI units or not, or of the preload may be followed by +- and its\n"
    "  standard uncertainty: --work-j-per-m2 0.08+-0.01. The scene is then solved again with the\n"
    "  number less and more by twice that, and the standard uncertainty of the pull-off force is\n"
    "  printed beside its numerical error: to first order, for each such number, for the noise of\n"
    "  --smooth, and for all together if they are independent.\n"
    "\n"
    "Results:\n"
    "  --want LIST             additional results, separated by commas (default: none):\n"
    "                            curve        points of the branch\n"
    "                            profile      gap and traction against radius\n"
    "                            hysteresis   loading and unloading, with every jump\n"
    "                            preload      the pull-off force for every preload\n"
    "                            diagnostics  residuals, condition numbers, energy balance,\n"
    "                                         sensitivities, reverse trace\n"
    "                            theories     the pull-off force of every theory, as pulloff\n"
    "                                         compare\n"
    "                            loop         the states of loading and unloading\n"
    "                            history      the states of unloading of a viscoelastic body\n"
    "  --profile-approach D    approach at which the profile is taken, in epsilon (default: that\n"
    "                          of the pull-off)\n"
    "  --profile-approach-m D  the same in m, after --from-physical\n"
    "  --profile-load W        load at which the profile is taken, in pi w R: where the branch "
    "first\n"
    "                          has it, which for W >= 0 is the state that loading at given load\n"
    "                          reaches\n"
    "  --profile-load-n F      the same in N, after --from-physical\n"
    "  --curve FILE            write the points of the branch to FILE, as CSV; for this and the "
    "other\n"
    "                          files, which are in SI units after --from-physical, - is standard\n"
    "                          output, and the result is printed on standard error\n"
    "  --profile-csv FILE      write gap and traction to FILE, as CSV; --profile FILE does the\n"
    "                          same if FILE has a period or a slash\n"
    "  --staircase FILE        write the pull-off force for every preload to FILE, as CSV\n"
    "  --loop FILE             write the states of loading and unloading to FILE, as CSV: what a\n"
    "                          test records, through the spring if there is one\n"
    "  --history FILE          write load, contact radius and energies of a viscoelastic body "
    "against\n"
    "                          time to FILE, as CSV\n"
    "  --smoothed FILE         write the smoothed profile of --smooth to FILE, as CSV: r, gap and\n"
    "                          what was removed from each row, in the unit of --profile-file\n"
    "  --plot FILE             draw the branch, and the additional results that are wanted, in "
    "FILE,\n"
    "                          which ends in .svg, .png or .pdf (needs gnuplot); it changes no\n"
    "                          result\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff solve --tabor 3 --amplitude 1 --wavelength 20 --outer-radius 100 --json\n"
    "Example: pulloff solve --profile punch:5,20 --coupling 0.05 --wave 0.2,3 --outer-radius 60\n"
    "Example: pulloff solve --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7\n";

/* Beside the options of keys. */
static const po_option OPTIONS[] = {PO_SOLVE_LINE_OPTIONS, {0}};

/* Completes the request of the line with other texts. */
static po_status make_request(const po_texts *given, const void *user, po_request *request) {
  po_solve_line moved = *(const po_solve_line *)user;
  moved.warned = true;
  moved.scene.given = *given;
  moved.request = po_input_default();
  moved.request.want = ((const po_solve_line *)user)->request.want;
  const po_status status = po_solve_line_end(&moved);
  *request = moved.request;
  return status;
}

/* Completes the request and checks it, also those with the uncertain numbers moved. */
static po_status complete_line(po_solve_line *line, po_uncertain_inputs *uncertain) {
  po_status status = po_uncertain_read(&line->scene.given, uncertain);
  if (!status)
    status = po_solve_line_end(line);
  return status
             ? status
             : po_uncertain_vary(uncertain, &line->scene.given, make_request, line, &line->request);
}

/* -- The solve -- */

/* Prints the result; on standard error if standard output is for a table. */
static po_status print_result(const po_solve_line *line, const po_result *result) {
  if (line->json)
    return po_print_json(&line->request, &line->scene.given, result);
  fflush(stdout);
  const int output = line->tables ? dup(STDOUT_FILENO) : -1;
  if (output >= 0)
    dup2(STDERR_FILENO, STDOUT_FILENO);
  const po_status status = po_print_text(&line->request, &line->scene.given, result);
  fflush(stdout);
  if (output >= 0) {
    dup2(output, STDOUT_FILENO);
    close(output);
  }
  return status;
}

/* Draws the figure. A result without the points of the branch is solved once more with them: what a
 * figure needs changes the steps of a trace and ends its search beyond the preload. */
static po_status draw_result(const po_solve_line *line, const po_result *result) {
  const unsigned points =
      line->request.creep.kind == PO_CREEP_NONE ? PO_WANT_CURVE : PO_WANT_HISTORY;
  if (line->request.want & points)
    return po_plot_show(po_plot_of_solve(&line->request, result), line->plot);
  po_solve_line again = *line;
  again.request.want = (line->request.want & PO_PLOT_WANTS) | points;
  again.request.search = PO_SEARCH_NONE;
  po_result drawn = {0};
  po_status status = po_solve_line_solve(&again, &drawn);
  if (!status)
    status = po_plot_show(po_plot_of_solve(&again.request, &drawn), line->plot);
  po_result_clear(&drawn);
  return status;
}

/* Writes all files, even if one of them cannot be written. */
static po_status write_files(const po_solve_line *line, const po_result *result) {
  const char *const tables[] = {[PO_PROFILE_TABLE] = line->profile,
                                [PO_CURVE_TABLE] = line->curve,
                                [PO_STAIRCASE_TABLE] = line->staircase,
                                [PO_LOOP_TABLE] = line->loop,
                                [PO_HISTORY_TABLE] = line->history};
  po_status failed = PO_OK, status = PO_OK;
  fflush(stdout); /* a file may be /dev/stdout */
  for (int k = PO_PROFILE_TABLE; k <= PO_HISTORY_TABLE; ++k)
    if (tables[k] &&
        (status = po_tables_write((po_table)k, tables[k], &line->request, result, NULL)))
      failed = status;
  if (line->smoothed && (status = po_tables_write_smoothed(line->smoothed, &line->request)))
    failed = status;
  if (line->plot && (status = draw_result(line, result)))
    failed = status;
  return failed;
}

/* Processor time after which the line of the theories is left out, s. They take some hundredths. */
static const double LONGEST_THEORIES = 0.5;

/* Evaluates the theories for their line, if they are not wanted as a result. */
static void evaluate_theories(const po_request *request, po_result *result) {
  const po_deadline before = po_deadline_begin(request->stop, po_clock_thread() + LONGEST_THEORIES);
  const double begin = po_clock_wall();
  if (!result->theories)
    request->theories->theories(request, result);
  const double beside = po_clock_wall() - begin;
  result->seconds_beside += beside;
  result->work.seconds += beside;
  po_deadline_end(before);
  po_message_clear();
}

static int solve_line(po_solve_line *line) {
  po_result result = {0};
  const po_status solved = po_solve_line_solve(line, &result);
  if (!solved && !line->json)
    evaluate_theories(&line->request, &result);
  po_status status = print_result(line, &result);
  if (!status && !solved)
    status = write_files(
        line,
        &result); /* after the result, which must be printed even if a file cannot be written */
  if (!status && solved)
    status = po_fail(solved, "the solve failed: %s", result.reason);
  po_result_clear(&result);
  return po_options_end(status);
}

int po_verb_solve(int argc, char **argv) {
  const po_options options = {
      "solve", HELP, OPTIONS, argc, argv, 0, MORE_HELP, PO_FOR_SOLVE, po_solve_line_take_key};
  po_solve_line line = po_solve_line_begin();
  po_uncertain_inputs uncertain = {0};
  po_status status = PO_OK;
  const bool goes_on = po_options_read(&options, &line, &status);
  if (goes_on)
    status = complete_line(&line, &uncertain);
  const int code = status || !goes_on ? po_options_end(status) : solve_line(&line);
  po_uncertain_clear(&uncertain);
  return code;
}
