#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_live.h"
#include "po_memory.h"
#include "po_options.h"
#include "po_plot_scene.h"
#include "po_print_series.h"
#include "po_range.h"
#include "po_series.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff follow --key KEY --from A --to B [OPTION]...\n"
    "Computes the pull-off for a series of scenes in which one parameter varies. Some scenes, the\n"
    "checkpoints, are traced in full. Between two checkpoints the minima of the load are\n"
    "continued in the parameter. If the result does not agree with both checkpoints, the scene\n"
    "halfway between them is traced, too. The discretisation is always panel. Lengths are in\n"
    "units of the equilibrium distance epsilon, loads in pi w R (w: work of adhesion), or in\n"
    "pi w epsilon for a profile without a radius. The approach is positive when the bodies are\n"
    "pressed together, the load when it is compressive. The minimum of the load that is followed "
    "is\n"
    "the same through every spring: --stiffness and --stiffness-n-per-m are refused. Every scene "
    "of\n"
    "a viscoelastic body is loaded and unloaded.\n"
    "\n"
    "Series:\n"
    "  --key KEY               parameter that varies:\n"
    "@varying\n"
    "  --from A                first value of the parameter\n"
    "  --to B                  last value of the parameter\n"
    "  --points N              number of scenes, 2 to 10000 (default 60)\n"
    "  --scale NAME            scale on which the values are equidistant, log or linear (default\n"
    "                          log)\n"
    "  --of NAME               what is followed, pull-off or folds (default pull-off); with\n"
    "                          folds, the first scene is traced and each of its folds is\n"
    "                          continued for as long as it exists\n"
    "  --checkpoint-every K    at least one scene in K is a checkpoint, 1 to 10000 (default 15)\n"
    "\n"
    "Scene:\n"
    "@scene\n"
    "\n"
    "Preload and time:\n"
    "@trace\n"
    "\n"
    "Discretisation:\n"
    "@mesh\n"
    "\n"
    "Results:\n"
    "  --curve FILE            write the pull-offs to FILE, as CSV, in SI units after\n"
    "                          --from-physical; - is standard output, on which nothing else is\n"
    "                          then printed\n"
    "  --plot FILE             draw the pull-off force, or the approaches of the folds, against "
    "the\n"
    "                          parameter in FILE, which ends in .svg, .png or .pdf (needs "
    "gnuplot)\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff follow --key tabor --from 0.1 --to 5 --points 60 --amplitude 1 \\\n"
    "             --wavelength 20 --outer-radius 100\n"
    "Example: pulloff follow --key unload-speed --from 1e-4 --to 1e4 --points 25 --tabor 3 \\\n"
    "             --preload 5 --viscoelastic sls:0.1\n"
    "Example: pulloff follow --from-physical --key radius-m --from 1e-7 --to 1e-6 --points 10 \\\n"
    "             --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10\n";

enum { DEFAULT_POINTS = 60 };

typedef struct {
  po_scene_options scene;
  int varied; /* the key whose value varies; -1: not given */
  po_range range;
  size_t checkpoints;       /* 0: not given */
  const char *curve, *plot; /* files; NULL: none */
  bool folds, json;
} follow_line;

static po_status take_varied(const char *name, void *varied) {
  char flag[PO_FLAG_LENGTH];
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    po_key_flag(key, flag);
    if (!po_key_is_continuous(key) || !(PO_KEYS[key].verbs & PO_FOR_FOLLOW) ||
        strcmp(flag, optarg) != 0)
      continue;
    *(int *)varied = key;
    return PO_OK;
  }
  po_text names = {0};
  po_options_add_varying(&names);
  const po_status status = po_options_refuse(name, optarg, po_text_string(&names));
  po_text_clear(&names);
  return status;
}

static po_status take_count(const char *name, size_t least, size_t *count) {
  if (po_number_parse_count(optarg, count) && *count >= least && *count <= PO_MOST_VALUES)
    return PO_OK;
  char expected[64];
  snprintf(expected, sizeof expected, "a whole number from %zu to %zu", least,
           (size_t)PO_MOST_VALUES);
  return po_options_refuse(name, optarg, expected);
}

static po_status take_points(const char *name, void *count) {
  return take_count(name, 2, count);
}

static po_status take_checkpoints(const char *name, void *count) {
  return take_count(name, 1, count);
}

static po_status take_scale(const char *name, void *log) {
  return po_range_read_scale(optarg, log) ? PO_OK
                                          : po_options_refuse(name, optarg, "log or linear");
}

static po_status take_followed(const char *name, void *folds) {
  *(bool *)folds = strcmp(optarg, "folds") == 0;
  return *(bool *)folds || strcmp(optarg, "pull-off") == 0
             ? PO_OK
             : po_options_refuse(name, optarg, "pull-off or folds");
}

/* Beside the options of keys. */
static const po_option OPTIONS[] = {
    PO_TAKEN("key", follow_line, varied, take_varied),
    PO_NUMBER("from", follow_line, range.from, -INFINITY, "a finite number"),
    PO_NUMBER("to", follow_line, range.to, -INFINITY, "a finite number"),
    PO_TAKEN("points", follow_line, range.count, take_points),
    PO_TAKEN("scale", follow_line, range.log, take_scale),
    PO_TAKEN("of", follow_line, folds, take_followed),
    PO_TAKEN("checkpoint-every", follow_line, checkpoints, take_checkpoints),
    PO_TEXT("curve", follow_line, curve, "the name of a file"),
    PO_TAKEN("plot", follow_line, plot, po_plot_take_file),
    PO_REFUSED_STIFFNESS,
    PO_FLAG("json", follow_line, json),
    {0}};

