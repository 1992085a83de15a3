#include "po_maugis.h"

#include <math.h>

#include "po_abel.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_margins.h"
#include "po_root.h"

/* A contact radius, and what is needed to find the end of the tension. */
typedef struct {
  const po_scene *scene;
  double coupling, tension, a;
  po_abel at;   /* the transform at a */
  double *work; /* pieces of integrals so far; may be NULL */
} ring;

/* Lengths of a width d = c - a of the ring, without cancellation. */
typedef struct {
  double c, s, angle; /* s = sqrt(c^2 - a^2), angle = arccos(a/c) */
} lengths;

static lengths lengths_of(const ring *m, double width) {
  const double s = sqrt(width * (2.0 * m->a + width));
  return (lengths){m->a + width, s, po_atan2(s, m->a)};
}

static double shortest_wave(const po_scene *scene) {
  double length = INFINITY;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    length = fmin(length, po_scene_wave(scene, k).length);
  return length;
}

/* The gap at the end of a ring of this width, less 1/tension. */
static double excess_gap(double width, const void *data) {
  const ring *m = data;
  const lengths l = lengths_of(m, width);
  const double profile = po_abel_opening(m->scene, m->a, m->at.g, l.c);
  if (m->work)
    *m->work += 1.0 + width / shortest_wave(m->scene);
  return M_2_PI * (profile + 2.0 * m->tension * m->coupling * (l.s * l.angle - width)) -
         1.0 / m->tension;
}

static ring ring_of(const po_scene *scene, double tension, double a) {
  return (ring){scene, po_scene_coupling(scene), tension, a, po_abel_at(scene, a), NULL};
}

/* Steps of the search for a width. */
enum { MOST_STEPS = 4000 };

/* The width of the ring. It grows by no more than an eighth of a wave a step. Given: a guess > 0.
 * Returned: NaN if none is found. */
static double width_of(const ring *m, double guess) {
  const double step = 2.0 / PO_POINTS_PER_WAVE * shortest_wave(m->scene);
  double low = guess, high = guess;
  int k = 0;
  while (!(excess_gap(low, m) < 0.0) && ++k < MOST_STEPS) {
    high = low;
    low /= PO_FARTHER;
  }
  while (!(excess_gap(high, m) >= 0.0) && ++k < MOST_STEPS) {
    low = high;
    high = fmin(PO_FARTHER * high, high + step);
  }
  return po_root(excess_gap, m, low, high); /* NaN without a change of sign */
}

/* Secants from a predicted width: the first one spans this part of it, the last step is no more
 * than rounding, and there are few if the prediction is good. */
static const double FIRST_SECANT = 1e-4, LAST_SECANT = 1e-13;
enum { MOST_SECANTS = 8 };

/* The width of the ring near a prediction > 0. Returned: NaN if the secants do not converge. */
static double width_near(const ring *m, double predicted) {
  double x = predicted, y = excess_gap(x, m), step = FIRST_SECANT * x;
  for (int k = 0; k < MOST_SECANTS; ++k) {
    const double before = y;
    x += step;
    y = excess_gap(x, m);
    if (y == 0.0 || fabs(step) <= LAST_SECANT * x)
      return x;
    step *= y / (before - y);
    if (!(fabs(step) < 0.5 * x))
      return NAN;
  }
  return NAN;
}

/* A width well below any: that of a rigid ring, or that of the JKR limit, pi/(8 q^2 k). */
static double narrow_width(const ring *m) {
  const double rigid = po_initial_gap_radius(m->scene, 1.0 / m->tension),
               stiff = M_PI_4 / (2.0 * m->tension * m->tension * m->coupling);
  return PO_NEAR_AXIS * fmin(rigid, stiff);
}

static po_contact contact_of(const ring *m, lengths l) {
  const double q = m->tension, k = m->coupling;
  return (po_contact){.load =
                          (2.0 / k * m->at.press - 2.0 * q * (m->a * l.s + l.c * l.c * l.angle)) /
                          (M_PI * m->scene->radius),
                      .approach = m->at.g - 2.0 * q * k * l.s,
                      .contact_radius = m->a};
}

