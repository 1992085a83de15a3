#include "po_rigid_profile.h"

#include <math.h>

#include "po_deadline.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law_kind.h"
#include "po_profile_kind.h"
#include "po_quadrature.h"
#include "po_root.h"
#include "po_scales.h"
#include "po_special.h"

/* p is a sum of two terms, factor (1 + H)^-exponent or factor exp(-exponent H). */
typedef struct {
  double factor[2], exponent[2];
  bool is_exponential;
} law_terms;

static bool terms_of(const po_law *law, law_terms *t) {
  const po_law_kind *kind = law->kind ? law->kind : &PO_LENNARD_JONES;
  if (kind == &PO_MORSE) {
    const double a = law->parameter[PO_MORSE_A];
    *t = (law_terms){{-2.0 * a, 2.0 * a}, {a, 2.0 * a}, true};
    return true;
  }
  if (kind != &PO_MIE && kind != &PO_LENNARD_JONES)
    return false;
  const double m = kind == &PO_MIE ? law->parameter[PO_MIE_M] : 3.0,
               n = kind == &PO_MIE ? law->parameter[PO_MIE_N] : 9.0;
  const double k = (m - 1.0) * (n - 1.0) / (n - m);
  *t = (law_terms){{-k, k}, {m, n}, false};
  return true;
}

/* A profile without waves is flat up to a radius, and beyond it the area within the radius of gap h
 * grows as the sum of 2 factor h^q/q: the load is pi flat^2 p(-D) plus 2 pi factor times the moment
 * of each q. A power C r^n has q = 2/n and the factor C^-q/n. */
typedef struct {
  double flat, factor[2], q[2];
} area_terms;

static bool areas_of(const po_scene *scene, area_terms *t) {
  const po_profile_kind *kind = scene->profile.kind ? scene->profile.kind : &PO_SPHERE;
  const double *of = scene->profile.parameter;
  *t = (area_terms){.q = {1.0, 0.5}};
  if (kind == &PO_SPHERE) {
    t->factor[0] = scene->radius;
  } else if (kind == &PO_POWER) {
    t->q[0] = 2.0 / of[PO_POWER_N];
    t->factor[0] = po_pow(of[PO_POWER_C], -t->q[0]) / of[PO_POWER_N];
  } else if (kind == &PO_CONE) {
    t->q[0] = 2.0;
    t->factor[0] = 1.0 / (of[PO_CONE_T] * of[PO_CONE_T]);
  } else if (kind == &PO_TRUNCATED) {
    t->flat = of[PO_TRUNCATED_B];
    t->factor[0] = of[PO_TRUNCATED_R];
  } else if (kind == &PO_PUNCH) { /* r = b + sqrt(2 R h) */
    t->flat = of[PO_PUNCH_B];
    t->factor[0] = of[PO_PUNCH_R];
    t->factor[1] = t->flat * sqrt(0.5 * of[PO_PUNCH_R]);
  } else if (kind == &PO_HYPERBOLOID) { /* r^2 = (h/t)^2 + 2 b h/t */
    t->factor[0] = of[PO_HYPERBOLOID_B] / of[PO_HYPERBOLOID_T];
    t->factor[1] = 1.0 / (of[PO_HYPERBOLOID_T] * of[PO_HYPERBOLOID_T]);
    t->q[1] = 2.0;
  } else {
    return false;
  }
  return !po_scene_is_wavy(scene) && isinf(scene->outer_radius);
}

/* Adds factor times the moment, the integral of p(h - D) h^(q - 1) over h from 0: Beta functions of
 * powers, Gamma functions of exponentials; and its derivative by D. */
static void add_moment(const law_terms *law, double approach, double q, double factor, double *load,
                       double *rate) {
  for (int i = 0; i < 2; ++i) {
    const double e = law->exponent[i], k = factor * law->factor[i], x = 1.0 - approach;
    if (law->is_exponential) {
      const double part = k * po_gamma(q) * po_exp(e * approach) * po_pow(e, -q);
      *load += part;
      *rate += e * part;
    } else {
      const double part = k * po_beta(q, e - q) * po_pow(x, q - e);
      *load += part;
      *rate += (e - q) / x * part;
    }
  }
}