static po_status check_line(const follow_line *line) {
  const po_range *range = &line->range;
  if (line->varied < 0 || isnan(range->from) || isnan(range->to))
    return po_fail(PO_BAD_INPUT, "--%s is not given: expected --key, --from and --to",
                   line->varied < 0     ? "key"
                   : isnan(range->from) ? "from"
                                        : "to");
  if (line->scene.given.text[line->varied]) {
    char flag[PO_FLAG_LENGTH];
    po_key_flag(line->varied, flag);
    return po_fail(PO_BAD_INPUT,
                   "--%s is given, but its value varies (--key): expected only one of the two",
                   flag);
  }
  if (range->from == range->to || (range->log && !(range->from > 0.0 && range->to > 0.0)))
    return po_fail(PO_BAD_INPUT, "--from is %g and --to is %g: expected two different values%s",
                   range->from, range->to, range->log ? " > 0, or --scale linear" : "");
  const po_use checkpoints = {"--checkpoint-every", line->checkpoints > 0, !line->folds};
  if (line->curve && line->folds)
    return po_fail(PO_BAD_INPUT, "--curve has no effect on --of folds: expected it to be left out");
  if (line->curve && line->json && strcmp(line->curve, "-") == 0)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  return po_use_check("--of folds", &checkpoints, 1);
}

/* Makes the request of one scene, as if its options had been given to `pulloff solve`. */
static po_status make_request(const follow_line *line, size_t point, po_request *request,
                              po_series_scene *scene, double *value) {
  scene->given = line->scene.given;
  po_range_print(&line->range, point, scene->text);
  *value = strtod(scene->text, NULL);
  scene->given.text[line->varied] = scene->text;
  *request = po_input_default();
  request->mesh.scheme = PO_PANEL;
  request->stop = po_interrupt_listen();
  po_status status = po_texts_read(&scene->given, request);
  if (!status)
    status = po_texts_check_waves(&scene->given);
  if (!status && point == 0)
    po_scene_options_warn(&scene->given);
  return status ? status : po_request_check(request);
}

typedef struct {
  po_live live;
  size_t count;
} follow_progress;

static void show_scenes(void *user, size_t seen) {
  follow_progress *progress = user;
  po_live_show(&progress->live, "%zu/%zu scenes", seen, progress->count);
}

/* Computes the series; one of more than a second shows its progress. */
static po_status compute_series(const follow_line *line, po_request *requests, po_result *results) {
  const size_t count = line->range.count;
  follow_progress progress = {.live = po_live_begin(true), .count = count};
  po_series_progress seen = {show_scenes, &progress, 0};
  void *marks = po_series_watch(requests, count, &seen);
  if (!marks)
    return PO_NO_MEMORY;
  const po_status status =
      line->folds ? po_series_folds(requests, count, results)
                  : po_series_pull_offs(requests, count,
                                        line->checkpoints ? line->checkpoints : PO_CHECKPOINT_EVERY,
                                        results);
  po_live_end(&progress.live);
  free(marks);
  return status;
}

static po_status follow_series(const follow_line *line, po_request *requests,
                               po_series_scene *scenes, double *values, po_result *results) {
  po_status status = PO_OK;
  for (size_t k = 0; k < line->range.count && !status; ++k)
    status = make_request(line, k, &requests[k], &scenes[k], &values[k]);
  if (status)
    return status;
  status = compute_series(line, requests, results);
  status = po_no_memory_or(status);
  if (status == PO_INTERRUPTED)
    return po_fail(status, "interrupted");
  char name[PO_FLAG_LENGTH];
  po_key_flag(line->varied, name);
  const po_printed_series series = {name, line->range.count, values, requests, scenes, results};
  if (!status)
    status = po_print_series(&series, line->folds, line->json, line->curve);
  if (!status && line->plot)
    status = po_plot_show(po_plot_of_series(&series, line->folds), line->plot);
  for (size_t k = 0; k < line->range.count && !status; ++k)
    if (results[k].status)
      status = po_fail(results[k].status, "the solve at %s %g failed: %s", name, values[k],
                       results[k].reason);
  return status;
}

int po_verb_follow(int argc, char **argv) {
  const po_options options = {
      "follow", HELP, OPTIONS, argc, argv, 0, NULL, PO_FOR_FOLLOW, po_scene_options_take};
  follow_line line = {
      .scene = po_scene_options_begin(), .varied = -1, .range = {NAN, NAN, DEFAULT_POINTS, true}};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  status = check_line(&line);
  if (status)
    return po_options_end(status);
  po_request *requests = po_allocate(line.range.count, sizeof *requests);
  po_result *results = po_allocate(line.range.count, sizeof *results);
  po_series_scene *scenes = po_allocate(line.range.count, sizeof *scenes);
  double *values = po_allocate(line.range.count, sizeof *values);
  status = requests && results && scenes && values
               ? follow_series(&line, requests, scenes, values, results)
               : PO_NO_MEMORY;
  for (size_t k = 0; results && k < line.range.count; ++k)
    po_result_clear(&results[k]);
  free(values);
  free(scenes);
  free(requests);
  free(results);
  return po_options_end(status);
}
