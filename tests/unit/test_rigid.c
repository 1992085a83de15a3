/* The rigid limit against Bradley and against brute-force quadrature of Eq 22. */
#include <math.h>

#include "po_law.h"
#include "po_profile.h"
#include "po_rigid.h"
#include "po_rigid_trace.h"
#include "run.h"

static const double APPROACHES[] = {-30.0, -2.385, -0.3, 0.0, 0.385, 0.8};

/* Eq 23, written out here so that this test does not depend on the theory code. */
static double bradley(double approach) {
  const double x = 1.0 - approach;
  return -2.0 * (4.0 * pow(x, 6.0) - 1.0) / (3.0 * pow(x, 8.0));
}

TABLE_TEST(smooth_rigid_sphere_is_eq_23, APPROACHES) {
  const po_scene scene = {0.0, 0.0, 0.0, 83.0, INFINITY};
  const double approach = APPROACHES[_i];
  double load = NAN, rate = NAN;
  ck_assert_int_eq(po_rigid_load(&scene, approach, &load, &rate), PO_OK);
  ck_assert_double_eq_tol(load, bradley(approach), 1e-10 * fmax(1.0, fabs(load)));
  const double x = 1.0 - approach, exact = -16.0 / 3.0 * (pow(x, -3.0) - pow(x, -9.0));
  ck_assert_double_eq_tol(rate, exact, 1e-10 * fmax(1.0, fabs(exact)));
}

/* Eq 22 by a fine midpoint sum in theta with the first Euler-Maclaurin term at 0. Beyond 400
 * periods the gap is replaced by its mean over a period. */
static double eq_22(double alpha, double amplitude, double approach) {
  const double step = 4e-4 * M_PI, end = 800.0 * M_PI;
  const double x0 = 1.0 / (1.0 - approach);
  double sum = -step * step / 24.0 * (pow(x0, 3.0) - pow(x0, 9.0));
  for (double theta = 0.5 * step; theta < end; theta += step) {
    const double gap =
        -approach + amplitude * (theta * theta / (8.0 * M_PI * M_PI * alpha) + 1.0 - cos(theta));
    const double x = 1.0 / (1.0 + gap), x3 = x * x * x;
    sum += (x3 - x3 * x3 * x3) * theta * step;
  }
  const double curvature = amplitude / (8.0 * M_PI * M_PI * alpha);
  sum += pow(curvature * end * end + amplitude + 1.0 - approach, -2.0) / (4.0 * curvature);
  return -4.0 * amplitude / (3.0 * M_PI * M_PI * alpha) * sum;
}

static const double WAVES[][3] = {
    /* alpha, A, approach */
    {0.25, 1.0, 0.2},
    {0.25, 1.0, -1.3},
    {2.385, 0.7, 0.31},
    {0.03, 5.0, -0.4},
    {1.1, 40.0, 0.1}};

TABLE_TEST(wavy_rigid_sphere_is_eq_22, WAVES) {
  const double alpha = WAVES[_i][0], amplitude = WAVES[_i][1], approach = WAVES[_i][2];
  const double radius = 77.0;
  const po_scene scene = {0.0, amplitude, sqrt(amplitude * radius / alpha), radius, INFINITY};
  double load = NAN, rate = NAN;
  ck_assert_int_eq(po_rigid_load(&scene, approach, &load, &rate), PO_OK);
  ck_assert_double_eq_tol(load, eq_22(alpha, amplitude, approach), 2e-9);
  double up, down, unused;
  po_rigid_load(&scene, approach + 1e-5, &up, &unused);
  po_rigid_load(&scene, approach - 1e-5, &down, &unused);
  ck_assert_double_eq_tol(rate, (up - down) / 2e-5, 1e-6 * fmax(1.0, fabs(rate)));
}

/* Short waves are averaged. Both ways give the same load where the one takes over from the other,
 * at lambda^2/(8 pi^2 R) = 1e-7 (1 - approach). Waves of 0.03 times this length would be too many
 * to be integrated one by one; the load is then that of the limit, to 1.3e-6. */
