#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_input.h"
#include "po_linear.h"
#include "po_live.h"
#include "po_observe.h"
#include "po_options.h"
#include "po_plot.h"
#include "po_plot_case.h"
#include "po_print.h"
#include "po_scene_flags.h"
#include "po_tables.h"
#include "po_use.h"
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
    "Results:\n"
    "  --want LIST             additional results, separated by commas (default: none):\n"
    "                            curve        points of the branch\n"
    "                            profile      gap and traction against radius\n"
    "                            hysteresis   loading and unloading, with every jump\n"
    "                            preload      the pull-off force for every preload\n"
    "                            diagnostics  residuals, condition numbers, energy balance,\n"
    "                                         sensitivities, reverse trace\n"
    "  --profile-approach D    approach at which the profile is taken, in epsilon (default: that\n"
    "                          of the pull-off)\n"
    "  --curve FILE            write the points of the branch to FILE, as dimensionless CSV; for\n"
    "                          this and the other files, - is standard output, and the result is\n"
    "                          printed on standard error\n"
    "  --profile-csv FILE      write gap and traction to FILE, as dimensionless CSV; --profile "
    "FILE\n"
    "                          does the same if FILE has a period or a slash\n"
    "  --staircase FILE        write the pull-off force for every preload to FILE, as\n"
    "                          dimensionless CSV\n"
    "  --plot FILE             draw the branch, and the additional results that are wanted, in "
    "FILE,\n"
    "                          which ends in .svg, .png or .pdf (needs gnuplot)\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_FLAGS_HELP "\n"
    "Example: pulloff solve --tabor 3 --amplitude 1 --wavelength 20 --outer-radius 100 --json\n"
    "Example: pulloff solve --profile punch:5,20 --coupling 0.05 --wave 0.2,3 --outer-radius 60\n"
    "Example: pulloff solve --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7\n";

enum { WANT = PO_FLAG_NEXT, CURVE_FILE, PROFILE_FILE, STAIRCASE_FILE, PLOT_FILE, RUN, JSON };

