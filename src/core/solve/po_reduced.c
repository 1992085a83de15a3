#include "po_reduced.h"

#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_load_unit.h"
#include "po_rigid.h"
#include "po_solve_parts.h"

/* Width of an edge, as po_reduced_width, with the greatest and the least range that is solved. Half
 * the width changes the force by about as much of it; at the least one the extrapolated force of
 * all scenes tried was right to 1e-8. */
#define WIDEST 4e-2
static const double NARROWEST = 1e-5;

/* The widths of the first and the last of SOLVES ranges differ by this factor, 2^(SOLVES - 1). */
const double PO_REDUCED_MOST_WIDTH = WIDEST / 32.0;

/* Below this width a scene is solved so without being asked, over the square root of the tolerance:
 * the least range that is solved is then at least three times the true one. A smooth sphere of
 * a greater width than CHOSEN_SMOOTH, a Tabor parameter below 14,000, is solved in some two seconds
 * with the true range, which gives all special points. */
static const double CHOSEN = 6e-3, CHOSEN_SMOOTH = 5e-9;

/* The range decreases by this factor from solve to solve. */
static const double STEP = M_SQRT2;

/* The tolerance of the solves relative to that of the request: the extrapolation multiplies their
 * errors by up to 28. */
static const double OF_TOLERANCE = 0.03;

/* Part of the tolerance at which the extrapolated force is accurate enough. */
static const double ENOUGH = 0.5;

/* Beyond these errors the limit of a special point or a preload is not stated: of the load,
 * relative to the tolerance times the pull-off force; of the approach, to a^2/R at pull-off. */
static const double MOST_OF_POINT = 10.0, CLOSE = 1e-3;

/* A crest of radius R jumps into contact from the gap D at which the attraction w eps^2/D^3 on the
 * area R D deflects the surface by about D: D^(7/2) = w eps^2 sqrt(R)/E*, so that D, and with it
 * approach and load, change with the power 4/7 of the range. Over the ranges that are solved, of
 * ratio 5.7, they change by 1.7 times what is left. (Smooth spheres of Tabor parameters 100 to
 * 10,000 have the power 0.56, a second crest on gelatin 0.54.) AGAIN is 2.5 times what is left. */
static const double AGAIN = 1.5;

/* Terms of F(s), found from as many solves; one solve more for the error; how many solves in a row
 * may fail; and how many more are made if it is not known on which stretch loading is reversed. */
enum { TERMS = 5, SOLVES = TERMS + 1, FAILURES = 4, FURTHER = 3 };

double po_reduced_width(const po_scene *scene) {
  const double length = po_scene_is_wavy(scene) ? po_initial_gap_detail(scene) : INFINITY;
  return 1.0 / (po_scene_coupling(scene) * fmin(length, po_scene_gamma(scene)));
}

bool po_reduced_applies(const po_request *request) {
  const po_scene *scene = &request->scene;
  return request->creep.kind == PO_CREEP_NONE && request->mesh.scheme == PO_PANEL &&
         !po_rigid_suffices(scene) && po_profile_is_sphere(&scene->profile) &&
         po_law_numbers_of(&scene->law)->exponent == 3.0 &&
         !(request->want & ~(unsigned)PO_WANT_THEORIES) && isnan(request->stiffness) &&
         isnan(request->approach_start) && isnan(request->profile_approach) && !request->show &&
         po_reduced_width(scene) < PO_REDUCED_MOST_WIDTH;
}

bool po_reduced_is_chosen(const po_request *request) {
  const double chosen =
      po_scene_is_wavy(&request->scene) ? CHOSEN * sqrt(request->mesh.tolerance) : CHOSEN_SMOOTH;
  return po_reduced_applies(request) &&
         (request->range == PO_RANGE_REDUCED ||
          (request->range == PO_RANGE_AUTO && po_reduced_width(&request->scene) < chosen));
}