TEST(short_waves_are_averaged) {
  static const double PARTS[] = {1.0 + 1e-6, 1.0 - 1e-6, 0.03};
  const double approach = 0.2, radius = 100.0;
  const double limit = M_PI * sqrt(8e-7 * radius * (1.0 - approach));
  double load[3], rate;
  for (int k = 0; k < 3; ++k) {
    const po_scene scene = {0.0, 1.0, PARTS[k] * limit, radius, INFINITY};
    ck_assert_int_eq(po_rigid_load(&scene, approach, &load[k], &rate), PO_OK);
  }
  ck_assert_double_eq_tol(load[1], load[0], 1e-9); /* 4.8e-10 is the averaging far out */
  ck_assert_double_eq_tol(load[2], load[0], 2e-6);
}

/* The load of the tail, r > r_max = R, in closed form. */
TEST(bounded_surface_lacks_the_load_of_the_tail) {
  const po_scene whole = {0.0, 0.0, 0.0, 100.0, INFINITY}, cut = {0.0, 0.0, 0.0, 100.0, 100.0};
  double a = NAN, b = NAN, rate;
  po_rigid_load(&whole, 0.0, &a, &rate);
  po_rigid_load(&cut, 0.0, &b, &rate);
  const double x = 1.0 / 51.0; /* 1 + H at r = R */
  ck_assert_double_eq_tol(a - b, -16.0 / 3.0 * (x * x / 2.0 - pow(x, 8.0) / 8.0), 1e-11);
}

/* The energy under a Mie law whose far field makes it just finite. It was not_converged below m =
 * 2.1 of a sphere, with a message about the load. */
static const struct {
  const char *profile, *law;
  double m, n, power, factor; /* of the law; of the profile, factor r^power */
} SLOW[] = {{"sphere", "mie:2.0001,10", 2.0001, 10, 2, 0.005},
            {"sphere", "mie:2.05,10", 2.05, 10, 2, 0.005},
            {"sphere", "mie:2.0999,7.3", 2.0999, 7.3, 2, 0.005},
            {"sphere", "mie:2.124,7.3", 2.124, 7.3, 2, 0.005},
            {"sphere", "mie:2.126,7.3", 2.126, 7.3, 2, 0.005},
            {"sphere", "mie:2.3,2.4", 2.3, 2.4, 2, 0.005},
            {"power:0.03,1.5", "mie:2.34,9", 2.34, 9, 1.5, 0.03},
            {"power:0.03,1.9", "mie:2.06,9", 2.06, 9, 1.9, 0.03},
            {"cone:0.1", "mie:3.02,9", 3.02, 9, 1, 0.1}};

/* The integral of (h + x)^-e r dr over the profile h = C r^N: a Beta function. */
static double of_power(double e, double x, double power, double factor) {
  const double q = 2.0 / power;
  return pow(factor, -q) / power * exp(lgamma(q) + lgamma(e - q) - lgamma(e)) * pow(x, q - e);
}

TABLE_TEST(energy_that_falls_slowly_is_that_of_a_beta_function, SLOW) {
  static const double AT[] = {-50.625, -0.3, 0.2, 0.77};
  po_scene scene = po_scene_default();
  scene.radius = 100.0;
  ck_assert(po_law_set(&scene.law, SLOW[_i].law));
  ck_assert(po_profile_set(&scene.profile, SLOW[_i].profile));
  ck_assert_int_eq(po_law_check(&scene.law), PO_OK);
  const double m = SLOW[_i].m, n = SLOW[_i].n, k = (m - 1) * (n - 1) / (n - m);
  for (size_t i = 0; i < sizeof AT / sizeof *AT; ++i) {
    double energy = NAN;
    const double x = 1.0 - AT[i], N = SLOW[_i].power, C = SLOW[_i].factor;
    const double exact = -k * 2.0 / scene.radius *
                         (of_power(m - 1, x, N, C) / (m - 1) - of_power(n - 1, x, N, C) / (n - 1));
    ck_assert_int_eq(po_rigid_energy(&scene, AT[i], &energy), PO_OK);
    ck_assert_double_eq_tol(energy, exact, 3e-12 * fabs(exact));
  }
}

