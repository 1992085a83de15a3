#include "po_jkr_profile.h"

#include <math.h>

#include "po_abel.h"
#include "po_deadline.h"
#include "po_root.h"

static const po_contact NONE = {NAN, NAN, NAN};

/* A curve and its bounds. */
typedef struct {
  const po_scene *scene;
  po_fixed fixed;
  double coupling;
  double adhesion; /* factor of the adhesive part; 1 in equilibrium */
  double fall;     /* po_abel_fall */
} curve;

static bool is_inside(const po_scene *scene, double a) {
  return scene->tabor > 0.0 && scene->radius > 0.0 && a >= 0.0;
}

static curve curve_of(const po_scene *scene, po_fixed fixed) {
  return (curve){scene, fixed, po_scene_coupling(scene), 1.0, po_abel_fall(scene)};
}

/* sqrt(2 pi w a/E*), the part of the adhesion in the approach. */
static double pull_in(double coupling, double a) {
  return sqrt(2.0 * M_PI * coupling * a);
}

/* The load of a press a g - integral of g and the adhesion sqrt(8 pi w E* a^3), pi w R. */
static double load_of(const curve *c, double press, double a) {
  const double scale = 2.0 / (M_PI * c->scene->radius * c->coupling);
  return scale * (press - c->adhesion * a * pull_in(c->coupling, a));
}

static double value_of(const curve *c, po_abel t, double a) {
  return c->fixed == PO_FIXED_LOAD ? load_of(c, t.press, a)
                                   : t.g - c->adhesion * pull_in(c->coupling, a);
}

/* dDelta/da = g' - sqrt(pi c/(2a)); dW/da = 2a/(pi R c) (g' - 3 sqrt(pi c/(2a))) */
static double rate_of(const curve *c, double rate, double a) {
  const double adhesion = c->adhesion * sqrt(0.5 * M_PI * c->coupling / a);
  return c->fixed == PO_FIXED_LOAD
             ? 2.0 * a / (M_PI * c->scene->radius * c->coupling) * (rate - 3.0 * adhesion)
             : rate - adhesion;
}

static double value_at(double a, const void *data) {
  const curve *c = data;
  return value_of(c, po_abel_at(c->scene, a), a);
}

static double rate_at(double a, const void *data) {
  const curve *c = data;
  return rate_of(c, po_abel_at(c->scene, a).rate, a);
}

/* Load or approach at a from the profile alone at another radius, with the bounds of the waves on
 * [low, a]. */
static double bound_of(const curve *c, double at, double low, double a) {
  po_abel t = po_abel_of_profile(c->scene, at);
  const double fall = c->fall * (a - at);
  if (c->fixed == PO_FIXED_LOAD)
    t.press += po_abel_waves_least(c->scene, low, a).press - 0.5 * fall * (a + at);
  else
    t.g += po_abel_waves_least(c->scene, low, a).g - fall;
  return value_of(c, t, a);
}

/* The profile alone gives no less than at the lower end, but for its fall; the adhesion is greatest
 * at the upper end. */
static double below(const curve *c, double low, double high) {
  return bound_of(c, low, low, high);
}

/* No greater than the derivative anywhere on [low, high]. */
static double slowest(const curve *c, double low, double high) {
  const double drop = po_abel_greatest_drop(c->scene, low, high);
  return isinf(drop) ? -INFINITY : rate_of(c, po_abel_at(c->scene, low).rate - drop, low);
}

po_contact po_jkr_profile_at(const po_scene *scene, double contact_radius) {
  if (!is_inside(scene, contact_radius))
    return NONE;
  const curve c = curve_of(scene, PO_FIXED_LOAD);
  const po_abel t = po_abel_at(scene, contact_radius);
  return (po_contact){.load = load_of(&c, t.press, contact_radius),
                      .approach = t.g - pull_in(c.coupling, contact_radius),
                      .contact_radius = contact_radius};
}

