/* The uncertainty of the pull-off force: the adjoint agrees with solves of the changed profile,
 * uncertain inputs with their derivatives, and what is not linear is no number. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "po_solve.h"
#include "run.h"

/* A tip with a deviation that smoothing does not remove, and one that it does. */
static po_profile noisy_tip(void) {
  char path[] = "/tmp/po_uncertainty_XXXXXX";
  const int file = mkstemp(path);
  FILE *f = fdopen(file, "w");
  ck_assert_ptr_nonnull(f);
  fprintf(f, "r,gap\n");
  for (int k = 0; k <= 330; ++k) {
    const double r = 0.2 * k, noise = 0.01 * sin(1.7 * k * k);
    fprintf(f, "%.17g,%.17g\n", r, 100.0 - sqrt(10000.0 - r * r) + 0.1 * sin(0.3 * r) + noise);
  }
  ck_assert_int_eq(fclose(f), 0);
  po_profile profile = po_profile_sphere();
  profile.parameter[PO_TABLE_SMOOTH] = 0.0075;
  ck_assert_msg(po_profile_set_file(&profile, path) == PO_OK, "%s", po_message());
  ck_assert_int_eq(unlink(path), 0);
  return profile;
}

/* Coupling, and outer radius: unbounded and cut, stiff and soft, and rigid. */
static const double SCENES[][2] = {
    {0.004, INFINITY}, {0.1, 55.0}, {2.0, INFINITY}, {0.0, INFINITY}};

TABLE_TEST(adjoint_agrees_with_solves, SCENES) {
  po_request request = po_request_default();
  request.scene.profile = noisy_tip();
  request.scene.radius = 1.0;
  request.scene.tabor = po_scene_tabor_of_coupling(SCENES[_i][0], 1.0);
  request.scene.outer_radius = SCENES[_i][1];
  po_result o;
  ck_assert_msg(po_solve(&request, &o) == PO_OK, "%s", o.reason);
  ck_assert_uint_eq(o.uncertain_count, 1);
  const po_uncertain *u = o.uncertain;
  ck_assert_double_gt(u->force, 1e-4 * o.pull_off.force);
  ck_assert_double_lt(u->force, 0.1 * o.pull_off.force);
  ck_assert_double_eq_tol(0.25 * (u->above - u->below), u->force, 1e-2 * u->force);
  ck_assert_double_eq_tol(u->deviation, 0.0075, 1e-15);
  ck_assert_double_eq(o.uncertainty, u->force);
  po_result_clear(&o);
}

static void vary(po_variation *v, po_request moved[2]) {
  *v = (po_variation){.moved = {&moved[0], &moved[1]}, .unit = {1.0, 1.0}};
  snprintf(v->source, sizeof v->source, "input");
}

TEST(inputs_agree_with_their_derivatives) {
  po_request request = po_request_default(), tabor[2], amplitude[2];
  request.scene.amplitude = 0.37;
  request.scene.wavelength = 11.3;
  for (int k = 0; k < 2; ++k) {
    tabor[k] = amplitude[k] = request;
    tabor[k].scene.tabor *= k ? 1.02 : 0.98;
    amplitude[k].scene.amplitude *= k ? 1.005 : 0.995;
  }
  po_variation variation[2];
  vary(&variation[0], tabor);
  vary(&variation[1], amplitude);
  variation[1].unit[1] = 1.0001; /* the unit of its force */
  request.variation = variation;
  request.variations = 2;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  const po_sensitivity *by = &o.pull_off.sensitivity;
  const double force = o.pull_off.force, a = 0.01 * by->tabor * force,
               b = 0.005 * by->amplitude * force;
  ck_assert_double_eq_tol(o.uncertain[0].force, fabs(a), 2e-2 * fabs(a));
  ck_assert_double_eq_tol(o.uncertain[1].above, b + 0.0001 * force, 2e-2 * fabs(b));
  ck_assert_double_eq_tol(o.uncertainty, hypot(o.uncertain[0].force, o.uncertain[1].force), 1e-15);
  po_result_clear(&o);
}

/* At 2.616 loading jumps to another minimum; beside it the force does not depend on the preload. */
LOOP_TEST(jumps_are_no_uncertainty, 0, 2) {
  po_request request = po_request_default(), moved[2];
  request.scene.tabor = 3.0;
  request.scene.amplitude = 1.0;
  request.scene.wavelength = 20.0;
  request.preload.approach = _i ? 2.6 : 1.6;
  for (int k = 0; k < 2; ++k) {
    moved[k] = request;
    moved[k].preload.approach += k ? 0.05 : -0.05;
  }
  po_variation variation;
  vary(&variation, moved);
  request.variation = &variation;
  request.variations = 1;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  if (_i) {
    ck_assert(isnan(o.uncertain[0].force) && isnan(o.uncertainty));
    ck_assert_double_eq_tol(o.uncertain[0].above, 0.78552, 1e-4);
  } else {
    ck_assert_double_eq_tol(o.uncertainty, 0.0, 1e-6);
  }
  po_result_clear(&o);
}

/* A jump that is small beside the uncertainty by another input counts in full. */
TEST(small_jumps_are_their_size) {
  po_request request = po_request_default(), tabor[2], same[2];
  for (int k = 0; k < 2; ++k) {
    tabor[k] = same[k] = request;
    tabor[k].scene.tabor *= k ? 1.05 : 0.95;
  }
  po_variation variation[2];
  vary(&variation[0], same);
  vary(&variation[1], tabor);
  variation[0].unit[1] = 1.0002; /* as if the force jumped */
  request.variation = variation;
  request.variations = 2;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_double_eq_tol(o.uncertain[0].force, 0.0001 * o.pull_off.force, 1e-9);
  ck_assert_double_eq_tol(o.uncertainty, hypot(o.uncertain[0].force, o.uncertain[1].force), 1e-15);
  po_result_clear(&o);
}

/* A force that cannot be solved is unknown. */
TEST(failures_are_unknown) {
  po_request request = po_request_default(), moved[2];
  moved[0] = moved[1] = request;
  moved[1].scene.radius = -1.0;
  po_variation variation;
  vary(&variation, moved);
  request.variation = &variation;
  request.variations = 1;
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert(isnan(o.uncertain[0].force) && isnan(o.uncertain[0].above));
  ck_assert_double_eq_tol(o.uncertain[0].below, 0.0, 1e-9);
  po_result_clear(&o);
}