bool po_reduced_is_resort(const po_request *request, po_status status) {
  const bool stuck = status == PO_STEP_TOO_SMALL || status == PO_OUT_OF_NODES ||
                     status == PO_NOT_CONVERGED || status == PO_TOO_MANY_POINTS;
  return stuck && po_reduced_applies(request);
}

/* The request with a range `s` times as great: every length in units of eps is so much smaller, and
 * so is the Tabor parameter; loads in pi w R are the same. */
static po_request with_range(const po_request *request, double s) {
  po_request r = *request;
  r.scene.tabor /= s;
  r.scene.radius /= s;
  r.scene.outer_radius /= s;
  r.scene.amplitude /= s;
  r.scene.wavelength /= s;
  for (size_t k = 0; k < r.scene.more_waves; ++k) {
    r.scene.more[k].amplitude /= s;
    r.scene.more[k].length /= s;
  }
  r.preload.approach /= s;
  r.approach_end /= s;
  r.range = PO_RANGE_EXACT;
  r.mesh.tolerance = fmax(OF_TOLERANCE * r.mesh.tolerance, PO_LEAST_TOLERANCE);
  return r;
}

po_request po_reduced_narrowest(const po_request *request) {
  const double s = sqrt(NARROWEST / po_reduced_width(&request->scene));
  return with_range(request, fmax(1.0, s));
}

/* -- Extrapolation -- */

/* The last solves: their ranges, decreasing, and results; and how many there were. */
typedef struct {
  double range[SOLVES];
  po_result result[SOLVES];
  int count;
} solves;

/* The weights of values at the ranges, of which the sum is F(1). Given: the number of terms, and
 * the first of as many values. The unknowns are eliminated without pivots, of which none is small:
 * ranges differ by STEP or more. */
static void weights_of(const solves *s, int first, int terms, double weight[SOLVES]) {
  double a[TERMS][TERMS + 1];
  const double unit = s->range[first + terms - 1];
  for (int k = 0; k <= terms; ++k) {
    const double x = (k < terms ? s->range[first + k] : 1.0) / unit, l = po_log(x);
    const double term[TERMS] = {1.0, x * x, x * x * l, x * x * x, x * x * x * l};
    for (int t = 0; t < terms; ++t)
      a[t][k] = term[t];
  }
  for (int k = 0; k < terms; ++k)
    for (int t = 0; t < terms; ++t) {
      if (t == k)
        continue;
      const double factor = a[t][k] / a[k][k];
      for (int j = k; j <= terms; ++j)
        a[t][j] -= factor * a[k][j];
    }
  for (int k = 0; k < SOLVES; ++k)
    weight[k] = 0.0;
  for (int k = 0; k < terms; ++k)
    weight[first + k] = a[k][terms] / a[k][k];
}

/* A number of the results at the true range. */
typedef struct {
  /* Weights of the values: of all terms by the last solves, by those before, and with one term
   * less.
   */
  double weight[SOLVES], before[SOLVES], fewer[SOLVES];
} limit;

static limit limit_of(const solves *s) {
  limit l;
  weights_of(s, SOLVES - TERMS, TERMS, l.weight);
  weights_of(s, SOLVES - TERMS - 1, TERMS, l.before);
  weights_of(s, SOLVES - TERMS + 1, TERMS - 1, l.fewer);
  return l;
}

/* Returned: the limit of values, and a bound of its error: by half the widths of the edges the
 * error of the limit falls to half or less, so that it is at most the change by the last solve;
 * where that change is small by chance, the last term says more. */
static double at_limit(const limit *l, const double value[SOLVES], const double error[SOLVES],
                       double *bound) {
  double sum = 0.0, before = 0.0, fewer = 0.0, noise = 0.0;
  for (int k = 0; k < SOLVES; ++k) {
    sum += l->weight[k] * value[k];
    before += l->before[k] * value[k];
    fewer += l->fewer[k] * value[k];
    noise += fabs(l->weight[k]) * error[k];
  }
  *bound = fmax(fabs(sum - before), fabs(sum - fewer)) + noise;
  return sum;
}

