#include "po_path.h"

#include <math.h>

#include "po_hermite.h"
#include "po_margins.h"
#include "po_memory.h"
#include "po_root.h"

/* Two approaches (eps) that differ by less are the same: far above the 1e-12 with which a trace
 * meets an approach, far below the errors of a solve. */
static const double SAME_APPROACH = 1e-9;

bool po_path_is_at(double approach, double asked) {
  return fabs(approach - asked) < SAME_APPROACH;
}

bool po_path_reaches(double approach, double asked) {
  return approach >= asked - SAME_APPROACH;
}

typedef po_cubic_ends cubic; /* one quantity as a function of the fraction of a segment */

static void cubics(const po_path *path, size_t index, cubic *approach, cubic *load) {
  const po_curve_point *a = &path->point[index], *b = a + 1;
  const double length = b->position - a->position;
  *approach =
      (cubic){a->approach, length * a->approach_rate, b->approach, length * b->approach_rate};
  *load = (cubic){a->load, length * a->load_rate, b->load, length * b->load_rate};
}

static double value(const cubic *c, double fraction) {
  return po_hermite_value(c->f0, c->d0, c->f1, c->d1, fraction, 1.0);
}

po_path_state po_path_at(const po_path *path, po_path_place place) {
  const po_curve_point *a = &path->point[place.index], *b = a + 1;
  const double t = place.fraction;
  if (t == 0.0)
    return (po_path_state){a->approach, a->load, a->energy, a->contact_radius, a->position};
  cubic approach, load;
  cubics(path, place.index, &approach, &load);
  const cubic energy = {a->energy, a->load * approach.d0, b->energy, b->load * approach.d1};
  return (po_path_state){.approach = value(&approach, t),
                         .load = value(&load, t),
                         .energy = value(&energy, t),
                         .contact_radius =
                             a->contact_radius + t * (b->contact_radius - a->contact_radius),
                         .position = a->position + t * (b->position - a->position)};
}

po_curve_rates po_path_rates(const po_path *path, po_path_place place) {
  const po_curve_point *a = &path->point[place.index], *b = a + 1;
  const double length = b->position - a->position, t = place.fraction;
  cubic approach, load;
  cubics(path, place.index, &approach, &load);
  return (po_curve_rates){
      po_hermite_rate(approach.f0, approach.d0, approach.f1, approach.d1, t, 1.0) / length,
      po_hermite_rate(load.f0, load.d0, load.f1, load.d1, t, 1.0) / length};
}

po_path_doubt po_path_doubt_at(const po_path *path, po_path_place place) {
  const po_curve_point *a = &path->point[place.index], *b = a + 1;
  if (place.fraction == 0.0)
    return (po_path_doubt){.of_points = a->energy_error};
  const double energy = po_path_at(path, place).energy;
  const double before = a->energy + po_path_work(path, place.index, 0.0, place.fraction);
  const double after = b->energy - po_path_work(path, place.index, place.fraction, 1.0);
  return (po_path_doubt){.interpolated = fmax(fabs(energy - before), fabs(energy - after)),
                         .of_points = fmax(a->energy_error, b->energy_error)};
}

typedef struct {
  const cubic *c;
  double target;
} search;

static bool is_before(double fraction, const void *data) {
  const search *s = data;
  return (value(s->c, fraction) < s->target) == (s->c->f0 < s->target);
}

/* The held quantity on the segment from point `index`. */
static cubic held_cubic(const po_path *path, size_t index, po_control control) {
  cubic a, w;
  cubics(path, index, &a, &w);
  return (cubic){po_held(control, a.f0, w.f0), po_held(control, a.d0, w.d0),
                 po_held(control, a.f1, w.f1), po_held(control, a.d1, w.d1)};
}

po_path_place po_path_where(const po_path *path, size_t index, po_control control, double target) {
  const cubic held = held_cubic(path, index, control);
  const search s = {&held, target};
  double low = 0.0, high = 1.0;
  if (target == s.c->f0)
    return (po_path_place){index, 0.0};
  po_bisect(is_before, &s, 0.0, &low, &high);
  return (po_path_place){index, 0.5 * (low + high)};
}

double po_path_work(const po_path *path, size_t index, double from, double to) {
  cubic approach, load;
  cubics(path, index, &approach, &load);
  return po_hermite_integral(&load, &approach, from, to);
}

/* An extremum so near an end of a segment, relative to its length, is that of the point there. */
static const double AT_END = 1e-9;

