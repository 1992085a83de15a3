#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_interrupt.h"
#include "po_json.h"
#include "po_linear.h"
#include "po_live.h"
#include "po_memory.h"
#include "po_options.h"
#include "po_print.h"
#include "po_range.h"
#include "po_scene_flags.h"
#include "po_series.h"
#include "po_series_folds.h"
#include "po_tables.h"
#include "po_text.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff follow --key KEY --from A --to B [OPTION]...\n"
    "Computes the pull-off for a series of scenes in which one parameter varies. Some scenes, the\n"
    "checkpoints, are traced in full. Between two checkpoints the minima of the load are\n"
    "continued in the parameter. If the result does not agree with both checkpoints, the scene\n"
    "halfway between them is traced, too. The discretisation is always panel. Lengths are in\n"
    "units of the equilibrium distance epsilon, loads in pi w R (w: work of adhesion), or in\n"
    "pi w epsilon for a profile without a radius. The approach is positive when the bodies are\n"
    "pressed together, the load when it is compressive.\n"
    "\n"
    "Series:\n"
    "  --key KEY               parameter that varies: tabor, amplitude, wavelength, radius,\n"
    "                          outer-radius, amplitude-ratio, coupling, or a parameter of the law\n"
    "                          or the profile: mie-m, mie-n, morse-a, power-c, power-n, cone-t,\n"
    "                          punch-b, punch-r, truncated-b or truncated-r\n"
    "  --from A                first value of the parameter\n"
    "  --to B                  last value of the parameter\n"
    "  --points N              number of scenes, 2 to 10000 (default 60)\n"
    "  --scale NAME            scale on which the values are equidistant, log or linear (default\n"
    "                          log)\n"
    "  --of NAME               what is followed, pull-off or folds (default pull-off); with\n"
    "                          folds, the first scene is traced and each of its folds is\n"
    "                          continued for as long as it exists\n"
    "  --checkpoint-every K    at least one scene in K is a checkpoint, 1 to 10000 (default 15)\n"
    "\n";

static const char MORE_HELP[] =
    "Scene:\n"
    "  --tabor MU              Tabor parameter, >= 0 (default 1)\n"
    "  --amplitude A           amplitude of the waviness, in epsilon; 0 is a smooth sphere\n"
    "                          (default 0)\n"
    "  --amplitude-ratio Q     amplitude divided by wavelength, instead of --amplitude; constant\n"
    "                          if the wavelength varies\n"
    "  --wavelength L          wavelength of the waviness, in epsilon\n"
    "  --radius R              radius of the sphere, in epsilon (default 100); for another "
    "profile\n"
    "                          the length R in the unit of the load, pi w R (default 1)\n"
    "  --outer-radius R        radius at which the elastic surface is cut, in epsilon; inf is the\n"
    "                          unbounded half-space (default inf)\n"
    "  --law LAW               traction-separation law: lennard-jones (Eq 9), mie:M,N with\n"
    "                          N > M > 1, or morse:A (default lennard-jones)\n"
    "  --mie-m M, --mie-n N    exponents M and N, for --law mie without exponents\n"
    "  --morse-a A             parameter A, for --law morse without parameter\n"
    "  --coupling C            w/(E* epsilon), >= 0, instead of --tabor\n" PO_PROFILE_HELP
    "  --preload D             approach up to which each sphere is loaded before it is pulled\n"
    "                          off, in epsilon; inf searches all preloads for the greatest\n"
    "                          pull-off force\n"
    "  --preload-load W        load up to which each sphere is loaded, in pi w R; with --preload,\n"
    "                          loading ends at whichever is reached first (default 1, unless\n"
    "                          --preload is given)\n"
    "  --tolerance T           relative tolerance on the pull-off force, 1e-10 to 0.01 (default\n"
    "                          1e-6)\n"
    "\n"
    "  --time-limit S          processor time after which each solve is stopped, in seconds\n"
    "                          (default: no limit)\n"
    "\n"
    "  --curve FILE            write the pull-offs to FILE, as dimensionless CSV; - is standard\n"
    "                          output, on which nothing else is then printed\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n"
    "Example: pulloff follow --key tabor --from 0.1 --to 5 --points 60 --amplitude 1 \\\n"
    "             --wavelength 20 --outer-radius 100\n";

