/* Traction–separation laws: the traction is the derivative of the energy, the work of adhesion is
 * 1, the average over a wave is correct. The law of the paper is Eqs 9 and 16. Invalid laws are
 * refused. */
#include <math.h>
#include <string.h>

#include "po_law.h"
#include "run.h"

static const char *const LAWS[] = {"lennard-jones", "mie:3,9",   "mie:4,10", "mie:2.5,12",
                                   "mie:3.3,7.7",   "morse:0.5", "morse:1",  "morse:3"};
static const double GAPS[] = {-0.4, -0.05, 0.0, 0.3, 2.385, 11.0};
enum { LAW_COUNT = sizeof LAWS / sizeof *LAWS, GAP_COUNT = sizeof GAPS / sizeof *GAPS };

static po_law law_of(const char *text) {
  po_law law = po_law_lennard_jones();
  ck_assert(po_law_set(&law, text));
  ck_assert_int_eq(po_law_check(&law), PO_OK);
  return law;
}

/* Central differences of the energy and of the traction, whose relative errors are 1e-10. */
LOOP_TEST(traction_and_slope_are_derivatives_of_the_energy, 0, (LAW_COUNT * GAP_COUNT)) {
  const po_law law = law_of(LAWS[_i / GAP_COUNT]);
  const double gap = GAPS[_i % GAP_COUNT], step = 1e-5 * po_law_size(&law, gap);
  const po_law_value p = po_law_at(&law, gap);
  const po_law_value above = po_law_at(&law, gap + step), below = po_law_at(&law, gap - step);
  const double size = fabs(above.traction) + fabs(below.traction);
  const double slope = (above.traction - below.traction) / (2.0 * step);
  ck_assert_double_eq_tol(p.slope, slope, 1e-7 * (fabs(p.slope) + size / po_law_size(&law, gap)));
  const double up = po_law_energy(&law, gap + step), down = po_law_energy(&law, gap - step);
  ck_assert_double_eq_tol(
      p.traction, -(up - down) / (2.0 * step),
      1e-7 * (fabs(p.traction) + (fabs(up) + fabs(down)) / po_law_size(&law, gap)));
  ck_assert_double_eq_tol(po_law_traction(&law, gap).high, p.traction, 1e-14 * (size + 1.0));
}

/* p(0) = 0. The energy is -1, the work of adhesion, at H = 0, and 0 far away. The tension is
 * greatest at the peak. At large gaps the law tends to its far field. The scale is positive, and
 * its rate is its derivative; so is that of the closeness, which is 1 up to H = 0 and falls as the
 * slope of the law far out. */
LOOP_TEST(law_is_normalised, 0, LAW_COUNT) {
  const po_law law = law_of(LAWS[_i]);
  ck_assert_double_eq_tol(po_law_at(&law, 0.0).traction, 0.0, 1e-15);
  ck_assert_double_eq_tol(po_law_energy(&law, 0.0), -1.0, 1e-15);
  ck_assert_double_eq_tol(po_law_energy(&law, 1e9), 0.0, 1e-12);
  const double peak = po_law_numbers_of(&law)->peak_gap;
  ck_assert_double_eq_tol(po_law_at(&law, peak).slope, 0.0, 1e-13);
  ck_assert_double_lt(po_law_at(&law, peak).traction, po_law_at(&law, 1.01 * peak).traction);
  ck_assert_double_lt(po_law_at(&law, peak).traction, po_law_at(&law, 0.99 * peak).traction);
  const double far = 1e3;
  const po_law_numbers *field = po_law_numbers_of(&law);
  const double expected =
      isinf(field->exponent) ? 0.0 : -field->factor * pow(1.0 + far, -field->exponent);
  ck_assert_double_eq_tol(po_law_at(&law, far).traction, expected, 1e-6 * fabs(expected) + 1e-30);
  ck_assert_double_eq(po_law_closeness_at(&law, -0.01).value, 1.0);
  ck_assert_double_eq_tol(po_law_closeness_at(&law, 1e-9).value, 1.0, 1e-12);
  const double away = 12.0, farther = 15.0;
  ck_assert_double_eq_tol(po_law_closeness_at(&law, farther).value /
                              po_law_closeness_at(&law, away).value,
                          po_law_at(&law, farther).slope / po_law_at(&law, away).slope,
                          2e-2 * po_law_at(&law, farther).slope / po_law_at(&law, away).slope);
  for (size_t k = 0; k < GAP_COUNT; ++k) {
    const po_law_scale scale = po_law_scale_at(&law, GAPS[k]);
    const double h = 1e-6;
    ck_assert_double_eq_tol(po_law_closeness_at(&law, GAPS[k]).rate,
                            (po_law_closeness_at(&law, GAPS[k] + h).value -
                             po_law_closeness_at(&law, GAPS[k] - h).value) /
                                (2.0 * h),
                            1e-4); /* at H = 0 its second derivative jumps */
    ck_assert_double_gt(scale.size, 0.0);
    ck_assert_double_eq_tol(
        scale.rate, (po_law_size(&law, GAPS[k] + h) - po_law_size(&law, GAPS[k] - h)) / (2.0 * h),
        1e-6);
  }
}

/* Eqs 9 and 16, with the greatest tension 16/(9 sqrt 3) at h = 3^(1/6). The Mie law (3, 9) is the
 * same. */