/* The fractions in (0, 1) at which a cubic has an extremum, ascending. Returned: their number. */
static size_t extrema_of(const cubic *c, double fraction[2]) {
  const double rise = c->f1 - c->f0;
  const double square = 3.0 * (c->d0 + c->d1 - 2.0 * rise), half = 3.0 * rise - 2.0 * c->d0 - c->d1;
  const double inside = half * half - square * c->d0;
  size_t count = 0;
  if (!(inside > 0.0))
    return 0;
  /* the derivative is d0 + 2 half t + square t^2 */
  const double sum = -(half + copysign(sqrt(inside), half));
  const double root[] = {c->d0 / sum, sum / square};
  const int first = root[1] < root[0];
  for (int k = 0; k < 2; ++k) {
    const double t = root[k ? 1 - first : first];
    if (t > AT_END && t < 1.0 - AT_END)
      fraction[count++] = t;
  }
  return count;
}

/* The point of the curve at a place inside a segment. */
static po_curve_point point_at(const po_path *path, po_path_place place) {
  const po_curve_point *a = &path->point[place.index];
  const po_path_state s = po_path_at(path, place);
  const po_path_doubt doubt = po_path_doubt_at(path, place);
  const po_curve_rates rates = po_path_rates(path, place);
  return (po_curve_point){.position = s.position,
                          .approach = s.approach,
                          .load = s.load,
                          .energy = s.energy,
                          .energy_error = doubt.interpolated + doubt.of_points,
                          .contact_radius = s.contact_radius,
                          .approach_rate = rates.approach,
                          .load_rate = rates.load,
                          .unstable_modes = a->unstable_modes};
}

/* The place of a position on the curve. */
static po_path_place place_of(const po_path *path, double position) {
  size_t k = 0;
  while (k + 2 < path->count && path->point[k + 1].position <= position)
    ++k;
  const po_curve_point *a = &path->point[k];
  return (po_path_place){k, (position - a->position) / (a[1].position - a->position)};
}

po_path_state po_path_moved(const po_path *path, po_control control, po_path_state state,
                            double by) {
  const po_path_place place = place_of(path, state.position);
  const po_curve_point here = point_at(path, place), *a = &path->point[place.index];
  const double way = by / po_held(control, here.approach_rate, here.load_rate);
  if (!(fabs(way) < a[1].position - a->position)) /* the held quantity turns here */
    return state;
  state.position += way;
  state.approach += way * here.approach_rate;
  state.load += way * here.load_rate;
  state.energy += way * here.approach_rate * here.load;
  return state;
}

/* The third derivatives of approach and load between two points of the curve. */
static po_path_error third_derivatives(const po_path *path, size_t from, size_t to) {
  const po_curve_point *a = &path->point[from], *b = &path->point[to];
  const double h = b->position - a->position, of = 6.0 / (h * h * h);
  return (po_path_error){
      of * (h * (a->approach_rate + b->approach_rate) - 2.0 * (b->approach - a->approach)),
      of * (h * (a->load_rate + b->load_rate) - 2.0 * (b->load - a->load))};
}

/* A segment beside another is not taken alone if it is shorter than this part of it: its third
 * derivative has the rounding of the points over its length cubed. */
static const double LEAST_NEIGHBOUR = 0.5;

/* Raises the fourth derivatives by those between a segment and what is beside it, from point `from`
 * to point `to`. */
static void compare_derivatives(const po_path *path, size_t index, size_t from, size_t to,
                                po_path_error *fourth) {
  const po_curve_point *p = path->point;
  const po_path_error own = third_derivatives(path, index, index + 1),
                      other = third_derivatives(path, from, to);
  const double distance =
      0.5 * (p[index + 1].position - p[index].position + p[to].position - p[from].position);
  fourth->approach = fmax(fourth->approach, fabs(other.approach - own.approach) / distance);
  fourth->load = fmax(fourth->load, fabs(other.load - own.load) / distance);
}

/* A bound of the error of the held quantity by the cubics at a place. The error of a cubic is the
 * fourth derivative over 24, times the squares of the distances from both ends; the derivative is
 * the change of the third one from the segments beside it. Where the curve changes manifold from
 * one segment to the next that is too much, and the distance for which the points are chosen bounds
 * it.
 */
static double held_miss(const po_path *path, po_control control, po_path_place place) {
  const po_curve_point *p = path->point;
  const size_t k = place.index;
  const double h = p[k + 1].position - p[k].position, least = LEAST_NEIGHBOUR * h;
  po_path_error fourth = {NAN, NAN};
  size_t before = k, after = k + 1;
  while (before > 0 && p[k].position - p[before].position < least)
    --before;
  while (after + 1 < path->count && p[after].position - p[k + 1].position < least)
    ++after;
  if (before < k)
    compare_derivatives(path, k, before, k, &fourth);
  if (after > k + 1)
    compare_derivatives(path, k, k + 1, after, &fourth);
  const double inside = h * h * place.fraction * (1.0 - place.fraction);
  const double part = PO_SAFETY * inside * inside / 24.0;
  return po_held(control, fmin(path->miss, part * fourth.approach), /* ignores NAN */
                 fmin(path->miss, part * fourth.load));
}