enum { VARIED = 1, FROM, TO, POINTS, SCALE, OF, CHECKPOINTS, CURVE, JSON, KEY = PO_OPTION_KEYS };
enum { DEFAULT_POINTS = 60 };

/* The values of the options of the scene are KEY + po_key. */
static const struct option OPTIONS[] = {
    {"key", required_argument, NULL, VARIED},
    {"from", required_argument, NULL, FROM},
    {"to", required_argument, NULL, TO},
    {"points", required_argument, NULL, POINTS},
    {"scale", required_argument, NULL, SCALE},
    {"of", required_argument, NULL, OF},
    {"checkpoint-every", required_argument, NULL, CHECKPOINTS},
    {"curve", required_argument, NULL, CURVE},
    {"json", no_argument, NULL, JSON},
    {"tabor", required_argument, NULL, KEY + PO_KEY_TABOR},
    {"amplitude", required_argument, NULL, KEY + PO_KEY_AMPLITUDE},
    {"amplitude-ratio", required_argument, NULL, KEY + PO_KEY_AMPLITUDE_RATIO},
    {"wavelength", required_argument, NULL, KEY + PO_KEY_WAVELENGTH},
    {"radius", required_argument, NULL, KEY + PO_KEY_RADIUS},
    {"outer-radius", required_argument, NULL, KEY + PO_KEY_OUTER_RADIUS},
    {"law", required_argument, NULL, KEY + PO_KEY_LAW},
    {"mie-m", required_argument, NULL, KEY + PO_KEY_MIE_M},
    {"mie-n", required_argument, NULL, KEY + PO_KEY_MIE_N},
    {"morse-a", required_argument, NULL, KEY + PO_KEY_MORSE_A},
    {"coupling", required_argument, NULL, KEY + PO_KEY_COUPLING},
    {"profile", required_argument, NULL, KEY + PO_KEY_PROFILE},
    {"profile-file", required_argument, NULL, KEY + PO_KEY_PROFILE_FILE},
    {"power-c", required_argument, NULL, KEY + PO_KEY_POWER_C},
    {"power-n", required_argument, NULL, KEY + PO_KEY_POWER_N},
    {"cone-t", required_argument, NULL, KEY + PO_KEY_CONE_T},
    {"punch-b", required_argument, NULL, KEY + PO_KEY_PUNCH_B},
    {"punch-r", required_argument, NULL, KEY + PO_KEY_PUNCH_R},
    {"truncated-b", required_argument, NULL, KEY + PO_KEY_TRUNCATED_B},
    {"truncated-r", required_argument, NULL, KEY + PO_KEY_TRUNCATED_R},
    {"table-scale", required_argument, NULL, KEY + PO_KEY_TABLE_SCALE},
    {"wave", required_argument, NULL, KEY + PO_KEY_WAVES},
    {"tolerance", required_argument, NULL, KEY + PO_KEY_TOLERANCE},
    {"preload", required_argument, NULL, KEY + PO_KEY_PRELOAD},
    {"preload-load", required_argument, NULL, KEY + PO_KEY_PRELOAD_LOAD},
    {"time-limit", required_argument, NULL, KEY + PO_KEY_TIME_LIMIT},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

typedef struct {
  const char *given[PO_KEY_END]; /* the text of each option of the scene; NULL: not given */
  po_wave wave[PO_MOST_WAVES];   /* of --wave, which may be repeated */
  size_t waves;
  const char *varied; /* the name of the option whose value varies */
  po_key key;
  po_range range;
  size_t checkpoints; /* 0: not given */
  const char *curve;  /* a file; NULL: none */
  bool folds, json;
} follow_line;

static const struct option *option_of(int value) {
  const struct option *option = OPTIONS;
  while (option->name && option->val != value)
    ++option;
  return option;
}

/* Whether an option sets a parameter of the scene that may vary along a series. */
static bool is_of_scene(const struct option *option) {
  return option->val >= KEY && option->val < PO_OPTION_HELP &&
         po_key_is_continuous(option->val - KEY);
}

static po_status take_varied(follow_line *line) {
  for (const struct option *option = OPTIONS; option->name; ++option)
    if (is_of_scene(option) && strcmp(option->name, optarg) == 0) {
      line->key = (po_key)(option->val - KEY);
      line->varied = option->name;
      return PO_OK;
    }
  return po_options_refuse("key", optarg,
                           "tabor, coupling, amplitude, wavelength, radius, outer-radius, "
                           "amplitude-ratio, or a parameter of the law or the profile");
}

static po_status take_count(const char *option, size_t least, size_t *count) {
  if (po_number_parse_count(optarg, count) && *count >= least && *count <= PO_MOST_VALUES)
    return PO_OK;
  char expected[64];
  snprintf(expected, sizeof expected, "a whole number from %zu to %zu", least,
           (size_t)PO_MOST_VALUES);
  return po_options_refuse(option, optarg, expected);
}

static po_status take_option(void *to, int option) {
  follow_line *line = to;
  switch (option) {
  case KEY + PO_KEY_WAVES:
    return po_scene_flags_take_wave(line->wave, &line->waves);
  case VARIED:
    return take_varied(line);
  case FROM:
  case TO:
    if (po_number_parse(optarg, option == FROM ? &line->range.from : &line->range.to))
      return PO_OK;
    return po_options_refuse(option == FROM ? "from" : "to", optarg, "a finite number");
  case POINTS:
    return take_count("points", 2, &line->range.count);
  case CHECKPOINTS:
    return take_count("checkpoint-every", 1, &line->checkpoints);
  case SCALE:
    if (po_range_read_scale(optarg, &line->range.log))
      return PO_OK;
    return po_options_refuse("scale", optarg, "log or linear");
  case OF:
    line->folds = strcmp(optarg, "folds") == 0;
    if (line->folds || strcmp(optarg, "pull-off") == 0)
      return PO_OK;
    return po_options_refuse("of", optarg, "pull-off or folds");
  case CURVE:
    return po_options_take_text("curve", "the name of a file", &line->curve);
  case JSON:
    line->json = true;
    return PO_OK;
  default:
    line->given[option - KEY] = optarg;
    return PO_OK;
  }
}

/* Whether a key is given or varies. */
static bool is_given(const follow_line *line, int key) {
  return line->given[key] || (int)line->key == key;
}

static po_status check_line(const follow_line *line) {
  const po_range *range = &line->range;
  if (!line->varied || isnan(range->from) || isnan(range->to))
    return po_fail(PO_BAD_INPUT, "--%s is not given: expected --key, --from and --to",
                   !line->varied        ? "key"
                   : isnan(range->from) ? "from"
                                        : "to");
  if (line->given[line->key])
    return po_fail(PO_BAD_INPUT,
                   "--%s is given, but its value varies (--key): expected only one of the two",
                   line->varied);
  if (range->from == range->to || (range->log && !(range->from > 0.0 && range->to > 0.0)))
    return po_fail(PO_BAD_INPUT, "--from is %g and --to is %g: expected two different values%s",
                   range->from, range->to, range->log ? " > 0, or --scale linear" : "");
  if ((line->given[PO_KEY_AMPLITUDE] || line->key == PO_KEY_AMPLITUDE) &&
      (line->given[PO_KEY_AMPLITUDE_RATIO] || line->key == PO_KEY_AMPLITUDE_RATIO))
    return po_fail(PO_BAD_INPUT,
                   "both amplitude and amplitude-ratio are given: expected only one of the two");
  if (is_given(line, PO_KEY_COUPLING) && is_given(line, PO_KEY_TABOR))
    return po_fail(PO_BAD_INPUT, "both coupling and tabor are given: expected only one of the two");
  if (line->given[PO_KEY_PROFILE] && line->given[PO_KEY_PROFILE_FILE])
    return po_fail(PO_BAD_INPUT, "both --profile and --profile-file are given: expected only one");
  const bool wavy = line->given[PO_KEY_AMPLITUDE] || line->key == PO_KEY_AMPLITUDE ||
                    line->given[PO_KEY_AMPLITUDE_RATIO] || line->key == PO_KEY_AMPLITUDE_RATIO;
  if (wavy && !line->given[PO_KEY_WAVELENGTH] && line->key != PO_KEY_WAVELENGTH)
    return po_fail(PO_BAD_INPUT, "a waviness is given without --wavelength: expected both");
  if (!wavy && line->key == PO_KEY_WAVELENGTH)
    return po_fail(PO_BAD_INPUT,
                   "the wavelength varies, but the scenes have no amplitude: expected "
                   "--amplitude or --amplitude-ratio");
  const po_flag_use wavelength = {"wavelength", line->given[PO_KEY_WAVELENGTH], wavy};
  const po_flag_use checkpoints = {"checkpoint-every", line->checkpoints > 0, !line->folds};
  if (line->curve && line->folds)
    return po_fail(PO_BAD_INPUT, "--curve has no effect on --of folds: expected it to be left out");
  if (line->curve && line->json && strcmp(line->curve, "-") == 0)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  const po_status status = po_options_refuse_idle("scenes without amplitude", &wavelength, 1);
  return status ? status : po_options_refuse_idle("--of folds", &checkpoints, 1);
}

static po_status set_key(po_request *request, int key, const char *text) {
  if (key == PO_KEY_PROFILE_FILE) {
    const po_status status = po_profile_set_file(&request->scene.profile, text);
    if (status)
      return status;
  }
  if (po_key_set(request, (po_key)key, text))
    return PO_OK;
  return po_options_refuse(option_of(KEY + key)->name, text, po_key_expected((po_key)key));
}

/* The request of one point of the series. Groups such as the amplitude ratio are set after the keys
 * on which they depend. */
static po_status make_request(const follow_line *line, size_t point, po_request *request) {
  char value[PO_NUMBER_LENGTH];
  po_range_print(&line->range, point, value);
  *request = po_input_default();
  request->mesh.scheme = PO_PANEL;
  po_status status = PO_OK;
  for (int key = 0; key < PO_KEY_END && !status; ++key) {
    const char *text = key == (int)line->key ? value : line->given[key];
    if (text)
      status = set_key(request, key, text);
  }
  bool of_law[PO_LAW_PARAMETER_COUNT], of_profile[PO_PROFILE_PARAMETER_COUNT];
  for (int k = 0; k < PO_LAW_PARAMETER_COUNT; ++k)
    of_law[k] = is_given(line, PO_KEY_MIE_M + k);
  for (int k = 0; k < PO_PROFILE_PARAMETER_COUNT; ++k)
    of_profile[k] = is_given(line, PO_KEY_POWER_C + k);
  if (!status)
    status = po_scene_flags_check_law(&request->scene.law, of_law);
  if (!status)
    status = po_scene_flags_check_profile(&request->scene.profile, of_profile);
  if (!status)
    status = po_scene_flags_add_waves(line->wave, line->waves, 1.0, &request->scene);
  request->stop = po_interrupt_listen();
  return status ? status : po_request_check(request);
}

static po_status print_json(const po_request *requests, const po_result *results, size_t count) {
  json_t *points = po_json_empty_array();
  for (size_t k = 0; k < count; ++k)
    po_json_append(&points, po_json_result(&requests[k], &results[k]));
  return po_print_document(
      PO_JSON_OBJECT({"schema", po_json_text("pulloff-line/1")}, {"points", points}));
}

static void print_text(const follow_line *line, const po_request *requests,
                       const po_result *results) {
  printf("%15s %14s %8s %16s %8s %14s %-9s %14s\n", line->varied, "force", "error", "approach",
         "error", "contact radius", "obtained", "factorisations");
  uint64_t all = 0;
  size_t followed = 0;
  for (size_t k = 0; k < line->range.count; ++k) {
    const po_result *o = &results[k];
    const unsigned long long factorizations = o->work.factorizations;
    printf("%15g ", po_key_number(&requests[k], line->key));
    if (o->has_pull_off)
      printf("%14.9f %8.1e %16.9f %8.1e %14.6g ", o->pull_off.force, o->pull_off.force_error,
             o->pull_off.approach, o->pull_off.approach_error, o->pull_off.contact_radius);
    printf("%-9s %14llu\n",
           o->status     ? po_status_name(o->status)
           : o->followed ? "followed"
                         : "traced",
           factorizations);
    all += factorizations;
    followed += o->followed;
  }
  printf("work     %llu factorisations for %zu scenes, %zu of them followed\n",
         (unsigned long long)all, line->range.count, followed);
}

/* Prints a block of rows for each fold of the first scene. */
static void print_folds(const follow_line *line, const po_request *requests,
                        const po_result *results) {
  printf("%-9s %15s %16s %8s %14s %8s %14s\n", "fold", line->varied, "approach", "error", "load",
         "error", "contact radius");
  uint64_t all = 0;
  for (size_t k = 0; k < line->range.count; ++k)
    all += results[k].work.factorizations;
  for (size_t j = 0; j < results[0].fold_count; ++j) {
    bool there = true;
    for (size_t k = 0; k < line->range.count && there; ++k) {
      const po_special_point *fold = &results[k].folds[j];
      there = !isnan(fold->approach);
      printf("%-9s %15g ", po_special_kind_name(fold->kind),
             po_key_number(&requests[k], line->key));
      if (there)
        printf("%16.10f %8.1e %14.10f %8.1e %14.6g\n", fold->approach, fold->approach_error,
               fold->load, fold->load_error, fold->contact_radius);
      else
        printf("%16s\n", "ended");
    }
  }
  printf("work     %llu factorisations for %zu folds of %zu scenes\n", (unsigned long long)all,
         results[0].fold_count, line->range.count);
}

/* The scenes of which a trace or a followed minimum has been seen. */
typedef struct {
  po_live live;
  size_t seen, count;
} follow_progress;

typedef struct {
  follow_progress *progress;
  bool is_seen;
} follow_mark;

static void show_scene(void *watcher, double approach, double load) {
  (void)approach, (void)load;
  follow_mark *mark = watcher;
  mark->progress->seen += !mark->is_seen;
  mark->is_seen = true;
  if (po_live_is_due(&mark->progress->live))
    po_live_show(&mark->progress->live, "%zu/%zu scenes", mark->progress->seen,
                 mark->progress->count);
}

/* Computes the series; one of more than a second shows its progress. */
static po_status compute(const follow_line *line, po_request *requests, po_result *results) {
  const size_t count = line->range.count;
  follow_progress progress = {.live = po_live_begin(true), .count = count};
  follow_mark *marks = po_allocate(count, sizeof *marks);
  if (!marks)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < count; ++k) {
    marks[k].progress = &progress;
    requests[k].watch = show_scene;
    requests[k].watcher = &marks[k];
  }
  const po_status status =
      line->folds
          ? po_series_folds(requests, count, results)
          : po_series_observe(requests, count,
                              line->checkpoints ? line->checkpoints : PO_CHECKPOINT_EVERY, results);
  po_live_end(&progress.live);
  free(marks);
  return status;
}

