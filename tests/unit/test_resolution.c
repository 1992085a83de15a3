/* Whether the estimated errors of panels show what a mesh of these panels misses. */
#include <math.h>
#include <stdlib.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_memory.h"
#include "po_quadrature.h"
#include "po_resolution.h"
#include "po_surface.h"
#include "run.h"

enum { FINE = 200 };

/* A panel from the axis to `end` of a body with waves, APART from the half-space. */
static const double APART = 3.0;

typedef struct {
  po_scene scene;
  po_surface surface;
  po_equilibrium e;
  po_panels *panels;
} one_panel;

static void set_up(double wavelength, double amplitude, double end, one_panel *p) {
  p->scene = (po_scene){.tabor = 0.1,
                        .radius = 1.0,
                        .amplitude = amplitude,
                        .wavelength = wavelength,
                        .outer_radius = INFINITY};
  ck_assert(po_profile_set(&p->scene.profile, "power:0.05,1.5"));
  ck_assert(po_law_set(&p->scene.law, "morse:1.4"));
  p->surface = (po_surface){.core_radius = end};
  p->e =
      (po_equilibrium){.scene = &p->scene, .surface = &p->surface, .radius = 1.0, .coupling = 0.03};
  p->panels = po_allocate(1, sizeof *p->panels);
  ck_assert_ptr_nonnull(p->panels);
  po_panels_uniform(p->panels, 0);
}

static double load_density(const one_panel *p, double r) {
  return po_law_at(&p->scene.law, APART + po_initial_gap(&p->scene, r)).traction * r;
}

/* What Gauss's rule on the panel misses of its load, pi w R, and the load. */
static double missed_load(const one_panel *p, double *load) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  const double end = p->surface.core_radius;
  double node[FINE], weight[FINE], nodes = 0.0;
  ck_assert_int_eq(po_gauss_rule(FINE, node, weight), PO_OK);
  *load = 0.0;
  for (int i = 0; i < FINE; ++i)
    *load += 2.0 * end * weight[i] * load_density(p, end * node[i]);
  for (int j = 0; j < PO_TABLE_ORDER; ++j)
    nodes += 2.0 * end * rule->weight[j] * load_density(p, end * rule->node[j]);
  return fabs(nodes - *load);
}

/* Wavelength, amplitude, length of the panel: the last Legendre coefficients are less than 0.03 of
 * the greatest one, and 4 % of the load is missed. */
static const double WAVES[][3] = {{5.76, 0.9, 15.1}, {5.45, 0.9, 14.3}, {5.88, 0.87, 15.4}};

TABLE_TEST(load_between_the_nodes_of_a_panel_with_waves_is_seen, WAVES) {
  one_panel p;
  set_up(WAVES[_i][0], WAVES[_i][1], WAVES[_i][2], &p);
  double gap[PO_TABLE_ORDER], load;
  for (int j = 0; j < PO_TABLE_ORDER; ++j)
    gap[j] = APART +
             po_initial_gap(&p.scene, p.surface.core_radius * po_panel_table_get()->rule.node[j]);
  const double missed = missed_load(&p, &load);
  ck_assert_double_gt(missed, 0.03 * fabs(load));
  const po_resolution r = po_resolution_of(&p.e, (po_allowance){INFINITY, 0.3 * missed});
  ck_assert_double_gt(po_resolution_excess(&r, p.panels, gap), 2.0);
  free(p.panels);
}

/* A panel longer than a wave whose nodes have the load is not asked for more. */
TEST(a_panel_of_a_small_wave_is_resolved) {
  one_panel p;
  set_up(5.0, 0.01, 6.0, &p);
  double gap[PO_TABLE_ORDER], load;
  for (int j = 0; j < PO_TABLE_ORDER; ++j)
    gap[j] = APART +
             po_initial_gap(&p.scene, p.surface.core_radius * po_panel_table_get()->rule.node[j]);
  ck_assert_double_lt(missed_load(&p, &load), 1e-6 * fabs(load));
  const po_resolution r = po_resolution_of(&p.e, (po_allowance){INFINITY, 1e-3 * fabs(load)});
  ck_assert_double_gt(p.surface.core_radius, r.detail);
  ck_assert_double_lt(po_resolution_excess(&r, p.panels, gap), 0.1);
  free(p.panels);
}