double po_jkr_profile_rate(const po_scene *scene, po_fixed fixed, double contact_radius) {
  const curve c = curve_of(scene, fixed);
  if (!is_inside(scene, contact_radius))
    return NAN;
  /* g' is finite at the axis: from there the load falls as a^(3/2), the approach as a^(1/2). */
  if (contact_radius == 0.0)
    return fixed == PO_FIXED_LOAD ? 0.0 : -INFINITY;
  return rate_at(contact_radius, &c);
}

static const double SMALLEST = 1e-150, LARGEST = 1e150;

/* Whether all rates up to a are below that of the adhesion. */
static bool falls_to(const po_scene *scene, double coupling, double a) {
  return po_abel_greatest_rate(scene, a) * sqrt(a) < sqrt(0.5 * M_PI * coupling);
}

double po_jkr_profile_first(const po_scene *scene) {
  if (!is_inside(scene, 0.0))
    return NAN;
  const double coupling = po_scene_coupling(scene);
  double a = 1.0;
  while (a > SMALLEST && !falls_to(scene, coupling, a))
    a *= 0.25;
  while (a < LARGEST && falls_to(scene, coupling, 2.0 * a))
    a *= 2.0;
  return a > SMALLEST && a < LARGEST ? a : NAN;
}

/* A contact radius beyond which the lower bound is above `value` >= 0. From the longest wavelength
 * on, the bounds of waves and adhesion grow as a^(3/2), or in the approach as sqrt(a), and the
 * profile faster. */
static double last_radius(const curve *c, double from, double value) {
  double a = fmax(from, po_abel_longest_wave(c->scene));
  while (a > 0.0 && a < LARGEST && !(bound_of(c, a, 0.0, a) > value))
    a *= 2.0;
  return a;
}

/* A profile that grows as a lower power loses against adhesion and waves at large radii. */
static const double LEAST_GROWTH = 0.5;

enum { MOST_EDGES = 3 };

/* The edges of the search: from where the curve has fallen to where it stays above `value` >= 0,
 * with the kink between. */
static po_status find_edges(const curve *c, double value, double edge[MOST_EDGES], size_t *edges) {
  const po_scene *scene = c->scene;
  const po_shape shape = po_profile_shape(&scene->profile);
  if (!is_inside(scene, 0.0))
    return po_fail(PO_BAD_INPUT, "tabor is %g: expected a number > 0 for the JKR theory",
                   scene->tabor);
  if (!(shape.growth > LEAST_GROWTH))
    return po_fail(PO_BAD_INPUT,
                   "the profile grows as r^%g far out: by the JKR theory its pull-off force is "
                   "infinite; expected a growth faster than r^%g",
                   shape.growth, LEAST_GROWTH);
  edge[0] = 0.5 * po_jkr_profile_first(scene);
  double outer = fmax(edge[0], 2.0 * shape.kink); /* of NAN the other */
  if (isfinite(shape.end))
    outer = fmax(outer, 2.0 * shape.end);
  outer = last_radius(c, outer, value);
  *edges = 1;
  if (shape.kink > edge[0])
    edge[(*edges)++] = shape.kink;
  edge[(*edges)++] = outer;
  return edge[0] > 0.0 && outer < LARGEST && isfinite(value_at(outer, c))
             ? PO_OK
             : po_fail(PO_BAD_INPUT,
                       "the pull-off by the JKR theory is beyond the range of numbers: expected "
                       "values of more similar size");
}

/* The search for a minimum of the curve, of which there are many, by branch and bound: intervals
 * are halved, and those in which the lower bound excludes a minimum are left out. A corner at which
 * the derivative rises through zero is a minimum. */
typedef struct {
  const curve *c;
  bool last;       /* the last minimum is sought, from the last interval on; otherwise the lowest */
  double most;     /* minima above it are not wanted */
  double a, value; /* of the minimum found */
  bool found;
  size_t intervals;
  po_status stopped;
} search;

