#include "po_particle_law.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_elementary.h"
#include "po_hermite.h"
#include "po_margins.h"
#include "po_memory.h"
#include "po_path.h"
#include "po_solve.h"

const double PO_LAW_PRELOAD = 10.0;

/* -- One stretch of stable equilibria, a function of the approach -- */

typedef struct {
  po_path path; /* its points: approach ascending */
  const po_result *result;
  double unit;                                  /* sqrt(R eps), eps */
  double *approach, *position, *radius, *slope; /* of the points, the slope by the position; owned,
                                                   one array */
} curve;

static po_status begin_curve(const po_result *result, double radius, size_t first, size_t last,
                             curve *c) {
  const size_t count = last - first + 1;
  *c = (curve){.path = {&result->curve[first], count, 0.0}, .result = result, .unit = sqrt(radius)};
  if (count < 4)
    return po_fail(PO_BAD_INPUT,
                   "the stable equilibria from approach %.6g to %.6g have %zu points: "
                   "expected a greater preload",
                   result->curve[first].approach, result->curve[last].approach, count);
  c->approach = po_allocate(4 * count, sizeof(double));
  if (!c->approach)
    return PO_NO_MEMORY;
  c->radius = c->approach + count;
  c->slope = c->radius + count;
  c->position = c->slope + count;
  for (size_t k = 0; k < count; ++k) {
    c->approach[k] = c->path.point[k].approach;
    c->position[k] = c->path.point[k].position;
    c->radius[k] = c->path.point[k].contact_radius / c->unit;
  }
  const po_status status = po_spline_slopes(count, c->position, c->radius, c->slope);
  if (!status)
    po_spline_limit(count, c->position, c->radius, c->slope);
  for (size_t k = 0; k < count && !status; ++k)
    if (c->radius[k] == 0.0)
      c->slope[k] = 0.0;
  return status;
}

