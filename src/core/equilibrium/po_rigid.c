#include "po_rigid.h"

#include <math.h>

#include "po_deadline.h"
#include "po_elementary.h"
#include "po_far_energy.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_panel_table.h"
#include "po_quadrature.h"
#include "po_scales.h"

/* Bound of the change of the load by elasticity, over mu^(3/2): the deflection is at most 2
 * coupling integral |p| dr, about 3 mu^(3/2) eps, and the load changes by at most 2 for each eps of
 * it. A law whose greatest tension is q times USUAL_TENSION, about that of Lennard-Jones, acts over
 * 1/q of the gap, q^(-1/2) of the radius: the deflection is q^(1/2) times as great, and the load
 * changes q times as fast with it. A scene with less than NEGLIGIBLE_LOAD is solved as rigid. */
static const double ELASTIC_EFFECT = 6.0, USUAL_TENSION = 1.03, NEGLIGIBLE_LOAD = 1e-8;

/* Relative and absolute accuracy of each piece of the quadrature. Without the latter, some loads
 * take more bisections, and their last bits differ. */
static const double PIECE_ACCURACY = 1e-12, SMALL = 1e-14;

double po_rigid_elastic_effect(const po_scene *scene) {
  const double reach = po_initial_gap_radius(scene, 0.5); /* sqrt(R) for a sphere */
  const double tension = -po_law_at(&scene->law, po_law_numbers_of(&scene->law)->peak_gap).traction;
  const double q = fmax(1.0, tension / USUAL_TENSION);
  return q * sqrt(q) * ELASTIC_EFFECT * scene->tabor * sqrt(scene->tabor) *
         (reach / sqrt(scene->radius));
}

bool po_rigid_suffices(const po_scene *scene) {
  return po_rigid_elastic_effect(scene) <= NEGLIGIBLE_LOAD;
}

/* The integrand: p, dp/dH, or the energy per area phi. */
enum { TRACTION, SLOPE, ENERGY };

typedef struct {
  const po_scene *scene;
  double approach, begin; /* begin: radius beyond which the profile is a power of r */
  double first;           /* least length of a piece without waves, first_edge */
  int of;                 /* TRACTION, SLOPE or ENERGY */
  bool from_zero;         /* far out the energy is relative to that at approach 0 */
  bool relative;          /* it is at the radius of the piece */
  bool averaged;          /* the waves are averaged */
} integral;

/* The integrand at a gap; with `mean`, its average over the waves about that mean gap. */
static double law_at(const integral *q, double gap, bool mean) {
  const po_law *law = &q->scene->law;
  const double amplitude = mean ? po_initial_gap_amplitude(q->scene) : 0.0;
  if (q->of == ENERGY)
    return mean ? po_law_energy_averaged(law, gap, amplitude) : po_law_energy(law, gap);
  const po_law_value p = mean ? po_law_averaged(law, gap, amplitude) : po_law_at(law, gap);
  return q->of == SLOPE ? p.slope : p.traction;
}

static double at_gap(const integral *q, double initial) {
  const double zero = q->relative ? law_at(q, initial, q->averaged) : 0.0;
  return law_at(q, initial - q->approach, q->averaged) - zero;
}

static double inside(double r, void *data) {
  const integral *q = data;
  return at_gap(q, q->averaged ? po_initial_gap_mean(q->scene, r) : po_initial_gap(q->scene, r)) *
         r;
}

static double beyond(double t, void *data) { /* r = begin / t */
  const integral *q = data;
  const double r = q->begin / t;
  return inside(r, data) * r / t;
}

/* The length over which the traction changes at the axis, eps: for Lennard-Jones 1 - approach. */
static double distance_at(const integral *q) {
  return po_law_size(&q->scene->law, -q->approach);
}

/* The radius of the profile at which the gap has changed by that distance. */
static double first_edge(const integral *q) {
  return po_initial_gap_radius(q->scene, distance_at(q));
}

/* The end of the piece of the quadrature that begins at r: half a wave further, so that each piece
 * has one crest or trough; without waves, or with averaged ones, twice the radius. The profile is
 * analytic on a piece. */
static double next_edge(const integral *q, double r) {
  const double joint = po_profile_next_joint(&q->scene->profile, r);
  if (po_scene_is_wavy(q->scene) && !q->averaged)
    return fmin(joint, r + 0.5 * po_initial_gap_detail(q->scene));
  return fmin(joint, fmax(2.0 * r, q->first));
}

