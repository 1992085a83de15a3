/* Conversion from SI units to dimensionless groups, with ordinary and extreme values, and refusals.
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include "po_si.h"
#include "run.h"

/* modulus, work, distance, radius, amplitude, wavelength, outer radius */
static const po_physical BODIES[] = {
    {2.385e9, 0.0537, 3.1e-10, 1.7e-6, 4.3e-9, 2.9e-7, 1.1e-6},  /* a soft particle, rough */
    {7.3e10, 0.0271, 1.65e-10, 3.3e-8, 0.0, 0.0, INFINITY},      /* a probe of silica */
    {1.13e6, 0.0413, 5.7e-10, 7.7e-3, 8.1e-7, 3.7e-4, INFINITY}, /* a lens of rubber */
    {3.1, 1.9e-7, 7.3e-4, 41.0, 0.83, 5.9, 77.0},                /* no real material */
    {4.7e40, 3.3e-60, 9.1e-90, 2.3e-80, 1.9e-85, 8.3e-82, INFINITY},
    {6.1e-70, 7.9e120, 5.3e90, 4.9e130, 3.7e110, 2.1e125, 8.8e129},
    {1.7e308, 1.3e-300, 2.9e-150, 3.1e10, 0.0, 0.0, INFINITY},
};
enum { BODY_COUNT = sizeof BODIES / sizeof *BODIES };

static void is_near(double got, double expected) {
  if (isinf(expected) || expected == 0.0)
    ck_assert_double_eq(got, expected);
  else
    ck_assert_double_eq_tol(got / expected, 1.0, 8 * DBL_EPSILON);
}

LOOP_TEST(groups_are_those_of_the_paper, 0, BODY_COUNT) {
  const po_physical *p = &BODIES[_i];
  po_scene s;
  ck_assert_msg(po_physical_scene(p, &s) == PO_OK, "%s", po_message());
  /* Eq 14 in logarithms and extended precision, so that no intermediate product overflows */
  const long double log_mu =
      (logl((long double)p->radius) + 2 * logl((long double)p->work) -
       2 * logl((long double)p->modulus) - 3 * logl((long double)p->distance)) /
      3;
  is_near(s.tabor, (double)expl(log_mu));
  is_near(s.radius, p->radius / p->distance);
  is_near(s.amplitude, p->amplitude / p->distance);
  is_near(s.wavelength, p->wavelength / p->distance);
  is_near(s.outer_radius, p->outer_radius / p->distance);
}

TEST(units_are_those_of_the_paper) {
  const po_physical *p = &BODIES[0];
  po_scene s;
  ck_assert_int_eq(po_physical_scene(p, &s), PO_OK);
  const po_units u = po_physical_units(p, &s);
  is_near(u.force, 3.14159265358979323846 * 0.0537 * 1.7e-6);
  is_near(u.length, 3.1e-10);
  is_near(u.tension, 0.0537 / 3.1e-10);
  /* JKR: a load of -3/2 is 3/2 pi w R; Hertz: W/(pi w R) = (4/(3 pi)) (a/Gamma)^3 */
  const double a = 2.385e-7, hertz = 4.0 / 3.0 * p->modulus * a * a * a / p->radius;
  const double cube = pow(a / p->distance / po_scene_gamma(&s), 3.0);
  ck_assert_double_eq_tol(4.0 / (3.0 * M_PI) * cube * u.force / hertz, 1.0, 1e-13);
  /* the units of traction and of Gamma give the unit of force: W = 2 int P u du */
  const double gamma = po_scene_gamma(&s) * u.length;
  ck_assert_double_eq_tol(2.0 * M_PI * gamma * gamma * u.traction / (2.0 * u.force), 1.0, 1e-13);
}

TEST(rigid_has_no_tabor_parameter) {
  po_physical p = BODIES[1];
  p.modulus = INFINITY;
  po_scene s;
  ck_assert_int_eq(po_physical_scene(&p, &s), PO_OK);
  ck_assert_double_eq(s.tabor, 0.0);
  ck_assert(isinf(po_physical_units(&p, &s).traction));
}

static const struct {
  size_t place; /* of the member */
  double value;
  const char *message;
} BAD[] = {
    {offsetof(po_physical, amplitude), INFINITY, "the amplitude is inf: expected a finite"},
    {offsetof(po_physical, radius), 1e306, "the radius over the equilibrium distance is inf"},
    {offsetof(po_physical, amplitude), 1e-323, "the amplitude over the equilibrium distance is "},
};

TABLE_TEST(refusals_name_the_bad_value, BAD) {
  po_physical p = BODIES[0];
  memcpy((char *)&p + BAD[_i].place, &BAD[_i].value, sizeof(double));
  po_scene s = {.tabor = 7.7};
  ck_assert_int_eq(po_physical_scene(&p, &s), PO_BAD_INPUT);
  ck_assert_msg(strncmp(po_message(), BAD[_i].message, strlen(BAD[_i].message)) == 0, "%s",
                po_message());
  ck_assert_double_eq(s.tabor, 7.7); /* unchanged */
}

/* R, w, E*, epsilon, and the units that a person who has this scene would write, by hand: a tip (pi
 * w R = 7.5 nN, w/epsilon = 267 MPa, mu = 0.19), a lens on gelatin (3.1 mN, 100 MPa, mu = 2.2e4, so
 * that epsilon mu = 22 um), and a number of which no prefix is left. */
