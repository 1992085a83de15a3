/* The length of predictor steps where contact annuli form, and their error. */
#include <math.h>

#include "po_continuation.h"
#include "po_prediction.h"
#include "po_trace.h"
#include "run.h"

enum { MOST = 200 };

static const double TOLERANCE = 1e-4, ERROR = 0.01;
/* Contact annuli form until the contact has 13 edges. */
static const po_scene SCENE = {2.0, 2.0, 5.0, 100.0, 100.0};

/* The steps of a trace. */
typedef struct {
  size_t count;
  po_solution point[MOST];
  po_arena arrays; /* of the points */
} steps;

static bool keep(const po_branch_point *p, void *data) {
  steps *s = data;
  if (p->kind != PO_POINT_STEP)
    return false;
  ck_assert_int_eq(po_solution_allocate(&s->point[s->count], p->solution->n, &s->arrays), PO_OK);
  po_solution_copy(p->solution, &s->point[s->count++]);
  return s->count == MOST || p->load > 1.0;
}

static double trace(steps *s) {
  po_surface *panels = NULL;
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  const double domain = po_trace_domain(&SCENE, po_surface_core(&SCENE, NAN));
  ck_assert_int_eq(po_surface_create_panels(&SCENE, domain, 4, &panels), PO_OK);
  ck_assert_int_eq(po_equilibrium_create(&SCENE, panels, &e), PO_OK);
  e->precision = po_trace_precision(TOLERANCE);
  po_continuation_options options = po_continuation_options_default();
  options.visit = keep;
  options.data = s;
  ck_assert_int_eq(
      po_continuation_create(e, po_trace_allowance(TOLERANCE), &options, &continuation), PO_OK);
  ck_assert_int_eq(po_continuation_run(continuation), PO_OK);
  const double met = panels->core_radius;
  po_continuation_destroy(continuation);
  po_equilibrium_destroy(e);
  po_surface_destroy(panels);
  return met;
}

/* Predictions to the point after the next, twice as far as the error of the prediction allows. The
 * error there may be ten times the limit. It is no larger where the prediction leaves out some
 * contact edges, and the trace has several such places. */
TEST(edges_are_left_out_only_if_the_prediction_stays_accurate) {
  static steps s; /* too large for the stack */
  po_surface surface = {.core_radius = trace(&s)};
  const po_equilibrium e = {.scene = &SCENE, .surface = &surface};
  size_t left = 0;
  for (size_t k = 1; k + 2 < s.count; ++k) {
    const po_solution *b = &s.point[k - 1], *a = &s.point[k], *to = &s.point[k + 2];
    const double way = po_solution_progress(a, to);
    if (!(way > 0.0))
      continue;
    po_prediction p;
    const double reach = po_prediction_reach(&e, a, b, way, ERROR, &p);
    ck_assert_double_gt(reach, 0.0);
    ck_assert_double_le(reach, way);
    ck_assert_double_lt(po_edge_strain(&p.edges, p.shift), 0.5);
    if (reach < way || p.edges.count == a->edges.count)
      continue;
    ck_assert_double_lt(
        po_prediction_error(&(po_gap_field){po_prediction_gap, &p}, &e.scene->law, NULL, to),
        10.0 * ERROR);
    ++left;
  }
  ck_assert_uint_ge(left, 4);
  po_arena_free(&s.arrays);
}

/* If the steps follow the contact edges of every annulus from its first contact, there are 133. */
TEST(contact_annuli_form_in_few_steps) {
  static steps s; /* too large for the stack */
  trace(&s);
  ck_assert_uint_lt(s.count, 122);
  po_arena_free(&s.arrays);
}
