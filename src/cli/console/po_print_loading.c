#include "po_print.h"

#include <math.h>
#include <stdio.h>

#include "po_path.h"
#include "po_result_rows.h"
#include "po_si.h"
#include "po_text.h"

/* The factors of printed numbers, and what follows them: 1 and nothing, or SI units. */
typedef struct {
  double length, load, energy, stiffness;
  char of_length[12], of_load[12], of_energy[12], of_stiffness[12];
  char words[48]; /* all of them */
} units;

/* The greatest numbers that are printed with these units. */
typedef struct {
  double length, load, energy, stiffness;
} greatest;

static units units_of(const po_request *request, const greatest *g) {
  units u = {.length = 1, .load = 1, .energy = 1, .stiffness = 1};
  const struct {
    po_dimension dimension;
    double greatest, *factor;
    char *text;
  } items[] = {{PO_DIMENSION_LENGTH, g->length, &u.length, u.of_length},
               {PO_DIMENSION_LOAD, g->load, &u.load, u.of_load},
               {PO_DIMENSION_ENERGY, g->energy, &u.energy, u.of_energy},
               {PO_DIMENSION_STIFFNESS, g->stiffness, &u.stiffness, u.of_stiffness}};
  if (!request->in_si)
    return u;
  for (size_t i = 0; i < sizeof items / sizeof *items; ++i) {
    const po_si_unit unit =
        items[i].dimension == PO_DIMENSION_LENGTH
            ? po_si_readable_approach(&request->units, items[i].greatest)
            : po_si_readable(&request->units, items[i].dimension, items[i].greatest);
    *items[i].factor = unit.factor;
    snprintf(items[i].text, sizeof u.of_load, " %s", unit.text);
  }
  snprintf(u.words, sizeof u.words, ", in%s,%s and%s", u.of_length, u.of_load, u.of_energy);
  return u;
}

static void take_greatest(greatest *g, const po_path_state *state) {
  po_si_take(&g->length, state->approach);
  po_si_take(&g->load, state->load);
}

static greatest greatest_of_control(po_control control) {
  return (greatest){.stiffness = po_is_spring(control) ? control : 0.0};
}

static greatest greatest_of_staircase(const po_staircase *s) {
  greatest g = greatest_of_control(s->control);
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    take_greatest(&g, &step->preload);
    take_greatest(&g, &step->pull_off);
    if (!step->open)
      take_greatest(&g, &step->until);
    po_si_take(&g.energy, step->cycle[0].loss.energy);
  }
  return g;
}

static greatest greatest_of_loop(const po_loop *loop) {
  greatest g = greatest_of_control(loop->control);
  take_greatest(&g, &loop->preload);
  take_greatest(&g, &loop->pull_off);
  po_si_take(&g.energy, loop->energy_lost);
  for (size_t k = 0; k < loop->jump_count; ++k) {
    take_greatest(&g, &loop->jumps[k].before);
    take_greatest(&g, &loop->jumps[k].after);
    po_si_take(&g.energy, loop->jumps[k].energy_lost);
  }
  return g;
}

const char *po_print_error(double error, char text[16]) {
  snprintf(text, 16, isfinite(error) ? "%.1e" : "", error);
  return text;
}

/* What is held in a test. */
static const char *held_of(po_control control, const units *u, char held[64]) {
  snprintf(held, 64, "%s control", control == PO_LOAD_CONTROL ? "load" : "displacement");
  if (po_is_spring(control))
    snprintf(held, 64, "spring of stiffness %.6g%s", control * u->stiffness, u->of_stiffness);
  return held;
}

static void print_staircase(const char *theory, const po_staircase *s, const po_request *request) {
  const greatest g = greatest_of_staircase(s);
  const units of_table = units_of(request, &g), *u = &of_table;
  char held[64];
  printf("%s%s: pull-off force against preload%s\n%14s %14s %-9s %14s %16s %8s %16s %14s %8s\n",
         theory, held_of(s->control, u, held), u->words, "from approach", "load", "begins at",
         po_is_spring(s->control) ? "until base" : "until", "force", "error", "at approach",
         "energy lost", "error");
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    const po_cycle *cycle = &step->cycle[0];
    const double end = po_held(s->control, step->until.approach, step->until.load) *
                       (s->control == PO_LOAD_CONTROL ? u->load : u->length);
    char from[PO_NUMBER_LENGTH], until[PO_NUMBER_LENGTH], lost[PO_NUMBER_LENGTH];
    char error[16], lost_error[16];
    printf("%14s %14.8g %-9s %14s %16.10g %8s %16.10g %14s %8s\n",
           po_number_or("%.8g", step->preload.approach * u->length, "contact", from),
           step->preload.load * u->load, step->jumped ? "jump" : "minimum",
           po_number_or("%.8g", step->open ? (double)NAN : end, "open", until),
           -step->pull_off.load * u->load,
           po_print_error(step->pull_off_error.load * u->load, error),
           step->pull_off.approach * u->length,
           po_number_or("%.8g", cycle->loss.energy * u->energy, "boundless", lost),
           po_print_error(cycle->energy_error * u->energy, lost_error));
  }
}

