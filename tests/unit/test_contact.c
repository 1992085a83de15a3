/* Contact edges and annuli: their radii, the errors of these, and a crest at the threshold. */
#include <math.h>
#include <stdlib.h>

#include "po_contact.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_solve.h"
#include "run.h"

static const double PEAK_GAP = 0.20093695517600277; /* 3^(1/6) - 1, of the law of the paper */

/* The gaps of a fixed mesh on a half-space. Radii between nodes are interpolated linearly. */
static po_contact_gap gap_on_nodes(const po_scene *flat, size_t n, const double *node,
                                   const double *gap) {
  const po_branch_point point = {.n = n, .node = node, .gap = gap};
  return po_contact_gap_of(flat, &point);
}

static po_scene flat_scene(void) {
  return (po_scene){1.0, 0.0, 0.0, 1e30, INFINITY};
}

TEST(radius_is_where_the_tension_is_greatest) {
  const double node[4] = {0.0, 1.0, 2.0, 3.0};
  const double gap[4] = {0.0, 0.9, PEAK_GAP - 0.1, PEAK_GAP + 0.3}; /* a groove at 1 */
  const po_scene flat = flat_scene();
  po_contact_gap g = gap_on_nodes(&flat, 4, node, gap);
  ck_assert_double_eq_tol(po_contact_radius(&g), 2.25, 1e-14);
  const double open[2] = {0.3, 0.9}, closed[2] = {-0.3, 0.1};
  g = gap_on_nodes(&flat, 2, node, open);
  ck_assert_double_eq(po_contact_radius(&g), 0.0);
  g = gap_on_nodes(&flat, 2, node, closed); /* closed up to the end of the surface */
  ck_assert_double_eq(po_contact_radius(&g), 1.0);
}

TEST(annuli_are_where_the_gap_is_small) {
  const double node[] = {0.5, 1.0, 2.0, 3.5, 4.0, 5.0};
  const double gap[] = {-0.1, 0.3, 0.1, -0.2, 0.2, 0.6};
  const po_scene flat = flat_scene();
  po_contact_gap g = gap_on_nodes(&flat, 6, node, gap);
  po_contact_annuli a = {0};
  ck_assert_int_eq(po_contact_annuli_fill(&g, &a), PO_OK);
  ck_assert_uint_eq(a.compressed_count, 2);
  ck_assert_double_eq(a.compressed[0].inner, 0.0);
  ck_assert_double_eq_tol(a.compressed[0].outer, 0.625, 1e-15);
  ck_assert_double_eq_tol(a.compressed[1].inner, 2.5, 1e-15);
  ck_assert_double_eq_tol(a.compressed[1].outer, 3.75, 1e-15);
  ck_assert_uint_eq(a.held_count, 2); /* the gap is 0.3 at radius 1 */
  const double shallow[] = {-0.1, 0.1, 0.1, -0.2, 0.2, 0.6};
  g = gap_on_nodes(&flat, 6, node, shallow);
  ck_assert_int_eq(po_contact_annuli_fill(&g, &a), PO_OK); /* filled again */
  ck_assert_uint_eq(a.held_count, 1);                      /* the groove is closed */
  const double at_end[] = {0.3, 0.1};
  g = gap_on_nodes(&flat, 2, node, at_end);
  ck_assert_int_eq(po_contact_annuli_fill(&g, &a), PO_OK);
  ck_assert_uint_eq(a.compressed_count, 0);
  ck_assert_uint_eq(a.held_count, 1); /* open at the end */
  ck_assert_double_eq(a.held[0].outer, 1.0);
  free(a.compressed);
  free(a.held);
}

static po_contact_gap rigid_gap(const po_scene *scene, double approach) {
  const po_branch_point point = {.approach = approach};
  return po_contact_gap_of(scene, &point);
}

/* The crest nearest a multiple of the wavelength, where the slope r/R + A k sin(k r) vanishes. */
static double crest_near(const po_scene *scene, double wave) {
  const double k = 2.0 * M_PI / scene->wavelength;
  double r = wave * scene->wavelength;
  for (int i = 0; i < 20; ++i)
    r -= (r / scene->radius + scene->amplitude * k * sin(k * r)) /
         (1.0 / scene->radius + scene->amplitude * k * k * cos(k * r));
  return r;
}

static double gap_of_crest(const po_scene *scene, double r) {
  const double k = 2.0 * M_PI / scene->wavelength;
  return 0.5 * r * r / scene->radius + scene->amplitude * (1.0 - cos(k * r));
}

/* The contact of a high crest is narrower than any step of a search; its half-width follows from
 * the curvature of the crest. An earlier version searched in steps of 1/256 of the wavelength and
 * missed a crest of A = 500 that penetrates by 1e-4. */