static const struct {
  double modulus, work, distance, radius;
  const char *text[PO_DIMENSION_COUNT], *name;
  double load, length;
} PREFIXED[] = {
    {5e9,
     0.08,
     3e-10,
     3e-8,
     {"", "", "", "nm", "nm", "nN", "aJ", "N/m", "MPa"},
     "N_per_m",
     7.5398223686155035,
     0.3},
    {1e5,
     0.1,
     1e-9,
     1e-2,
     {"", "", "", "µm", "µm", "mN", "nJ", "N/m", "MPa"},
     "N_per_m",
     3.1415926535897931,
     1e-3},
    {INFINITY,
     1e-30,
     1e-30,
     1e-10,
     {"", "", "", "ym", "ym", "yN", "yJ", "pN/m", "Pa"},
     "pN_per_m",
     3.1415926535897931e-16,
     1e-6},
};

/* Printed numbers were 24747.27659 fN and 151255.502 pN: the prefix was that of the scene, whatever
 * its numbers. */
static const struct {
  po_dimension dimension;
  double value; /* in SI units */
  const char *text;
} READABLE[] = {{PO_DIMENSION_LOAD, -2.474727659e-11, "pN"},
                {PO_DIMENSION_LOAD, 1.51255502e-7, "nN"},
                {PO_DIMENSION_LOAD, 1e-9, "nN"},
                {PO_DIMENSION_LOAD, 0.0021, "mN"},
                {PO_DIMENSION_LOAD, 999.0, "N"},
                {PO_DIMENSION_LOAD, 4.2e7, "MN"},
                {PO_DIMENSION_LENGTH, 3.2815e-6, "µm"},
                {PO_DIMENSION_LENGTH, 4e-14, "fm"},
                {PO_DIMENSION_ENERGY, 1.6e-18, "aJ"},
                {PO_DIMENSION_ENERGY, 7e-13, "fJ"},
                {PO_DIMENSION_STIFFNESS, 1.2e-5, "µN/m"},
                {PO_DIMENSION_STIFFNESS, 2e4, "kN/m"},
                {PO_DIMENSION_TRACTION, 1.71066746e8, "MPa"},
                {PO_DIMENSION_TRACTION, 2.5e-3, "mPa"}};

TABLE_TEST(printed_numbers_are_readable, READABLE) {
  const po_units scenes[] = {{1e-10, 3e-14, 1, 1e3, 1e3, 0, 0},
                             {3e-10, 1.5e-9, 0.05, 1.7e8, 2e7, 0, 0},
                             {1e-3, 1.0, 1.0, 1e9, 1e5, 0, 0}};
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; ++k) {
    const double factor = po_si_unit_of(&scenes[k], READABLE[_i].dimension).factor;
    const double number = READABLE[_i].value / factor;
    const po_si_unit usual = po_si_prefixed(&scenes[k], READABLE[_i].dimension),
                     unit = po_si_readable(&scenes[k], READABLE[_i].dimension, fabs(number));
    const double shown = fabs(number * unit.factor);
    ck_assert(shown >= 0.1 && shown < 1000.0);
    ck_assert(strcmp(unit.text, READABLE[_i].text) == 0 || strcmp(unit.text, usual.text) == 0);
    ck_assert_str_eq(po_si_readable(&scenes[k], READABLE[_i].dimension, 0).text, usual.text);
    ck_assert_str_eq(po_si_readable(&scenes[k], READABLE[_i].dimension, NAN).text, usual.text);
  }
  const po_units si = {.length = 1, .force = 1, .tension = 1, .traction = 1};
  ck_assert_str_eq(po_si_readable(&si, PO_DIMENSION_LOAD, 2.474727659e-11).text, "pN");
}

TABLE_TEST(units_have_the_prefix_of_the_scene, PREFIXED) {
  const po_physical p = {.modulus = PREFIXED[_i].modulus,
                         .work = PREFIXED[_i].work,
                         .distance = PREFIXED[_i].distance,
                         .radius = PREFIXED[_i].radius,
                         .outer_radius = INFINITY};
  po_scene s;
  ck_assert_int_eq(po_physical_scene(&p, &s), PO_OK);
  const po_units u = po_physical_units(&p, &s);
  for (int d = PO_DIMENSION_NONE; d < PO_DIMENSION_COUNT; ++d) {
    const po_si_unit unit = po_si_prefixed(&u, (po_dimension)d);
    ck_assert_str_eq(unit.text, PREFIXED[_i].text[d]);
    ck_assert(d != PO_DIMENSION_STIFFNESS || strcmp(unit.name, PREFIXED[_i].name) == 0);
  }
  const po_si_unit load = po_si_prefixed(&u, PO_DIMENSION_LOAD);
  const po_si_unit gap = po_si_prefixed(&u, PO_DIMENSION_GAP);
  is_near(po_si_value(&load, -1.5), -1.5 * PREFIXED[_i].load);
  is_near(po_si_value(&gap, 0.25), 1.25 * PREFIXED[_i].length); /* H = h/eps - 1 */
  is_near(po_si_unit_of(&u, PO_DIMENSION_ENERGY).factor, u.force * u.length);
}
