/* The pull-off after every preload at the true range, from staircases with greater ones.
 *
 * The steps of light preloads depend on the range: which crest jumps first, and between which
 * minima of the load far from contact. Those of the hardest preloads do not, and are the same at
 * all ranges. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "po_memory.h"
#include "po_reduced_internal.h"
#include "po_staircase.h"

enum { SOLVES = PO_RANGES_OF_LIMIT };

/* The same step has a force that differs by at most this part from that with the last range. */
static const double SAME_FORCE = 0.25;

/* The staircases of one test at all ranges. */
typedef struct {
  const po_range_solves *of;
  int test;
} bundle;

static const po_staircase *stairs_at(const bundle *b, int k) {
  return &b->of->solved[k].staircase.of[b->test];
}

/* The step of a staircase before one with the index `end` whose force is the nearest to that of a
 * step of the last range. Returned: its index; SIZE_MAX: none is close. */
static size_t nearest(const po_staircase *s, size_t end, const po_step *to) {
  size_t found = SIZE_MAX;
  double least = SAME_FORCE * fabs(to->pull_off.load);
  for (size_t j = end; j-- > 0;) {
    const double apart = fabs(s->step[j].pull_off.load - to->pull_off.load);
    if (apart < least)
      found = j;
    least = fmin(least, apart);
  }
  return found;
}

/* The same step at all ranges. Given: end[k], the index of the step behind it at each. Returned:
 * whether there is one; end[k], its index. */
static bool step_before(const bundle *b, size_t end[SOLVES], po_range_group *g) {
  const po_staircase *last = stairs_at(b, SOLVES - 1);
  if (end[SOLVES - 1] == 0)
    return false;
  const po_step *step = &last->step[--end[SOLVES - 1]];
  g->request = b->of->request;
  g->at[SOLVES - 1] = (const char *)step;
  for (int k = 0; k < SOLVES - 1; ++k) {
    end[k] = nearest(stairs_at(b, k), end[k], step);
    if (end[k] == SIZE_MAX)
      return false;
    g->at[k] = (const char *)&stairs_at(b, k)->step[end[k]];
  }
  return true;
}

static void begin_behind(const bundle *b, size_t end[SOLVES]) {
  for (int k = 0; k < SOLVES; ++k)
    end[k] = stairs_at(b, k)->count;
}

/* The error of the pull-off force of a step over the tolerance times the force. */
static double excess_of(const bundle *b, const po_range_group *g) {
  double bound;
  const double load = po_range_limit_of_number(g, &b->of->edges, offsetof(po_step, pull_off.load),
                                               offsetof(po_step, pull_off_error.load), &bound);
  return bound / (b->of->request->mesh.tolerance * fabs(load));
}

/* The number of steps of the last range that are stated: the last ones. Returned: also the greatest
 * excess of the forces. */
static size_t steps_known(const bundle *b, double *greatest) {
  size_t end[SOLVES], known = 0;
  po_range_group g;
  *greatest = 0.0;
  begin_behind(b, end);
  while (step_before(b, end, &g)) {
    const double excess = excess_of(b, &g);
    if (!(excess <= PO_MOST_EXCESS))
      break;
    *greatest = fmax(*greatest, excess);
    ++known;
  }
  return known;
}

static const po_step *step_at(const po_range_group *g, int k) {
  return (const po_step *)(const void *)g->at[k];
}

/* Whether a step begins at a jump at all ranges, or at none. */
static bool begins_alike(const po_range_group *g) {
  bool same = true;
  for (int k = 0; k < SOLVES; ++k)
    same &= step_at(g, k)->jumped == step_at(g, 0)->jumped;
  return same;
}

/* Whether the tests that are reversed just beyond the beginning of a step, or of a cycle of it,
 * have as many jumps at all ranges. Given: the step of the last range. */
static bool jumps_alike(const po_range_group *g, const po_step *step, size_t cycle) {
  bool same = begins_alike(g);
  for (int k = 0; k < SOLVES; ++k) {
    const po_step *other = step_at(g, k);
    same = same && (cycle == 0 || other->cycle_count == step->cycle_count) &&
           other->cycle[cycle].loss.jumps == step->cycle[cycle].loss.jumps;
  }
  return same;
}