/* -- Results at the true range -- */

/* Gathers a member of every result. */
#define GATHER(member)                                                                             \
  {                                                                                                \
    s->result[0].member, s->result[1].member, s->result[2].member, s->result[3].member,            \
        s->result[4].member, s->result[5].member                                                   \
  }
_Static_assert(SOLVES == 6, "GATHER has six results");

/* Sets a member and its error to the limit. */
#define TO_LIMIT(member, error_member)                                                             \
  do {                                                                                             \
    const double values[] = GATHER(member), errors[] = GATHER(error_member);                       \
    o->member = at_limit(l, values, errors, &o->error_member);                                     \
  } while (false)

static void limit_of_pull_off(const solves *s, const limit *l, po_result *o) {
  static const double none[SOLVES] = {0.0};
  double ignored;
  TO_LIMIT(pull_off.force, pull_off.force_error);
  TO_LIMIT(pull_off.approach, pull_off.approach_error);
  TO_LIMIT(pull_off.contact_radius, pull_off.contact_radius_error);
  if (o->pull_off.has_sensitivity) {
    const double tabor[] = GATHER(pull_off.sensitivity.tabor),
                 radius[] = GATHER(pull_off.sensitivity.radius),
                 amplitude[] = GATHER(pull_off.sensitivity.amplitude),
                 wavelength[] = GATHER(pull_off.sensitivity.wavelength);
    o->pull_off.sensitivity.tabor = at_limit(l, tabor, none, &ignored);
    o->pull_off.sensitivity.radius = at_limit(l, radius, none, &ignored);
    o->pull_off.sensitivity.amplitude = at_limit(l, amplitude, none, &ignored);
    o->pull_off.sensitivity.wavelength = at_limit(l, wavelength, none, &ignored);
  }
}

/* The greatest pull-off of all preloads is known if it is in every result, and the same pull-off in
 * all or in none. */
static void limit_of_any(const solves *s, const limit *l, po_result *o) {
  bool known = true, same = true;
  for (int k = 0; k < SOLVES; ++k) {
    const po_result *r = &s->result[k];
    known =
        known && r->pull_off_any.is_known && r->pull_off_any.complete == o->pull_off_any.complete;
    same = same && r->pull_off_any.force == r->pull_off.force;
  }
  o->pull_off_any.is_known = known;
  if (same) {
    o->pull_off_any.force = o->pull_off.force;
    o->pull_off_any.force_error = o->pull_off.force_error;
    o->pull_off_any.approach = o->pull_off.approach;
    o->pull_off_any.approach_error = o->pull_off.approach_error;
  } else if (known) {
    TO_LIMIT(pull_off_any.force, pull_off_any.force_error);
    TO_LIMIT(pull_off_any.approach, pull_off_any.approach_error);
  }
}

/* The greatest errors of loads and approaches of which the limit is called known, pi w R and eps.
 */
typedef struct {
  double load, approach;
} known;

/* Replaces a special point by its limit. Given: the same one of every result. Returned: whether the
 * limit is known. That of a jump into contact from afar, of which the place depends on the range,
 * is not. */
static bool limit_of_point(const po_special_point *const of[SOLVES], const limit *l,
                           const known *most, po_special_point *to) {
  double load[SOLVES], approach[SOLVES], radius[SOLVES], energy[SOLVES], errors[4][SOLVES];
  for (int k = 0; k < SOLVES; ++k) {
    if (of[k]->kind != to->kind)
      return false;
    load[k] = of[k]->load;
    approach[k] = of[k]->approach;
    radius[k] = of[k]->contact_radius;
    energy[k] = of[k]->energy;
    errors[0][k] = of[k]->load_error;
    errors[1][k] = of[k]->approach_error;
    errors[2][k] = of[k]->contact_radius_error;
    errors[3][k] = of[k]->energy_error;
  }
  to->load = at_limit(l, load, errors[0], &to->load_error);
  to->approach = at_limit(l, approach, errors[1], &to->approach_error);
  to->contact_radius = at_limit(l, radius, errors[2], &to->contact_radius_error);
  to->energy = at_limit(l, energy, errors[3], &to->energy_error);
  return to->load_error <= most->load && to->approach_error <= most->approach;
}

