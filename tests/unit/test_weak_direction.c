/* Traces that need the factors of panels to be corrected in one direction (po_corrector.c). */
#include <math.h>

#include "po_continuation.h"
#include "po_initial_gap.h"
#include "po_input.h"
#include "po_load_unit.h"
#include "po_scales.h"
#include "po_solve_parts.h"
#include "run.h"

static const double TOLERANCE = 1e-6;

/* Arclength at which the trace ends. Without the correction it stays at 2.0067, where the
 * determinant of the factors changes its sign and that of the Jacobian does not. */
static const double END = 2.5;

static bool is_beyond(const po_branch_point *p, void *data) {
  *(double *)data = p->position;
  return p->position > END;
}

/* Two narrow rings of tension on a truncated sphere move nearly freely. */
START_TEST(a_ring_of_tension_that_moves_freely_is_followed) {
  po_request request = po_request_default();
  ck_assert(po_key_set(&request, PO_KEY_LAW, "morse:4.35609"));
  ck_assert(po_key_set(&request, PO_KEY_PROFILE, "truncated:39.439,37.8845"));
  ck_assert(po_key_set(&request, PO_KEY_COUPLING, "1.20057"));
  ck_assert(
      po_key_set(&request, PO_KEY_WAVES, "0.805184@33.7833;0.193323@5.85164;0.0503183@14.8622"));
  request = po_load_unit_request(&request);
  /* po_solve_domain moves the end of the domain a little, to have the kink of the profile at the
   * end of a panel, and the factors serve */
  const double core = po_surface_core(&request.scene, NAN);
  const double domain =
      po_averaging_radius(&request.scene, po_averaging_phase(&request.scene, core));
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  ck_assert_int_eq(po_surface_create_panels(&request.scene, domain, 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&request.scene, panels, &e), PO_OK);
  e->precision = po_solve_precision(TOLERANCE);
  double position = 0.0;
  po_continuation_options options = po_continuation_options_default();
  options.visit = is_beyond;
  options.data = &position;
  options.most_points = 1000;
  ck_assert_int_eq(
      po_continuation_create(e, po_solve_allowance(TOLERANCE), &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  ck_assert_double_gt(position, END);
  po_continuation_destroy(continuation);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
}
END_TEST

static void add(TCase *tests) {
  tcase_add_test(tests, a_ring_of_tension_that_moves_freely_is_followed);
}

int main(void) {
  return run_case("weak_direction", add);
}