/* dU/d(approach) is the load, whatever the waves. */
TEST(energy_that_falls_slowly_has_the_load_as_its_rate) {
  po_scene scene = po_scene_default();
  scene.radius = 77.0;
  scene.amplitude = 0.4;
  scene.wavelength = 9.0;
  ck_assert(po_law_set(&scene.law, "mie:2.05,10"));
  const double approach = 0.2, step = 1e-3;
  double up = NAN, down = NAN, load = NAN, rate = NAN;
  ck_assert_int_eq(po_rigid_energy(&scene, approach + step, &up), PO_OK);
  ck_assert_int_eq(po_rigid_energy(&scene, approach - step, &down), PO_OK);
  ck_assert_int_eq(po_rigid_load(&scene, approach, &load, &rate), PO_OK);
  ck_assert_double_eq_tol((up - down) / (2.0 * step), load, 1e-4 * fabs(load));
}

typedef struct {
  int minima, stations, points;
  double force, approach, last;
} seen;

static bool look(const po_branch_point *p, void *data) {
  seen *s = data;
  ++s->points;
  s->last = p->approach;
  s->stations += p->kind == PO_POINT_STATION;
  if (p->kind == PO_POINT_LOAD_MIN) {
    ++s->minima;
    s->force = -p->load;
    s->approach = p->approach;
  }
  return false;
}

TEST(trace_finds_pull_off_and_station) {
  const po_scene scene = {0.0, 0.0, 0.0, 83.0, INFINITY};
  seen s = {0, 0, 0, 0.0, 0.0, 0.0};
  po_continuation_options options = po_continuation_options_default();
  options.visit = look;
  options.data = &s;
  options.station[0] = -0.7;
  options.end = 0.385;
  ck_assert_int_eq(po_rigid_trace(&scene, -5.0, &options), PO_OK);
  ck_assert_int_eq(s.minima, 1);
  ck_assert_int_eq(s.stations, 1);
  ck_assert_double_eq_tol(s.force, 2.0, 1e-10);
  ck_assert_double_eq_tol(s.approach, 0.0, 1e-8);
  ck_assert_double_eq_tol(s.last, 0.385, 1e-15);
  options.end = 1.0;
  ck_assert_int_eq(po_rigid_trace(&scene, -5.0, &options), PO_BAD_INPUT);
}

typedef struct {
  double approach[4], load[4];
  int count;
} passages;

static bool note_passage(const po_branch_point *p, void *data) {
  passages *s = data;
  if (p->kind == PO_POINT_STATION_LOAD) {
    ck_assert_int_lt(s->count, 4);
    s->approach[s->count] = p->approach;
    s->load[s->count++] = p->load;
  }
  return false;
}

/* Eq 23 has each load above -2 twice below 0, and the step with the minimum has -1.999 twice. */
TEST(trace_passes_a_load_on_both_sides_of_the_minimum) {
  static const double LOAD[] = {-1.237, -1.999};
  const po_scene scene = {0.0, 0.0, 0.0, 83.0, INFINITY};
  for (int k = 0; k < 2; ++k) {
    passages s = {.count = 0};
    po_continuation_options options = po_continuation_options_default();
    options.visit = note_passage;
    options.data = &s;
    options.station_load = LOAD[k];
    options.end = 0.385;
    ck_assert_int_eq(po_rigid_trace(&scene, -5.0, &options), PO_OK);
    ck_assert_int_eq(s.count, 2);
    ck_assert_double_lt(s.approach[0], 0.0);
    ck_assert_double_gt(s.approach[1], 0.0);
    for (int j = 0; j < 2; ++j) {
      const double gap = 1.0 - s.approach[j];
      const double bradley = -8.0 / 3.0 * (pow(gap, -2.0) - 0.25 * pow(gap, -8.0));
      ck_assert_double_eq_tol(s.load[j], LOAD[k], 1e-9);
      ck_assert_double_eq_tol(bradley, LOAD[k], 1e-9);
    }
  }
}
TEST(scene_is_solved_as_rigid_only_at_negligible_elasticity) {
  po_scene scene = po_scene_default();
  scene.tabor = 1e-4; /* the value that the paper uses for its rigid limit */
  ck_assert(!po_rigid_suffices(&scene));
  scene.tabor = 1e-7;
  ck_assert(po_rigid_suffices(&scene));
  scene.tabor = 0.0;
  ck_assert(po_rigid_suffices(&scene));
}
