#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_interrupt.h"
#include "po_json.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_options.h"
#include "po_print.h"
#include "po_range.h"
#include "po_scene_flags.h"
#include "po_series.h"
#include "po_series_folds.h"
#include "po_text.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff follow --key KEY --from A --to B [OPTION]...\n"
    "The pull-off along a line of scenes: some are traced, between them the minima of the load "
    "are\n"
    "followed, at a few factorisations a scene, where that agrees with both traces.\n"
    "Lengths in units of the equilibrium distance epsilon; load in pi w R, compressive > 0.\n\n"
    "  --key KEY               what runs: tabor, amplitude, wavelength, radius, outer-radius,\n"
    "                          amplitude-ratio (A / lambda), mie-m, mie-n, morse-a\n"
    "  --from A, --to B        its first and last value\n"
    "  --points N              how many values (60)\n"
    "  --scale log|linear      of equal steps (log)\n"
    "  --of pull-off|folds     what is followed (pull-off); folds: those of the first scene, "
    "which\n"
    "                          is traced, as far along the line as they are there\n"
    "  --checkpoint-every K        one scene in K is traced at least (15)\n"
    "  --tabor MU              Tabor parameter (1)\n"
    "  --amplitude A           of the waviness (0: smooth)\n"
    "  --amplitude-ratio Q     the same, in wavelengths, kept when the wavelength runs\n"
    "  --wavelength L          of the waviness\n"
    "  --radius R              of the sphere (100)\n"
    "  --outer-radius R|inf    where the surface is cut (inf: not cut)\n"
    "  --law LAW               traction-separation law: lennard-jones (default, Eq 9), mie:M,N\n"
    "                          or morse:A; the parameters also by --mie-m, --mie-n, --morse-a\n"
    "  --preload D|inf         greatest approach to which each sphere is pressed, inf: any; and\n"
    "  --preload-load W        greatest load, in pi w R; of both whichever is met first, of\n"
    "                          none of them: load 1\n"
    "  --tolerance T           relative, of the pull-off force (1e-6)\n"
    "  --json                  one JSON document on standard output, nothing else\n"
    "  -h, --help              this text\n\n"
    "Example: pulloff follow --key tabor --from 0.1 --to 5 --points 60 --amplitude 1 \\\n"
    "             --wavelength 20 --outer-radius 100\n";

enum { RUNS = 1, FROM, TO, POINTS, SCALE, OF, CHECKPOINTS, JSON, KEY };
enum { DEFAULT_POINTS = 60 };

