/* Loops of loading and unloading at the true range, from those with greater ones. */
#include <math.h>
#include <stddef.h>

#include "po_load_unit.h"
#include "po_reduced_internal.h"

enum { SOLVES = PO_RANGES_OF_LIMIT };

/* The loops of one test at several ranges. */
typedef struct {
  const po_range_solves *of;
  int test;
} bundle;

static const po_loop *loop_at(const bundle *b, int k) {
  return &b->of->solved[k].hysteresis.of[b->test];
}

/* Whether two jumps of loops with different ranges are the same jump. */
static bool is_same_jump(const po_jump *a, const po_jump *b) {
  return a->loading == b->loading && isfinite(a->before.approach) == isfinite(b->before.approach) &&
         isfinite(a->after.approach) == isfinite(b->after.approach) &&
         isnan(a->energy_lost) == isnan(b->energy_lost);
}

/* Whether the loops of a test have the same jumps at all ranges. */
static bool is_same_at_all(const bundle *b) {
  const po_loop *first = loop_at(b, 0);
  bool same = true;
  for (int k = 1; k < SOLVES && same; ++k) {
    const po_loop *loop = loop_at(b, k);
    same = loop->jump_count == first->jump_count;
    for (size_t j = 0; j < first->jump_count && same; ++j)
      same = is_same_jump(&loop->jumps[j], &first->jumps[j]);
  }
  return same;
}

/* The loops of a test, or one of their jumps. */
enum { OF_LOOP = -1 };
static po_range_group group_of(const bundle *b, ptrdiff_t jump) {
  po_range_group g = {.request = b->of->request};
  for (int k = 0; k < SOLVES; ++k) {
    const po_loop *loop = loop_at(b, k);
    g.at[k] = jump < 0 ? (const char *)loop : (const char *)&loop->jumps[jump];
  }
  return g;
}

static po_path_state state_of(const bundle *b, const po_range_limit *limit, ptrdiff_t jump,
                              size_t offset, po_path_error *error, double *energy) {
  const po_range_group g = group_of(b, jump);
  return po_range_limit_of_state(&g, limit, offset, error, energy);
}

/* The energy lost in a jump. */
static double lost_in(const bundle *b, const po_range_limit *limit, ptrdiff_t jump, double *bound) {
  const po_range_group g = group_of(b, jump);
  return po_range_limit_of_number(&g, limit, offsetof(po_jump, energy_lost),
                                  offsetof(po_jump, energy_lost_error), bound);
}

/* Keeps the greatest errors of approaches and loads at the ends of jumps. */
static void take_greatest(const po_path_error *error, po_range_loops *worst) {
  worst->approach = fmax(worst->approach, error->approach);
  worst->load = fmax(worst->load, error->load);
}

/* The limit by which the numbers of a jump are found: a jump of loading from a fold depends on the
 * crest that jumps; one from infinitely far away does not. */
static const po_range_limit *limit_by(const bundle *b, const po_jump *jump) {
  const bool by_crest = jump->loading && isfinite(jump->before.approach);
  return by_crest ? &b->of->crests : &b->of->edges;
}

/* The limit of a jump, whose errors are then among the greatest of the loop. */
static po_jump jump_of(const bundle *b, ptrdiff_t index, po_loop *loop, po_range_loops *worst) {
  po_jump jump = loop_at(b, SOLVES - 1)->jumps[index];
  const po_range_limit *limit = limit_by(b, &jump);
  po_path_error error;
  double energy;
  jump.before = state_of(b, limit, index, offsetof(po_jump, before), &error, &energy);
  take_greatest(&error, worst);
  loop->energy_error = fmax(loop->energy_error, energy);
  jump.after = state_of(b, limit, index, offsetof(po_jump, after), &error, &energy);
  take_greatest(&error, worst);
  loop->energy_error = fmax(loop->energy_error, energy);
  jump.energy_lost = lost_in(b, limit, index, &jump.energy_lost_error);
  if (isnan(jump.energy_lost))
    jump.energy_lost_error = NAN;
  return jump;
}

/* The state of greatest tension is the pull-off of the result if it is the same to the errors. */
static void take_pull_off(const bundle *b, const po_result *o, po_loop *loop) {
  double ignored;
  loop->pull_off = state_of(b, &b->of->edges, OF_LOOP, offsetof(po_loop, pull_off),
                            &loop->pull_off_error, &ignored);
  const double error = loop->pull_off_error.load + o->pull_off.force_error;
  if (!(fabs(-loop->pull_off.load - o->pull_off.force) <= error))
    return;
  loop->pull_off.load = -o->pull_off.force;
  loop->pull_off.approach = o->pull_off.approach;
  loop->pull_off.contact_radius = o->pull_off.contact_radius;
  loop->pull_off_error =
      (po_path_error){.load = o->pull_off.force_error, .approach = o->pull_off.approach_error};
}

