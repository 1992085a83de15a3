#include "po_solve_line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_live.h"
#include "po_number.h"
#include "po_observe.h"
#include "po_plot_case.h"
#include "po_use.h"

po_solve_line po_solve_line_begin(void) {
  return (po_solve_line){.request = po_input_default(),
                         .flags = po_scene_flags_default(),
                         .preload_n = (double)NAN,
                         .stiffness_n_per_m = (double)NAN};
}

/* Sets a key that is not one of po_scene_flags.h. */
static po_status take_key(po_solve_line *line, po_key key) {
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

static po_status take_si(const char *name, double *value) {
  return po_number_parse(optarg, value) && *value > 0.0
             ? PO_OK
             : po_options_refuse(name, optarg, "a finite number > 0");
}

/* Sets load and stiffness that are given in SI units. */
static po_status take_units(po_solve_line *line) {
  po_request *request = &line->request;
  const bool given = !isnan(line->preload_n) || !isnan(line->stiffness_n_per_m);
  if (!line->flags.from_physical)
    return given ? po_fail(PO_BAD_INPUT, "--%s is in SI units: expected --from-physical",
                           isnan(line->preload_n) ? "stiffness-n-per-m" : "preload-load-n")
                 : PO_OK;
  if (!isnan(request->preload.load))
    return po_fail(PO_BAD_INPUT, "--preload-load is dimensionless: expected --preload-m or "
                                 "--preload-load-n with --from-physical");
  if (!isnan(request->stiffness))
    return po_fail(PO_BAD_INPUT, "--stiffness is dimensionless: expected --stiffness-n-per-m with "
                                 "--from-physical");
  const po_units *units = &line->flags.units;
  request->preload.load = line->preload_n / units->force;
  request->stiffness = line->stiffness_n_per_m / (units->force / units->length);
  return PO_OK;
}

po_status po_solve_line_take(void *to, int option) {
  po_solve_line *line = to;
  const bool old = option == PO_FLAG_PROFILE && names_file(optarg);
  if (old)
    option = PO_LINE_PROFILE;
  if (option < PO_FLAG_NEXT)
    return po_scene_flags_take(&line->flags, option);
  switch (option) {
  case PO_LINE_WANT:
    return po_want_read(optarg, &line->request.want)
               ? PO_OK
               : po_options_refuse("want", optarg, PO_WANT_EXPECTED);
  case PO_LINE_CURVE:
    line->request.want |= PO_WANT_CURVE;
    return po_options_take_text("curve", "the name of a file", &line->curve);
  case PO_LINE_PROFILE:
    line->request.want |= PO_WANT_PROFILE;
    return po_options_take_text(old ? "profile" : "profile-csv", "the name of a file",
                                &line->profile);
  case PO_LINE_STAIRCASE:
    line->request.want |= PO_WANT_PRELOAD;
    return po_options_take_text("staircase", "the name of a file", &line->staircase);
  case PO_LINE_SMOOTHED:
    return po_options_take_text("smoothed", "the name of a file", &line->smoothed);
  case PO_LINE_PLOT:
    line->request.want |= PO_WANT_CURVE;
    return po_plot_take_file(optarg, &line->plot);
  case PO_LINE_RUN:
    return po_options_take_text("run", "the name of a folder", &line->run);
  case PO_LINE_PRELOAD_LOAD_N:
    return take_si("preload-load-n", &line->preload_n);
  case PO_LINE_STIFFNESS_N_PER_M:
    return take_si("stiffness-n-per-m", &line->stiffness_n_per_m);
  case PO_LINE_THEORY:
    return po_options_take_text("theory", "the name of a theory", &line->theory);
  case PO_LINE_JSON:
    line->json = true;
    return PO_OK;
  default:
    return take_key(line, (po_key)(option - PO_OPTION_KEYS));
  }
}

/* Refuses options that have no effect with the chosen scheme. */
static po_status refuse_keys_of_other_scheme(const po_solve_line *line) {
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
static po_status refuse_idle(const po_solve_line *line) {
  const double *length = line->flags.length;
  po_use flags[] = {{.given = !isnan(length[PO_LENGTH_WAVELENGTH]),
                     .taken = !isnan(length[PO_LENGTH_AMPLITUDE])}};
  po_scene_flags_name(&line->flags, PO_LENGTH_WAVELENGTH, flags[0].name);
  return po_use_check("--", "a scene without amplitude", flags, 1);
}

static bool is_output(const char *file) {
  return file && strcmp(file, "-") == 0;
}

int po_solve_line_tables(const po_solve_line *line) {
  return is_output(line->curve) + is_output(line->profile) + is_output(line->staircase) +
         is_output(line->smoothed);
}

po_status po_solve_line_end(po_solve_line *line) {
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
  if (po_solve_line_tables(line) + line->json > 1)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  if (line->smoothed && isnan(request->scene.profile.parameter[PO_TABLE_SMOOTH]))
    return po_fail(PO_BAD_INPUT, "--smoothed is given without --smooth: expected both");
  request->approach_start = length[PO_LENGTH_APPROACH_START];
  request->approach_end = length[PO_LENGTH_APPROACH_END];
  request->profile_approach = length[PO_LENGTH_PROFILE_APPROACH];
  status = take_units(line);
  if (status)
    return status;
  request->preload.approach = length[PO_LENGTH_PRELOAD];
  if (!isnan(request->stiffness))
    request->want |= PO_WANT_HYSTERESIS;
  if (!isnan(request->profile_approach))
    request->want |= PO_WANT_PROFILE;
  po_request_choose_search(request);
  return po_request_check(request);
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

po_status po_solve_line_observe(po_solve_line *line, po_result *result) {
  solve_progress progress = {.live = po_live_begin(false)};
  line->request.stop = po_interrupt_listen();
  line->request.watch = show_point;
  line->request.watcher = &progress;
  const po_status status = po_observe(&line->request, result);
  po_live_end(&progress.live);
  if (status && !result->reason[0])
    snprintf(result->reason, sizeof result->reason, "%.250s", po_message());
  return status;
}