/* Replaces the special points of a list of the last result by their limits, and leaves out those of
 * which the limit is not known. Given: the list of each result. The points are counted from the
 * ends of the lists: the range changes how many there are where the bodies jump into contact from
 * afar. Returned: the number of points left. */
static size_t limit_of_points(const po_special_point *const list[SOLVES],
                              const size_t count[SOLVES], const limit *l, const known *most,
                              po_special_point *to) {
  size_t left = 0;
  size_t least = count[0];
  for (int k = 1; k < SOLVES; ++k)
    least = count[k] < least ? count[k] : least;
  for (size_t back = least; back > 0; --back) {
    const po_special_point *of[SOLVES];
    for (int k = 0; k < SOLVES; ++k)
      of[k] = &list[k][count[k] - back];
    po_special_point point = *of[SOLVES - 1];
    if (limit_of_point(of, l, most, &point))
      to[left++] = point;
  }
  return left;
}

/* A preload at the true range; NAN if its limit is not known. */
static void limit_of_preload(const limit *l, const known *most, const po_preload of[SOLVES],
                             po_preload *to) {
  static const double none[SOLVES] = {0.0};
  double approach[SOLVES], load[SOLVES], error;
  for (int k = 0; k < SOLVES; ++k) {
    approach[k] = of[k].approach;
    load[k] = of[k].load;
  }
  to->load = at_limit(l, load, none, &error);
  to->approach = at_limit(l, approach, none, &error);
  if (!(error <= most->approach))
    *to = (po_preload){NAN, NAN};
}

/* The result at the true range, in place of the last result. */
static void to_limit(solves *s, const po_request *request) {
  po_result *o = &s->result[SOLVES - 1];
  const limit l = limit_of(s);
  const double before = o->pull_off.force;
  const po_special_point *const folds[] = GATHER(folds), *const extrema[] = GATHER(extrema);
  const size_t fold_count[] = GATHER(fold_count), extremum_count[] = GATHER(extremum_count);
  o->range.is_reduced = true;
  o->range.least = s->range[SOLVES - 1];
  o->range.greatest = s->range[0];
  limit_of_pull_off(s, &l, o);
  limit_of_any(s, &l, o);
  o->range.change = o->pull_off.force - before;
  const double radius = o->pull_off.contact_radius, scale = request->scene.radius;
  const known most = {MOST_OF_POINT * request->mesh.tolerance * o->pull_off.force,
                      CLOSE * radius * radius / scale};
  o->fold_count = limit_of_points(folds, fold_count, &l, &most, o->folds);
  o->extremum_count = limit_of_points(extrema, extremum_count, &l, &most, o->extrema);
  limit_of_preload(&l, &most, (const po_preload[])GATHER(pull_off.pressed), &o->pull_off.pressed);
  limit_of_preload(&l, &most, (const po_preload[])GATHER(pull_off.until), &o->pull_off.until);
  limit_of_preload(&l, &most, (const po_preload[])GATHER(pull_off_any.pressed),
                   &o->pull_off_any.pressed);
}

/* -- Where loading jumps -- */

/* A smaller range lets loading jump later: the crest of a wave is attracted from less far away. The
 * place of such a jump changes with the power 4/7 of the range, so that its limit is not known by
 * the expansion above; by how much it changes is. Where loading might reach the preload before a
 * jump at the true range, and did not at a greater one, it would be reversed on another stretch of
 * the branch, and another pull-off would follow. */

