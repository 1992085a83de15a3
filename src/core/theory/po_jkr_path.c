#include "po_margins.h"
#include "po_theory_forces.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "po_deadline.h"
#include "po_elementary.h"
#include "po_guduru.h"
#include "po_initial_gap.h"
#include "po_jkr_profile.h"
#include "po_loop.h"
#include "po_memory.h"
#include "po_quadrature.h"
#include "po_root.h"
#include "po_staircase.h"

/* PATH_POINTS_PER_WAVE: points of the curve in a wavelength. RULE: points of the Gauss rule for the
 * energy between two of them. MOST_LENGTHS: extensions of the curve, at most. */
enum { PATH_POINTS_PER_WAVE = 128, RULE = 8, MOST_LENGTHS = 10 };
/* A general curve has at most so many points, which take some seconds. */
enum { MOST_POINTS = 1 << 18 };
/* Steps of Newton's method from an interpolated state, whose contact radius is off by some 1e-9 of
 * it; and the longest step, over the radius. */
enum { SHARPENING = 3 };
static const double NEAR = 1e-6;
/* The least approach, eps, of a preload that presses the bodies into contact: twice the tolerance
 * with which a curve reaches an approach (po_path_reaches). */
static const double TOUCH = 2e-9;
/* Two loads that differ by less, relatively, are the same: above the rounding of a minimum, which
 * is 1e-14. */
static const double SAME = 1e-9;

/* The curve of a scene. For those of the paper it is that of Eq 5, for all others that of
 * po_jkr_profile.h. */
typedef struct {
  const po_scene *scene;
  po_contact (*at)(const po_scene *scene, double a);
  double (*rate)(const po_scene *scene, po_fixed fixed, double a); /* dW/da, dDelta/da */
  double first;     /* contact radius of the first point */
  double size;      /* about the contact radius at pull-off */
  double wave;      /* the shortest wavelength, or the size if that is less */
  double long_wave; /* the longest wavelength; 0 without waves */
  double kink;      /* radius at which the slope of the profile jumps; NAN: none */
  size_t most;      /* points */
} jkr_curve;

/* Sets the curve and its pull-off at given load. */
static po_status curve_of(const po_scene *scene, jkr_curve *c, po_contact *least) {
  if (!(scene->tabor > 0.0))
    return po_fail(PO_BAD_INPUT, "tabor is %g: expected a number > 0 for the JKR theory",
                   scene->tabor);
  const bool wavy = po_scene_is_wavy(scene);
  *c = (jkr_curve){.scene = scene,
                   .at = po_guduru_at,
                   .rate = po_guduru_rate,
                   .size = po_scene_gamma(scene),
                   .kink = po_profile_shape(&scene->profile).kink,
                   .long_wave = wavy ? scene->wavelength : 0.0,
                   .most = SIZE_MAX};
  c->wave = wavy ? fmin(scene->wavelength, c->size) : c->size;
  c->first = PO_GUDURU_FIRST * c->wave;
  if (po_scene_is_of_paper(scene)) {
    *least = po_guduru_pull_off(scene);
    return PO_OK;
  }
  c->at = po_jkr_profile_at;
  c->rate = po_jkr_profile_rate;
  c->most = MOST_POINTS;
  c->first = PO_GUDURU_FIRST * po_jkr_profile_first(scene);
  const po_status status = po_jkr_profile_pull_off(scene, PO_FIXED_LOAD, least);
  c->size = c->wave = least->contact_radius;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    c->wave = fmin(c->wave, po_scene_wave(scene, k).length);
    c->long_wave = fmax(c->long_wave, po_scene_wave(scene, k).length);
  }
  return status;
}

typedef struct {
  const jkr_curve *curve;
  po_curve_point *point;
  size_t count, room;
  double node[RULE], weight[RULE];
  double energy, last; /* the energy at position `last` */
} builder;

static double approach_rate(double a, const void *data) {
  const jkr_curve *c = data;
  return c->rate(c->scene, PO_FIXED_APPROACH, a);
}

static double load_rate(double a, const void *data) {
  const jkr_curve *c = data;
  return c->rate(c->scene, PO_FIXED_LOAD, a);
}

/* Beyond a kink b load and approach are smooth in sqrt(a^2 - b^2): the position is b plus this. */
static double position_of(const jkr_curve *c, double a) {
  return a > c->kink ? c->kink + sqrt((a - c->kink) * (a + c->kink)) : a;
}

static double radius_at(const jkr_curve *c, double position) {
  return position > c->kink ? po_hypot(position - c->kink, c->kink) : position;
}

/* da/dposition */
static double radius_rate(const jkr_curve *c, double a) {
  return a > c->kink ? sqrt((a - c->kink) * (a + c->kink)) / a : 1.0;
}