/* The most intervals that are searched. No sphere with one wave is known to need so many;
 * some scenes with three waves and couplings above 10 do, after 0.4 s. */
enum { MOST_INTERVALS = 1 << 18 };
/* A bound that exceeds the wanted value by less than this part of it excludes nothing. */
static const double ROUNDING = 1e-12;

static bool is_done(const search *s) {
  return s->stopped || s->intervals >= MOST_INTERVALS || (s->last && s->found);
}

static bool is_wanted(const search *s, double value) {
  return !(value > s->most + ROUNDING * fabs(s->most));
}

static void take(search *s, double a) {
  const double value = value_at(a, s->c);
  if (!is_wanted(s, value) || (s->found && !(value < s->value)))
    return;
  s->a = a;
  s->value = value;
  s->found = true;
  s->most = fmin(s->most, value);
}

static void search_in(search *s, double low, double high) {
  const curve *c = s->c;
  if (is_done(s) || !is_wanted(s, below(c, low, high)))
    return;
  s->intervals += 1;
  s->stopped = po_deadline_check();
  if (slowest(c, low, high) > 0.0) /* it rises: no minimum */
    return;
  if (high - low <= po_abel_detail(c->scene, low)) {
    const double from = nextafter(low, high); /* the derivative on the right of a corner */
    if (rate_at(from, c) < 0.0 && rate_at(high, c) >= 0.0)
      take(s, po_root(rate_at, c, from, high));
    return;
  }
  const double middle = high > 2.0 * low ? sqrt(low) * sqrt(high) : 0.5 * (low + high);
  if (!s->last)
    s->most = fmin(s->most, value_at(middle, c));
  const bool outer_first = s->last || below(c, middle, high) < below(c, low, middle);
  search_in(s, outer_first ? middle : low, outer_first ? high : middle);
  search_in(s, outer_first ? low : middle, outer_first ? middle : high);
}

/* Finds the lowest minimum, or the last one whose value is at most `most`. Status: PO_NOT_FOUND if
 * there is none; PO_TOO_MANY_POINTS; as find_edges. */
static po_status find_minimum(const curve *c, bool last, double most, double *a) {
  search s = {.c = c, .last = last, .most = most};
  double edge[MOST_EDGES];
  size_t edges = 0;
  const po_status status = find_edges(c, 0.0, edge, &edges);
  if (status)
    return status;
  for (size_t i = 0; i + 1 < edges; ++i) {
    const size_t k = last ? edges - 2 - i : i, corner = last ? k : k + 1;
    search_in(&s, edge[k], edge[k + 1]);
    if (corner > 0 && corner + 1 < edges && !is_done(&s) && rate_at(edge[corner], c) < 0.0 &&
        rate_at(nextafter(edge[corner], INFINITY), c) > 0.0)
      take(&s, edge[corner]);
  }
  if (s.stopped)
    return s.stopped;
  if (s.intervals >= MOST_INTERVALS)
    return po_fail(
        PO_TOO_MANY_POINTS,
        "more than %d intervals of the contact radius may have a minimum: expected fewer "
        "waves in the contact",
        MOST_INTERVALS);
  *a = s.a;
  return s.found ? PO_OK : po_fail(PO_NOT_FOUND, "the curve has no minimum");
}

po_status po_jkr_profile_pull_off(const po_scene *scene, po_fixed fixed, po_contact *least) {
  const curve c = curve_of(scene, fixed);
  double a;
  const po_status status = find_minimum(&c, false, INFINITY, &a);
  *least = status ? NONE : po_jkr_profile_at(scene, a);
  return status;
}

double po_jkr_profile_last_minimum(const po_scene *scene, double load, double excess) {
  curve c = curve_of(scene, PO_FIXED_LOAD);
  double a;
  c.adhesion = 1.0 + excess;
  if (!(load < 0.0))
    return NAN;
  const po_status status = find_minimum(&c, true, load, &a);
  return status == PO_OK ? a : status == PO_NOT_FOUND ? 0.0 : NAN;
}

