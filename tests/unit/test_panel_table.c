/* The tabulated influence of panels on a graded tree against product integration, which test_bem.c
 * compares with closed forms. Properties of the tree. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_panel_table.h"
#include "po_panels.h"
#include "po_surface.h"
#include "run.h"

/* Refines a tree towards x, to the given level. */
static void refine_towards(po_panels *panels, double x, uint32_t level) {
  po_panels_uniform(panels, 1);
  for (;;) {
    const size_t at = po_panels_find(panels, x, 0);
    if (panels->panel[at].level >= level)
      return;
    for (size_t k = 0; k < panels->count; ++k)
      panels->marked[k] = k == at;
    ck_assert(po_panels_split(panels));
  }
}

/* The panels cover the domain in ascending order, and the levels of neighbours differ by no more
 * than the limit. */
static void check_tree(const po_panels *panels) {
  double end = 0.0;
  for (size_t k = 0; k < panels->count; ++k) {
    ck_assert_double_eq(po_panel_begin(panels->panel[k]), end);
    end = po_panel_end(panels->panel[k]);
    if (k > 0)
      ck_assert_int_le(abs((int)panels->panel[k].level - (int)panels->panel[k - 1].level),
                       PO_MOST_LEVEL_STEP);
  }
  ck_assert_double_eq(end, 1.0);
}

TEST(tree_stays_graded) {
  static po_panels panels;
  refine_towards(&panels, 0.2385, 9);
  check_tree(&panels);
  size_t before = panels.count;
  do {
    for (size_t k = 0; k < panels.count; ++k)
      panels.marked[k] = true;
    before = panels.count;
    po_panels_join(&panels);
    check_tree(&panels);
  } while (panels.count < before);
  ck_assert_uint_eq(panels.count, 1);
}

TEST(split_without_room_changes_nothing) {
  static po_panels panels;
  po_panels_uniform(&panels, 13);
  for (size_t k = 0; k < panels.count; ++k)
    panels.marked[k] = k < PO_MOST_PANELS - panels.count;
  ck_assert(po_panels_split(&panels)); /* full */
  for (size_t k = 0; k < panels.count; ++k)
    panels.marked[k] = k == 3;
  ck_assert(!po_panels_split(&panels));
  ck_assert_uint_eq(panels.count, PO_MOST_PANELS);
}

static const double FOCI[] = {0.0, 0.2385, 0.5, 0.9999};

LOOP_TEST(tabulated_blocks_agree_with_product_integration, 0, 4) {
  const po_panel_table *table = po_panel_table_get();
  ck_assert_ptr_nonnull(table);
  static po_panels panels;
  refine_towards(&panels, FOCI[_i], 8);
  double worst = 0.0;
  for (size_t a = 0; a < panels.count; ++a)
    for (size_t b = 0; b < panels.count; ++b) {
      const po_panel target = panels.panel[a], source = panels.panel[b];
      const po_panel_span panel = {po_panel_begin(source), po_panel_end(source)};
      po_panel_block block;
      po_panel_table_block(table, target, source, block);
      for (size_t i = 0; i < PO_TABLE_ORDER; ++i) {
        const double r = po_panel_begin(target) +
                         (po_panel_end(target) - po_panel_begin(target)) * table->rule.node[i];
        double row[PO_TABLE_ORDER], by_table = 0.0, by_rule = 0.0;
        po_panel_influence(&table->rule, panel, r, row, 1);
        for (size_t j = 0; j < PO_TABLE_ORDER; ++j) { /* a smooth traction */
          const double p =
              cos(1.3 + 2.0 * (panel.begin + (panel.end - panel.begin) * table->rule.node[j]));
          by_table += block[i][j] * p;
          by_rule += row[j] * p;
        }
        worst = fmax(worst, fabs(by_table - by_rule) / (panel.end - panel.begin));
      }
    }
  ck_assert_double_lt(worst, 3e-12);
}

/* The panels of a mesh are recognised from its radii, those of a part of the mesh from the first of
 * these. Other radii belong to no panels. */
TEST(panels_are_recognised_from_their_nodes) {
  static const po_scene SCENE = {.tabor = 2.385, .radius = 93.0, .outer_radius = 71.0};
  po_surface *surface = NULL;
  ck_assert_int_eq(po_surface_create_panels(&SCENE, 71.0, 2, &surface), PO_OK);
  static po_panels mesh, panels;
  refine_towards(&mesh, 0.2385, 7);
  ck_assert_int_eq(po_surface_mesh(surface, &mesh), PO_OK);
  ck_assert_uint_eq(surface->n, PO_TABLE_ORDER * mesh.count);
  double *node = malloc(surface->n * sizeof *node);
  memcpy(node, surface->node, surface->n * sizeof *node);
  for (size_t count = 0; count <= mesh.count; ++count) {
    ck_assert_int_eq(po_surface_panels_of(surface, PO_TABLE_ORDER * count, node, &panels), PO_OK);
    ck_assert_uint_eq(panels.count, count);
    for (size_t k = 0; k < count; ++k)
      ck_assert(po_panel_equal(panels.panel[k], mesh.panel[k]));
  }
  ck_assert_int_eq(po_surface_panels_of(surface, surface->n - 1, node, &panels), PO_BAD_INPUT);
  node[PO_TABLE_ORDER + 5] *= 1.001;
  ck_assert_int_eq(po_surface_panels_of(surface, surface->n, node, &panels), PO_BAD_INPUT);
  free(node);
  po_surface_destroy(surface);
}

/* A surface with many waves has room for more panels; a mesh for which there is none changes
 * nothing. */
TEST(mesh_without_room_changes_nothing) {
  static const po_scene SMOOTH = {.tabor = 2.385, .radius = 93.0, .outer_radius = 71.0};
  po_scene wavy = SMOOTH;
  wavy.amplitude = 0.1;
  wavy.wavelength = 71.0 / 1000.0;
  static po_panels small, large;
  po_panels_uniform(&small, 2);
  po_panels_uniform(&large, 13);
  for (int k = 0; k < 2; ++k) {
    po_surface *surface = NULL;
    ck_assert_int_eq(po_surface_create_panels(k ? &wavy : &SMOOTH, 71.0, 2, &surface), PO_OK);
    ck_assert_int_eq(po_surface_mesh(surface, &small), PO_OK);
    const bool has_room = surface->capacity >= PO_TABLE_ORDER * large.count;
    ck_assert_int_eq(has_room, k == 1);
    if (!has_room) {
      ck_assert_int_eq(po_surface_mesh(surface, &large), PO_OUT_OF_NODES);
      ck_assert(po_panels_equal(po_surface_panels(surface), &small));
      ck_assert_uint_eq(surface->n, PO_TABLE_ORDER * small.count);
    }
    po_surface_destroy(surface);
  }
}
