#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_plot_scene.h"
#include "po_quote.h"
#include "po_session.h"
#include "po_solve_line.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff plot [OPTION]... [FILE]\n"
    "       pulloff plot --case CASE [--run DIR] [FILE]\n"
    "Plots one scene, which is given by the options of pulloff solve, or the pull-off forces of a\n"
    "case against the number that varies in it, or as a map if two numbers vary, with eight\n"
    "values or more each. FILE ends in .svg, .png or .pdf. Without FILE, the plot is\n"
    "printed as characters. gnuplot draws both. Axes are in SI units after --from-physical.\n"
    "\n"
    "  --want LIST       what is plotted, separated by commas (default: curve,hysteresis):\n"
    "                      curve        load against approach: the branch, its folds, the "
    "pull-off\n"
    "                      hysteresis   the paths of loading and unloading with their jumps; with\n"
    "                                   --stiffness also over the position of the base\n"
    "                      profile      gap and traction against radius at pull-off, or as\n"
    "                                   --profile-approach or --profile-load say\n"
    "                      preload      the pull-off force for every preload\n"
    "                      history      of a viscoelastic body, its default: load and energies "
    "while\n"
    "                                   it is unloaded\n"
    "  --plot FILE       the same as FILE\n"
    "  --case CASE       plot this case: a name (see pulloff list) or the path of a YAML file\n"
    "  --run DIR         folder of the records of CASE (default build/run); points without a\n"
    "                    result are solved\n"
    "  -h, --help        print this text\n"
    "\n"
    "The options of the scene, the preload and the discretisation are those of pulloff solve;\n"
    "beside --case they are refused. --json and the options of tables are refused.\n"
    "\n"
    "Example: pulloff plot --tabor 3 --amplitude 1 --wavelength 20 wavy.svg\n"
    "         pulloff plot --tabor 3 --amplitude 1 --wavelength 20 --stiffness 0.3 spring.pdf\n"
    "         pulloff plot --case fig15\n";

/* Beside the options of keys. */
static const po_option OPTIONS[] = {
    PO_TEXT("case", po_solve_line, of_case, "the name of a case, or the path of its file"),
    PO_TEXT("run", po_solve_line, run, "the name of a folder"),
    PO_SOLVE_LINE_OPTIONS,
    {0}};

enum { CASE = PO_OPTION_ROWS, RUN }; /* the first of them */

typedef struct {
  po_solve_line line;
  const po_options *options;
  bool is_scene; /* an option other than --case, --run and --plot is given */
} plot_line;

/* Takes one option of the command line. */
static po_status take_option(void *to, int option) {
  plot_line *p = to;
  const bool is_key = option < PO_OPTION_ROWS;
  p->is_scene = p->is_scene || is_key ||
                (option != CASE && option != RUN &&
                 strcmp(OPTIONS[option - PO_OPTION_ROWS].name, "plot") != 0);
  return po_options_take(p->options, &p->line, option);
}

/* -- The plot of a case -- */

/* The least number of values of both keys; a case with fewer values of one is a set of curves. */
enum { LEAST_VALUES = 8 };

/* The number of different values of a key in a case. */
static size_t count_values(const po_case *kase, po_key key) {
  size_t count = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const double value = po_key_number(&kase->points[i].request, key);
    bool is_new = isfinite(value);
    for (size_t k = 0; k < i && is_new; ++k)
      is_new = po_key_number(&kase->points[k].request, key) != value;
    count += is_new;
  }
  return count;
}

/* Returned: the number of values of a continuous key in the sweep of a case; 0 for others. */
static size_t varied_values(const po_case *kase, int key) {
  bool swept = false;
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    swept = swept || kase->file->sweep[i].named.has[key];
  return swept && po_key_is_continuous(key) ? count_values(kase, key) : 0;
}

/* Reports whether exactly two numbers vary in a case, each with at least 8 values, in different
 * items of its sweep. Returned: then, the keys on the x and on the y axis; that of the last item is
 * on the x axis. */