static po_status check_input(const po_scene *scene, double tension, double a) {
  if (!(scene->tabor > 0.0))
    return po_fail(PO_BAD_INPUT, "tabor is %g: expected a number > 0 for Maugis-Dugdale",
                   scene->tabor);
  if (!(tension > 0.0 && isfinite(tension)))
    return po_fail(PO_BAD_INPUT, "the tension is %g: expected a finite number > 0", tension);
  return a >= 0.0 && isfinite(a)
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "the contact radius is %g: expected a finite number >= 0", a);
}

/* The width of a ring at another contact radius, from which it is guessed. */
typedef struct {
  double radius, width; /* width NAN: no guess */
  double slope;         /* of the width by the radius */
  bool predicts;        /* whether the width is predicted with its slope */
  double *work;
} guess;

static const guess NO_GUESS = {(double)NAN, (double)NAN, (double)NAN, false, NULL};

/* The state at a contact radius. */
static po_status solve(const po_scene *scene, double tension, double a, const guess *last,
                       po_maugis *state) {
  ring m = ring_of(scene, tension, a);
  m.work = last->work;
  const double predicted = last->width + last->slope * (a - last->radius);
  double width = last->predicts && predicted > 0.0 ? width_near(&m, predicted) : NAN;
  if (!(width > 0.0))
    width = width_of(&m, last->width > 0.0 ? last->width : narrow_width(&m));
  *state = (po_maugis){{NAN, NAN, NAN}, NAN, NAN};
  if (!(width > 0.0))
    return po_fail(PO_NOT_FOUND,
                   "no radius outside the contact of radius %g has the gap %g at which the tension "
                   "%g ends",
                   a, 1.0 / tension, tension);
  *state = (po_maugis){contact_of(&m, lengths_of(&m, width)), a + width, width};
  return PO_OK;
}

double po_maugis_matched_tension(const po_scene *scene) {
  return -po_law_at(&scene->law, po_law_numbers_of(&scene->law)->peak_gap).traction;
}

po_status po_maugis_at(const po_scene *scene, double tension, double contact_radius,
                       po_maugis *state) {
  const po_status status = check_input(scene, tension, contact_radius);
  return status ? status : solve(scene, tension, contact_radius, &NO_GUESS, state);
}

static double rate_by_cosine(double x, po_abel t, const void *data) {
  return t.rate * x / *(const double *)data;
}

/* On a ring narrower than this part of the contact radius and of a wave the transform is linear,
 * to its square. Below, the rounding of c would spoil the integral. */
static const double NARROW = 1e-8;

/* By the implicit function of the gap: along the curve d(c - a)/da = -(gap_a + gap_c)/gap_c. In the
 * JKR limit the parts with a/s, of a tension that is multiplied by its zone, are greater than their
 * sum by a factor of q^2 k a, so they are added before they are multiplied. */
double po_maugis_rate(const po_scene *scene, double tension, po_fixed fixed, const po_maugis *state,
                      double *width_rate) {
  const double a = state->contact.contact_radius, c = state->end, width = state->width;
  const ring m = ring_of(scene, tension, a);
  const lengths l = lengths_of(&m, width);
  const double pull = 2.0 * tension * m.coupling;
  const double slope = width < NARROW * fmin(a, shortest_wave(scene))
                           ? m.at.rate * l.s / c
                           : po_abel_integral(scene, a, c, true, rate_by_cosine, &c);
  const double gap_c = slope + pull * (a / c + c * l.angle / l.s - 1.0);
  const double moved = l.angle * m.at.rate - slope + pull * width * (1.0 / c - l.angle / l.s);
  *width_rate = moved / gap_c;
  if (fixed == PO_FIXED_APPROACH)
    return m.at.rate - pull * (width + c * *width_rate) / l.s;
  const double zone = a * width / l.s + c * l.angle + c * (a / l.s + l.angle) * *width_rate;
  return (2.0 * a / m.coupling * m.at.rate - 4.0 * tension * zone) / (M_PI * scene->radius);
}

