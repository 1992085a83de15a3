/* Every closed form inside and far outside its domain, with the default error handler of GSL: each
 * call returns soon, with numbers or NaN. */
#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>

#include "po_estimates.h"
#include "po_forms.h"
#include "po_guduru.h"
#include "po_kernel.h"
#include "po_law.h"
#include "po_special.h"
#include "po_wavy_rigid.h"
#include "run.h"

static const po_law LAW = {0}; /* of the paper */

static const double SIZES[] = {0.0,  5e-324, 1e-310, 1e-300, 2.385e-154, 1e-77,  1e-16, 3.7e-8,
                               1e-3, 0.41,   1.0,    7.7,    100.0,      1e4,    1e8,   4.6e15,
                               1e16, 1e30,   1e77,   1e154,  1e300,      DBL_MAX};
enum { SIZE_COUNT = sizeof SIZES / sizeof *SIZES };

static const double PLACES[] = {
    -DBL_MAX,          -1e30, -1e8, -3.3, -1.0, -1e-9, 0.0,     1e-300,   1e-9, 0.2009, 0.999999,
    1.0 - DBL_EPSILON, 1.0,   17.0, 1e9,  1e16, 1e154, DBL_MAX, INFINITY, NAN};
enum { PLACE_COUNT = sizeof PLACES / sizeof *PLACES };

static const char *const FORMS[] = {
    "bradley",          "rigid",       "jkr",   "guduru",       "kesari-lew", "persson-tosatti",
    "rumpf-rabinowicz", "compactness", "crest", "lennard-jones"};
enum { FORM_COUNT = sizeof FORMS / sizeof *FORMS };

/* A closed form takes microseconds, the integral of the rigid sphere at most 0.2 s. A test in which
 * a call does not return is killed. The limit is in processor time, so that a busy machine does not
 * matter. */
static void limit_time(void) {
  const struct rlimit seconds = {60, 60};
  ck_assert_int_eq(setrlimit(RLIMIT_CPU, &seconds), 0);
}

static void call(const po_form *form, const po_scene *scene, double alpha, double at) {
  const po_form_input input = {*scene, alpha, at};
  po_form_values values = {.count = 0};
  form->fixed(&input, &values);
  if (form->along && !isnan(at))
    form->along(&input, &values);
  ck_assert_uint_le(values.count, PO_FORM_MOST_VALUES);
  ck_assert_uint_gt(values.count, 0);
  for (size_t i = 0; i < values.count; ++i)
    ck_assert_uint_gt(strlen(values.items[i].name), 0);
}

/* First each pair of parameters takes all pairs of sizes while the others have ordinary values.
 * Then all four parameters are drawn at random from the sizes. */
LOOP_TEST(every_form_returns_for_extreme_scenes, 0, FORM_COUNT) {
  const po_form *form = po_form_find(FORMS[_i]);
  /* The rigid wavy sphere is an integral, some 10 ms each; the others take microseconds. */
  const int stride = strcmp(form->name, "rigid") == 0 ? 151 : 1;
  limit_time();
  for (int i = 0; i < SIZE_COUNT; ++i)
    for (int k = 0; k < SIZE_COUNT; ++k)
      for (int pair = 0; pair < 6; ++pair) {
        if (((i * SIZE_COUNT + k) * 6 + pair) % stride)
          continue;
        static const int FIRST[] = {0, 0, 0, 1, 1, 2}, SECOND[] = {1, 2, 3, 2, 3, 3};
        double group[4] = {2.385, 0.7, 13.1, 77.0}; /* tabor, amplitude, wavelength, radius */
        group[FIRST[pair]] = SIZES[i];
        group[SECOND[pair]] = SIZES[k];
        const po_scene scene = {group[0], group[1], group[2], group[3], INFINITY};
        call(form, &scene, po_scene_alpha(&scene), PLACES[(i * SIZE_COUNT + k) % PLACE_COUNT]);
      }
  unsigned seed = 2385;
  for (int n = 0; n < 500 / stride; ++n) {
    int drawn[6];
    for (int j = 0; j < 6; ++j) {
      seed = seed * 1664525u + 1013904223u;
      drawn[j] = (int)(seed >> 16);
    }
    const po_scene scene = {SIZES[drawn[0] % SIZE_COUNT], SIZES[drawn[1] % SIZE_COUNT],
                            SIZES[drawn[2] % SIZE_COUNT], SIZES[drawn[3] % SIZE_COUNT], INFINITY};
    call(form, &scene, SIZES[drawn[4] % SIZE_COUNT], PLACES[drawn[5] % PLACE_COUNT]);
  }
}