/* Beside the options of keys. */
static const struct option OPTIONS[] = {
    {"run", required_argument, NULL, RUN}, /* only for the verb plot */
    {"want", required_argument, NULL, WANT},
    PO_LENGTH_OPTIONS("profile-approach", PO_LENGTH_PROFILE_APPROACH),
    {"curve", required_argument, NULL, CURVE_FILE},
    {"profile-csv", required_argument, NULL, PROFILE_FILE},
    {"staircase", required_argument, NULL, STAIRCASE_FILE},
    {"plot", required_argument, NULL, PLOT_FILE},
    {"json", no_argument, NULL, JSON},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

typedef struct {
  po_request request;
  po_scene_flags flags;
  bool given[PO_KEY_END];                  /* which keys beside those of `flags` were given */
  const char *curve, *profile, *staircase; /* files; NULL: none */
  const char *plot, *run;                  /* figure, and folder of records; NULL: none */
  bool json;
} solve_line;

/* Sets a key that is not one of po_scene_flags.h. */
static po_status take_key(solve_line *line, po_key key) {
  line->given[key] = true;
  if (po_key_set(&line->request, key, optarg))
    return PO_OK;
  char flag[PO_FLAG_LENGTH_OF_NAME];
  po_key_flag((int)key, flag);
  return po_options_refuse(flag, optarg, po_key_expected(key));
}

/* --profile gives the profile of the scene; as in earlier versions, it also gives the file for gap
 * and traction if its value is a path with a period or a slash. */
static bool names_file(const char *text) {
  return !*text || strcspn(text, "./") < strcspn(text, ":");
}

static po_status take_option(void *to, int option) {
  solve_line *line = to;
  const bool old = option == PO_FLAG_PROFILE && names_file(optarg);
  if (old)
    option = PROFILE_FILE;
  if (option < PO_FLAG_NEXT)
    return po_scene_flags_take(&line->flags, option);
  switch (option) {
  case WANT:
    return po_want_read(optarg, &line->request.want)
               ? PO_OK
               : po_options_refuse("want", optarg, PO_WANT_EXPECTED);
  case CURVE_FILE:
    line->request.want |= PO_WANT_CURVE;
    return po_options_take_text("curve", "the name of a file", &line->curve);
  case PROFILE_FILE:
    line->request.want |= PO_WANT_PROFILE;
    return po_options_take_text(old ? "profile" : "profile-csv", "the name of a file",
                                &line->profile);
  case STAIRCASE_FILE:
    line->request.want |= PO_WANT_PRELOAD;
    return po_options_take_text("staircase", "the name of a file", &line->staircase);
  case PLOT_FILE:
    line->request.want |= PO_WANT_CURVE;
    return po_plot_take_file(optarg, &line->plot);
  case RUN:
    return po_options_take_text("run", "the name of a folder", &line->run);
  case JSON:
    line->json = true;
    return PO_OK;
  default:
    return take_key(line, (po_key)(option - PO_OPTION_KEYS));
  }
}

/* Refuses options that have no effect with the chosen scheme. */
static po_status refuse_keys_of_other_scheme(const solve_line *line) {
  static const po_key KEYS[] = {PO_KEY_TOLERANCE, PO_KEY_NODES, PO_KEY_GRADING};
  for (size_t i = 0; i < sizeof KEYS / sizeof *KEYS; ++i)
    if (line->given[KEYS[i]] && po_key_is_of_other_scheme(&line->request, KEYS[i]))
      return po_fail(PO_BAD_INPUT, "--%s is given for scheme %s: expected it with --scheme %s",
                     po_key_name(KEYS[i]), po_scheme_name(line->request.mesh.scheme),
                     KEYS[i] == PO_KEY_TOLERANCE ? "panel" : "ring or triangle");
  return PO_OK;
}

/* Refuses a wavelength without an amplitude, which has no effect. A wavelength with amplitude 0 is
 * accepted: it is the smooth end of a sweep. */
static po_status refuse_idle(const solve_line *line) {
  const double *length = line->flags.length;
  po_use flags[] = {{.given = !isnan(length[PO_LENGTH_WAVELENGTH]),
                     .taken = !isnan(length[PO_LENGTH_AMPLITUDE])}};
  po_scene_flags_name(&line->flags, PO_LENGTH_WAVELENGTH, flags[0].name);
  return po_use_check("--", "a scene without amplitude", flags, 1);
}

static bool is_output(const char *file) {
  return file && strcmp(file, "-") == 0;
}

/* The number of tables that are written to standard output. */
static int tables_on_output(const solve_line *line) {
  return is_output(line->curve) + is_output(line->profile) + is_output(line->staircase);
}

/* Completes the request and checks it. */
static po_status end_line(solve_line *line) {
  po_request *request = &line->request;
  const double *length = line->flags.length;
  po_status status = refuse_keys_of_other_scheme(line);
  if (!status)
    status = po_scene_flags_end(&line->flags, true, &request->scene);
  if (!status)
    status = refuse_idle(line);
  if (!status)
    status = po_scene_flags_check_law(&request->scene.law, line->given);
  if (status)
    return status;
  if (length[PO_LENGTH_AMPLITUDE] > 0 && isnan(length[PO_LENGTH_WAVELENGTH])) {
    char amplitude[32], wavelength[32];
    po_scene_flags_name(&line->flags, PO_LENGTH_AMPLITUDE, amplitude);
    po_scene_flags_name(&line->flags, PO_LENGTH_WAVELENGTH, wavelength);
    return po_fail(PO_BAD_INPUT, "--%s is given without --%s: expected both", amplitude,
                   wavelength);
  }
  if (tables_on_output(line) + line->json > 1)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  request->approach_start = length[PO_LENGTH_APPROACH_START];
  request->approach_end = length[PO_LENGTH_APPROACH_END];
  request->profile_approach = length[PO_LENGTH_PROFILE_APPROACH];
  if (line->flags.from_physical && !isnan(request->preload.load))
    return po_fail(PO_BAD_INPUT, "--preload-load is dimensionless: expected --preload-m with "
                                 "--from-physical");
  request->preload.approach = length[PO_LENGTH_PRELOAD];
  if (!isnan(request->profile_approach))
    request->want |= PO_WANT_PROFILE;
  po_request_choose_search(request);
  return po_request_check(request);
}

/* Prints the result; on standard error if standard output is for a table. */
static po_status print_result(const solve_line *line, const po_result *result) {
  if (line->json)
    return po_print_json(&line->request, &line->flags, result);
  fflush(stdout);
  const int output = tables_on_output(line) ? dup(STDOUT_FILENO) : -1;
  if (output >= 0)
    dup2(STDERR_FILENO, STDOUT_FILENO);
  const po_status status = po_print_text(&line->request, &line->flags, result);
  fflush(stdout);
  if (output >= 0) {
    dup2(output, STDOUT_FILENO);
    close(output);
  }
  return status;
}

/* Writes all files, even if one of them cannot be written. */
static po_status write_files(const solve_line *line, const po_result *result) {
  po_status status = PO_OK;
  fflush(stdout); /* a file may be /dev/stdout */
  if (line->profile)
    status = po_tables_write_profile(line->profile, &line->request, result, NULL);
  const po_status curve =
      line->curve ? po_tables_write_curve(line->curve, &line->request, result, NULL) : PO_OK;
  const po_status staircase =
      line->staircase ? po_tables_write_staircase(line->staircase, &line->request, result, NULL)
                      : PO_OK;
  const po_status plot = line->plot ? po_plot_to_file(&line->request, result, line->plot) : PO_OK;
  return curve ? curve : staircase ? staircase : plot ? plot : status;
}

typedef struct {
  po_live live;
  size_t points;
} solve_progress;

static void show_point(void *watcher, double approach, double load) {
  solve_progress *progress = watcher;
  ++progress->points;
  if (po_live_is_due(&progress->live))
    po_live_show(&progress->live, "%zu points, approach %.4g, load %.4g", progress->points,
                 approach, load);
}

/* Solves the scene; a solve of more than a second shows its progress on a terminal. */
static po_status observe(solve_line *line, po_result *result) {
  solve_progress progress = {.live = po_live_begin(false)};
  line->request.stop = po_interrupt_listen();
  line->request.watch = show_point;
  line->request.watcher = &progress;
  const po_status status = po_observe(&line->request, result);
  po_live_end(&progress.live);
  return status;
}

static int solve(solve_line *line) {
  po_result result = {0};
  const po_status solved = observe(line, &result);
  if (solved && !result.reason[0])
    snprintf(result.reason, sizeof result.reason, "%.250s", po_message());
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

static const char PLOT_HELP[] =
    "Usage: pulloff plot [OPTION]... [FILE]\n"
    "       pulloff plot [--run DIR] CASE [FILE]\n"
    "Plots one scene, which is given by the options of pulloff solve, or the pull-off forces of a\n"
    "case against the number that varies in it, or as a map if two numbers vary. FILE ends in\n"
    ".svg, .png or .pdf and is drawn with gnuplot; without FILE, the plot is printed as\n"
    "characters.\n"
    "\n"
    "  --want LIST       what is plotted, separated by commas (default: curve,hysteresis):\n"
    "                      curve        load against approach: the branch, its folds, the "
    "pull-off\n"
    "                      hysteresis   the jumps of loading and unloading\n"
    "                      profile      gap and traction against radius at pull-off\n"
    "                      preload      the pull-off force for every preload\n"
    "  --run DIR         folder of the records of CASE (default build/run); points without a\n"
    "                    result are solved\n"
    "  -h, --help        print this text\n"
    "\n"
    "The options of the scene, the preload and the discretisation are those of pulloff solve.\n"
    "\n"
    "Example: pulloff plot --tabor 3 --amplitude 1 --wavelength 20 wavy.svg\n"
    "         pulloff plot fig15\n";

/* Takes the operands of plot: a case, a figure, or both in this order. */
static po_status take_operands(solve_line *line, const po_options *options, char **name) {
  const int count = options->argc - optind;
  char **operand = options->argv + optind;
  const bool figure = count > 0 && po_plot_is_figure(operand[count - 1]);
  if (count > 2 || (count == 2 && !figure))
    return po_fail(PO_BAD_INPUT,
                   "plot takes a case and a file that ends in .svg, .png or .pdf (see "
                   "pulloff plot --help)");
  line->plot = figure ? operand[count - 1] : NULL;
  *name = count > figure ? operand[0] : NULL;
  if (line->run && !*name)
    return po_fail(PO_BAD_INPUT, "--run is given without a case: expected both");
  return line->json
             ? po_fail(PO_BAD_INPUT, "--json has no effect on plot: expected it to be left out")
             : PO_OK;
}

/* Solves the scene and plots it. */
static po_status plot(solve_line *line) {
  po_result result = {0};
  po_status status = observe(line, &result);
  if (!status)
    status = line->plot ? po_plot_to_file(&line->request, &result, line->plot)
                        : po_plot_to_terminal(&line->request, &result);
  po_result_clear(&result);
  return status;
}

int po_verb_plot(int argc, char **argv) {
  const po_options options = {"plot", PLOT_HELP, OPTIONS, argc, argv, NULL, PO_FOR_SOLVE};
  solve_line line = {.request = po_input_default(), .flags = po_scene_flags_default()};
  char *name = NULL;
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  const bool scene = optind > (line.run ? 3 : 1); /* options other than --run DIR */
  status = take_operands(&line, &options, &name);
  if (!status && name && scene)
    status =
        po_fail(PO_BAD_INPUT, "options of a scene have no effect on a case: expected them to be "
                              "left out");
  if (!status && name)
    return po_options_end(po_plot_case(name, line.run, line.plot));
  if (!(line.request.want & PO_PLOT_WANTS))
    line.request.want |= isinf(line.flags.length[PO_LENGTH_PRELOAD])
                             ? PO_WANT_CURVE
                             : PO_WANT_CURVE | PO_WANT_HYSTERESIS;
  else if (line.request.want & PO_WANT_HYSTERESIS)
    line.request.want |= PO_WANT_CURVE;
  if (!status)
    status = end_line(&line);
  return po_options_end(status ? status : plot(&line));
}

int po_verb_solve(int argc, char **argv) {
  const po_options options = {"solve", HELP, OPTIONS + 1, argc, argv, MORE_HELP, PO_FOR_SOLVE};
  solve_line line = {.request = po_input_default(), .flags = po_scene_flags_default()};
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  status = po_options_no_operands(&options);
  if (!status)
    status = end_line(&line);
  return status ? po_options_end(status) : solve(&line);
}