/* Whether the last step at given approach, and through a spring, is known; another range is needed
 * where it does not begin with the same jumps. */
static bool judge(const po_range_solves *s, double *excess) {
  *excess = 0.0;
  for (int test = 0; test < PO_TESTS; ++test) {
    const bundle b = {s, test};
    double greatest;
    if (test == PO_AT_LOAD || (test == PO_THROUGH_SPRING && isnan(s->request->stiffness)))
      continue;
    if (!steps_known(&b, &greatest))
      return false;
    size_t end[SOLVES];
    po_range_group last;
    begin_behind(&b, end);
    step_before(&b, end, &last);
    *excess =
        jumps_alike(&last, step_at(&last, SOLVES - 1), 0) ? fmax(*excess, greatest) : INFINITY;
  }
  return true;
}

/* -- Limits -- */

/* Replaces the preloads of the cycles of a step and their losses by limits. Where these are other
 * jumps at some ranges, a loss is that of the last range, with an unknown error. */
static void take_cycles(const bundle *b, const po_range_group *of_step, po_step *step) {
  for (size_t c = 0; c < step->cycle_count; ++c) {
    po_cycle *cycle = &step->cycle[c];
    if (!jumps_alike(of_step, step, c) || isnan(cycle->loss.energy)) {
      cycle->energy_error = NAN;
      continue;
    }
    po_range_group g = {.request = of_step->request};
    for (int k = 0; k < SOLVES; ++k)
      g.at[k] = (const char *)&step_at(of_step, k)->cycle[c];
    po_cycle to = *cycle;
    po_path_error error;
    double energy;
    to.preload =
        po_range_limit_of_state(&g, &b->of->crests, offsetof(po_cycle, preload), &error, &energy);
    to.loss.energy = po_range_limit_of_number(&g, &b->of->crests, offsetof(po_cycle, loss.energy),
                                              offsetof(po_cycle, energy_error), &to.energy_error);
    *cycle = to;
  }
}

/* The state of greatest tension is the pull-off of the result if it is the same to the errors. */
static void take_pull_off(const po_result *o, po_step *step) {
  const double error = step->pull_off_error.load + o->pull_off.force_error;
  if (!(fabs(-step->pull_off.load - o->pull_off.force) <= error))
    return;
  step->pull_off.load = -o->pull_off.force;
  step->pull_off.approach = o->pull_off.approach;
  step->pull_off_error = (po_path_error){o->pull_off.approach_error, o->pull_off.force_error};
}

/* The limit of a step, with the cycles of the last range. Given: the step behind it, which is known
 * already; NULL: it is the last. The preload of one that does not begin at a jump at all ranges is
 * that of the last one, with an unknown error: at the true range a crest may jump later, past the
 * minimum of the load at which the step begins. */
static po_step limit_of(const bundle *b, const po_range_group *g, const po_step *behind) {
  po_step step = *step_at(g, SOLVES - 1);
  po_path_error ignored;
  double energy;
  const bool ends_behind = behind && step.until.position == behind->preload.position;
  step.preload_error = (po_path_error){NAN, NAN};
  if (step.jumped && begins_alike(g))
    step.preload = po_range_limit_of_state(g, &b->of->crests, offsetof(po_step, preload),
                                           &step.preload_error, &energy);
  if (ends_behind)
    step.until = behind->preload;
  else if (!step.open)
    step.until =
        po_range_limit_of_state(g, &b->of->edges, offsetof(po_step, until), &ignored, &energy);
  step.pull_off = po_range_limit_of_state(g, &b->of->edges, offsetof(po_step, pull_off),
                                          &step.pull_off_error, &energy);
  step.pull_off.load =
      po_range_limit_of_number(g, &b->of->edges, offsetof(po_step, pull_off.load),
                               offsetof(po_step, pull_off_error.load), &step.pull_off_error.load);
  return step;
}