/* If all parameters are within a factor of 1e20 of each other, every value is finite. */
LOOP_TEST(every_form_is_finite_for_moderate_scenes, 0, FORM_COUNT) {
  const po_form *form = po_form_find(FORMS[_i]);
  static const double USUAL[] = {1e-10, 1e-5, 0.1, 1.0, 31.0, 1e5, 1e10};
  const int stride = strcmp(form->name, "rigid") == 0 ? 31 : 1;
  for (int i = 0; i < 7 * 7 * 7; i += stride) {
    const po_scene scene = {2.385, USUAL[i % 7], USUAL[i / 7 % 7], USUAL[i / 49], INFINITY};
    const po_form_input input = {scene, po_scene_alpha(&scene),
                                 form->variable == PO_FORM_AT_APPROACH ? -0.3 : 1.7};
    po_form_values values = {.count = 0};
    form->fixed(&input, &values);
    if (form->along)
      form->along(&input, &values);
    for (size_t k = 0; k < values.count; ++k)
      ck_assert_msg(isfinite(values.items[k].value),
                    "%s: %s is %g at amplitude %g wavelength %g radius %g", form->name,
                    values.items[k].name, values.items[k].value, scene.amplitude, scene.wavelength,
                    scene.radius);
  }
}

/* The mathematical functions that the closed forms use. */
TEST(closed_forms_are_finite_for_extreme_arguments) {
  limit_time();
  for (int i = 0; i < SIZE_COUNT; ++i) {
    const double x = SIZES[i];
    for (int n = 0; n < 2; ++n)
      ck_assert(isfinite(po_struve(n, x)));
    ck_assert(!isnan(po_law_energy(&LAW, x)) && !isnan(po_lennard_jones_traction(x)));
    for (int k = 0; k < SIZE_COUNT; ++k) {
      const double y = SIZES[k];
      if (y > 0.0 && isfinite(x / y))
        for (int n = 0; n < 2; ++n)
          ck_assert_double_le(fabs(po_struve_wave(n, x, y)), 1.0);
      if (x + y > 1e-150 && x + y < 1e150) /* its square must not overflow or underflow */
        ck_assert(po_kernel(x + y, x - y) > 0.0);
      if (x < 1e300 && y < 1e300)
        ck_assert(isfinite(po_disc_deflection(x, y)));
    }
  }
  for (int i = 0; i < PLACE_COUNT; ++i) {
    const double x = PLACES[i];
    ck_assert(isnan(po_bradley_load(x)) == !(x < 1.0));
    ck_assert(isnan(po_lennard_jones_traction(x)) == !(x > -1.0));
  }
}

/* Contacts with very many waves. The pull-off is found wave by wave up to 1e8 waves, and from the
 * envelope beyond. Both agree with the envelope, and the work is bounded. The approach is that of
 * the nearest trough. */
TEST(guduru_pull_off_with_many_waves_is_the_envelope) {
  limit_time();
  for (double wavelength = 1e-2; wavelength > 1e-12; wavelength *= 0.37) {
    const po_scene s = {5.0, 1.0, wavelength, 100.0, INFINITY};
    const po_contact got = po_guduru_pull_off(&s);
    const double force = 1.5 * po_kesari_lew_work(&s), a = got.contact_radius;
    const double waves = a / wavelength;
    ck_assert_double_eq_tol(-got.load / force, 1.0, 1e-14 + 0.3 / (waves * waves));
    const po_contact edge = po_kesari_lew_edge(&s, a, -1);
    ck_assert_double_eq_tol(got.approach / edge.approach, 1.0, 1e-14 + 1.0 / waves / waves);
    if (waves < 1e11) { /* the phase is resolved by the contact radius: Eq 5 gives the load there */
      const po_contact there = po_guduru_at(&s, a);
      const double phase = 2.0 * M_PI * DBL_EPSILON * waves;
      ck_assert_double_eq_tol(there.load / got.load, 1.0, 1e-14 + phase * phase);
      ck_assert_double_eq_tol(there.approach / got.approach, 1.0, 1e-14 + phase * phase);
    }
  }
}

/* H0 and H1 for many waves: no digits are lost by the rounding of 2 pi a/lambda. The values were
 * computed with mpmath and 40 digits for these doubles. */
