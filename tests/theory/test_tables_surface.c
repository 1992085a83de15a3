/* Influence coefficients and the rigid loading curve against every row of their reference tables.
 */
#include <float.h>

#include "../unit/run.h"
#include "po_element.h"
#include "po_rigid.h"
#include "po_rigid_trace.h"
#include "table.h"

/* The tolerances stated in po_element.h and po_rigid.h. */
static const double RING_ACCURACY = 1e-15, TRIANGLE_ACCURACY = 1e-12, RIGID_ACCURACY = 1e-9;

ROWS_TEST(ring_agrees_with_the_table, "kernel.csv", "rings", 33, 1) {
  if (table_leaves_out(t, row, "ring"))
    return;
  const double edge[] = {table_number(t, row, "s1"), table_number(t, row, "s2")};
  const double r = table_number(t, row, "r");
  double deflection = NAN;
  po_ring_influence(1, edge, r, &deflection, 1);
  /* the rounding of a radius by half an ulp, times the integrand G s, which is about its mean */
  const double read = 0.5 * DBL_EPSILON * (edge[0] + edge[1] + r);
  const double inherited = read * table_number(t, row, "value") / (edge[1] - edge[0]);
  table_compare(t, row, "value", deflection, RING_ACCURACY * fmax(r, edge[1]) + inherited);
}

ROWS_TEST(triangle_agrees_with_the_table, "kernel.csv", "triangles", 39, 1) {
  if (table_leaves_out(t, row, "triangle"))
    return;
  double node[3], deflection[3] = {NAN, NAN, NAN};
  size_t n = 0, top = 0;
  static const char *const COLUMNS[] = {"s1", "s2", "s3"};
  for (int k = 0; k < 3; ++k) { /* half a hat function has two nodes */
    const double s = table_number(t, row, COLUMNS[k]);
    if (!n || s != node[n - 1])
      node[n++] = s;
    if (k == 1)
      top = n - 1;
  }
  po_triangle *triangle = NULL;
  ck_assert_int_eq(po_triangle_create(n, node, &triangle), PO_OK);
  po_triangle_influence(triangle, table_number(t, row, "r"), deflection, 1);
  po_triangle_destroy(triangle);
  table_compare(t, row, "value", deflection[top],
                TRIANGLE_ACCURACY * table_number(t, row, "value"));
}

/* The rows depend on alpha only, so any radius may be chosen. */
static po_scene rigid_scene(const table *t, size_t row) {
  const double amplitude = table_number(t, row, "amplitude"), radius = 77.0;
  return (po_scene){.amplitude = amplitude,
                    .wavelength = sqrt(amplitude * radius / table_number(t, row, "alpha")),
                    .radius = radius,
                    .outer_radius = INFINITY};
}

ROWS_TEST(rigid_load_agrees_with_the_table, "rigid_integral.csv",
          "load of the solver's rigid limit", 80, 1) {
  const po_scene scene = rigid_scene(t, row);
  double load = NAN, rate = NAN;
  ck_assert_int_eq(po_rigid_load(&scene, table_number(t, row, "approach"), &load, &rate), PO_OK);
  table_compare(t, row, "load", load,
                RIGID_ACCURACY * fmax(1.0, fabs(table_number(t, row, "load"))));
}

typedef struct {
  double force, approach;
} deepest;

static bool look(const po_branch_point *p, void *data) {
  deepest *d = data;
  if (p->kind == PO_POINT_LOAD_MIN && -p->load > d->force)
    *d = (deepest){-p->load, p->approach};
  return false;
}

ROWS_TEST(rigid_pull_off_agrees_with_the_table, "rigid_pull_off.csv",
          "pull-off of the solver's rigid limit", 153, 2) {
  const po_scene scene = rigid_scene(t, row);
  deepest d = {0.0, NAN};
  po_continuation_options options = po_continuation_options_default();
  /* the central crest pushes with 12 and everything else pulls with at most 2 */
  options.end = po_rigid_approach_of_crest(&scene, 12.0);
  options.visit = look;
  options.data = &d;
  ck_assert_int_eq(po_rigid_trace(&scene, -0.3, &options), PO_OK);
  table_compare(t, row, "force", d.force, RIGID_ACCURACY);
  table_compare(t, row, "approach", d.approach, 1e-8);
}