/* Replaces the steps of a staircase, which is that of the last range, by their limits, and removes
 * those that are not known. Returned: how many these are. Status: PO_NO_MEMORY. */
static po_status take_stairs(const bundle *b, const po_result *o, po_staircase *to, size_t *left) {
  double excess;
  const size_t known = steps_known(b, &excess);
  size_t end[SOLVES];
  po_range_group g;
  po_step *made = po_allocate(known, sizeof *made);
  if (!made)
    return PO_NO_MEMORY;
  *left = to->count - known;
  begin_behind(b, end);
  for (size_t n = known; n-- > 0 && step_before(b, end, &g);) {
    made[n] = limit_of(b, &g, n + 1 < known ? &made[n + 1] : NULL);
    take_cycles(b, &g, &made[n]);
    take_pull_off(o, &made[n]);
  }
  for (size_t k = 0; k < *left; ++k)
    free(to->step[k].cycle);
  free(to->step);
  to->step = made;
  to->count = known;
  return PO_OK;
}

static po_preload pressed(const po_path_state *state) {
  return (po_preload){state->approach, state->load};
}

/* The preloads of the pull-off, and the greatest pull-off of all preloads, which are not known
 * without steps. Given: whether no harder preload gives more. */
static void take_preloads(const po_staircase *s, bool complete, po_result *o) {
  for (size_t k = s->count; k-- > 0;)
    if (-s->step[k].pull_off.load == o->pull_off.force) {
      o->pull_off.pressed = pressed(&s->step[k].preload);
      o->pull_off.until = s->step[k].open ? (po_preload){NAN, NAN} : pressed(&s->step[k].until);
    }
  const po_step *step = po_staircase_greatest(s);
  o->pull_off_any.is_known = true;
  o->pull_off_any.complete = complete;
  o->pull_off_any.force = -step->pull_off.load;
  o->pull_off_any.force_error = step->pull_off_error.load;
  o->pull_off_any.approach = step->pull_off.approach;
  o->pull_off_any.approach_error = step->pull_off_error.approach;
  o->pull_off_any.pressed = pressed(&step->preload);
  o->pull_off_any.searched = pressed(&s->reached);
}

/* Moves the staircases of all ranges into the result, as limits. */
static po_status take_staircases(po_range_solves *s, po_result *o) {
  po_staircases *from = &s->solved[SOLVES - 1].staircase;
  po_status status = PO_OK;
  for (int test = 0; test < PO_TESTS && !status; ++test) {
    const bundle b = {s, test};
    size_t left = 0;
    if (test == PO_THROUGH_SPRING && !from->has_spring)
      continue;
    status = take_stairs(&b, o, &from->of[test], &left);
    if (test == PO_AT_APPROACH)
      o->range.stairs = (po_range_stairs){.are_known = !status,
                                          .least = s->range[SOLVES - 1],
                                          .greatest = s->range[0],
                                          .left_out = left};
  }
  if (status)
    return status;
  po_staircases_clear(&o->staircase);
  o->staircase = *from;
  o->has_staircases = true;
  o->ended = s->solved[SOLVES - 1].ended;
  bool complete = true;
  for (int k = 0; k < SOLVES; ++k)
    complete &= s->solved[k].pull_off_any.complete;
  take_preloads(&o->staircase.of[PO_AT_APPROACH], complete, o);
  *from = (po_staircases){0};
  return PO_OK;
}

po_status po_reduced_staircases(const po_ranges *ranges, po_reduced_solver *solve,
                                po_result *result) {
  po_range_solves s;
  bool known;
  po_status status =
      po_range_solves_make(ranges, PO_WANT_PRELOAD, judge, solve, &s, &result->work, &known);
  if (!status && known)
    status = take_staircases(&s, result);
  else if (!status)
    status = po_fail(PO_NOT_CONVERGED,
                     "the staircases with ranges of the attraction %.3g to %.3g times as great do "
                     "not have the same last step: expected the range exact",
                     ranges->range[ranges->count - 1], ranges->range[0]);
  po_range_solves_clear(&s);
  return status;
}
