#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_interrupt.h"
#include "po_linear.h"
#include "po_options.h"
#include "po_print.h"
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
    "  --scheme ring|triangle|panel  discretisation (triangle)\n"
    "  --grading uniform|graded  of the elements, for ring and triangle (uniform)\n"
    "  --nodes N               of the surface, for ring and triangle (501)\n"
    "  --tolerance T           relative, of the pull-off force, for panel (1e-6)\n"
    "  --approach-start D      where the trace begins (chosen by the solver)\n"
    "  --approach-end D        where it ends (once the pull-off is certain)\n"
    "  --time-limit S          seconds of processor time after which the solve ends (none)\n"
    "  --want curve,profile    points of the branch; gap and traction over the radius\n"
    "  --profile-approach D    where the profile is taken (at pull-off)\n"
    "  --curve FILE            write the points of the branch as CSV\n"
    "  --profile FILE          write the profile as CSV\n"
    "  --json                  one JSON document on standard output, nothing else\n"
    "  --help                  this text\n\n"
    "Example: pulloff solve --tabor 3 --amplitude 1 --wavelength 20 --outer-radius 100 --json\n";

enum { WANT = 100, PROFILE_APPROACH, CURVE_FILE, PROFILE_FILE, JSON }; /* above every po_key + 1 */

/* The values of the scene's options are po_key + 1. */
static const struct option OPTIONS[] = {
    {"tabor", required_argument, NULL, PO_KEY_TABOR + 1},
    {"amplitude", required_argument, NULL, PO_KEY_AMPLITUDE + 1},
    {"wavelength", required_argument, NULL, PO_KEY_WAVELENGTH + 1},
    {"radius", required_argument, NULL, PO_KEY_RADIUS + 1},
    {"outer-radius", required_argument, NULL, PO_KEY_OUTER_RADIUS + 1},
    {"scheme", required_argument, NULL, PO_KEY_SCHEME + 1},
    {"grading", required_argument, NULL, PO_KEY_GRADING + 1},
    {"nodes", required_argument, NULL, PO_KEY_NODES + 1},
    {"tolerance", required_argument, NULL, PO_KEY_TOLERANCE + 1},
    {"approach-start", required_argument, NULL, PO_KEY_APPROACH_START + 1},
    {"approach-end", required_argument, NULL, PO_KEY_APPROACH_END + 1},
    {"time-limit", required_argument, NULL, PO_KEY_TIME_LIMIT + 1},
    {"want", required_argument, NULL, WANT},
    {"profile-approach", required_argument, NULL, PROFILE_APPROACH},
    {"curve", required_argument, NULL, CURVE_FILE},
    {"profile", required_argument, NULL, PROFILE_FILE},
    {"json", no_argument, NULL, JSON},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

typedef struct {
  po_request request;
  const char *curve, *profile; /* files; NULL: none */
  bool json;
  unsigned given; /* bit po_key: the option was there */
} solve_line;

static po_status take_want(solve_line *line, const char *list) {
  for (const char *item = list;; ++item) {
    const size_t length = strcspn(item, ",");
    if (length == 5 && strncmp(item, "curve", 5) == 0)
      line->request.want |= PO_WANT_CURVE;
    else if (length == 7 && strncmp(item, "profile", 7) == 0)
      line->request.want |= PO_WANT_PROFILE;
    else
      return po_options_refuse("want", list, "curve, profile or both, with a comma between");
    item += length;
    if (*item == '\0')
      return PO_OK;
  }
}

/* The name of an option by its value. */
static const char *option_name(int value) {
  const struct option *option = OPTIONS;
  while (option->name && option->val != value)
    ++option;
  return option->name ? option->name : "";
}

static po_status take_option(solve_line *line, int option) {
  switch (option) {
  case WANT:
    return take_want(line, optarg);
  case PROFILE_APPROACH:
    line->request.want |= PO_WANT_PROFILE;
    return po_number_parse(optarg, &line->request.profile_approach)
               ? PO_OK
               : po_options_refuse("profile-approach", optarg, "a finite number");
  case CURVE_FILE:
    line->curve = optarg;
    line->request.want |= PO_WANT_CURVE;
    return PO_OK;
  case PROFILE_FILE:
    line->profile = optarg;
    line->request.want |= PO_WANT_PROFILE;
    return PO_OK;
  case JSON:
    line->json = true;
    return PO_OK;
  default:
    line->given |= 1u << (option - 1);
    return po_key_set(&line->request, (po_key)(option - 1), optarg)
               ? PO_OK
               : po_options_refuse(option_name(option), optarg,
                                   po_key_expected((po_key)(option - 1)));
  }
}

static po_status check_line(const solve_line *line) {
  if (line->request.scene.amplitude > 0 && !(line->given & 1u << PO_KEY_WAVELENGTH))
    return po_fail(PO_BAD_INPUT, "--amplitude is given without --wavelength: expected both");
  return po_request_check(&line->request);
}

static po_status write_files(const solve_line *line, const po_outcome *outcome) {
  po_status status = PO_OK;
  if (line->curve)
    status = po_tables_write_curve(line->curve, &line->request, outcome, NULL);
  if (!status && line->profile)
    status = po_tables_write_profile(line->profile, &line->request, outcome, NULL);
  return status;
}

static int solve(solve_line *line) {
  po_outcome outcome = {0};
  line->request.stop = po_interrupt_listen();
  po_linear_single_thread();
  const po_status solved = po_observe(&line->request, &outcome);
  if (solved && !outcome.reason[0])
    snprintf(outcome.reason, sizeof outcome.reason, "%.250s", po_message());
  po_status status = solved ? PO_OK : write_files(line, &outcome);
  if (!status)
    status = line->json ? po_print_json(&line->request, &outcome)
                        : po_print_text(&line->request, &outcome);
  if (!status && solved)
    status = po_fail(solved, "the solve failed: %s", outcome.reason);
  po_outcome_clear(&outcome);
  return po_options_end(status);
}

int po_verb_solve(int argc, char **argv) {
  const po_options options = {"solve", HELP, OPTIONS, argc, argv};
  solve_line line = {.request = po_request_default()};
  po_status status = PO_OK;
  int option = 0;
  while (!status && (option = po_options_next(&options)) > 0) {
    if (option == PO_OPTION_HELP)
      return PO_EXIT_OK;
    status = take_option(&line, option);
  }
  if (option == PO_OPTION_BAD)
    status = PO_BAD_INPUT;
  if (!status)
    status = po_options_no_operands(&options);
  if (!status)
    status = check_line(&line);
  return status ? po_options_end(status) : solve(&line);
}