TEST(a_high_crest_that_barely_touches_is_found) {
  const po_scene scene = {0.0, 500.0, 3.0, 100.0, INFINITY};
  const double k = 2.0 * M_PI / scene.wavelength, dip = 1e-4;
  const double crest = crest_near(&scene, 2.0);
  const double touching = gap_of_crest(&scene, crest) - PEAK_GAP;
  const double curvature = 1.0 / scene.radius + scene.amplitude * k * k * cos(k * crest);
  po_contact_gap g = rigid_gap(&scene, touching + dip);
  ck_assert_double_eq_tol(po_contact_radius(&g), crest + sqrt(2.0 * dip / curvature), 1e-8);
  g = rigid_gap(&scene, touching - dip);
  const double first = po_contact_radius(&g);
  ck_assert_double_lt(first, 1.1 * scene.wavelength); /* the previous crest */
  ck_assert_double_eq_tol(po_initial_gap(&scene, first), touching - dip + PEAK_GAP, 1e-10);
}

/* The error of the gap is too large to decide whether the crest is in contact. Both radii are
 * stated, whichever is taken as the result. */
TEST(a_crest_within_the_error_gives_both_radii) {
  const po_scene scene = {0.0, 2.385, 7.0, 90.0, INFINITY};
  const double crest = crest_near(&scene, 1.0), by = 1e-7;
  const double touching = gap_of_crest(&scene, crest) - PEAK_GAP;
  const po_contact_doubt doubt = {.constant = 1e-6}, certain = {.constant = 1e-8};
  po_contact_gap out = rigid_gap(&scene, touching - by), in = rigid_gap(&scene, touching + by);
  const po_contact_edge inner = po_contact_estimate(&out, &doubt);
  ck_assert_double_lt(inner.radius, 0.5 * scene.wavelength);
  ck_assert_double_eq_tol(inner.other, crest, 1e-6);
  ck_assert_double_lt(inner.error, 1e-4); /* of the radius if the crest is not in contact */
  ck_assert_double_gt(inner.error, 1e-8);
  const po_contact_edge outer = po_contact_estimate(&in, &doubt);
  ck_assert_double_gt(outer.radius, crest);
  ck_assert_double_eq_tol(outer.other, inner.radius, 1e-5);
  ck_assert_double_lt(outer.error, 1e-2);
  ck_assert_double_ge(outer.error,
                      outer.radius - crest); /* the contact of the crest may have any width */
  ck_assert_double_nan(po_contact_estimate(&out, &certain).other);
  ck_assert_double_nan(po_contact_estimate(&in, &certain).other);
}

/* All of more than a hundred crests are found. An earlier version had room for 48 edges and left
 * out the outermost. */
TEST(no_annulus_is_left_out) {
  const po_scene scene = {0.0, 3.0, 2.0, 2e5, INFINITY};
  const double approach = 0.8;
  size_t crests = 1; /* the axis */
  while (gap_of_crest(&scene, crest_near(&scene, (double)crests)) - approach < PEAK_GAP)
    ++crests;
  ck_assert_uint_gt(crests, 100);
  const po_contact_gap g = rigid_gap(&scene, approach);
  po_contact_annuli a = {0};
  ck_assert_int_eq(po_contact_annuli_fill(&g, &a), PO_OK);
  ck_assert_uint_eq(a.held_count, crests);
  ck_assert_double_eq(a.held[0].inner, 0.0);
  for (size_t j = 1; j < a.held_count; ++j) {
    ck_assert_double_lt(a.held[j].inner, crest_near(&scene, (double)j));
    ck_assert_double_gt(a.held[j].outer, crest_near(&scene, (double)j));
  }
  ck_assert_double_eq(a.held[crests - 1].outer, po_contact_radius(&g));
  free(a.compressed);
  free(a.held);
}

/* A loose and a tight tolerance give the same radius within the stated errors, and these errors
 * decrease with the tolerance. Linear interpolation between the nodes, as in an earlier version,
 * gives 13.5664 instead of 13.56821 at mu = 1 for any tolerance, and errors of 1 % on nearly rigid
 * spheres. */
LOOP_TEST(radius_differs_by_no_more_than_its_stated_error, 0, 4) {
  static const po_scene SCENES[] = {{1.0, 0.0, 0.0, 100.0, INFINITY},
                                    {0.0137, 0.0, 0.0, 850.766, INFINITY},
                                    {3.0, 1.0, 20.0, 100.0, 100.0},
                                    {0.1078, 0.78638, 17.2168, 233.144, 233.144}};
  po_request request = po_request_default();
  request.scene = SCENES[_i];
  request.mesh.tolerance = 1e-9;
  po_result tight, loose;
  ck_assert_int_eq(po_solve(&request, &tight), PO_OK);
  if (_i == 0)
    ck_assert_double_eq_tol(tight.pull_off.contact_radius, 13.56821, 5e-6);
  ck_assert_double_le(tight.pull_off.contact_radius_error, 1e-6);
  for (double tolerance = 1e-3; tolerance > 1e-8; tolerance *= 0.01) {
    request.mesh.tolerance = tolerance;
    ck_assert_int_eq(po_solve(&request, &loose), PO_OK);
    const double error = fabs(loose.pull_off.contact_radius - tight.pull_off.contact_radius);
    ck_assert_double_le(error,
                        loose.pull_off.contact_radius_error + tight.pull_off.contact_radius_error);
    ck_assert_double_le(loose.pull_off.contact_radius_error,
                        tolerance * tight.pull_off.contact_radius);
    ck_assert_double_nan(loose.pull_off.contact_radius_other);
    po_result_clear(&loose);
  }
  po_result_clear(&tight);
}
