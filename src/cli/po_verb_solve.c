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

/* -- Numbers with a standard uncertainty: 0.08+-0.01 -- */

/* The number of a key, as it was given last. */
typedef struct {
  int key;
  const char *text; /* of the option, without uncertainties */
  int body;         /* of two with a comma between, 0 or 1 */
  double value, deviation;
} uncertain_number;

typedef struct {
  po_solve_line line;
  const po_options *options;
  uncertain_number *uncertain; /* in the order of the line; owned, as the next two */
  size_t count, room;
  po_variation *variation;
  po_request *moved; /* the request with each uncertain number less and more */
} uncertain_line;

static const char SIGN[] = "+-";

static void clear(uncertain_line *u) {
  free(u->uncertain);
  free(u->variation);
  free(u->moved);
}

/* Whether a number may be uncertain: one of the scene, in SI units or not, or of the preload. */
static bool may_vary(int key) {
  if (key < 0 || key >= PO_KEY_ALL)
    return false;
  const po_key target = po_key_target(key);
  return po_key_is_continuous(key) || po_key_is_pair(key) || key == PO_KEY_TABLE_SCALE ||
         target == PO_KEY_PRELOAD || target == PO_KEY_PRELOAD_LOAD;
}

/* Refuses a number with its uncertainty. */
static po_status refuse_uncertain(const char *text, int option) {
  const int key = option - PO_OPTION_KEYS;
  char name[PO_FLAG_LENGTH];
  if (option < PO_OPTION_ROWS)
    po_key_flag(key, name);
  return po_options_refuse(option < PO_OPTION_ROWS ? name : OPTIONS[option - PO_OPTION_ROWS].name,
                           text,
                           may_vary(key) ? "a number, or with +- a number and its uncertainty > 0"
                                         : "a value without uncertainty");
}

/* Reads one number with its uncertainty, which ends at `end`, and cuts the latter off. Returned:
 * false if it is none. */
static bool cut_uncertainty(char *number, char *end, uncertain_number *read) {
  char *sign = strstr(number, SIGN), after = *end;
  *sign = *end = '\0';
  const bool valid = po_number_parse(number, &read->value) &&
                     po_number_parse(sign + strlen(SIGN), &read->deviation) &&
                     read->deviation > 0.0;
  *sign = *SIGN;
  *end = after;
  if (valid)
    memmove(sign, end, strlen(end) + 1);
  return valid;
}

/* Reads the uncertain numbers of an option, two if it has one for each body, and cuts their
 * uncertainties off. */
static po_status read_uncertain(uncertain_line *u, char *text, int option) {
  const int key = option - PO_OPTION_KEYS;
  char *number = text;
  if (!may_vary(key))
    return refuse_uncertain(text, option);
  for (int body = 0; number; ++body) {
    char *comma = po_key_is_pair(key) ? strchr(number, ',') : NULL;
    const char *sign = strstr(number, SIGN);
    if (sign && (!comma || sign < comma)) {
      uncertain_number *grown = po_grow(u->uncertain, u->count, &u->room, sizeof *grown);
      if (!grown)
        return PO_NO_MEMORY;
      u->uncertain = grown;
      grown[u->count] = (uncertain_number){.key = key, .text = text, .body = body};
      if (!cut_uncertainty(number, comma ? comma : number + strlen(number), &grown[u->count]))
        return refuse_uncertain(text, option);
      u->count += 1;
      comma = po_key_is_pair(key) ? strchr(number, ',') : NULL;
    }
    number = comma ? comma + 1 : NULL;
  }
  return PO_OK;
}

/* Takes one option of the command line. */
static po_status take(void *to, int option) {
  uncertain_line *u = to;
  if (optarg && strstr(optarg, SIGN)) {
    const po_status status = read_uncertain(u, optarg, option);
    if (status)
      return status;
  }
  return po_options_take(u->options, &u->line, option);
}

/* Makes the request of the line with one number moved. */
static po_status move(const po_solve_line *line, const uncertain_number *number, double by,
                      po_request *request) {
  po_solve_line moved = *line;
  char text[3 * PO_NUMBER_LENGTH], value[PO_NUMBER_LENGTH];
  const char *comma = po_key_is_pair(number->key) ? strchr(number->text, ',') : NULL;
  po_number_print(number->value + by, value);
  snprintf(text, sizeof text, "%.*s%s%s",
           comma && number->body ? (int)(comma + 1 - number->text) : 0, number->text, value,
           comma && !number->body ? comma : "");
  moved.warned = true;
  moved.scene.given.text[number->key] = text;
  moved.request = po_input_default();
  moved.request.want = line->request.want;
  const po_status status = po_solve_line_end(&moved);
  *request = moved.request;
  return status;
}

static po_status vary(uncertain_line *u, const uncertain_number *number, size_t index) {
  po_variation *v = &u->variation[index];
  po_status status = PO_OK;
  *v = (po_variation){.value = number->value, .deviation = number->deviation};
  po_key_flag(number->key, v->source);
  if (po_key_is_pair(number->key) && strchr(number->text, ','))
    strcat(v->source, number->body ? " of body 2" : " of body 1");
  for (int more = 0; more < 2 && !status; ++more) {
    po_request *moved = &u->moved[2 * index + (size_t)more];
    const double by = PO_VARIATION_REACH * number->deviation;
    status = move(&u->line, number, more ? by : -by, moved);
    if (status == PO_BAD_INPUT)
      status =
          po_fail(status, "--%s is %s+-%g, and moved by twice its uncertainty it is refused: %s",
                  v->source, number->text, number->deviation, po_message());
    v->moved[more] = moved;
    v->unit[more] = moved->in_si ? moved->units.force / u->line.request.units.force : 1.0;
  }
  return status;
}

/* Completes the request and checks it, also those with the uncertain numbers moved. */
static po_status complete(uncertain_line *u) {
  po_status status = po_solve_line_end(&u->line);
  u->variation = po_allocate(u->count, sizeof *u->variation);
  u->moved = po_allocate(2 * u->count, sizeof *u->moved);
  if (!u->variation || !u->moved)
    return PO_NO_MEMORY;
  size_t count = 0;
  for (size_t k = 0; k < u->count && !status; ++k) /* one that is given again is left out */
    if (u->uncertain[k].text == u->line.scene.given.text[u->uncertain[k].key])
      status = vary(u, &u->uncertain[k], count++);
  u->line.request.variation = u->variation;
  u->line.request.variations = count;
  return status;
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
static po_status draw(const po_solve_line *line, const po_result *result) {
  if (line->request.want & PO_WANT_CURVE)
    return po_plot_show(po_plot_of_solve(&line->request, result), line->plot);
  po_solve_line again = *line;
  again.request.want = (line->request.want & PO_PLOT_WANTS) | PO_WANT_CURVE;
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
  if (line->plot && (status = draw(line, result)))
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

static int solve(po_solve_line *line) {
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
      "solve", HELP, OPTIONS, argc, argv, 0, MORE_HELP, PO_FOR_SOLVE, po_solve_line_take_key, take};
  uncertain_line u = {.line = po_solve_line_begin(), .options = &options};
  po_status status = PO_OK;
  const bool goes_on = po_options_read(&options, &u, &status);
  if (goes_on)
    status = complete(&u);
  const int code = status || !goes_on ? po_options_end(status) : solve(&u.line);
  clear(&u);
  return code;
}