/* Replaces the numbers of a loop, which is that of the last range, by their limits. */
static void take_loop(const bundle *b, const po_result *o, po_loop *loop, po_range_loops *worst) {
  const double excess = loop->work - loop->energy_lost;
  po_path_error error;
  double energy;
  loop->preload = state_of(b, &b->of->edges, OF_LOOP, offsetof(po_loop, preload), &error, &energy);
  loop->energy_error = fmax(loop->energy_error, energy);
  take_pull_off(b, o, loop);
  loop->energy_lost = loop->energy_lost_error = 0.0;
  for (size_t j = 0; j < loop->jump_count; ++j) {
    loop->jumps[j] = jump_of(b, (ptrdiff_t)j, loop, worst);
    loop->energy_lost += loop->jumps[j].energy_lost;
    loop->energy_lost_error += loop->jumps[j].energy_lost_error;
  }
  loop->work = loop->energy_lost + excess;
  loop->work_error = loop->energy_lost_error + fabs(excess);
}

/* -- The solves -- */

/* The error of the limit of the energy that a loop loses. */
static double error_of_loss(const bundle *b) {
  const po_loop *loop = loop_at(b, SOLVES - 1);
  double sum = 0.0, bound;
  for (size_t j = 0; j < loop->jump_count; ++j) {
    lost_in(b, limit_by(b, &loop->jumps[j]), (ptrdiff_t)j, &bound);
    sum += bound;
  }
  return sum;
}

/* Whether there are loops at given load with the same jumps at all ranges. */
static bool is_known_at_load(const po_range_solves *l) {
  const bundle b = {l, PO_AT_LOAD};
  bool has_load = true;
  for (int k = 0; k < SOLVES; ++k)
    has_load &= l->solved[k].hysteresis.has_load;
  return has_load && is_same_at_all(&b);
}

/* Whether the limits of the loops at given approach and through a spring are known, and those of
 * the loops at given load, if the last range has one. */
static bool judge(const po_range_solves *l, double *excess) {
  double greatest = 0.0;
  for (int test = 0; test < PO_TESTS; ++test) {
    const bundle b = {l, test};
    if (test == PO_AT_LOAD || (test == PO_THROUGH_SPRING && isnan(l->request->stiffness)))
      continue;
    if (!is_same_at_all(&b))
      return false;
    const double lost = l->request->mesh.tolerance * loop_at(&b, SOLVES - 1)->energy_lost;
    greatest = fmax(greatest, error_of_loss(&b) / lost);
  }
  const bool lacks_load = l->solved[SOLVES - 1].hysteresis.has_load && !is_known_at_load(l);
  *excess = lacks_load ? INFINITY : greatest;
  return true;
}

/* Whether every jump of loading is still made at the true range: before its approach is that of the
 * preload. */
static bool jumps_before_preload(const po_loop *loop, const po_range_loops *worst) {
  for (size_t j = 0; j < loop->loading_jumps; ++j) {
    const double approach = loop->jumps[j].before.approach;
    if (isfinite(approach) && !(approach + worst->approach < loop->preload.approach))
      return false;
  }
  return true;
}

/* Moves the loops of all ranges into the result, as limits. */
static po_status take_loops(po_range_solves *l, po_result *o) {
  po_hysteresis *from = &l->solved[SOLVES - 1].hysteresis, to = *from;
  po_range_loops *worst = &o->range.loops;
  *worst =
      (po_range_loops){.are_known = true, .least = l->range[SOLVES - 1], .greatest = l->range[0]};
  to.has_load = is_known_at_load(l);
  bool made = true;
  /* The copies share the jumps of `from`: each is read before it is replaced. */
  for (int test = 0; test < PO_TESTS; ++test) {
    const bundle b = {l, test};
    if (test == PO_AT_LOAD ? !to.has_load : test == PO_THROUGH_SPRING && !to.has_spring)
      continue;
    take_loop(&b, o, &to.of[test], worst);
    made = made && (test != PO_AT_APPROACH || jumps_before_preload(&to.of[test], worst));
  }
  o->hysteresis = to;
  o->has_hysteresis = true;
  *from = (po_hysteresis){0};
  if (made)
    return PO_OK;
  o->has_hysteresis = o->range.loops.are_known = false;
  return po_fail(PO_NOT_CONVERGED,
                 "with the true range of the attraction a jump of loading may lie "
                 "beyond the preload: expected another preload, or the range exact");
}

po_status po_reduced_loops(const po_ranges *ranges, po_reduced_solver *solve, po_result *result) {
  po_range_solves l;
  bool known;
  po_status status =
      po_range_solves_make(ranges, PO_WANT_HYSTERESIS, judge, solve, &l, &result->work, &known);
  if (!status && known)
    status = take_loops(&l, result);
  else if (!status)
    status = po_fail(PO_NOT_CONVERGED,
                     "the loops with ranges of the attraction %.3g to %.3g times as great do not "
                     "have the same jumps: expected the range exact",
                     ranges->range[ranges->count - 1], ranges->range[0]);
  po_range_solves_clear(&l);
  return status;
}
