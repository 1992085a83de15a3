/* Loops of loading and unloading at the true range, from those with greater ones. */
#include <math.h>
#include <stddef.h>

#include "po_load_unit.h"
#include "po_reduced_internal.h"

/* Every second range, of which each is half the one before; and the most of them. */
enum { SOLVES = PO_RANGES_OF_LIMIT, STRIDE = 2, MOST = 9 };

/* Part of the tolerance at which the energy lost is accurate enough. */
static const double ENOUGH = 0.5;

/* The last solves with loops, in units of the true range, and the limits of numbers that depend on
 * contact edges only, and of those at jumps of loading. */
typedef struct {
  const po_request *request;
  double range[SOLVES];
  po_result solved[SOLVES];
  int count;
  po_range_limit edges, crests;
} loops_of_ranges;

/* The loops of one test at several ranges. */
typedef struct {
  const loops_of_ranges *of;
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

/* The limit of a number of the loops, at an offset of each of them or of a jump. Given: the offset
 * of its error; NO_ERROR: it is of the order of the tolerance. Returned: also *bound. A number that
 * is not finite is that of the last range. */
enum { OF_LOOP = -1, NO_ERROR = 0 };
static double limit_of(const bundle *b, const po_range_limit *limit, ptrdiff_t jump, size_t offset,
                       size_t error_offset, double *bound) {
  double value[SOLVES], error[SOLVES];
  bool finite = true;
  for (int k = 0; k < SOLVES; ++k) {
    const po_loop *loop = loop_at(b, k);
    const char *owner = jump < 0 ? (const char *)loop : (const char *)&loop->jumps[jump];
    value[k] = *(const double *)(const void *)(owner + offset);
    error[k] = error_offset ? *(const double *)(const void *)(owner + error_offset)
                            : po_reduced_tolerance(b->of->request) * fabs(value[k]);
    finite &= isfinite(value[k]);
  }
  *bound = 0.0;
  return finite ? po_range_limit_at(limit, value, error, bound) : value[SOLVES - 1];
}

/* The limit of a state, and in *error bounds of the errors of approach and load, *energy that of
 * its energy. */
static po_path_state state_of(const bundle *b, const po_range_limit *limit, ptrdiff_t jump,
                              size_t offset, po_path_error *error, double *energy) {
  const po_loop *loop = loop_at(b, SOLVES - 1);
  const char *owner = jump < 0 ? (const char *)loop : (const char *)&loop->jumps[jump];
  const po_path_state last = *(const po_path_state *)(const void *)(owner + offset);
  double ignored;
#define MEMBER(name) (offset + offsetof(po_path_state, name))
  return (po_path_state){
      .approach = limit_of(b, limit, jump, MEMBER(approach), NO_ERROR, &error->approach),
      .load = limit_of(b, limit, jump, MEMBER(load), NO_ERROR, &error->load),
      .energy = limit_of(b, limit, jump, MEMBER(energy), NO_ERROR, energy),
      .contact_radius = limit_of(b, limit, jump, MEMBER(contact_radius), NO_ERROR, &ignored),
      .position = last.position};
#undef MEMBER
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
  jump.energy_lost = limit_of(b, limit, index, offsetof(po_jump, energy_lost),
                              offsetof(po_jump, energy_lost_error), &jump.energy_lost_error);
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

static void clear(loops_of_ranges *l) {
  for (int k = 0; k < l->count; ++k)
    po_result_clear(&l->solved[k]);
  l->count = 0;
}

/* Solves with one range and adds its loops; the first gives way if there are SOLVES. */
static po_status add_range(loops_of_ranges *l, double range, po_reduced_solver *solve,
                           po_work *work) {
  po_request request = po_reduced_request(l->request, range);
  request.want = PO_WANT_HYSTERESIS;
  request.watch = NULL;
  po_result solved;
  const po_status status = solve(&request, NULL, &solved);
  po_work_add(&solved.work, work);
  if (status || !solved.has_hysteresis) {
    po_result_clear(&solved);
    return status;
  }
  if (l->count == SOLVES) {
    po_result_clear(&l->solved[0]);
    for (int k = 1; k < SOLVES; ++k) {
      l->solved[k - 1] = l->solved[k];
      l->range[k - 1] = l->range[k];
    }
    --l->count;
  }
  po_load_unit_lengthen(&solved, range);
  l->range[l->count] = range;
  l->solved[l->count++] = solved;
  return PO_OK;
}

/* The error of the limit of the energy that a loop loses. */
static double error_of_loss(const bundle *b) {
  const po_loop *loop = loop_at(b, SOLVES - 1);
  double sum = 0.0, bound;
  for (size_t j = 0; j < loop->jump_count; ++j) {
    limit_of(b, limit_by(b, &loop->jumps[j]), (ptrdiff_t)j, offsetof(po_jump, energy_lost),
             offsetof(po_jump, energy_lost_error), &bound);
    sum += bound;
  }
  return sum;
}

/* Whether the limits of the loops at given approach and through a spring are known; and the
 * greatest error of the energy lost over the tolerance times the energy. */
static bool is_known(loops_of_ranges *l, double *excess) {
  *excess = INFINITY;
  if (l->count < SOLVES)
    return false;
  l->edges = po_range_limit_of(PO_BY_EDGES, l->range);
  l->crests = po_range_limit_of(PO_BY_CRESTS, l->range);
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
  *excess = greatest;
  return true;
}

/* Whether there are loops at given load with the same jumps at all ranges. */
static bool is_known_at_load(const loops_of_ranges *l) {
  const bundle b = {l, PO_AT_LOAD};
  bool has_load = l->count == SOLVES;
  for (int k = 0; k < l->count; ++k)
    has_load &= l->solved[k].hysteresis.has_load;
  return has_load && is_same_at_all(&b);
}

/* Whether a loop at given load, which the last range has, needs another one. */
static bool lacks_load(const loops_of_ranges *l) {
  return l->count > 0 && l->solved[l->count - 1].hysteresis.has_load && !is_known_at_load(l);
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
static po_status take_loops(loops_of_ranges *l, po_result *o) {
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
  loops_of_ranges l = {.request = ranges->request};
  po_status status = PO_OK;
  double excess = INFINITY;
  bool known = false;
  for (int at = 0, made = 0;
       at < ranges->count && made < MOST && !status && (excess > ENOUGH || lacks_load(&l));
       at += STRIDE, ++made) {
    status = add_range(&l, ranges->range[at], solve, &result->work);
    const bool fails = status && !po_reduced_ends(status);
    if (fails)
      status = PO_OK;
    if (fails && known) /* smaller ranges are harder */
      break;
    if (fails)
      clear(&l);
    known = is_known(&l, &excess);
  }
  if (!status && known)
    status = take_loops(&l, result);
  else if (!status)
    status = po_fail(PO_NOT_CONVERGED,
                     "the loops with ranges of the attraction %.3g to %.3g times as great do not "
                     "have the same jumps: expected the range exact",
                     ranges->range[ranges->count - 1], ranges->range[0]);
  clear(&l);
  return status;
}