/* The jumps of loading before the preload, the last one first: the greatest load since the jump
 * before, pi w R, and the approach, eps. */
enum { MOST_JUMPS = 16 };
typedef struct {
  double load[MOST_JUMPS], approach[MOST_JUMPS];
  int count;
} jumps;

static void add_jump(jumps *of, double load, double approach) {
  of->count += of->count < MOST_JUMPS;
  for (int k = of->count; --k > 0;) {
    of->load[k] = of->load[k - 1];
    of->approach[k] = of->approach[k - 1];
  }
  of->load[0] = load;
  of->approach[0] = approach;
}

/* The special point that follows along the branch; NULL: there is none. */
static const po_special_point *next_point(const po_result *o, size_t *fold, size_t *extremum) {
  const bool folds = *fold < o->fold_count, extrema = *extremum < o->extremum_count;
  if (!folds && !extrema)
    return NULL;
  const bool takes_fold =
      folds && (!extrema || o->folds[*fold].position < o->extrema[*extremum].position);
  return takes_fold ? &o->folds[(*fold)++] : &o->extrema[(*extremum)++];
}

/* Loading visits the points whose approach exceeds that of all points before. */
static jumps jumps_of(const po_result *o, const po_preload *preload) {
  jumps of = {.count = 0};
  double load = -INFINITY, approach = -INFINITY;
  size_t fold = 0, extremum = 0;
  for (const po_special_point *p; (p = next_point(o, &fold, &extremum));) {
    if (!(p->approach >= approach) || (p->kind != PO_JUMP_IN && p->kind != PO_MAXIMUM))
      continue;
    if (p->load >= preload->load || p->approach >= preload->approach)
      break;
    approach = p->approach;
    load = fmax(load, p->load);
    if (p->kind == PO_JUMP_IN) {
      add_jump(&of, load, approach);
      load = -INFINITY;
    }
  }
  return of;
}

/* The range of numbers, of which there may be none. */
typedef struct {
  double least, most;
} spread;

static void widen(spread *s, double value) {
  s->least = fmin(s->least, value);
  s->most = fmax(s->most, value);
}

/* Whether a number that loading reaches before it jumps stays below the preload at the true range:
 * by AGAIN times as much as it has changed over the ranges that were solved. */
static bool stays_below(const spread *s, double preload) {
  return isnan(preload) || s->most + AGAIN * (s->most - s->least) < preload;
}

/* Whether loading is reversed on the same stretch at the true range. */
static bool is_same_stretch(const solves *s, const po_request *request) {
  const po_preload preload = po_request_preload(request);
  jumps of[SOLVES];
  for (int k = 0; k < SOLVES; ++k)
    of[k] = jumps_of(&s->result[k], &preload);
  for (int j = 0; j < MOST_JUMPS; ++j) {
    spread load = {INFINITY, -INFINITY}, approach = load;
    for (int k = 0; k < SOLVES; ++k)
      if (j < of[k].count) {
        widen(&load, of[k].load[j]);
        widen(&approach, of[k].approach[j]);
      }
    if (load.most > -INFINITY &&
        !(stays_below(&load, preload.load) && stays_below(&approach, preload.approach)))
      return false;
  }
  return true;
}

/* The error of the extrapolated force over the tolerance times the force; INFINITY if there are too
 * few results, or it is not known on which stretch loading is reversed. */
static double excess_of(const solves *s, const po_request *request) {
  const double tolerance = request->mesh.tolerance;
  if (s->count < SOLVES || !is_same_stretch(s, request))
    return INFINITY;
  const limit l = limit_of(s);
  const double force[] = GATHER(pull_off.force), errors[] = GATHER(pull_off.force_error);
  double error;
  const double value = at_limit(&l, force, errors, &error);
  return error / (tolerance * fabs(value));
}

/* -- The solves -- */