static po_status append(builder *b, po_curve_point point) {
  if (b->count == b->curve->most)
    return po_fail(PO_TOO_MANY_POINTS, "the JKR curve has more than %zu points", b->curve->most);
  po_curve_point *moved = po_grow(b->point, b->count, &b->room, sizeof *moved);
  if (!moved)
    return PO_NO_MEMORY;
  b->point = moved;
  b->point[b->count++] = point;
  return PO_OK;
}

/* Appends the equilibrium of contact radius a. The energy is integrated from the previous one with
 * the Gauss rule. */
static po_status append_contact(builder *b, double a) {
  const jkr_curve *curve = b->curve;
  const double position = position_of(curve, a), step = position - b->last;
  for (int k = 0; k < RULE; ++k) {
    const double s = radius_at(curve, b->last + step * b->node[k]);
    b->energy += step * b->weight[k] * curve->at(curve->scene, s).load *
                 (approach_rate(s, curve) * radius_rate(curve, s));
  }
  b->last = position;
  const po_contact c = curve->at(curve->scene, a);
  const double rate = radius_rate(curve, a);
  return append(b, (po_curve_point){.approach = c.approach,
                                    .load = c.load,
                                    .energy = b->energy,
                                    .approach_rate = approach_rate(a, curve) * rate,
                                    .load_rate = load_rate(a, curve) * rate,
                                    .contact_radius = a,
                                    .position = position});
}

/* Appends the last point again with the rates on its right. */
static po_status append_corner(builder *b) {
  const jkr_curve *c = b->curve;
  const double beside = c->kink * (1.0 + PO_BESIDE), rate = radius_rate(c, beside);
  po_curve_point point = b->point[b->count - 1];
  point.approach_rate = approach_rate(beside, c) * rate;
  point.load_rate = load_rate(beside, c) * rate;
  return append(b, point);
}

/* Appends the folds and extrema between two contact radii in order, then the second contact
 * radius. */
static po_status append_up_to(builder *b, double left, double right) {
  const double from = left == b->curve->kink ? left * (1.0 + PO_BESIDE) : left;
  const double fold = po_root(approach_rate, b->curve, from, right);
  const double extremum = po_root(load_rate, b->curve, from, right);
  /* NaN if there is none; fmin and fmax then return the other */
  const double first = fmin(fold, extremum), second = fmax(fold, extremum);
  po_status status = PO_OK;
  if (first > left && first < right)
    status = append_contact(b, first);
  if (!status && second > first && second < right)
    status = append_contact(b, second);
  if (!status)
    status = append_contact(b, right);
  return !status && right == b->curve->kink ? append_corner(b) : status;
}

/* Sets the stability and the minima of all points: an equilibrium is stable at fixed approach where
 * the approach increases with the contact radius. A corner is two points. */
static void mark_points(builder *b) {
  for (size_t k = 0; k + 1 < b->count; ++k) {
    po_curve_point *p = &b->point[k];
    p->unstable_modes = p[1].approach <= p->approach;
    const po_curve_point *next =
        p[1].position == b->curve->kink && k + 2 < b->count ? p + 2 : p + 1;
    p->minimum = k > 0 && p->load < p[-1].load && p->load < next->load;
  }
}

/* The JKR curve: the separated bodies at load 0 up to the first contact at approach 0, then every
 * contact radius up to `end` (eps). Folds and extrema of the load are points; the energy is
 * integrated from the loads. `position` is the contact radius, negative before contact; beyond an
 * edge b of the profile it is b + sqrt(a^2 - b^2). A corner is two points at one position. The
 * curve begins farther out than every jump. Accuracy: special points to rounding, energies to
 * 1e-12. */
static po_status build(builder *b, double end) {
  const jkr_curve *c = b->curve;
  po_status status = po_gauss_rule(RULE, b->node, b->weight);
  if (!status) /* the separated bodies; the approach is set below */
    status = append(b, (po_curve_point){.position = -1.0});
  if (!status)
    status = append(b, (po_curve_point){.position = 0.0});
  if (!status) /* the first contact again, with the derivatives for positions above 0 */
    status = append(b, (po_curve_point){.approach_rate = -1.0});
  double left = c->first;
  if (!status)
    status = append_contact(b, left);
  while (left < end && !status) {
    const double right = fmin(fmin(PO_NEXT_RADIUS * left, left + c->wave / PATH_POINTS_PER_WAVE),
                              po_profile_next_joint(&c->scene->profile, left));
    status = append_up_to(b, left, right);
    left = right;
    if (!status)
      status = po_deadline_check();
  }
  double least = 0.0;
  for (size_t k = 0; k < b->count; ++k)
    least = fmin(least, b->point[k].approach);
  if (!status) {
    b->point[0].approach = 2.0 * least;
    b->point[0].approach_rate = b->point[1].approach_rate = -2.0 * least; /* by the position */
    mark_points(b);
  }
  return status;
}