/* Largest c/y for which short waves are averaged, with c = lambda^2/(8 pi^2 R) and y = 1 -
 * approach. The load of short waves is that of the averaged law less 4c sum_j a_j/j^2, where a_j
 * are the Fourier coefficients of the law over the wave at the axis (two integrations by parts,
 * whose other boundary terms vanish). The next term is smaller by about 50 c/y; the error is below
 * 1e-11 of the load at this limit. Scenes above the limit have a few thousand waves at most.
 * Compared with the integral over every wave in tests/unit/test_rigid.c, which also has a scene
 * with more waves than MOST_PIECES. */
static const double SHORT_WAVES = 1e-7;
/* Largest number of half waves that are integrated one by one; the load then takes 0.1 s. */
static const double MOST_PIECES = 5e4;

static bool has_short_waves(const integral *q) {
  const double length = q->scene->wavelength / M_PI, c = length * length / (8.0 * q->scene->radius);
  return po_scene_is_wavy(q->scene) && po_scene_is_of_paper(q->scene) &&
         c < SHORT_WAVES * distance_at(q);
}

/* The integrand of the correction for short waves: the law at the phase phi of the wave at the
 * axis, times sum_j cos(j phi)/j^2. */
static double at_axis(double phi, void *data) {
  const integral *q = data;
  const double half = po_sin(0.5 * phi);
  const double gap = 2.0 * q->scene->amplitude * half * half - q->approach;
  const double sum = M_PI * M_PI / 6.0 - 0.5 * phi * (M_PI - 0.5 * phi);
  return law_at(q, gap, false) * sum;
}

/* Adds the integral of a function between two values of its variable to *sum. */
static po_status add_piece(po_integrand function, integral *q, double from, double to,
                           double *sum) {
  double part;
  const po_status status = po_integrate(function, q, from, to, SMALL, PIECE_ACCURACY, &part);
  *sum += part;
  return status;
}

/* A piece between two rows of a table, on which the gap is a cubic, is short if the gap changes by
 * at most SHORT of the length of the law. Gauss's rule of FEW points then leaves out less than
 * SHORT^(2 FEW), 1e-16 times a coefficient of 1e2 for Lennard-Jones: tables of many rows take a
 * fifth of the time. */
enum { FEW = 4 };
static const double SHORT = 0.01;
static const double FEW_NODE[FEW] = {0.06943184420297371, 0.33000947820757187, 0.6699905217924281,
                                     0.9305681557970263};
static const double FEW_WEIGHT[FEW] = {0.17392742256872693, 0.32607257743127307,
                                       0.32607257743127307, 0.17392742256872693};

/* Adds a piece if it is short. Returned: whether it is. */
static bool add_short(const integral *q, double from, double to, double *sum) {
  const po_scene *scene = q->scene;
  double r[FEW], gap[FEW], least = INFINITY, most = -INFINITY, part = 0.0;
  if (!po_profile_is_table(&scene->profile) || (po_scene_is_wavy(scene) && !q->averaged))
    return false;
  for (int k = 0; k < FEW; ++k) {
    r[k] = from + (to - from) * FEW_NODE[k];
    gap[k] = po_initial_gap_mean(scene, r[k]);
    least = fmin(least, gap[k]);
    most = fmax(most, gap[k]);
  }
  if (most - least > SHORT * po_law_size(&scene->law, least - q->approach))
    return false;
  for (int k = 0; k < FEW; ++k)
    part += FEW_WEIGHT[k] * at_gap(q, gap[k]) * r[k];
  *sum += (to - from) * part;
  return true;
}

/* Adds the integral between two radii, piece by piece. */
static po_status add_pieces(integral *q, double from, double end, double *sum) {
  po_status failed = PO_OK;
  for (double r = from; r < end && !failed;) {
    const double to = fmin(next_edge(q, r), end);
    if (!add_short(q, r, to, sum))
      failed = add_piece(inside, q, r, to, sum);
    r = to;
  }
  return failed;
}

/* Adds the correction for short waves, which are averaged from the axis on. */
static po_status add_correction(integral *q, double *sum) {
  double at_the_axis = 0.0;
  const po_status failed = add_piece(at_axis, q, 0.0, M_PI, &at_the_axis);
  const double length = q->scene->wavelength / M_PI;
  *sum -= length * length / (2.0 * M_PI) * at_the_axis;
  return failed;
}