/* -- The state at a given load or approach -- */

/* The search for the greatest contact radius at which the curve rises through a value. */
typedef struct {
  curve c;
  double value;
  double a; /* the radius; NAN: not found */
  size_t intervals;
  po_status stopped;
} passage;

static double excess_at(double a, const void *data) {
  const passage *p = data;
  return value_at(a, &p->c) - p->value;
}

/* Takes the passage between two radii, at the inner one of which the curve is not above the value.
 * At a minimum that touches it, it may be above by rounding. */
static void take_passage(passage *p, double low, double high) {
  const double at_low = excess_at(low, p);
  p->a = at_low >= 0.0 ? low : po_root(excess_at, p, low, high);
}

/* An interval in which the derivative changes its sign once at most. Given: the curve is above the
 * value at and beyond its upper end. */
static void pass_in_detail(passage *p, double low, double high) {
  const double from = nextafter(low, high); /* the derivative on the right of a corner */
  const double left = rate_at(from, &p->c), right = rate_at(high, &p->c);
  double turn = low; /* the curve rises from here on, or up to here */
  if (left < 0.0 ? right >= 0.0 : right < 0.0)
    turn = po_root(rate_at, &p->c, from, high);
  const bool valley = left < 0.0 && right >= 0.0;
  const double lowest = valley ? turn : low, highest = left >= 0.0 && right < 0.0 ? turn : high;
  if (left < 0.0 && !valley) /* it falls */
    return;
  const double touch = ROUNDING * fabs(p->value);
  if (excess_at(lowest, p) <= (valley ? touch : 0.0) && excess_at(highest, p) > 0.0)
    take_passage(p, lowest, highest);
}

static void pass_in(passage *p, double low, double high) {
  if (p->stopped || p->a > 0.0 || p->intervals >= MOST_INTERVALS ||
      below(&p->c, low, high) > p->value + ROUNDING * fabs(p->value))
    return;
  p->intervals += 1;
  p->stopped = po_deadline_check();
  if (slowest(&p->c, low, high) > 0.0) { /* it rises */
    if (excess_at(low, p) <= 0.0)
      take_passage(p, low, high);
    return;
  }
  if (high - low <= po_abel_detail(p->c.scene, low)) {
    pass_in_detail(p, low, high);
    return;
  }
  const double middle = high > 2.0 * low ? sqrt(low) * sqrt(high) : 0.5 * (low + high);
  pass_in(p, middle, high);
  pass_in(p, low, middle);
}

static po_status no_state(const passage *p, const char *why, double number) {
  return po_fail(PO_NOT_FOUND, "the JKR theory has no stable state at %s %.9g: %s %.9g",
                 p->c.fixed == PO_FIXED_LOAD ? "load" : "approach", p->value, why, number);
}

po_status po_jkr_profile_outermost(const po_scene *scene, po_fixed fixed, double value,
                                   double within, double *a) {
  passage p = {.c = curve_of(scene, fixed), .value = value, .a = NAN};
  double edge[MOST_EDGES];
  size_t edges = 0;
  *a = NAN;
  po_status status = find_edges(&p.c, fmax(value, 0.0), edge, &edges);
  if (status)
    return status;
  const double greatest = isfinite(within) ? value_at(within, &p.c) : INFINITY;
  if (within <= edge[0])
    return no_state(&p, "the contact radius of the preload is", within);
  if (value > greatest + ROUNDING * fabs(greatest))
    return no_state(&p, "expected at most that of the preload,", greatest);
  if (value >= greatest - ROUNDING * fabs(greatest)) {
    *a = within;
    return PO_OK;
  }
  for (size_t k = edges - 1; k-- > 0;)
    if (edge[k] < within)
      pass_in(&p, edge[k], fmin(edge[k + 1], within));
  *a = p.a;
  if (p.stopped)
    return p.stopped;
  if (p.intervals >= MOST_INTERVALS)
    return po_fail(PO_TOO_MANY_POINTS,
                   "more than %d intervals of the contact radius may have the %s %.9g: expected "
                   "fewer waves in the contact",
                   MOST_INTERVALS, fixed == PO_FIXED_LOAD ? "load" : "approach", value);
  if (p.a > 0.0)
    return PO_OK;
  po_contact least;
  status = po_jkr_profile_pull_off(scene, fixed, &least);
  return status ? status
                : no_state(&p, "the lowest of all states is",
                           fixed == PO_FIXED_LOAD ? least.load : least.approach);
}