/* The staircases of the solve, and those of the JKR theory if the scene has one: Eq 5 for the
 * scenes of the paper, the Abel transform of the profile for others. */
static void print_staircases(const po_request *request, const po_result *o) {
  const char *jkr = po_scene_is_of_paper(&request->scene) ? "JKR theory (Eq 5), " : "JKR theory, ";
  for (int k = 0; k < 2 + o->staircase.has_spring; ++k)
    print_staircase("", &o->staircase.of[k], request);
  for (int k = 0; o->theory.has_staircases && k < 2 + o->theory.staircase.has_spring; ++k)
    print_staircase(jkr, &o->theory.staircase.of[k], request);
}

/* One cycle of loading and unloading: where loading was reversed, the measured pull-off, and every
 * jump. */
static void print_loop(const po_loop *loop, const po_request *request) {
  const greatest g = greatest_of_loop(loop);
  const units of_loop = units_of(request, &g), *u = &of_loop;
  const bool spring = po_is_spring(loop->control);
  char error[16], held[64];
  const double length = u->length, load = u->load;
  printf("%s: loading reversed at approach %.6g%s, load %.6g%s; measured pull-off force %.8g%s at "
         "approach %.8g%s",
         held_of(loop->control, u, held), loop->preload.approach * length, u->of_length,
         loop->preload.load * load, u->of_load, fmax(0.0, -loop->pull_off.load) * load, u->of_load,
         loop->pull_off.approach * length, u->of_length);
  if (isfinite(loop->energy_lost))
    printf("; energy lost %.6g%s", loop->energy_lost * u->energy, u->of_energy);
  if (isfinite(loop->energy_lost_error))
    printf(", error %s", po_print_error(loop->energy_lost_error * u->energy, error));
  if (loop->jump_count == 0) {
    printf("; no jumps\n");
    return;
  }
  printf("%s%s\n%-5s%-10s %s%14s %14s %14s %14s %12s %8s\n", *u->words ? "; jumps" : "", u->words,
         "jump", "phase", spring ? "          base " : "", "approach", "to", "load", "to",
         "energy lost", "error");
  for (size_t k = 0; k < loop->jump_count; ++k) {
    const po_jump *jump = &loop->jumps[k];
    po_label label;
    po_jump_label(jump->loading, k + 1 - (jump->loading ? 0 : loop->loading_jumps), label);
    char from[PO_NUMBER_LENGTH], to[PO_NUMBER_LENGTH], lost[PO_NUMBER_LENGTH];
    /* a load that is held, without the rounding of the state beyond */
    const bool held_load = loop->control == PO_LOAD_CONTROL;
    printf("%-5s%-10s ", label, jump->loading ? "loading" : "unloading");
    if (spring)
      printf("%14.8g ", po_held(loop->control, jump->before.approach, jump->before.load) * length);
    printf("%14s %14s %14.8g %14.8g %12s",
           po_number_or("%.8g", jump->before.approach * length, "apart", from),
           po_number_or("%.8g", jump->after.approach * length, "apart", to),
           jump->before.load * load, (held_load ? jump->before : jump->after).load * load,
           po_number_or("%.8g", jump->energy_lost * u->energy, "boundless", lost));
    if (isfinite(jump->energy_lost_error))
      printf(" %8s", po_print_error(jump->energy_lost_error * u->energy, error));
    printf("\n");
  }
}

/* Why there is no loop at given load. */
static void print_no_loop(const po_request *request, const po_result *o) {
  if (o->range.loops.are_known) {
    printf("load control: no loop, because those with greater ranges of the attraction do not have "
           "the same jumps; with a greater equilibrium distance there may be one\n");
    return;
  }
  greatest g = {0};
  po_si_take(&g.length, o->ended.approach);
  po_si_take(&g.load, o->ended.load);
  const units u = units_of(request, &g);
  printf("load control: no loop, which begins at load 0: the trace ended at approach %.6g%s, load "
         "%.6g%s, and has no stable equilibrium at load 0; a greater approach_end may have one\n",
         o->ended.approach * u.length, u.of_length, o->ended.load * u.load, u.of_load);
}