/* The values of the options of the scene are KEY + po_key. */
static const struct option OPTIONS[] = {
    {"key", required_argument, NULL, RUNS},
    {"from", required_argument, NULL, FROM},
    {"to", required_argument, NULL, TO},
    {"points", required_argument, NULL, POINTS},
    {"scale", required_argument, NULL, SCALE},
    {"of", required_argument, NULL, OF},
    {"checkpoint-every", required_argument, NULL, CHECKPOINTS},
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
    {"tolerance", required_argument, NULL, KEY + PO_KEY_TOLERANCE},
    {"preload", required_argument, NULL, KEY + PO_KEY_PRELOAD},
    {"preload-load", required_argument, NULL, KEY + PO_KEY_PRELOAD_LOAD},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

typedef struct {
  const char *given[PO_KEY_END]; /* values of keys, as written */
  const char *runs;              /* the name of the key, as its option is called */
  po_key key;
  po_range range;
  size_t checkpoints; /* 0: not given */
  bool folds, json;
} follow_line;

static const struct option *option_of(int value) {
  const struct option *option = OPTIONS;
  while (option->name && option->val != value)
    ++option;
  return option;
}

/* Whether an option is of the scene, which may run along a line. */
static bool is_of_scene(const struct option *option) {
  const int key = option->val - KEY;
  return option->val >= KEY && option->val < PO_OPTION_HELP && key != PO_KEY_TOLERANCE &&
         key != PO_KEY_LAW && key != PO_KEY_PRELOAD && key != PO_KEY_PRELOAD_LOAD;
}

static po_status take_runs(follow_line *line) {
  for (const struct option *option = OPTIONS; option->name; ++option)
    if (is_of_scene(option) && strcmp(option->name, optarg) == 0) {
      line->key = (po_key)(option->val - KEY);
      line->runs = option->name;
      return PO_OK;
    }
  return po_options_refuse("key", optarg, "the name of an option of the scene");
}

static po_status take_count(const char *option, size_t least, size_t *count) {
  if (po_number_parse_count(optarg, count) && *count >= least && *count <= PO_MOST_VALUES)
    return PO_OK;
  return po_options_refuse(option, optarg, "a whole number, of points at least 2, up to 10000");
}

static po_status take_option(void *to, int option) {
  follow_line *line = to;
  switch (option) {
  case RUNS:
    return take_runs(line);
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
  case JSON:
    line->json = true;
    return PO_OK;
  default:
    line->given[option - KEY] = optarg;
    return PO_OK;
  }
}

static po_status check_line(const follow_line *line) {
  const po_range *range = &line->range;
  if (!line->runs || isnan(range->from) || isnan(range->to))
    return po_fail(PO_BAD_INPUT, "--%s is not given: expected --key, --from and --to",
                   !line->runs          ? "key"
                   : isnan(range->from) ? "from"
                                        : "to");
  if (line->given[line->key])
    return po_fail(PO_BAD_INPUT, "--%s is given, and runs: expected one of both", line->runs);
  if (range->from == range->to || (range->log && !(range->from > 0.0 && range->to > 0.0)))
    return po_fail(PO_BAD_INPUT, "the line goes from %g to %g: expected two values%s", range->from,
                   range->to, range->log ? " > 0, or --scale linear" : "");
  if ((line->given[PO_KEY_AMPLITUDE] || line->key == PO_KEY_AMPLITUDE) &&
      (line->given[PO_KEY_AMPLITUDE_RATIO] || line->key == PO_KEY_AMPLITUDE_RATIO))
    return po_fail(PO_BAD_INPUT, "amplitude and amplitude-ratio are both said: expected one");
  const bool wavy = line->given[PO_KEY_AMPLITUDE] || line->key == PO_KEY_AMPLITUDE ||
                    line->given[PO_KEY_AMPLITUDE_RATIO] || line->key == PO_KEY_AMPLITUDE_RATIO;
  if (wavy && !line->given[PO_KEY_WAVELENGTH] && line->key != PO_KEY_WAVELENGTH)
    return po_fail(PO_BAD_INPUT, "a waviness is given without --wavelength: expected both");
  if (!wavy && line->key == PO_KEY_WAVELENGTH)
    return po_fail(PO_BAD_INPUT, "the wavelength runs along scenes without amplitude: expected "
                                 "--amplitude or --amplitude-ratio");
  const po_flag_use wavelength = {"wavelength", line->given[PO_KEY_WAVELENGTH], wavy};
  const po_flag_use checkpoints = {"checkpoint-every", line->checkpoints > 0, !line->folds};
  const po_status status = po_options_refuse_idle("scenes without amplitude", &wavelength, 1);
  return status ? status : po_options_refuse_idle("--of folds", &checkpoints, 1);
}

static po_status set_key(po_request *request, int key, const char *text) {
  if (po_key_set(request, (po_key)key, text))
    return PO_OK;
  return po_options_refuse(option_of(KEY + key)->name, text, po_key_expected((po_key)key));
}

/* The request of a point of the line; keys before groups of them. */
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
  bool given[PO_LAW_PARAMETER_COUNT];
  for (int k = 0; k < PO_LAW_PARAMETER_COUNT; ++k)
    given[k] = line->given[PO_KEY_MIE_M + k] || (int)line->key == PO_KEY_MIE_M + k;
  if (!status)
    status = po_scene_flags_check_law(&request->scene.law, given);
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
  printf("%15s %14s %8s %16s %8s %14s %-9s %14s\n", line->runs, "force", "error", "approach",
         "error", "contact radius", "", "factorisations");
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

/* A block of rows for each fold of the first scene. */
static void print_folds(const follow_line *line, const po_request *requests,
                        const po_result *results) {
  printf("%-9s %15s %16s %8s %14s %8s %14s\n", "", line->runs, "approach", "error", "load", "error",
         "contact radius");
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

static po_status follow(const follow_line *line, po_request *requests, po_result *results) {
  po_status status = PO_OK;
  for (size_t k = 0; k < line->range.count && !status; ++k)
    status = make_request(line, k, &requests[k]);
  if (status)
    return status;
  status = po_linear_reserve(1);
  if (!status)
    status = line->folds
                 ? po_series_folds(requests, line->range.count, results)
                 : po_series_observe(requests, line->range.count,
                                     line->checkpoints ? line->checkpoints : PO_CHECKPOINT_EVERY,
                                     results);
  status = po_no_memory_or(status);
  if (status == PO_INTERRUPTED)
    return po_fail(status, "interrupted");
  if (!status && line->json)
    status = print_json(requests, results, line->range.count);
  else if (!status && line->folds && !results[0].status)
    print_folds(line, requests, results);
  else if (!status && !line->folds)
    print_text(line, requests, results);
  for (size_t k = 0; k < line->range.count && !status; ++k)
    if (results[k].status)
      status = po_fail(results[k].status, "a solve failed, at %s %g: %s", line->runs,
                       po_key_number(&requests[k], line->key), results[k].reason);
  return status;
}

int po_verb_follow(int argc, char **argv) {
  const po_options options = {"follow", HELP, OPTIONS, argc, argv};
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