/* The search for the pull-off. */
typedef struct {
  const po_scene *scene;
  double tension;
  po_fixed fixed;
  guess last;
} search;

static double value_of(const search *s, const po_maugis *state) {
  return s->fixed == PO_FIXED_LOAD ? state->contact.load : state->contact.approach;
}

static double rate_at(double a, const void *data) {
  const search *s = data;
  po_maugis state;
  double width_rate;
  if (solve(s->scene, s->tension, a, &s->last, &state))
    return NAN;
  return po_maugis_rate(s->scene, s->tension, s->fixed, &state, &width_rate);
}

/* Steps of the contact radius relative to it, and to a wave; the first one relative to the width of
 * a ring about the axis and to the radius up to which the JKR curve falls; the most steps. */
static const double STEP = 0.1;
enum { MOST_RADII = 20000 };
/* The most work of a search that predicts, in pieces of integrals: some tenths of a second. A
 * contact of a hundred shallow waves takes as much, one of ten a tenth of it. */
static const double MOST_WORK = 3e4;

/* Whether load and approach stay above `value` >= 0 from here on: the profile alone, with the
 * bounds of the waves, is more than the tension, whose part grows more slowly. */
static bool is_beyond(const search *s, const po_maugis *state, double value) {
  const po_scene *scene = s->scene;
  const double a = state->contact.contact_radius, end = po_profile_shape(&scene->profile).end;
  if (a < po_abel_longest_wave(scene) || a < 2.0 * po_profile_shape(&scene->profile).kink ||
      (isfinite(end) && a < 2.0 * end))
    return false;
  const po_abel all = po_abel_at(scene, a), profile = po_abel_of_profile(scene, a);
  if (s->fixed == PO_FIXED_APPROACH)
    return state->contact.approach - all.g + profile.g + po_abel_waves_least(scene, 0.0, a).g >
           value;
  const double waves = po_abel_waves_least(scene, 0.0, a).press + profile.press - all.press;
  return state->contact.load + 2.0 * waves / (po_scene_coupling(scene) * M_PI * scene->radius) >
         value;
}

static double next_radius(const search *s, double a) {
  const double next = a + fmin(STEP * a, shortest_wave(s->scene) / PO_POINTS_PER_WAVE),
               kink = po_profile_shape(&s->scene->profile).kink;
  return a < kink && kink < next ? kink : next;
}

/* Takes the state at a if it is the lowest. */
static po_status take(search *s, double a, po_maugis *least) {
  po_maugis state;
  const po_status status = solve(s->scene, s->tension, a, &s->last, &state);
  if (!status && (isnan(least->end) || value_of(s, &state) < value_of(s, least)))
    *least = state;
  return status;
}

/* The rate at a contact radius, on the right of a corner, and the guess of the width. */
static po_status rate_beyond(search *s, double a, po_maugis *state, double *rate) {
  const po_status status = solve(s->scene, s->tension, a, &s->last, state);
  if (!status) {
    *rate = po_maugis_rate(s->scene, s->tension, s->fixed, state, &s->last.slope);
    s->last.radius = a;
    s->last.width = state->width;
  }
  return status;
}

po_status po_maugis_pull_off(const po_scene *scene, double tension, po_fixed fixed, bool predict,
                             po_maugis *state) {
  search s = {scene, tension, fixed, NO_GUESS};
  double work = 0.0;
  s.last.predicts = predict;
  s.last.work = predict ? &work : NULL;
  *state = (po_maugis){{NAN, NAN, NAN}, NAN, NAN};
  po_status status = check_input(scene, tension, 0.0);
  if (!status)
    status = take(&s, 0.0, state);
  double a = PO_NEAR_AXIS * fmin(state->end, po_jkr_profile_first(scene)), left = a,
         left_rate = 0.0;
  for (int k = 0; k < MOST_RADII && !status && work < MOST_WORK; ++k) {
    po_maugis here;
    double rate;
    status = rate_beyond(&s, a, &here, &rate);
    if (status || is_beyond(&s, &here, 0.0))
      return status;
    if (left_rate < 0.0 && rate >= 0.0)
      status = take(&s, po_root(rate_at, &s, left, a), state);
    left = a;
    left_rate = rate;
    if (!status &&
        a == po_profile_shape(&scene->profile).kink) { /* a corner, and the rate on its right */
      left = a * (1.0 + PO_BESIDE);
      status = rate_beyond(&s, left, &here, &left_rate);
      if (!status && rate < 0.0 && left_rate >= 0.0)
        status = take(&s, a, state);
    }
    a = next_radius(&s, a);
  }
  return status
             ? status
             : po_fail(PO_TOO_MANY_POINTS,
                       "the pull-off of Maugis-Dugdale is not found up to the contact radius %g: "
                       "expected fewer waves",
                       a);
}