static bool is_map(const po_case *kase, po_key keys[2]) {
  size_t count = 0;
  for (unsigned i = kase->file->sweep_count; i-- > 0;) {
    size_t of_item = 0;
    for (int key = 0; key < PO_KEY_END; ++key) {
      if (!kase->file->sweep[i].named.has[key])
        continue;
      if (++of_item > 1 || count == 2 || varied_values(kase, key) < LEAST_VALUES)
        return false;
      keys[count++] = key;
    }
  }
  return count == 2;
}

/* Values that differ by their rounding, because they are computed from other keys, are the same. */
static bool is_above(double a, double b) {
  return a - b > 1e-12 * fabs(b);
}

/* The different values of a key, ascending. Returned: their number. */
static size_t values_of(const po_case *kase, po_key key, double *value) {
  size_t count = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const double here = po_key_number(&kase->points[i].request, key);
    if (isfinite(here))
      value[count++] = here;
  }
  qsort(value, count, sizeof *value, po_order_ascending);
  size_t different = 0;
  for (size_t i = 0; i < count; ++i)
    if (different == 0 || is_above(value[i], value[different - 1]))
      value[different++] = value[i];
  return different;
}

/* The index of a value in a list of values. */
static size_t index_of(const double *value, size_t count, double wanted) {
  size_t k = 0;
  while (k + 1 < count && is_above(wanted, value[k]))
    ++k;
  return k;
}

/* Fills the forces and their range. Returned: whether any point has a pull-off. */
static bool fill_map(const po_case_run *run, const po_case *kase, const po_key keys[2],
                     po_plot_map *map, double *force) {
  map->low = INFINITY;
  map->high = -INFINITY;
  for (size_t k = 0; k < map->columns * map->rows; ++k)
    force[k] = NAN;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_request *request = &kase->points[i].request;
    const double x = po_key_number(request, keys[0]), y = po_key_number(request, keys[1]);
    if (!run->points[i].result.has_pull_off || !isfinite(x) || !isfinite(y))
      continue;
    const size_t row = index_of(map->y, map->rows, y);
    const double value = run->points[i].result.pull_off.force;
    force[row * map->columns + index_of(map->x, map->columns, x)] = value;
    map->low = fmin(map->low, value);
    map->high = fmax(map->high, value);
  }
  return map->low <= map->high;
}

/* Plots the pull-off forces of such a case as a map: in a file, or as characters if it is NULL.
 * Status: as po_plot_draw; PO_BAD_INPUT if no point has a pull-off. */
static po_status plot_map(const po_case_run *run, const po_case *kase, const po_key keys[2],
                          const char *file) {
  double *x = po_allocate(kase->point_count, sizeof *x);
  double *y = po_allocate(kase->point_count, sizeof *y);
  double *force = NULL;
  po_status status = x && y ? PO_OK : PO_NO_MEMORY;
  po_plot_map map = {0};
  if (!status) {
    map = (po_plot_map){PO_KEYS[keys[0]].name,       PO_KEYS[keys[1]].name,       x,   y,
                        values_of(kase, keys[0], x), values_of(kase, keys[1], y), NULL};
    map.value = force = po_allocate(map.columns * map.rows, sizeof *force);
    status = force ? PO_OK : PO_NO_MEMORY;
  }
  if (!status && !fill_map(run, kase, keys, &map, force))
    status = po_fail(PO_BAD_INPUT, "no point of the case %s has a pull-off", kase->file->name);
  if (!status) {
    po_plot_picture picture =
        po_plot_begin(po_copy_text(kase->file->title), &kase->points[0].request);
    picture.map = &map;
    status = po_plot_show(picture, file);
  }
  free(force);
  free(x);
  free(y);
  return status;
}

/* One point of a run: the value of the key on the x axis, and the values of the other keys. */
typedef struct {
  po_plot_point at;
  char others[160];
} run_point;

/* The continuous key of the sweep with the most values; -1 if none varies. */
static int find_key(const po_case *kase) {
  int best = -1;
  size_t most = 1;
  for (int key = 0; key < PO_KEY_END; ++key) {
    const size_t count = varied_values(kase, key);
    if (count > most) {
      most = count;
      best = key;
    }
  }
  return best;
}