static double square(double x, po_abel t, const void *data) {
  (void)x;
  const double difference = *(const double *)data - t.g;
  return difference * difference;
}

po_status po_jkr_profile_energy(const po_scene *scene, double contact_radius, double *energy) {
  *energy = NAN;
  if (!is_inside(scene, contact_radius))
    return PO_OK;
  const double approach = po_jkr_profile_at(scene, contact_radius).approach;
  const double sum = po_abel_integral(scene, 0.0, contact_radius, false, square, &approach);
  if (isnan(sum))
    return po_fail(PO_NO_MEMORY, "no memory for the energy of a contact of radius %g",
                   contact_radius);
  *energy =
      (sum / (M_PI * po_scene_coupling(scene)) - contact_radius * contact_radius) / scene->radius;
  return PO_OK;
}

/* Radii outside the contact at which the transform and the gap are looked at, at most. */
enum { MOST_LOOKS = 1 << 18 };

/* Finds the first radius beyond the contact at which g < approach. Returned: INFINITY if there is
 * none; NaN if it takes too many looks. */
static double first_below(const curve *c, double a, double approach) {
  const po_scene *scene = c->scene;
  const double end = po_profile_shape(&scene->profile).end;
  const double whole = fmax(isfinite(end) ? 2.0 * end : 0.0, po_abel_longest_wave(scene));
  double x = a;
  for (int k = 0; k < MOST_LOOKS; ++k) {
    const po_abel profile = po_abel_of_profile(scene, x);
    if (x >= whole && profile.g + po_abel_waves_least(scene, 0.0, x).g > approach)
      return INFINITY;
    if (k > 0 && po_abel_at(scene, x).g < approach)
      return x;
    x += po_abel_detail(scene, x);
  }
  return NAN;
}

po_status po_jkr_profile_check(const po_scene *scene, double contact_radius, double *gap,
                               double *radius) {
  const double a = contact_radius;
  *gap = 0.0;
  *radius = a;
  if (!is_inside(scene, a) || a == 0.0)
    return PO_OK;
  const curve c = curve_of(scene, PO_FIXED_APPROACH);
  const double approach = po_jkr_profile_at(scene, a).approach;
  const double profile = po_abel_of_profile(scene, a).g + c.fall * a;
  /* The deflection outside is at least -greatest a/r, as g is not above approach + greatest inside:
   * y H0(y) <= sqrt(2y/pi) + 1.3. */
  double greatest = profile - po_abel_waves_least(scene, 0.0, a).g - approach;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    greatest += 1.3 * M_PI_2 * po_scene_wave(scene, k).amplitude;
  double r = first_below(&c, a, approach);
  for (int k = 0; k < MOST_LOOKS && isfinite(r); ++k) {
    const double lowest = po_profile_gap_beyond(&scene->profile, scene->radius, r);
    if (lowest - approach > greatest * a / r)
      return PO_OK;
    const double here = po_abel_gap(scene, a, approach, r);
    if (here < *gap) {
      *gap = here;
      *radius = r;
    }
    r += po_abel_detail(scene, r);
  }
  return isinf(r) ? PO_OK
                  : po_fail(PO_TOO_MANY_POINTS,
                            "the gap outside the contact of radius %g has more than %d points to "
                            "look at: expected fewer waves",
                            a, MOST_LOOKS);
}