/* Says that the trace does not pass the approach or the load at which the profile is wanted. */
static void print_no_profile(const po_request *request) {
  const bool elastic = request->creep.kind == PO_CREEP_NONE;
  const char *where = elastic ? "the trace" : "unloading";
  const char *remedy = elastic ? ", see --approach-end" : "";
  greatest g = {0};
  if (isfinite(request->profile_approach))
    po_si_take(&g.length, request->profile_approach);
  if (isfinite(request->profile_load))
    po_si_take(&g.load, request->profile_load);
  const units u = units_of(request, &g);
  if (isfinite(request->profile_approach))
    printf("profile  none: %s does not pass approach %.8g%s%s\n", where,
           request->profile_approach * u.length, u.of_length, remedy);
  else if (isfinite(request->profile_load))
    printf("profile  none: %s does not pass load %.8g%s%s\n", where, request->profile_load * u.load,
           u.of_load, remedy);
}

/* The results of --want that are too long for the terminal: their size, and which option writes
 * them. */
static void print_wanted(const po_request *request, const po_result *o) {
  greatest of_approach = {0}, of_annuli = {0};
  po_si_take(&of_approach.length, o->profile_approach);
  for (size_t k = 0; k < o->annuli.held_count; ++k)
    po_si_take(&of_annuli.length, o->annuli.held[k].outer);
  const units at = units_of(request, &of_approach), annuli = units_of(request, &of_annuli);
  if (request->want & PO_WANT_CURVE)
    printf("curve    %zu %s; --curve FILE or --json writes them\n", o->curve_count,
           po_one_or_more(o->curve_count, "point", "points"));
  if (o->hysteresis.of[PO_AT_APPROACH].has_rows)
    printf(
        "loop     %zu rows; --loop FILE or --json writes them\n",
        o->hysteresis.of[o->hysteresis.has_spring ? PO_THROUGH_SPRING : PO_AT_APPROACH].row_count);
  if (!(request->want & PO_WANT_PROFILE))
    return;
  if (o->profile_count == 0) {
    print_no_profile(request);
    return;
  }
  printf("profile  %zu %s at approach %.8g%s; --profile-csv FILE or --json writes them\n",
         o->profile_count, po_one_or_more(o->profile_count, "radius", "radii"),
         o->profile_approach * at.length, at.of_length);
  printf("annuli   in contact: ");
  for (size_t k = 0; k < o->annuli.held_count; ++k)
    printf("%s%.6g to %.6g%s", k ? ", " : "", o->annuli.held[k].inner * annuli.length,
           o->annuli.held[k].outer * annuli.length, annuli.of_length);
  printf("%s\n", o->annuli.held_count ? "" : "none");
}

/* With which ranges of the attraction the loops were found, if not with the true one. */
static void print_ranges_of_loops(const po_request *request, const po_result *o) {
  const po_range_loops *range = &o->range.loops;
  greatest g = {0};
  po_si_take(&g.length, range->approach);
  po_si_take(&g.load, range->load);
  const units u = units_of(request, &g);
  if (range->are_known)
    printf(
        "loops    limits of those with ranges %.4g to %.4g times as great; errors of the ends of "
        "jumps: approach at most %.1e%s, load %.1e%s\n",
        range->least, range->greatest, range->approach * u.length, u.of_length,
        range->load * u.load, u.of_load);
}

/* The same of the staircases. */
static void print_ranges_of_stairs(const po_result *o) {
  const po_range_stairs *range = &o->range.stairs;
  if (!range->are_known)
    return;
  printf("stairs   limits of those with ranges %.4g to %.4g times as great", range->least,
         range->greatest);
  if (range->left_out)
    printf("; the pull-off after lighter preloads depends on the range, and is left out");
  printf("\n");
}

void po_print_loading(const po_request *request, const po_result *result) {
  const po_hysteresis *h = &result->hysteresis;
  print_ranges_of_loops(request, result);
  for (int k = 0; result->has_hysteresis && k < 2 + h->has_spring; ++k)
    if (k != PO_AT_LOAD || h->has_load)
      print_loop(&h->of[k], request);
    else
      print_no_loop(request, result);
  print_ranges_of_stairs(result);
  if (result->has_staircases)
    print_staircases(request, result);
  print_wanted(request, result);
}