/* The difference of load or approach from a wanted value. */
typedef struct {
  search s;
  double value;
} passage;

static double excess_at(double a, const void *data) {
  const passage *p = data;
  po_maugis state;
  return solve(p->s.scene, p->s.tension, a, &NO_GUESS, &state) ? (double)NAN
                                                               : value_of(&p->s, &state) - p->value;
}

/* Takes the passage on (left, right), if the curve rises there through the value. Given: its values
 * less the wanted one, and its derivatives, at both ends. */
static void take_passage(const passage *p, const double a[2], const double excess[2],
                         const double rate[2], double *found) {
  double low = a[0];
  if (!(excess[1] > 0.0))
    return;
  if (rate[0] < 0.0 && rate[1] >= 0.0) /* a minimum between */
    low = po_root(rate_at, &p->s, a[0], a[1]);
  const double at_low = low == a[0] ? excess[0] : excess_at(low, p);
  if (at_low <= 0.0)
    *found = po_root(excess_at, p, low, a[1]);
}

po_status po_maugis_outermost(const po_scene *scene, double tension, po_fixed fixed, double value,
                              double *contact_radius) {
  passage p = {{scene, tension, fixed, NO_GUESS}, value};
  po_maugis here;
  double a[2] = {0.0, 0.0}, excess[2] = {NAN, NAN}, rate[2] = {NAN, NAN};
  *contact_radius = NAN;
  po_status status = check_input(scene, tension, 0.0);
  if (!status)
    status = solve(scene, tension, 0.0, &NO_GUESS, &here);
  a[1] = PO_NEAR_AXIS * fmin(here.end, po_jkr_profile_first(scene));
  const double kink = po_profile_shape(&scene->profile).kink;
  for (int k = 0; k < MOST_RADII && !status; ++k) {
    status = rate_beyond(&p.s, a[1], &here, &rate[1]);
    if (status)
      break;
    excess[1] = value_of(&p.s, &here) - value;
    take_passage(&p, a, excess, rate, contact_radius);
    if (is_beyond(&p.s, &here, fmax(value, 0.0)))
      return *contact_radius > 0.0
                 ? PO_OK
                 : po_fail(PO_NOT_FOUND, "Maugis-Dugdale has no stable state at %s %.9g",
                           fixed == PO_FIXED_LOAD ? "load" : "approach", value);
    a[0] = a[1];
    excess[0] = excess[1];
    rate[0] = rate[1];
    if (a[1] == kink)
      a[0] = kink * (1.0 + PO_BESIDE), status = rate_beyond(&p.s, a[0], &here, &rate[0]);
    a[1] = next_radius(&p.s, a[1]);
  }
  return status ? status
                : po_fail(PO_TOO_MANY_POINTS,
                          "the %s %.9g of Maugis-Dugdale is not found up to the contact radius %g: "
                          "expected fewer waves",
                          fixed == PO_FIXED_LOAD ? "load" : "approach", value, a[1]);
}

/* The part of the gap outside the contact that the tension makes at r, over 2 q k: the integral of
 * sqrt(c^2 - x^2)/sqrt(r^2 - x^2) from a to the lesser of r and c. */
typedef struct {
  double r, c;
} two_radii;