/* The words of a label that are not about the key on the x axis. */
static void other_words(const char *label, po_key key, char others[160]) {
  const char *name = PO_KEYS[key].name;
  const size_t length = strlen(name);
  others[0] = '\0';
  while (*label) {
    const size_t word = strcspn(label, " ");
    const bool is_key = strncmp(label, name, length) == 0 && label[length] == '=';
    const size_t used = strlen(others);
    if (!is_key)
      snprintf(others + used, 160 - used, "%s%.*s", used ? " " : "", (int)word, label);
    label += word + strspn(label + word, " ");
  }
}

static int by_curve(const void *a, const void *b) {
  const run_point *p = a, *q = b;
  const int order = strcmp(p->others, q->others);
  return order ? order : (p->at.x > q->at.x) - (p->at.x < q->at.x);
}

/* The points of a case that have a pull-off, sorted by curve and value. Returned: their number. */
static size_t collect_points(const po_case_run *run, const po_case *kase, po_key key,
                             run_point *points) {
  size_t count = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_result *o = &run->points[i].result;
    const double x = po_key_number(&kase->points[i].request, key);
    if (!o->has_pull_off || !isfinite(x))
      continue;
    points[count].at = (po_plot_point){
        x, o->pull_off.force, isfinite(o->pull_off.force_error) ? o->pull_off.force_error : 0};
    other_words(kase->points[i].label, key, points[count++].others);
  }
  qsort(points, count, sizeof *points, by_curve);
  return count;
}

static size_t end_of_curve(const run_point *points, size_t count, size_t begin) {
  size_t end = begin + 1;
  while (end < count && strcmp(points[end].others, points[begin].others) == 0)
    ++end;
  return end;
}

/* Draws the curves, or prints them if `file` is NULL. */
static po_status draw_run(const po_case *kase, po_key key, const run_point *points, size_t count,
                          const char *file) {
  po_plot_picture picture =
      po_plot_begin(po_copy_text(kase->file->title), &kase->points[0].request);
  po_plot_panel *panel = po_plot_add_panel(&picture);
  panel->x = po_plot_axis_of(&picture, PO_KEYS[key].name, "", PO_DIMENSION_NONE);
  panel->y = po_plot_axis_of(&picture, "pull-off force", "", PO_DIMENSION_LOAD);
  double least = INFINITY, most = 0.0;
  for (size_t begin = 0, end; begin < count; begin = end) {
    end = end_of_curve(points, count, begin);
    po_plot_series *s = po_plot_add_series(&picture, panel, PO_PLOT_CURVE, points[begin].others);
    for (size_t i = begin; i < end; ++i)
      po_plot_add_point(&picture, s, points[i].at);
    least = fmin(least, points[begin].at.x);
    most = fmax(most, points[end - 1].at.x);
  }
  panel->x.log = po_plot_is_log(least, most);
  return po_plot_show(picture, file);
}

static po_status plot_run(const po_case_run *run, const po_case *kase, const char *file) {
  po_key keys[2];
  if (is_map(kase, keys))
    return plot_map(run, kase, keys, file);
  const int key = find_key(kase);
  if (key < 0)
    return po_fail(PO_BAD_INPUT,
                   "no number varies in the case %s: expected a case with a sweep of one",
                   kase->file->name);
  run_point *points = po_allocate(kase->point_count, sizeof *points);
  if (!points)
    return PO_NO_MEMORY;
  const size_t count = collect_points(run, kase, key, points);
  const po_status status =
      !count ? po_fail(PO_BAD_INPUT, "no point of the case %s has a pull-off", kase->file->name)
             : draw_run(kase, key, points, count, file);
  free(points);
  return status;
}

/* Plots the pull-off forces of a case against a key of its sweep, or as a map if two keys vary.
 * Given: `run`, folder of the records; NULL: the default; `file`, NULL: as characters. Points
 * without a result are solved. */
