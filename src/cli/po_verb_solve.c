#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_interrupt.h"
#include "po_linear.h"
#include "po_observe.h"
#include "po_options.h"
#include "po_print.h"
#include "po_scene_flags.h"
#include "po_tables.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff solve [OPTION]...\n"
    "Solves one scene: traces the branch of equilibria from far out and reads the pull-off off "
    "it.\n"
    "Lengths in units of the equilibrium distance epsilon; load in pi w R, compressive > 0.\n\n"
    "  --tabor MU              Tabor parameter (1); 0: rigid\n"
    "  --amplitude A           of the waviness (0: smooth)\n"
    "  --wavelength L          of the waviness\n"
    "  --radius R              of the sphere (100)\n"
    "  --outer-radius R|inf    where the surface is cut (inf: not cut)\n"
    "  --law LAW               traction-separation law: lennard-jones (default, Eq 9), mie:M,N\n"
    "                          or morse:A; the parameters also by --mie-m, --mie-n, --morse-a\n"
    "  --scheme ring|triangle|panel  discretisation (panel)\n"
    "  --tolerance T           of panels: relative, of the pull-off force (1e-6)\n"
    "  --nodes N               of rings and triangles (501)\n"
    "  --grading uniform|graded  of rings and triangles (uniform)\n"
    "  --approach-start D      where the trace begins (chosen by the solver)\n"
    "  --preload D             greatest approach to which the sphere is pressed, inf: any, the\n"
    "                          pull-off is the greatest of all preloads; and\n"
    "  --preload-load W        greatest load, in pi w R; of both whichever is met first, of\n"
    "                          none of them: load 1\n"
    "  --approach-end D        where the trace ends, and then the preload (where the preload is\n"
    "                          met; without --preload, --preload-load and --want the solve goes\n"
    "                          on for a while, to see whether a harder preload gives more)\n"
    "  --time-limit S          seconds of processor time after which the solve ends (none)\n"
    "  --want LIST             of curve, profile, hysteresis, diagnostics, preload: points of the\n"
    "                          branch; gap and traction over the radius; loading and unloading\n"
    "                          with jumps; residuals, condition numbers, digits left; the\n"
    "                          pull-off after every preload\n"
    "  --profile-approach D    where the profile is taken (at pull-off)\n"
    "  --curve FILE            write the points of the branch as CSV, dimensionless\n"
    "  --staircase FILE        write the steps of the pull-off by the preload as CSV, "
    "dimensionless\n"
    "  --profile FILE          write the profile as CSV, dimensionless\n"
    "  --json                  one JSON document on standard output, nothing else\n"
    "  -h, --help              this text\n\n" PO_SCENE_FLAGS_HELP "\n"
    "Example: pulloff solve --tabor 3 --amplitude 1 --wavelength 20 --outer-radius 100 --json\n"
    "Example: pulloff solve --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7\n";

enum { WANT = PO_FLAG_NEXT, CURVE_FILE, PROFILE_FILE, STAIRCASE_FILE, JSON, KEY };