static double from_tension(double x, po_abel t, const void *data) {
  const two_radii *at = data;
  (void)t;
  return at->r < at->c ? sqrt((at->c - x) * (at->c + x))
                       : (at->c - x) * (at->c + x) / sqrt((at->r - x) * (at->r + x));
}

static double gap_at(const ring *m, const lengths *l, double r) {
  const two_radii at = {r, l->c};
  const double profile = po_abel_opening(m->scene, m->a, m->at.g, r);
  const double angle = po_atan2(sqrt((r - m->a) * (r + m->a)), m->a);
  const double part = po_abel_integral(m->scene, m->a, fmin(r, l->c), true, from_tension, &at);
  return M_2_PI * (profile + 2.0 * m->tension * m->coupling * (l->s * angle - part));
}

static double from_rate(double x, po_abel t, const void *data) {
  const double r = *(const double *)data;
  return t.rate / sqrt((x - r) * (x + r));
}

/* The pressure at r inside the contact, w/eps. */
static double pressure_at(const ring *m, const lengths *l, double r) {
  const double profile = po_abel_integral(m->scene, r, m->a, false, from_rate, &r);
  const double angle = po_atan2(l->s, sqrt((m->a - r) * (m->a + r)));
  return profile / (M_PI * m->coupling) - M_2_PI * m->tension * angle;
}

/* Radii that are looked at, at most, and the rounding of what is found there. */
enum { MOST_LOOKS = 20000 };
static const double ROUNDING = 1e-6;

static po_status refuse(const char *what, double value, double r) {
  return po_fail(PO_BAD_INPUT,
                 "Maugis-Dugdale needs a full disc of contact and a ring of tension around it, but "
                 "%s is %g at radius %g: expected shallower waves, another contact radius or "
                 "another tension",
                 what, value, r);
}

static po_status check_radius(const ring *m, const lengths *l, double r) {
  const double whole = 1.0 / m->tension;
  if (r < m->a) {
    const double pressure = pressure_at(m, l, r);
    return pressure < -(1.0 + ROUNDING) * m->tension
               ? refuse("the pressure in the contact", pressure, r)
               : PO_OK;
  }
  const double gap = gap_at(m, l, r);
  const bool is_right = r < l->c ? gap > -ROUNDING * whole && gap < (1.0 + ROUNDING) * whole
                                 : gap > (1.0 - ROUNDING) * whole;
  return is_right ? PO_OK : refuse(r < l->c ? "the gap of the ring" : "the gap outside", gap, r);
}

po_status po_maugis_check(const po_scene *scene, double tension, const po_maugis *state) {
  const ring m = ring_of(scene, tension, state->contact.contact_radius);
  const lengths l = lengths_of(&m, state->width);
  if (!po_scene_is_wavy(scene) && po_abel_fall(scene) == 0.0)
    return PO_OK;
  /* Outside, the deflection is at least -greatest a/r, as in po_jkr_profile_check, less that of the
   * tension, which attracts. */
  double greatest = po_abel_of_profile(scene, l.c).g + po_abel_fall(scene) * l.c -
                    po_abel_waves_least(scene, 0.0, l.c).g - state->contact.approach +
                    2.0 * tension * m.coupling * l.s;
  for (size_t k = 0; k < po_scene_waves(scene); ++k)
    greatest += 1.3 * M_PI_2 * po_scene_wave(scene, k).amplitude;
  double r = fmin(PO_NEAR_AXIS * l.c, po_abel_detail(scene, l.c));
  for (int k = 0; k < MOST_LOOKS; ++k) {
    const double lowest = po_profile_gap_beyond(&scene->profile, scene->radius, r);
    if (r > l.c && lowest - state->contact.approach - greatest * l.c / r > 1.0 / tension)
      return PO_OK;
    const po_status status = r == m.a ? PO_OK : check_radius(&m, &l, r);
    if (status)
      return status;
    r += 2.0 * po_abel_detail(scene, r);
  }
  return po_fail(PO_TOO_MANY_POINTS,
                 "the gap has more than %d points to look at: expected fewer waves", MOST_LOOKS);
}