static po_status plot_case(char *name, const char *run, const char *file) {
  po_session session = po_session_default();
  if (run)
    session.options.output = run;
  session.options.brief = true;
  po_status status = po_session_run(&session, &name, 1);
  if (!status)
    status = plot_run(&session.runs[0], session.catalog.cases[0], file);
  po_session_clear(&session);
  return status;
}

/* -- The plot of a scene -- */

/* Takes the operand of plot, a figure. */
static po_status take_figure(po_solve_line *line, const po_options *options) {
  const int count = options->argc - optind;
  char **operand = options->argv + optind;
  char shown[PO_QUOTE_LENGTH];
  if (count > 1 || (count && line->plot))
    return po_fail(PO_BAD_INPUT, "%s is one file too many: expected only one figure",
                   po_quote(operand[count - 1], shown));
  if (count && !po_plot_is_figure(operand[0]))
    return po_fail(PO_BAD_INPUT,
                   "%s is no figure: expected the name of a file that ends in .svg, .png or .pdf; "
                   "a case is given by --case",
                   po_quote(operand[0], shown));
  if (count)
    line->plot = operand[0];
  if (line->run && !line->of_case)
    return po_fail(PO_BAD_INPUT, "--run is given without --case: expected both");
  const char *idle = line->json        ? "json"
                     : line->curve     ? "curve"
                     : line->profile   ? "profile-csv"
                     : line->staircase ? "staircase"
                     : line->loop      ? "loop"
                     : line->history   ? "history"
                     : line->smoothed  ? "smoothed"
                                       : NULL;
  if (idle)
    return po_fail(PO_BAD_INPUT, "--%s has no effect on plot: expected it to be left out", idle);
  for (int k = 0; k < PO_WANT_COUNT; ++k)
    if (line->request.want & ~(unsigned)PO_PLOT_WANTS & (1u << k))
      return po_fail(PO_BAD_INPUT,
                     "%s is no panel of a plot: expected curve, hysteresis, profile, preload "
                     "or history after --want",
                     PO_WANTS[k]);
  return PO_OK;
}

/* Solves the scene and plots it. */
static po_status plot_scene(po_solve_line *line) {
  po_result result = {0};
  po_status status = po_solve_line_solve(line, &result);
  if (!status)
    status = po_plot_show(po_plot_of_solve(&line->request, &result), line->plot);
  po_result_clear(&result);
  return status;
}

/* Whether the preload is inf, for which there is no hysteresis. */
static bool seeks_all(const po_texts *given) {
  const char *preload = given->text[given->si ? PO_KEY_PRELOAD_M : PO_KEY_PRELOAD];
  return preload && strcmp(preload, "inf") == 0;
}

int po_verb_plot(int argc, char **argv) {
  const po_options options = {
      "plot",     HELP, OPTIONS, argc, argv, PO_SEVERAL, NULL, PO_FOR_SOLVE, po_solve_line_take_key,
      take_option};
  plot_line p = {.line = po_solve_line_begin(), .options = &options};
  po_solve_line *line = &p.line;
  po_status status = PO_OK;
  if (!po_options_read(&options, &p, &status))
    return po_options_end(status);
  status = take_figure(line, &options);
  if (!status && line->of_case && p.is_scene)
    status = po_fail(PO_BAD_INPUT, "options of a scene have no effect on a case: expected them to "
                                   "be left out");
  if (!status && line->of_case)
    return po_options_end(plot_case((char *)line->of_case, line->run, line->plot));
  po_solve_line_add_wants(line);
  if (!(line->request.want & PO_PLOT_WANTS))
    line->request.want |= line->scene.given.text[PO_KEY_VISCOELASTIC] ? PO_WANT_HISTORY
                          : seeks_all(&line->scene.given)             ? PO_WANT_CURVE
                                                          : PO_WANT_CURVE | PO_WANT_HYSTERESIS;
  else if (line->request.want & PO_WANT_HYSTERESIS)
    line->request.want |= PO_WANT_CURVE;
  if (!status)
    status = po_solve_line_end(line);
  return po_options_end(status ? status : plot_scene(line));
}