/* The values of the options of the mesh are KEY + po_key. */
static const struct option OPTIONS[] = {
    PO_SCENE_OPTIONS,
    PO_LENGTH_OPTIONS("outer-radius", PO_LENGTH_OUTER_RADIUS),
    {"law", required_argument, NULL, KEY + PO_KEY_LAW},
    {"mie-m", required_argument, NULL, KEY + PO_KEY_MIE_M},
    {"mie-n", required_argument, NULL, KEY + PO_KEY_MIE_N},
    {"morse-a", required_argument, NULL, KEY + PO_KEY_MORSE_A},
    {"scheme", required_argument, NULL, KEY + PO_KEY_SCHEME},
    {"grading", required_argument, NULL, KEY + PO_KEY_GRADING},
    {"nodes", required_argument, NULL, KEY + PO_KEY_NODES},
    {"tolerance", required_argument, NULL, KEY + PO_KEY_TOLERANCE},
    PO_LENGTH_OPTIONS("approach-start", PO_LENGTH_APPROACH_START),
    PO_LENGTH_OPTIONS("approach-end", PO_LENGTH_APPROACH_END),
    {"time-limit", required_argument, NULL, KEY + PO_KEY_TIME_LIMIT},
    PO_LENGTH_OPTIONS("preload", PO_LENGTH_PRELOAD),
    {"preload-load", required_argument, NULL, KEY + PO_KEY_PRELOAD_LOAD},
    {"want", required_argument, NULL, WANT},
    PO_LENGTH_OPTIONS("profile-approach", PO_LENGTH_PROFILE_APPROACH),
    {"curve", required_argument, NULL, CURVE_FILE},
    {"profile", required_argument, NULL, PROFILE_FILE},
    {"staircase", required_argument, NULL, STAIRCASE_FILE},
    {"json", no_argument, NULL, JSON},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

typedef struct {
  po_request request;
  po_scene_flags flags;
  bool given[PO_KEY_COUNT];                /* keys of the mesh or of the solve that were said */
  const char *curve, *profile, *staircase; /* files; NULL: none */
  bool json;
} solve_line;

static po_status take_want(solve_line *line, const char *list) {
  for (const char *item = list;; ++item) {
    const size_t length = strcspn(item, ",");
    int k = 0;
    while (k < PO_WANT_COUNT &&
           (strlen(po_want_name(k)) != length || strncmp(item, po_want_name(k), length) != 0))
      ++k;
    if (k == PO_WANT_COUNT)
      return po_options_refuse(
          "want", list,
          "any of curve, profile, hysteresis, diagnostics, preload, with commas between");
    line->request.want |= 1u << k;
    item += length;
    if (*item == '\0')
      return PO_OK;
  }
}

/* A key of the mesh or of the solve, by the name its option has. */
static po_status take_key(solve_line *line, po_key key, int option) {
  line->given[key] = true;
  if (po_key_set(&line->request, key, optarg))
    return PO_OK;
  const struct option *given = OPTIONS;
  while (given->val != option)
    ++given;
  return po_options_refuse(given->name, optarg, po_key_expected(key));
}

static po_status take_option(void *to, int option) {
  solve_line *line = to;
  if (option < PO_FLAG_NEXT)
    return po_scene_flags_take(&line->flags, option);
  switch (option) {
  case WANT:
    return take_want(line, optarg);
  case CURVE_FILE:
    line->request.want |= PO_WANT_CURVE;
    return po_options_take_text("curve", "the name of a file", &line->curve);
  case PROFILE_FILE:
    line->request.want |= PO_WANT_PROFILE;
    return po_options_take_text("profile", "the name of a file", &line->profile);
  case STAIRCASE_FILE:
    line->request.want |= PO_WANT_PRELOAD;
    return po_options_take_text("staircase", "the name of a file", &line->staircase);
  case JSON:
    line->json = true;
    return PO_OK;
  default:
    return take_key(line, (po_key)(option - KEY), option);
  }
}

/* What is said must mean something. */
static po_status refuse_keys_of_other_scheme(const solve_line *line) {
  static const po_key KEYS[] = {PO_KEY_TOLERANCE, PO_KEY_NODES, PO_KEY_GRADING};
  for (size_t i = 0; i < sizeof KEYS / sizeof *KEYS; ++i)
    if (line->given[KEYS[i]] && po_key_is_of_other_scheme(&line->request, KEYS[i]))
      return po_fail(PO_BAD_INPUT, "--%s is given for scheme %s: expected it with --scheme %s",
                     po_key_name(KEYS[i]), po_scheme_name(line->request.mesh.scheme),
                     KEYS[i] == PO_KEY_TOLERANCE ? "panel" : "ring or triangle");
  return PO_OK;
}

/* A wavelength without an amplitude has no effect; with amplitude 0 it is the smooth end of a
 * sweep. */
static po_status refuse_idle(const solve_line *line) {
  const double *length = line->flags.length;
  po_flag_use flags[] = {{.given = !isnan(length[PO_LENGTH_WAVELENGTH]),
                          .taken = !isnan(length[PO_LENGTH_AMPLITUDE])}};
  po_scene_flags_name(&line->flags, PO_LENGTH_WAVELENGTH, flags[0].name);
  return po_options_refuse_idle("a scene without amplitude", flags, 1);
}

/* Puts the request together and checks it. */
static po_status end_line(solve_line *line) {
  po_request *request = &line->request;
  const double *length = line->flags.length;
  po_status status = refuse_keys_of_other_scheme(line);
  if (!status)
    status = po_scene_flags_end(&line->flags, true, &request->scene);
  if (!status)
    status = refuse_idle(line);
  if (!status)
    status = po_scene_flags_check_law(&request->scene.law, line->given + PO_KEY_MIE_M);
  if (status)
    return status;
  if (request->scene.amplitude > 0 && isnan(length[PO_LENGTH_WAVELENGTH])) {
    char amplitude[32], wavelength[32];
    po_scene_flags_name(&line->flags, PO_LENGTH_AMPLITUDE, amplitude);
    po_scene_flags_name(&line->flags, PO_LENGTH_WAVELENGTH, wavelength);
    return po_fail(PO_BAD_INPUT, "--%s is given without --%s: expected both", amplitude,
                   wavelength);
  }
  request->approach_start = length[PO_LENGTH_APPROACH_START];
  request->approach_end = length[PO_LENGTH_APPROACH_END];
  request->profile_approach = length[PO_LENGTH_PROFILE_APPROACH];
  if (line->flags.from_physical && !isnan(request->preload.load))
    return po_fail(PO_BAD_INPUT, "--preload-load is in pi w R: expected --preload-m with "
                                 "--from-physical");
  request->preload.approach = length[PO_LENGTH_PRELOAD];
  if (!isnan(request->profile_approach))
    request->want |= PO_WANT_PROFILE;
  if (!request->want && isnan(request->preload.approach) && isnan(request->preload.load))
    request->search = PO_SEARCH_SOME;
  return po_request_check(request);
}

/* Writes each file that can be written. */
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
  return curve ? curve : staircase ? staircase : status;
}

static int solve(solve_line *line) {
  po_result result = {0};
  line->request.stop = po_interrupt_listen();
  const po_status solved = po_observe(&line->request, &result);
  if (solved && !result.reason[0])
    snprintf(result.reason, sizeof result.reason, "%.250s", po_message());
  po_status status = PO_OK;
  if (line->json)
    status = po_print_json(&line->request, &line->flags, &result);
  else
    po_print_text(&line->request, &line->flags, &result);
  if (!status && !solved)
    status = write_files(line, &result); /* a result must not be lost with a file beside it */
  if (!status && solved)
    status = po_fail(solved, "the solve failed: %s", result.reason);
  po_result_clear(&result);
  return po_options_end(status);
}

int po_verb_solve(int argc, char **argv) {
  const po_options options = {"solve", HELP, OPTIONS, argc, argv};
  solve_line line = {.request = po_input_default(), .flags = po_scene_flags_default()};
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  status = po_options_no_operands(&options);
  if (!status)
    status = end_line(&line);
  return status ? po_options_end(status) : solve(&line);
}