/* Adds the integral from the radius at which averaging begins to infinity. The rows of a table that
 * are farther out are integrated one by one: in one piece with what follows them, their undulations
 * would need more bisections than the quadrature has, or be passed over. */
static po_status add_outside(integral *q, double end, double *sum) {
  const double rows = po_profile_shape(&q->scene->profile).end;
  q->averaged = po_scene_is_wavy(q->scene);
  q->relative = q->from_zero;
  q->begin = isfinite(rows) ? fmax(end, rows) : end;
  const po_status failed = add_pieces(q, end, q->begin, sum);
  if (failed)
    return failed;
  q->averaged = true;
  if (q->of != ENERGY || !po_far_energy_is_apart(q->scene))
    return add_piece(beyond, q, 0.0, 1.0, sum);
  if (!po_panel_table_get())
    return PO_NO_MEMORY;
  const double gap = po_initial_gap_mean(q->scene, q->begin) - q->approach;
  *sum += po_far_energy(q->scene, q->begin, 1, &q->begin, &gap, q->approach); /* no deflection */
  return PO_OK;
}

/* The integral is taken piece by piece at least to the radius with this initial gap less the
 * approach. */
static const double NEAR_GAP = 4.0;

static double reach_of(const po_scene *scene, double approach, bool from_zero) {
  return po_initial_gap_radius(scene, NEAR_GAP + (from_zero ? 1.0 : fmax(0.0, approach)));
}

double po_rigid_end(const po_scene *scene, double approach, bool from_zero) {
  const double reach = reach_of(scene, approach, from_zero);
  return po_averaging_radius(scene, po_averaging_phase(scene, reach));
}

static po_status integrate(integral *q, double *sum) {
  const po_scene *scene = q->scene;
  po_status failed = po_deadline_check();
  if (failed)
    return failed;
  const bool bounded = isfinite(scene->outer_radius);
  q->averaged = !bounded && has_short_waves(q);
  q->first = first_edge(q);
  const double end = bounded       ? scene->outer_radius
                     : q->averaged ? reach_of(scene, q->approach, q->from_zero)
                                   : po_rigid_end(scene, q->approach, q->from_zero);
  const double pieces =
      po_scene_is_wavy(scene) && !q->averaged ? 2.0 * end / po_initial_gap_detail(scene) : 0.0;
  if (!(pieces <= MOST_PIECES))
    return po_fail(PO_OUT_OF_NODES,
                   "the rigid %s would be the sum of %.3g half waves up to radius %g, more than "
                   "%g; expected a longer wavelength or a smaller outer radius%s",
                   q->of == ENERGY ? "energy" : "load", pieces, end, MOST_PIECES,
                   bounded ? ", or none" : "");
  *sum = 0.0;
  if (q->averaged)
    failed = add_correction(q, sum);
  if (!failed)
    failed = add_pieces(q, 0.0, end, sum);
  if (!bounded && !failed)
    failed = add_outside(q, end, sum);
  return failed ? po_fail(failed, "the quadrature of the rigid %s failed at approach %g",
                          q->of == ENERGY ? "energy" : "load", q->approach)
                : PO_OK;
}

/* (2/R) times the integral of an integrand over r dr; 0 if it fails. */
static po_status integral_of(const po_scene *scene, double approach, int of, double *value) {
  integral q = {.scene = scene,
                .approach = approach,
                .of = of,
                .from_zero = of == ENERGY && po_scene_has_infinite_energy(scene)};
  *value = 0.0;
  const po_status status = integrate(&q, value);
  *value *= 2.0 / scene->radius;
  return status;
}

po_status po_rigid_load(const po_scene *scene, double approach, double *load, double *load_rate) {
  double slope = 0.0;
  po_status status = integral_of(scene, approach, TRACTION, load);
  if (!status)
    status = integral_of(scene, approach, SLOPE, &slope);
  *load_rate = -slope; /* dH = -d(approach) */
  return status;
}

po_status po_rigid_energy(const po_scene *scene, double approach, double *energy) {
  return integral_of(scene, approach, ENERGY, energy);
}

double po_rigid_approach_of_crest(const po_scene *scene, double load) {
  const double crest = 1.0 / (1.0 + 4.0 * M_PI * M_PI * po_scene_alpha(scene));
  return po_law_approach_of_push(&scene->law, crest, load);
}
