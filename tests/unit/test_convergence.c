/* Observed order of convergence: if the elements are half as long, the errors of the pull-off and
 * of the folds are a quarter. The errors are relative to the independent reference
 * (reference/feng_landmarks.csv, mu = 1, accurate to 1e-10). */
#include <math.h>
#include <stdio.h>

#include "po_solve.h"
#include "run.h"
#include "trace.h"

static const double FORCE = 1.67066477647629, APPROACH = -0.873379514904682;
static const double JUMP_IN = -1.62921671169182, JUMP_OUT = -1.74343014358001;

typedef struct {
  double force, approach, jump_in, jump_out;
} errors;

static errors errors_of(po_scheme scheme, po_grading grading, size_t elements) {
  po_request request = po_request_default();
  request.mesh = (po_mesh){scheme, grading, elements + (scheme == PO_TRIANGLE), 0.0};
  po_result o;
  ck_assert_int_eq(po_solve(&request, &o), PO_OK);
  ck_assert_uint_eq(o.fold_count, 2);
  const errors e = {o.pull_off.force - FORCE, o.pull_off.approach - APPROACH,
                    o.folds[0].approach - JUMP_IN, o.folds[1].approach - JUMP_OUT};
  po_result_clear(&o);
  return e;
}

LOOP_TEST(triangles_and_rings_converge_at_second_order, 0, 4) {
  const po_scheme scheme = _i / 2 ? PO_TRIANGLE : PO_RING;
  const po_grading grading = _i % 2 ? PO_GRADED : PO_UNIFORM;
  errors e[3];
  for (int k = 0; k < 3; ++k) {
    e[k] = errors_of(scheme, grading, (size_t)250 << k);
    printf("%s %s N = %zu: force %+.2e approach %+.2e folds %+.2e %+.2e\n", PO_SCHEMES[scheme],
           PO_GRADINGS[grading], (size_t)250 << k, e[k].force, e[k].approach, e[k].jump_in,
           e[k].jump_out);
  }
  /* 16 over two halvings; the order may be off by one half */
  ck_assert_double_ge(fabs(e[0].jump_in / e[2].jump_in), 8.0);
  ck_assert_double_ge(fabs(e[0].jump_out / e[2].jump_out), 8.0);
  ck_assert_double_ge(fabs(e[0].force / e[2].force), 8.0);
  ck_assert_double_lt(fabs(e[1].force), 1e-4);
  ck_assert_double_lt(fabs(e[2].approach), 1e-3);
}

static bool deepest(const po_branch_point *p, void *data) {
  double *least = data;
  *least = fmin(*least, p->load);
  return p->load > 0.2 && p->unstable_modes == 0;
}

/* Pull-off with elements of a given size up to a given core radius, Gauss panels beyond. */
static double pull_off(const po_scene *scene, double core, double size) {
  const po_mesh mesh = {PO_TRIANGLE, PO_UNIFORM, (size_t)(core / size + 1.5), 0.0};
  po_surface *surface = NULL;
  po_equilibrium *e = NULL;
  double least = 0.0;
  ck_assert_int_eq(po_surface_create(scene, &mesh, core, true, &surface), PO_OK);
  ck_assert_double_eq_tol(surface->core_radius, core, 1e-12);
  ck_assert_int_eq(po_equilibrium_create(scene, surface, &e), PO_OK);
  po_continuation_options options = po_continuation_options_default();
  options.visit = deepest;
  options.data = &least;
  ck_assert_int_eq(trace_fixed(e, &options), PO_OK);
  po_equilibrium_destroy(e);
  po_surface_destroy(surface);
  return least;
}

/* The far tail of an unbounded surface is accurate to 1e-8: the radius at which the elements end
 * and the panels begin does not change the result, once the error of the elements, of order h^2, is
 * removed by extrapolation. */
LOOP_TEST(tail_of_an_unbounded_surface_is_accurate_to_1e_8, 0, 2) {
  const po_scene scene = {1.0, _i ? 0.3 : 0.0, 15.0, 100.0, INFINITY};
  double load[2];
  for (int k = 0; k < 2; ++k) {
    const double core = k ? 90.0 : 60.0, h = 0.25;
    load[k] = (4.0 * pull_off(&scene, core, 0.5 * h) - pull_off(&scene, core, h)) / 3.0;
  }
  printf("%s: %.10f %.10f\n", _i ? "wavy" : "smooth", load[0], load[1]);
  ck_assert_double_eq_tol(load[0], load[1], 1e-8);
}