static bool closed_load(const po_scene *scene, double approach, double *load, double *rate) {
  law_terms law;
  area_terms area;
  if (!terms_of(&scene->law, &law) || !areas_of(scene, &area))
    return false;
  const po_law_value flat = po_law_at(&scene->law, -approach);
  *load = 0.5 * area.flat * area.flat * flat.traction;
  *rate = -0.5 * area.flat * area.flat * flat.slope;
  for (int j = 0; j < 2 && area.factor[j] > 0.0; ++j)
    add_moment(&law, approach, area.q[j], area.factor[j], load, rate);
  *load *= 2.0 / scene->radius;
  *rate *= 2.0 / scene->radius;
  return true;
}

typedef struct {
  const po_scene *scene;
  double approach, begin; /* begin: the radius beyond which the law is averaged over the waves */
  bool slope;
} integrand;

static double near_axis(double r, void *data) {
  const integrand *q = data;
  const po_law_value p = po_law_at(&q->scene->law, po_initial_gap(q->scene, r) - q->approach);
  return r * (q->slope ? -p.slope : p.traction);
}

static double averaged(double r, void *data) {
  const integrand *q = data;
  const double gap = po_initial_gap_mean(q->scene, r) - q->approach;
  const po_law_value p = po_law_averaged(&q->scene->law, gap, po_initial_gap_amplitude(q->scene));
  return (q->slope ? -p.slope : p.traction) * r;
}

/* r = begin/t */
static double far_out(double t, void *data) {
  const integrand *q = data;
  const double r = q->begin / t;
  return averaged(r, data) * r / t;
}

/* The quadrature of a piece is accurate to PIECE_ACCURACY, relative, or to SMALL times the area. */
static const double PIECE_ACCURACY = 1e-12, SMALL = 1e-15;
enum { MOST_PIECES = 50000 };
/* The pieces end beyond this gap, or beyond the reach of a law without far field; of a table the
 * rows beyond are pieces, too. */
static const double FARTHEST_GAP = 10.0;

static po_status add(po_integrand f, integrand *q, double from, double to, double area,
                     double *sum) {
  double part;
  const po_status status = po_integrate(f, q, from, to, SMALL * area, PIECE_ACCURACY, &part);
  *sum += part;
  return status ? po_fail(status, "the rigid load failed at approach %g", q->approach) : PO_OK;
}

static po_status integrate(integrand *q, double *sum) {
  const po_scene *scene = q->scene;
  const po_law *law = &scene->law;
  const double first = po_initial_gap_radius(scene, po_law_size(law, -q->approach));
  const bool has_far_field = isfinite(po_law_numbers_of(law)->exponent);
  const double gap =
      (has_far_field ? FARTHEST_GAP : po_law_numbers_of(law)->reach) + fmax(0.0, q->approach);
  const double whole =
      po_averaging_radius(scene, po_averaging_phase(scene, po_initial_gap_radius(scene, gap)));
  q->begin = fmin(whole, scene->outer_radius);
  *sum = 0.0;
  double r = 0.0;
  po_status status = PO_OK;
  for (int k = 0; r < q->begin && !status;) {
    const double wave = po_scene_is_wavy(scene) ? 0.5 * po_initial_gap_detail(scene) : INFINITY;
    const double joint = po_profile_next_joint(&scene->profile, r);
    const double to = fmin(fmin(r + wave, fmin(q->begin, joint)), fmax(first, 2.0 * r));
    k += to < joint; /* the rows of a table are no waves */
    if (k > MOST_PIECES)
      return po_fail(PO_TOO_MANY_POINTS,
                     "the rigid load has more than %d pieces: expected fewer waves", MOST_PIECES);
    status = add(near_axis, q, r, to, first * first, sum);
    if (!status)
      status = po_deadline_check();
    r = to;
  }
  if (status || !has_far_field || isfinite(scene->outer_radius))
    return status;
  for (const double rows = po_profile_shape(&scene->profile).end;
       isfinite(rows) && r < rows && !status; q->begin = r) {
    const double to = po_profile_next_joint(&scene->profile, r);
    status = add(averaged, q, r, to, first * first, sum);
    if (!status)
      status = po_deadline_check();
    r = to;
  }
  return status ? status : add(far_out, q, 0.0, 1.0, first * first, sum);
}