static const struct {
  double distance, wavelength, h0, h1;
} WAVES[] = {
    {1234.567, 0.1, -0.0007910394815794477095, 0.63937080837783985801},
    {87.6, 0.001, -0.00075931527223876508354, 0.63585930011758546738},
    {8220.24301039, 1e-07, -1.0965367582699527728e-6, 0.63661959862696632845},
    {17707.823, 1e-08, -1.6914771506334002926e-7, 0.63661960323051117058},
    {330000.0, 7e-13, 3.3113269207351902083e-10, 0.63661977204312046214},
    {1e+16, 10.0, -7.117625332850587084e-9, 0.6366197652499559089},
    {2500000000000.0, 3e-250, -8.7360354473010808196e-133, 0.63661977236758134308},
    {777.7, 2.385, -0.0046438596636612413784, 0.61970193796199908349},
};

TEST(struve_functions_of_many_waves_keep_their_digits) {
  for (size_t i = 0; i < sizeof WAVES / sizeof *WAVES; ++i) {
    const double size = 1e-15 * (1.0 + M_2_PI);
    ck_assert_double_eq_tol(
        po_struve_wave(0, WAVES[i].distance, WAVES[i].wavelength), WAVES[i].h0,
        2e-15 * fmax(fabs(WAVES[i].h0), sqrt(WAVES[i].wavelength / WAVES[i].distance)));
    ck_assert_double_eq_tol(po_struve_wave(1, WAVES[i].distance, WAVES[i].wavelength), WAVES[i].h1,
                            size);
  }
}

/* -(8/3) (x^3 - x^9) with x = 1/(1 + H), computed with mpmath for these doubles. Near the
 * equilibrium the two terms are nearly equal. */
TEST(traction_near_equilibrium_does_not_cancel) {
  ck_assert_double_eq_tol(po_lennard_jones_traction(1e-300) / -1.6e-299, 1.0, 2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(1e-15) / -1.5999999999999897243e-14, 1.0,
                          2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(-3.3e-11) / 5.2800000011325603786e-10, 1.0,
                          2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(1e-07) / -1.5999989600004132608e-6, 1.0, 2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(-0.001) / 0.016104414616717284102, 1.0, 2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(0.2009) / -1.0264004654365027143, 1.0, 2e-15);
  ck_assert_double_eq_tol(po_lennard_jones_traction(100000.0) / -2.6665866682666400004e-15, 1.0,
                          2e-15);
}

/* The limits of the rigid wavy sphere: one crest, no waves, and waves so short that only the
 * average of the law over a wave matters. */
TEST(rigid_wavy_sphere_tends_to_its_limits) {
  for (double alpha = 1e-3; alpha < 1e3; alpha *= 57.3)
    for (double amplitude = 1e13; amplitude < 1e60; amplitude *= 1e23)
      ck_assert_double_eq_tol(po_wavy_rigid_pull_off(amplitude, alpha).force * 0.5 *
                                  (1.0 + 4.0 * M_PI * M_PI * alpha),
                              1.0, 1e-11);
  for (double alpha = 1e-30; alpha < 1e30; alpha *= 1e13)
    ck_assert_double_eq_tol(po_wavy_rigid_pull_off(1e-14, alpha).force, 2.0, 1e-10);
  for (double amplitude = 0.01; amplitude < 1e4; amplitude *= 3.7)
    for (double approach = -7.0; approach < 0.9; approach += 0.57) {
      /* load = 2/R integral of the mean law over r dr = integral over the gap */
      const double mean = 2.0 * po_law_energy_averaged(&LAW, amplitude - approach, amplitude);
      ck_assert_double_eq_tol(po_wavy_rigid_load(amplitude, 1e25, approach), mean,
                              1e-10 * fabs(mean) + 1e-13);
    }
}

/* The error handler that the program has set. */
static void own_handler(const char *reason, const char *file, int line, int error) {
  ck_abort_msg("GSL: %s (%s:%d, %d)", reason, file, line, error);
}

TEST(gsl_error_handler_is_unchanged) {
  gsl_set_error_handler(own_handler);
  for (int i = 0; i < FORM_COUNT; ++i) {
    const po_scene scene = {5.0, 1.0, 10.0, 100.0, INFINITY};
    call(po_form_find(FORMS[i]), &scene, 1.0, 0.7);
  }
  ck_assert(gsl_set_error_handler(NULL) == own_handler);
}

/* Each test is a separate process, with the default error handler of GSL, which aborts. */