static po_curve_point extremum_at(const po_path *path, po_control control, po_path_place place) {
  po_curve_point point = point_at(path, place);
  const po_curve_point *a = &path->point[place.index], *b = a + 1;
  point.held_miss = held_miss(path, control, place) +
                    po_held(control, 0.0, fmax(a->load_error, b->load_error)); /* ignores NAN */
  return point;
}

po_status po_path_add_extrema(po_path *path, po_control control, po_curve_point **point) {
  size_t count = 0;
  *point = NULL;
  if (!po_is_spring(control))
    return PO_OK;
  *point = po_allocate(3 * path->count, sizeof **point);
  if (!*point)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < path->count; ++k) {
    (*point)[count++] = path->point[k];
    if (k + 1 == path->count)
      break;
    double fraction[2];
    const cubic held = held_cubic(path, k, control);
    const size_t extrema = extrema_of(&held, fraction);
    for (size_t i = 0; i < extrema; ++i)
      (*point)[count++] = extremum_at(path, control, (po_path_place){k, fraction[i]});
  }
  path->point = *point;
  path->count = count;
  return PO_OK;
}

double po_stable_controlled(const po_path *path, po_control control, size_t point) {
  return po_held(control, path->point[point].approach, path->point[point].load);
}

bool po_stable_is(const po_path *path, po_control control, size_t point) {
  const po_curve_point *p = &path->point[point];
  return point + 1 < path->count && p->unstable_modes == 0 && p[1].approach > p->approach &&
         po_stable_controlled(path, control, point + 1) >
             po_stable_controlled(path, control, point);
}

bool po_stable_find(const po_path *path, po_control control, size_t from, int by, double value,
                    po_path_place *found) {
  for (size_t k = from; by > 0 ? k + 1 < path->count : k-- > 0; k += by > 0) {
    if (!po_stable_is(path, control, k))
      continue;
    const double here = po_stable_controlled(path, control, k);
    const double next = po_stable_controlled(path, control, k + 1);
    if (by > 0 ? here <= value && value < next : here < value && value <= next) {
      *found = po_path_where(path, k, control, value);
      return true;
    }
  }
  return false;
}

po_path_state po_stable_apart(po_control control, double held) {
  const bool far = control == PO_LOAD_CONTROL;
  return (po_path_state){
      .approach = far ? -INFINITY : held, .load = far ? held : 0.0, .position = (double)NAN};
}

/* Returned: the decrease of the potential in a jump: of U and the energy of the spring, under load
 * control of U - W approach. After complete separation U is 0; under load control it is NAN under
 * tension, where the potential decreases without bound. */
static double energy_lost(po_control control, const po_path_state *before,
                          const po_path_state *after) {
  if (control != PO_LOAD_CONTROL)
    return before->energy - after->energy +
           0.5 * (before->load - after->load) * (before->load + after->load) / control;
  if ((isinf(before->approach) || isinf(after->approach)) && before->load != 0.0)
    return (double)NAN;
  const double first =
      isinf(before->approach) ? 0.0 : before->energy - before->load * before->approach;
  const double last = isinf(after->approach) ? 0.0 : after->energy - after->load * after->approach;
  return first - last;
}

po_loss po_loss_of_jump(po_control control, const po_path_state *before, const po_path_state *after,
                        po_path_doubt doubt) {
  const double change =
      control == PO_LOAD_CONTROL ? before->approach - after->approach : before->load - after->load;
  const double moved = isfinite(change) ? fabs(change) : 0.0; /* a load of separation is exact */
  return (po_loss){.energy = energy_lost(control, before, after),
                   .moved = moved,
                   .of_held = moved * doubt.held,
                   .size = 1.0 + fabs(before->load) + fabs(after->load),
                   .doubt = doubt,
                   .jumps = 1};
}

po_path_doubt po_doubt_of_jump(const po_path *path, po_control control, size_t from,
                               const po_path_place *to) {
  po_path_doubt doubt = to ? po_path_doubt_at(path, *to) : (po_path_doubt){0};
  const po_curve_point *first = &path->point[0];
  if (!po_is_spring(control))
    return doubt;
  doubt.of_points += path->point[from].energy_error;
  doubt.held = path->point[from].held_miss;
  if (!to)
    doubt.of_points += fabs(first->energy) + 0.5 * first->load * first->load / control;
  return doubt;
}

po_loss po_loss_sum(po_loss a, po_loss b) {
  return (po_loss){a.energy + b.energy,
                   a.moved + b.moved,
                   a.size + b.size,
                   a.of_held + b.of_held,
                   {.interpolated = a.doubt.interpolated + b.doubt.interpolated,
                    .of_points = a.doubt.of_points + b.doubt.of_points},
                   a.jumps + b.jumps};
}