/* The load by quadrature, or its rate. */
static po_status quadrature(const po_scene *scene, double approach, bool slope, double *value) {
  integrand q = {.scene = scene, .approach = approach, .slope = slope};
  const po_status status = integrate(&q, value);
  *value *= 2.0 / scene->radius;
  return status;
}

po_status po_rigid_profile_quadrature(const po_scene *scene, double approach, double *load,
                                      double *rate) {
  const po_status status = quadrature(scene, approach, false, load);
  return status ? status : quadrature(scene, approach, true, rate);
}

po_status po_rigid_profile_load(const po_scene *scene, double approach, double *load,
                                double *rate) {
  *load = *rate = NAN;
  if (!(approach < -po_law_numbers_of(&scene->law)->closest))
    return po_fail(PO_BAD_INPUT, "the approach is %g: expected a number < %g", approach,
                   -po_law_numbers_of(&scene->law)->closest);
  return closed_load(scene, approach, load, rate)
             ? PO_OK
             : po_rigid_profile_quadrature(scene, approach, load, rate);
}

static po_status find_rate(const po_scene *scene, double approach, double *rate) {
  double load;
  return closed_load(scene, approach, &load, rate) ? PO_OK
                                                   : quadrature(scene, approach, true, rate);
}

static double rate_at(double approach, const void *data) {
  double rate = NAN;
  return find_rate(data, approach, &rate) ? NAN : rate;
}

/* The minimum of the load is looked for at SCAN_POINTS approaches. The gap on the axis goes from
 * SCAN_BEGIN times that of the greatest tension down to the singularity of the law, where even
 * sharp crests repel; of the distance 1 + H from it the part NEAREST is left. Once the load is
 * compressive it stays so: of the two terms of a law the repulsion has the greater logarithmic
 * derivative by the approach at every gap, and more so of the integrals, in which it has more
 * weight where the gap is small. */
enum { SCAN_POINTS = 200 };
static const double NEAREST = 1e-3, SCAN_BEGIN = 1.01;

po_status po_rigid_profile_pull_off(const po_scene *scene, po_rigid_pull_off *pull_off) {
  const double closest = -po_law_numbers_of(&scene->law)->closest,
               begin = closest + SCAN_BEGIN * po_law_numbers_of(&scene->law)->peak_gap;
  /* the distance from the closest approach, which falls by one factor */
  const double factor = po_pow(NEAREST * closest / begin, 1.0 / SCAN_POINTS);
  *pull_off = (po_rigid_pull_off){NAN, NAN};
  double x = begin, left = 0.0, left_rate = NAN, load = NAN;
  for (int k = 0; k <= SCAN_POINTS && !(load > 0.0); ++k, x *= factor) {
    const double right = closest - x;
    double rate;
    po_status status = find_rate(scene, right, &rate);
    if (status)
      return status;
    if (left_rate < 0.0 && rate >= 0.0) {
      const double at = po_root(rate_at, scene, left, right);
      status = po_rigid_profile_load(scene, at, &load, &left_rate);
      if (status)
        return status;
      if (!(-load <= pull_off->force))
        *pull_off = (po_rigid_pull_off){-load, at};
    }
    if (rate > 0.0)
      status = po_rigid_profile_load(scene, right, &load, &left_rate);
    if (status)
      return status;
    left = right;
    left_rate = rate;
  }
  return isnan(pull_off->force)
             ? po_fail(PO_NOT_FOUND, "the load of the rigid bodies has no minimum")
             : PO_OK;
}

/* Points of the rule, and the gap at which it ends: of the integral some percent are beyond it. */
enum { ELONGATION_POINTS = 400 };
static const double ELONGATION_GAP = 5.0;

double po_rigid_profile_elongation(const po_scene *scene, double approach) {
  const double end = fmin(scene->outer_radius, po_initial_gap_radius(scene, ELONGATION_GAP));
  double sum = 0.0;
  for (int k = 0; k < ELONGATION_POINTS; ++k) {
    const double r = end * (k + 0.5) / ELONGATION_POINTS;
    sum += fabs(po_law_at(&scene->law, po_initial_gap(scene, r) - approach).traction);
  }
  return 2.0 * po_scene_coupling(scene) * sum * end / ELONGATION_POINTS;
}