/* Returned: whether in every staircase some preload gives the lowest load of the curve. */
static bool reach_load(const po_staircases *staircases, double load) {
  bool reached = true;
  for (int k = 0; k < 2 + staircases->has_spring; ++k) {
    const po_step *step = po_staircase_greatest(&staircases->of[k]);
    reached = reached && step && step->pull_off.load <= load * (1.0 - SAME);
  }
  return reached;
}

po_status po_jkr_staircases(const po_scene *scene, po_control spring, po_staircases *staircases) {
  *staircases = (po_staircases){.has_spring = false};
  jkr_curve curve;
  po_contact least;
  po_status status = curve_of(scene, &curve, &least);
  double end = 2.0 * fmax(least.contact_radius, curve.size);
  for (int k = 0; k < MOST_LENGTHS && !status; ++k, end *= PO_FARTHER) {
    builder b = {.curve = &curve};
    po_staircases_clear(staircases);
    status = build(&b, end);
    if (!status)
      status = po_staircases_read(&(po_path){b.point, b.count}, spring, staircases);
    free(b.point);
    if (reach_load(staircases, least.load))
      break;
  }
  return status;
}

po_status po_jkr_hysteresis(const po_scene *scene, po_preload preload, po_control spring,
                            size_t most, po_hysteresis *hysteresis) {
  *hysteresis = (po_hysteresis){.has_spring = false};
  if (preload.load == 0.0) /* the separated bodies have no load, and are not what is asked for */
    preload.load = DBL_MIN;
  if (preload.approach >= 0.0 && preload.approach < TOUCH) /* bodies that touch are in contact */
    preload.approach = TOUCH;
  jkr_curve curve;
  po_contact least;
  po_status status = curve_of(scene, &curve, &least);
  if (status)
    return status;
  curve.most = curve.most < most ? curve.most : most;
  double end = 4.0 * curve.size + 2.0 * curve.long_wave;
  if (preload.approach > 0.0)
    end += po_initial_gap_radius(scene, preload.approach);
  status = PO_NOT_FOUND;
  for (int k = 0; k < MOST_LENGTHS && status == PO_NOT_FOUND; ++k, end *= PO_FARTHER) {
    builder b = {.curve = &curve};
    status = build(&b, end);
    if (!status)
      status =
          po_hysteresis_follow(&(po_path){b.point, b.count}, preload, spring, false, hysteresis);
    if (!status && !hysteresis->has_load) {
      po_hysteresis_clear(hysteresis);
      status = PO_NOT_FOUND; /* a longer curve has one */
    }
    free(b.point);
  }
  return status;
}

/* The state of the curve next to one that was interpolated, at the same load or approach. */
static po_contact sharpened(const jkr_curve *c, const po_path_state *state, po_fixed fixed) {
  if (!(state->position > 0.0))
    return (po_contact){.load = 0.0, .approach = state->approach, .contact_radius = 0.0};
  double a = radius_at(c, state->position);
  for (int k = 0; k < SHARPENING; ++k) {
    const po_contact here = c->at(c->scene, a);
    const double rate = c->rate(c->scene, fixed, a), miss = fixed == PO_FIXED_LOAD
                                                                ? state->load - here.load
                                                                : state->approach - here.approach;
    if (!(fabs(miss) <= NEAR * fabs(rate) * a)) /* at a special point, which is exact */
      break;
    a += miss / rate;
  }
  return c->at(c->scene, a);
}

po_status po_jkr_after_preload(const po_scene *scene, po_preload preload, po_jkr_preloaded *state) {
  po_hysteresis loops;
  jkr_curve curve;
  po_contact least;
  po_status status = po_jkr_hysteresis(scene, preload, (double)NAN, MOST_POINTS, &loops);
  if (!status) {
    status = curve_of(scene, &curve, &least);
    const po_loop *loop = &loops.of[PO_AT_APPROACH];
    const bool by_load =
        fabs(loop->preload.load - preload.load) <= SAME * fmax(1.0, fabs(preload.load));
    po_path_state reversal = loop->preload;
    if (by_load) /* the number that was asked for */
      reversal.load = preload.load;
    else if (fabs(reversal.approach - preload.approach) <= TOUCH)
      reversal.approach = preload.approach;
    *state = (po_jkr_preloaded){
        sharpened(&curve, &reversal, by_load ? PO_FIXED_LOAD : PO_FIXED_APPROACH),
        sharpened(&curve, &loop->pull_off, PO_FIXED_APPROACH), (size_t)loop->loading_jumps};
    if (loop->pull_off.position == loop->preload.position)
      state->pull_off = state->reversal;
  }
  po_hysteresis_clear(&loops);
  return status;
}