static po_status follow(const follow_line *line, po_request *requests, po_result *results) {
  po_status status = PO_OK;
  for (size_t k = 0; k < line->range.count && !status; ++k)
    status = make_request(line, k, &requests[k]);
  if (status)
    return status;
  status = po_linear_reserve(1);
  if (!status)
    status = compute(line, requests, results);
  status = po_no_memory_or(status);
  if (status == PO_INTERRUPTED)
    return po_fail(status, "interrupted");
  if (!status && line->json)
    status = print_json(requests, results, line->range.count);
  else if (!status && line->folds && !results[0].status)
    print_folds(line, requests, results);
  else if (!status && !line->folds && !(line->curve && strcmp(line->curve, "-") == 0))
    print_text(line, requests, results);
  fflush(stdout);
  if (!status && line->curve)
    status = po_tables_write_series(line->curve, line->key, requests, results, line->range.count);
  for (size_t k = 0; k < line->range.count && !status; ++k)
    if (results[k].status)
      status = po_fail(results[k].status, "the solve at %s %g failed: %s", line->varied,
                       po_key_number(&requests[k], line->key), results[k].reason);
  return status;
}

int po_verb_follow(int argc, char **argv) {
  const po_options options = {"follow", HELP, OPTIONS, argc, argv, MORE_HELP};
  follow_line line = {.range = {NAN, NAN, DEFAULT_POINTS, true}};
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  status = po_options_no_operands(&options);
  if (!status)
    status = check_line(&line);
  if (status)
    return po_options_end(status);
  po_request *requests = po_allocate(line.range.count, sizeof *requests);
  po_result *results = po_allocate(line.range.count, sizeof *results);
  status = requests && results ? follow(&line, requests, results) : PO_NO_MEMORY;
  for (size_t k = 0; results && k < line.range.count; ++k)
    po_result_clear(&results[k]);
  free(requests);
  free(results);
  return po_options_end(status);
}