TEST(lennard_jones_is_the_law_of_the_paper) {
  const po_law law = po_law_lennard_jones(), mie = law_of("mie:3,9"), unset = {0};
  for (size_t k = 0; k < GAP_COUNT; ++k) {
    const double h = 1.0 + GAPS[k], size = pow(h, -3.0) + pow(h, -9.0);
    const double expected = -8.0 / 3.0 * (pow(h, -3.0) - pow(h, -9.0));
    ck_assert_double_eq_tol(po_law_at(&law, GAPS[k]).traction, expected, 1e-14 * size);
    ck_assert_double_eq_tol(po_law_at(&mie, GAPS[k]).traction, expected, 1e-14 * size);
    ck_assert_double_eq(po_law_at(&unset, GAPS[k]).slope, po_law_at(&law, GAPS[k]).slope);
    ck_assert_double_eq_tol(po_law_at(&mie, GAPS[k]).slope, po_law_at(&law, GAPS[k]).slope,
                            1e-13 * 24.0 * size / h);
  }
  ck_assert_double_eq_tol(po_law_numbers_of(&law)->peak_gap, pow(3.0, 1.0 / 6.0) - 1.0, 1e-15);
  ck_assert_double_eq_tol(po_law_numbers_of(&mie)->peak_gap, po_law_numbers_of(&law)->peak_gap,
                          1e-15);
  ck_assert_double_eq_tol(po_law_at(&law, po_law_numbers_of(&law)->peak_gap).traction,
                          -16.0 / (9.0 * sqrt(3.0)), 1e-15);
  ck_assert_str_eq(po_law_name(&unset), "lennard-jones");
}

static const double AVERAGES[][2] = {
    {5.0, 0.0}, {5.0, 0.385}, {5.0, 4.0}, {30.0, 10.0}, {2.0, 1.5}};
enum { AVERAGE_COUNT = sizeof AVERAGES / sizeof *AVERAGES };

/* The trapezoidal sum of a periodic function converges spectrally. */
LOOP_TEST(averaged_law_is_the_mean_over_a_period, 0, (LAW_COUNT * AVERAGE_COUNT)) {
  enum { POINTS = 4096 };
  const po_law law = law_of(LAWS[_i / AVERAGE_COUNT]);
  const double gap = AVERAGES[_i % AVERAGE_COUNT][0], amplitude = AVERAGES[_i % AVERAGE_COUNT][1];
  double traction = 0.0, slope = 0.0, energy = 0.0;
  for (int k = 0; k < POINTS; ++k) {
    const double at = gap - amplitude * cos(2.0 * M_PI * k / POINTS);
    const po_law_value p = po_law_at(&law, at);
    traction += p.traction / POINTS;
    slope += p.slope / POINTS;
    energy += po_law_energy(&law, at) / POINTS;
  }
  const po_law_value p = po_law_averaged(&law, gap, amplitude);
  ck_assert_double_eq_tol(p.traction / traction, 1.0, 1e-12);
  ck_assert_double_eq_tol(p.slope / slope, 1.0, 1e-11);
  ck_assert_double_eq_tol(po_law_energy_averaged(&law, gap, amplitude) / energy, 1.0, 1e-12);
}

/* The load of a rigid paraboloid is 2 phi, in pi w R of its radius. Of 1e4, attraction takes off at
 * most 4 %. */
LOOP_TEST(repulsion_pushes_with_the_load, 0, LAW_COUNT) {
  const po_law law = law_of(LAWS[_i]);
  const double share = 0.3, load = share * 1e4;
  const double approach = po_law_approach_of_push(&law, share, load);
  ck_assert_double_eq_tol(2.0 * share * po_law_energy(&law, -approach), load, 0.04 * load);
}

/* Parameters may be set one by one, in any order. */
TEST(parameters_are_set_one_by_one) {
  const po_law whole = law_of("mie:4,10");
  po_law law = po_law_lennard_jones();
  po_law_set_parameter(&law, PO_MIE_N, 10.0);
  ck_assert(po_law_set(&law, "mie"));
  ck_assert_int_eq(po_law_check(&law), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "mie_m is not given"));
  po_law_set_parameter(&law, PO_MIE_M, 4.0);
  ck_assert_int_eq(po_law_check(&law), PO_OK);
  ck_assert_double_eq(po_law_at(&law, 0.385).traction, po_law_at(&whole, 0.385).traction);
  ck_assert(po_law_has(&law, PO_MIE_M) && !po_law_has(&law, PO_MORSE_A));
  const po_law semicolons = law_of("mie:4;10"); /* the form used in tables */
  ck_assert_double_eq(po_law_at(&semicolons, 0.385).traction, po_law_at(&whole, 0.385).traction);
}

static const char *const BAD[] = {"",         "mie:",      "mie:3",  "mie:3,nan", "mie:3,9,12",
                                  "mie:3,9x", "morse:1,2", "morse:", "lennard",   "lennard-jones:3",
                                  "Mie:3,9",  "mie;3,9"};

TABLE_TEST(malformed_laws_are_refused, BAD) {
  po_law law = law_of("morse:1");
  ck_assert(!po_law_set(&law, BAD[_i]));
  ck_assert_str_eq(po_law_name(&law), "morse");
  ck_assert_double_eq(law.parameter[PO_MORSE_A], 1.0);
}

static const char *const OUT_OF_RANGE[] = {"mie:9,3",     "mie:1,9",  "mie:3,3",
                                           "mie:3,1e300", "morse:-1", "morse:0",
                                           "morse:1e6",   "mie",      "morse"};

TABLE_TEST(parameters_out_of_range_are_named, OUT_OF_RANGE) {
  po_law law = po_law_lennard_jones();
  ck_assert(po_law_set(&law, OUT_OF_RANGE[_i]));
  ck_assert_int_eq(po_law_check(&law), PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "expected"));
  ck_assert_ptr_nonnull(strstr(po_message(), po_law_name(&law)));
}