/* The index of the last point at or before an overlap, and not the last point. */
static size_t segment_of(const curve *c, double overlap) {
  size_t low = 0, high = c->path.count - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (c->approach[middle] <= overlap)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* Whether a special point of a list is a point of the curve. */
static bool is_special(const curve *c, const po_special_point *list, size_t count, size_t point) {
  for (size_t k = 0; k < count; ++k)
    if (list[k].position == c->path.point[point].position)
      return true;
  return false;
}

static bool is_extremum(const curve *c, size_t point) {
  return is_special(c, c->result->extrema, c->result->extremum_count, point);
}

/* The knot at a point of the curve; its stiffness is infinite at a fold. */
static po_particle_knot knot_of(const curve *c, size_t point) {
  const po_curve_point *p = &c->path.point[point];
  double stiffness = p->load_rate / p->approach_rate, widens = c->slope[point] / p->approach_rate;
  if (is_extremum(c, point))
    stiffness = 0.0;
  else if (is_special(c, c->result->folds, c->result->fold_count, point))
    stiffness = widens = INFINITY;
  return (po_particle_knot){p->approach, p->load, stiffness, c->radius[point], widens};
}

static po_particle_knot knot_at(const curve *c, double overlap) {
  const size_t k = segment_of(c, overlap);
  if (overlap == c->approach[k] || overlap == c->approach[k + 1])
    return knot_of(c, k + (overlap != c->approach[k]));
  const po_path_place place = po_path_where(&c->path, k, PO_DISPLACEMENT_CONTROL, overlap);
  const po_curve_rates rates = po_path_rates(&c->path, place);
  const double h = c->position[k + 1] - c->position[k], x = place.fraction * h;
  return (po_particle_knot){
      overlap, po_path_at(&c->path, place).load, rates.load / rates.approach,
      po_hermite_value(c->radius[k], c->slope[k], c->radius[k + 1], c->slope[k + 1], x, h),
      po_hermite_rate(c->radius[k], c->slope[k], c->radius[k + 1], c->slope[k + 1], x, h) /
          rates.approach};
}

/* -- Cubics -- */

static double force_between(const po_particle_knot *a, const po_particle_knot *b, double overlap) {
  return po_hermite_value(a->force, a->stiffness, b->force, b->stiffness, overlap - a->overlap,
                          b->overlap - a->overlap);
}

/* The slope of a cubic at a fold, over that of its chord, where the force goes as the root of the
 * distance from the fold. With 2.4 the greatest difference from the root is least, 0.06 of the
 * change over the interval; up to 3 the cubic is monotone. */
static const double SLOPE_AT_FOLD = 2.4;

/* Bounds the slopes of a cubic that is monotone where its ends are: 3 times the chord, F. N.
 * Fritsch and R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238. */
static const double STEEPEST = 3.0;

/* A force that changes by less than this part of the tolerance need not be monotone. */
static const double LEVEL = 1e-3;

/* The error of the radius, sqrt(R eps), over that of the force, over the pull-off force. */
static const double OF_RADIUS = 10.0;

/* Intervals that are halved in succession. */
enum { MOST_HALVINGS = 50 };

/* Places in an interval at which a cubic is compared with the curve. */
enum { PLACES = 31 };

typedef struct {
  const curve *c;
  double tolerance; /* of the force, pi w R */
  double radius_tolerance;
  po_particle_stretch *to;
  size_t room;
} fit;

/* Gives a fold at an end finite slopes. */
static void end_slopes(po_particle_knot *a, po_particle_knot *b) {
  const double h = b->overlap - a->overlap;
  po_particle_knot *const ends[] = {a, b};
  for (int k = 0; k < 2; ++k)
    if (isinf(ends[k]->stiffness)) {
      ends[k]->stiffness = SLOPE_AT_FOLD * (b->force - a->force) / h;
      ends[k]->radius_slope = SLOPE_AT_FOLD * (b->radius - a->radius) / h;
    }
}

static double radius_between(const po_particle_knot *a, const po_particle_knot *b, double overlap) {
  return po_hermite_value(a->radius, a->radius_slope, b->radius, b->radius_slope,
                          overlap - a->overlap, b->overlap - a->overlap);
}

/* The greatest differences of force and radius from the curve: at places in the interval, and at
 * the points of the curve, which are close together where it bends. */
typedef struct {
  double force, radius;
} miss;

static void note_miss(const po_particle_knot *a, const po_particle_knot *b,
                      const po_particle_knot *there, miss *m) {
  m->force = fmax(m->force, fabs(force_between(a, b, there->overlap) - there->force));
  m->radius = fmax(m->radius, fabs(radius_between(a, b, there->overlap) - there->radius));
}

static miss greatest_miss(const curve *c, const po_particle_knot *a, const po_particle_knot *b) {
  miss m = {0.0, 0.0};
  for (int k = 1; k <= PLACES; ++k) {
    const po_particle_knot there =
        knot_at(c, a->overlap + (b->overlap - a->overlap) * k / (PLACES + 1));
    note_miss(a, b, &there, &m);
  }
  for (size_t k = segment_of(c, a->overlap) + 1; k < c->path.count && c->approach[k] < b->overlap;
       ++k) {
    const po_particle_knot there = knot_of(c, k);
    note_miss(a, b, &there, &m);
  }
  return m;
}

static bool is_monotone(const po_particle_knot *a, const po_particle_knot *b) {
  const double chord = (b->force - a->force) / (b->overlap - a->overlap);
  return a->stiffness * chord >= 0.0 && b->stiffness * chord >= 0.0 &&
         fabs(a->stiffness) <= STEEPEST * fabs(chord) &&
         fabs(b->stiffness) <= STEEPEST * fabs(chord);
}

static po_status add_knot(fit *f, const po_particle_knot *knot) {
  po_particle_knot *grown = po_grow(f->to->knot, f->to->count, &f->room, sizeof *grown);
  if (!grown)
    return PO_NO_MEMORY;
  f->to->knot = grown;
  grown[f->to->count++] = *knot;
  return PO_OK;
}

/* Adds the knots after `a` up to `b`. The curve is monotone between them. */
static po_status add_between(fit *f, po_particle_knot a, po_particle_knot b, int halvings) {
  const po_particle_knot begin = a, end = b;
  end_slopes(&a, &b);
  const double middle = 0.5 * (a.overlap + b.overlap);
  const miss m = greatest_miss(f->c, &a, &b);
  const bool fits = (is_monotone(&a, &b) || fabs(b.force - a.force) < LEVEL * f->tolerance) &&
                    m.force <= f->tolerance && m.radius <= f->radius_tolerance;
  if (fits || halvings == MOST_HALVINGS || !(a.overlap < middle && middle < b.overlap)) {
    if (isinf(begin.stiffness))
      f->to->knot[f->to->count - 1] = a;
    return add_knot(f, &b);
  }
  const po_particle_knot half = knot_at(f->c, middle);
  const po_status status = add_between(f, begin, half, halvings + 1);
  return status ? status : add_between(f, half, end, halvings + 1);
}

/* The slope of the chord of the radius before a knot. */
static double radius_chord(const po_particle_stretch *s, size_t k) {
  return (s->knot[k].radius - s->knot[k - 1].radius) /
         (s->knot[k].overlap - s->knot[k - 1].overlap);
}

/* Limits the slopes of the radius, so that it is monotone where its knots are, and never below 0.
 */
static void limit_radii(po_particle_stretch *s) {
  for (size_t k = 0; k < s->count; ++k) {
    const double before = radius_chord(s, k > 0 ? k : 1),
                 after = radius_chord(s, k + 1 < s->count ? k + 1 : k);
    double *slope = &s->knot[k].radius_slope;
    const double most = STEEPEST * fmin(fabs(before), fabs(after));
    *slope = before * after > 0.0 && *slope * before > 0.0
                 ? copysign(fmin(fabs(*slope), most), before)
                 : 0.0;
  }
}

/* Tabulates a curve: its ends and the extrema of the load are knots. */
static po_status tabulate(const curve *c, double tolerance, double of_radius,
                          po_particle_stretch *to) {
  fit f = {.c = c, .tolerance = tolerance, .radius_tolerance = of_radius, .to = to};
  free(to->knot);
  *to = (po_particle_stretch){0};
  po_particle_knot last = knot_of(c, 0);
  po_status status = add_knot(&f, &last);
  for (size_t k = 1; k < c->path.count && !status; ++k) {
    if (k + 1 < c->path.count && !is_extremum(c, k))
      continue;
    const po_particle_knot next = knot_of(c, k);
    status = add_between(&f, last, next, 0);
    last = next;
  }
  if (!status)
    limit_radii(to);
  return status;
}

/* The index of the interval of a stretch with an overlap. */
static size_t interval_of(const po_particle_stretch *s, double overlap) {
  size_t k = 0;
  while (k + 2 < s->count && s->knot[k + 1].overlap <= overlap)
    ++k;
  return k;
}

double po_particle_law_force(const po_particle_law *law, const po_particle_stretch *stretch,
                             double overlap) {
  const po_particle_knot *last = &stretch->knot[stretch->count - 1];
  if (overlap <= last->overlap) {
    const size_t k = interval_of(stretch, overlap);
    return force_between(&stretch->knot[k], &stretch->knot[k + 1], overlap);
  }
  if (law->hertz == 0.0)
    return last->force + last->stiffness * (overlap - last->overlap);
  const double there = last->overlap - law->hertz_origin, here = overlap - law->hertz_origin;
  return last->force + law->hertz * (here * sqrt(here) - there * sqrt(there));
}

double po_particle_law_work(const po_particle_stretch *stretch, double from, double to) {
  double sum = 0.0;
  for (size_t k = 0; k + 1 < stretch->count; ++k) {
    const po_particle_knot *a = &stretch->knot[k], *b = a + 1;
    const double h = b->overlap - a->overlap;
    const double low = fmin(fmax((from - a->overlap) / h, 0.0), 1.0),
                 high = fmin(fmax((to - a->overlap) / h, 0.0), 1.0);
    const po_cubic_ends force = {a->force, h * a->stiffness, b->force, h * b->stiffness},
                        overlap = {a->overlap, h, b->overlap, h};
    sum += po_hermite_integral(&force, &overlap, low, high);
  }
  return sum;
}

/* -- The law of a result -- */

/* Refuses a scene whose loops need more than two states. */
static po_status check_states(const po_loop *loop) {
  const size_t loading = loop->loading_jumps, unloading = loop->jump_count - loading;
  if ((loading == 1 && unloading == 1) || loop->jump_count == 0)
    return PO_OK;
  char until[120] = "";
  if (loading > 1)
    snprintf(until, sizeof until,
             "; expected a preload below approach %.6g, that of the second jump",
             loop->jumps[1].before.approach);
  return po_fail(PO_BAD_INPUT,
                 "loading up to approach %.6g jumps %zu times and unloading %zu times: a contact "
                 "has more than the two states, out and in, of a law with one jump each%s",
                 loop->preload.approach, loading, unloading, until);
}

/* Solves a scene with its loop. Status: a failed solve has its reason in the message. */
static po_status solve(const po_request *request, unsigned want, po_result *result) {
  po_request wanting = *request;
  wanting.want = PO_WANT_HYSTERESIS | want;
  wanting.search = PO_SEARCH_NONE;
  const po_status status = po_solve(&wanting, result);
  if (status == PO_OK)
    return check_states(&result->hysteresis.of[PO_AT_APPROACH]);
  return status > 0 ? po_fail(status, "the law has no connected branch up to the preload: %s",
                              result->reason)
                    : status;
}

static po_particle_numbers numbers_of(const po_result *result) {
  const po_loop *loop = &result->hysteresis.of[PO_AT_APPROACH];
  const bool jumps = loop->jump_count > 0;
  return (po_particle_numbers){.jumps = jumps,
                               .jump_in = jumps ? loop->jumps[0].before.approach : (double)NAN,
                               .jump_out = jumps ? loop->jumps[1].before.approach : (double)NAN,
                               .pull_off = -loop->pull_off.load,
                               .pull_off_overlap = loop->pull_off.approach,
                               .energy_lost = loop->energy_lost,
                               .energy_lost_error = loop->energy_lost_error};
}

po_status po_particle_law_numbers(const po_request *request, po_particle_numbers *numbers) {
  po_result result = po_result_none();
  const po_status status = solve(request, 0, &result);
  if (!status)
    *numbers = numbers_of(&result);
  po_result_clear(&result);
  return status;
}

/* Traces for the beginning at most; the farthest beginning, eps. */
static const double FARTHEST = 1e5;
enum { MOST_TRACES = 4 };

/* Solves from an approach on at which the attraction is a part of the pull-off force; which follows
 * from the decay where an earlier trace began. */
static po_status solve_from_afar(const po_request *request, double error, po_result *result) {
  po_request from = *request;
  for (int k = 0; k < MOST_TRACES; ++k) {
    po_result_clear(result);
    const po_status status = solve(&from, PO_WANT_CURVE, result);
    if (status)
      return status;
    const po_curve_point *first = result->curve;
    const double excess =
        fabs(first->load) / (error * fabs(result->hysteresis.of[PO_AT_APPROACH].pull_off.load));
    if (excess <= 1.0)
      return PO_OK;
    const double power =
        fabs(first->approach * first->load_rate / (first->approach_rate * first->load));
    from.approach_start =
        -fabs(first->approach) * po_exp(po_log(excess / PO_AIM) / fmax(power, 0.25));
    if (from.approach_start < -FARTHEST)
      break;
  }
  return po_fail(PO_BAD_INPUT,
                 "the attraction falls so slowly that it is %g of the pull-off force only beyond "
                 "%g epsilon: expected a greater error",
                 error, FARTHEST);
}

/* The point of the curve at or after a state. */
static size_t point_at(const po_result *result, double position) {
  size_t k = 0;
  while (k + 1 < result->curve_count && result->curve[k].position < position)
    ++k;
  return k;
}

/* Notes the errors of a stretch. */
static void measure(const curve *c, const po_particle_stretch *s, po_particle_law *law) {
  for (size_t k = 0; k + 1 < s->count; ++k) {
    const miss m = greatest_miss(c, &s->knot[k], &s->knot[k + 1]);
    law->error = fmax(law->error, m.force / law->numbers.pull_off);
    law->radius_error = fmax(law->radius_error, m.radius);
  }
}

static void continue_beyond(const po_scene *scene, po_particle_law *law) {
  const po_particle_knot *last = &law->in.knot[law->in.count - 1];
  law->hertz = law->hertz_origin = 0.0;
  if (!po_profile_is_sphere(&scene->profile) || scene->tabor == 0.0)
    return;
  /* 4/3 E* sqrt(R) eps^(3/2)/(pi w R), with mu^(3/2) = sqrt(R) w/(E* eps^(3/2)) */
  static const double OF_HERTZ = 0.42441318157838756; /* 4/(3 pi) */
  law->hertz = OF_HERTZ / (scene->tabor * sqrt(scene->tabor));
  const double root = last->stiffness / (1.5 * law->hertz);
  law->hertz_origin = last->overlap - root * root;
}

/* The part by which the energy lost of the table may differ from that of the solver, a half of the
 * thousandth that is promised. */
static const double OF_LOSS = 5e-4;
enum { MOST_FITS = 8 };

static po_status fit_law(const curve *out, const curve *in, double error, po_particle_law *law) {
  const po_particle_numbers *n = &law->numbers;
  const double of_radius = OF_RADIUS * error;
  double tolerance = PO_AIM * error * n->pull_off;
  for (int k = 0; k < MOST_FITS; ++k, tolerance *= PO_STEP_CUT) {
    po_status status = tabulate(in, tolerance, of_radius, &law->in);
    if (!status && n->jumps)
      status = tabulate(out, tolerance, of_radius, &law->out);
    if (status)
      return status;
    const double from = law->in.knot[0].overlap;
    const double to = n->jumps ? law->out.knot[law->out.count - 1].overlap : from;
    law->table_lost = n->jumps ? po_particle_law_work(&law->out, from, to) -
                                     po_particle_law_work(&law->in, from, to)
                               : 0.0;
    law->error = law->radius_error = 0.0;
    measure(in, &law->in, law);
    if (n->jumps)
      measure(out, &law->out, law);
    if (law->error <= error &&
        fabs(law->table_lost - n->energy_lost) <= OF_LOSS * n->energy_lost + n->energy_lost_error)
      break;
  }
  return law->error <= error
             ? PO_OK
             : po_fail(PO_NOT_CONVERGED,
                       "the table differs from the curve by %g of the pull-off force: expected a "
                       "greater error, or less tolerance",
                       law->error);
}

po_status po_particle_law_make(const po_request *request, double error, po_particle_law *law) {
  po_result result = po_result_none();
  curve out = {.approach = NULL}, in = {.approach = NULL};
  *law = (po_particle_law){.numbers.jumps = false};
  po_status status = solve_from_afar(request, error, &result);
  if (!status) {
    const po_loop *loop = &result.hysteresis.of[PO_AT_APPROACH];
    const double radius = request->scene.radius;
    law->numbers = numbers_of(&result);
    const bool jumps = law->numbers.jumps;
    const size_t last = point_at(&result, loop->preload.position);
    const size_t first = jumps ? point_at(&result, loop->jumps[1].before.position) : 0;
    status = begin_curve(&result, radius, first, last, &in);
    if (!status && jumps)
      status =
          begin_curve(&result, radius, 0, point_at(&result, loop->jumps[0].before.position), &out);
  }
  if (!status)
    status = fit_law(&out, &in, error, law);
  if (!status)
    continue_beyond(&request->scene, law);
  free(out.approach);
  free(in.approach);
  po_result_clear(&result);
  if (status)
    po_particle_law_clear(law);
  return status;
}

void po_particle_law_clear(po_particle_law *law) {
  free(law->out.knot);
  free(law->in.knot);
  *law = (po_particle_law){.numbers.jumps = false};
}