/* Adds a result, the oldest one going. */
static void add_result(solves *s, double range, const po_result *result) {
  po_result_clear(&s->result[0]);
  for (int k = 1; k < SOLVES; ++k) {
    s->range[k - 1] = s->range[k];
    s->result[k - 1] = s->result[k];
  }
  s->range[SOLVES - 1] = range;
  s->result[SOLVES - 1] = *result;
  ++s->count;
}

/* The watcher of a request, whose approaches are in its own units. */
typedef struct {
  const po_request *request;
  double range;
} watcher;

static void watch_scaled(void *of, double approach, double load) {
  const watcher *w = of;
  w->request->watch(w->request->watcher, approach * w->range, load);
}

static po_status solve_one(const po_request *request, double range, po_reduced_solver *solve,
                           po_result *result) {
  po_request r = with_range(request, range);
  watcher w = {request, range};
  if (r.watch) {
    r.watch = watch_scaled;
    r.watcher = &w;
  }
  const po_status status = solve(&r, result);
  po_load_unit_lengthen(result, range);
  return status;
}

static bool ends(po_status status) {
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED || status == PO_OUT_OF_TIME ||
         status == PO_BAD_INPUT;
}

/* Fails because the error stays above the tolerance. */
static po_status inaccurate(const po_request *request, const po_result *o, double excess) {
  const double unit = po_scene_load_unit(&request->scene);
  return po_fail(PO_NOT_CONVERGED,
                 "the pull-off force with ranges of the attraction %.3g to %.3g times as great "
                 "leads to %.6g with an error of %.2g, %.2g times the tolerance: expected a "
                 "larger tolerance",
                 o->range.least, o->range.greatest, o->pull_off.force * unit,
                 o->pull_off.force_error * unit, excess);
}

static po_status undecided(po_result *o) {
  o->has_pull_off = o->pull_off_any.is_known = false;
  return po_fail(
      PO_NOT_CONVERGED,
      "with ranges of the attraction %.3g to %.3g times as great loading jumps so close "
      "to the preload that with the true one it may be reversed before: expected another "
      "preload, or the range exact",
      o->range.least, o->range.greatest);
}

/* The result by all solves. Returned: its status. */
static po_status conclude(solves *s, const po_request *request, double excess, po_result *result) {
  po_message_clear();
  to_limit(s, request);
  po_result_clear(result);
  *result = s->result[SOLVES - 1];
  s->result[SOLVES - 1] = po_result_none();
  if (isinf(excess))
    return undecided(result);
  return excess > PO_MOST_EXCESS ? inaccurate(request, result, excess) : PO_OK;
}

po_status po_reduced_solve(const po_request *request, po_reduced_solver *solve, po_result *result) {
  const double width = po_reduced_width(&request->scene);
  solves s = {.count = 0};
  po_work work = {0};
  po_status status = PO_OK;
  double excess = INFINITY;
  int failures = 0;
  for (int k = 0; k < SOLVES; ++k)
    s.result[k] = po_result_none();
  *result = po_result_none();
  for (double range = sqrt(WIDEST / width);
       range > 1.0 && width * range * range > NARROWEST && !(excess <= ENOUGH) &&
       !(isinf(excess) && s.count >= SOLVES + FURTHER);
       range /= STEP) {
    po_result one;
    status = solve_one(request, range, solve, &one);
    po_work_add(&one.work, &work);
    failures = status ? failures + 1 : 0;
    if (status || !one.has_pull_off) {
      po_result_clear(result);
      *result = one;
    } else {
      add_result(&s, range, &one);
      excess = excess_of(&s, request);
    }
    if (ends(status) || failures >= FAILURES)
      break;
  }
  if (!ends(status) && s.count >= SOLVES)
    status = conclude(&s, request, excess, result);
  result->work = work;
  for (int k = 0; k < SOLVES; ++k)
    po_result_clear(&s.result[k]);
  return status;
}
