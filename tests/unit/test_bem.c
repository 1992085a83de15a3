/* Influence matrices against pressures whose deflection is known in closed form (E* = 1), and their
 * coefficients against quadrature of Eq 11 in Copson's form, which contains no elliptic integral.
 */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

#include "po_element.h"
#include "po_panel.h"
#include "po_surface.h"
#include "run.h"

static double gauss_traction(double s) {
  return exp(-s * s);
}
static double gauss_deflection(double r) { /* sqrt(pi) e^(-r^2/2) I0(r^2/2) */
  return sqrt(M_PI) * gsl_sf_bessel_I0_scaled(0.5 * r * r);
}

static double hertz_traction(double s) {
  return s < 1.0 ? sqrt(1.0 - s * s) : 0.0;
}
static double hertz_deflection(double r) {
  return 0.25 * M_PI * (2.0 - r * r);
} /* r <= 1 */

/* p = (1 + s^2)^-3, the decay of Lennard-Jones: g(t) = (3 pi/16)(1 + t^2)^(-5/2), and the
 * deflection (4/pi) times the integral of g(r sin phi) over a quarter turn: a smooth periodic
 * integrand. */
static double algebraic_traction(double s) {
  return pow(1.0 + s * s, -3.0);
}
static double algebraic_deflection(double r) {
  enum { POINTS = 4000 };
  double sum = 0.0;
  for (int i = 0; i < POINTS; ++i)
    sum += pow(1.0 + gsl_pow_2(r * sin(M_PI_2 * (i + 0.5) / POINTS)), -2.5);
  return 0.75 * M_PI_2 * sum / POINTS;
}

static const double RADII[] = {0.0, 1e-7, 0.013, 0.2385, 0.4999, 0.77, 1.0, 1.31, 2.9, 5.3, 17.0};
enum { RADIUS_COUNT = sizeof RADII / sizeof *RADII };

/* Deflection at r of a traction interpolated on panels between the given edges. */
static double panel_deflection(const double *edge, size_t panels, size_t order, double r,
                               double (*traction)(double)) {
  po_panel_rule rule;
  ck_assert_int_eq(po_panel_rule_fill(order, &rule), PO_OK);
  double sum = 0.0;
  for (size_t k = 0; k < panels; ++k) {
    double node[PO_PANEL_MAX_ORDER], weight[PO_PANEL_MAX_ORDER], length[PO_PANEL_MAX_ORDER];
    double row[PO_PANEL_MAX_ORDER];
    const po_panel_span panel = {edge[k], edge[k + 1], 6.0};
    po_panel_nodes(&rule, panel, node, weight, length);
    po_panel_influence(&rule, panel, r, row, 1);
    for (size_t j = 0; j < order; ++j)
      sum += row[j] * traction(node[j]);
  }
  return sum;
}

/* The load of t^(decay + k) on the panel from b to infinity is b^2/(decay + k - 2); weights are
 * exact for k < order, whether the decay is a whole number or not. */
LOOP_TEST(weights_to_infinity_are_exact, 0, 5) {
  static const double DECAYS[] = {6.0, 8.0, 5.182, 4.3, 2.7};
  enum { ORDER = 12 };
  const double begin = 2.385;
  po_panel_rule rule;
  ck_assert_int_eq(po_panel_rule_fill(ORDER, &rule), PO_OK);
  double node[PO_PANEL_MAX_ORDER], weight[PO_PANEL_MAX_ORDER], length[PO_PANEL_MAX_ORDER];
  po_panel_nodes(&rule, (po_panel_span){begin, INFINITY, DECAYS[_i]}, node, weight, length);
  for (int k = 0; k < ORDER; ++k) {
    double load = 0.0;
    for (int j = 0; j < ORDER; ++j)
      load += weight[j] * pow(begin / node[j], DECAYS[_i] + k);
    ck_assert_double_eq_tol(load * (DECAYS[_i] + k - 2.0) / (begin * begin), 1.0, 1e-13);
  }
}

LOOP_TEST(panels_give_the_deflection_of_a_gaussian_traction, 0, RADIUS_COUNT) {
  static const double EDGES[] = {0.0, 0.5, 1.3, 2.0, 2.8, 4.0, 6.5};
  const double r = RADII[_i];
  ck_assert_double_eq_tol(panel_deflection(EDGES, 6, 16, r, gauss_traction), gauss_deflection(r),
                          2e-13);
}

LOOP_TEST(panel_to_infinity_integrates_the_tail, 0, RADIUS_COUNT) {
  static const double EDGES[] = {0.0, 0.5, 1.0, 2.0, 5.0, INFINITY};
  const double r = RADII[_i];
  ck_assert_double_eq_tol(panel_deflection(EDGES, 5, 20, r, algebraic_traction),
                          algebraic_deflection(r), 1e-11);
}

/* The integral of (1 + s^2)^-3 s ds is 1/4. */
TEST(panel_weights_integrate_the_traction_to_the_load) {
  static const double EDGES[] = {0.0, 0.5, 1.0, 2.0, 5.0, INFINITY};
  po_panel_rule rule;
  double sum = 0.0;
  po_panel_rule_fill(20, &rule);
  for (size_t k = 0; k < 5; ++k) {
    double node[20], weight[20], length[20];
    po_panel_nodes(&rule, (po_panel_span){EDGES[k], EDGES[k + 1], 6.0}, node, weight, length);
    for (size_t j = 0; j < 20; ++j)
      sum += weight[j] * algebraic_traction(node[j]);
  }
  ck_assert_double_eq_tol(sum, 0.25, 1e-13);
}

/* Integral of G(r, s) s p(s) ds in Copson's form, for a hat function p on (a, c) with its peak at
 * b.
 */
typedef struct {
  double a, b, c, t;
} hat;

static double hat_along(double x, void *data) {
  const hat *h = data;
  const double s = hypot(h->t, x);
  if (s <= h->a || s >= h->c)
    return 0.0;
  return s < h->b ? (s - h->a) / (h->b - h->a) : (h->c - s) / (h->c - h->b);
}

/* g(t) = integral of p(sqrt(t^2 + x^2)) dx, piecewise between the kinks. */
static double hat_g(hat *h, double t) {
  static gsl_integration_cquad_workspace *space = NULL;
  if (!space)
    space = gsl_integration_cquad_workspace_alloc(200);
  const double kink[4] = {0.0, h->a, h->b, h->c};
  double sum = 0.0;
  h->t = t;
  for (int k = 0; k < 3; ++k) {
    const double begin = kink[k] > t ? sqrt((kink[k] - t) * (kink[k] + t)) : 0.0;
    const double end = kink[k + 1] > t ? sqrt((kink[k + 1] - t) * (kink[k + 1] + t)) : 0.0;
    gsl_function f = {hat_along, h};
    double part = 0.0;
    if (end > begin)
      gsl_integration_cquad(&f, begin, end, 1e-300, 1e-14, space, &part, NULL, NULL);
    sum += part;
  }
  return sum;
}

typedef struct {
  hat *h;
  double r;
} turn;

static double turn_integrand(double phi, void *data) {
  turn *q = data;
  return hat_g(q->h, q->r * sin(phi));
}

static double hat_deflection(double a, double b, double c, double r) {
  hat h = {a, b, c, 0.0};
  turn q = {&h, r};
  gsl_function f = {turn_integrand, &q};
  gsl_integration_cquad_workspace *space = gsl_integration_cquad_workspace_alloc(400);
  const double kink[5] = {0.0, a, b, c, r};
  double sum = 0.0, from = 0.0;
  for (int k = 1; k < 5; ++k) {
    const double at = fmin(kink[k], r), to = at >= r ? M_PI_2 : asin(at / r);
    double part = 0.0;
    if (to > from)
      gsl_integration_cquad(&f, from, to, 1e-300, 3e-14, space, &part, NULL, NULL);
    sum += part;
    from = fmax(from, to);
  }
  gsl_integration_cquad_workspace_free(space);
  return 4.0 / M_PI * sum;
}

TEST(triangle_coefficients_agree_with_quadrature) { /* 1e-12 relative, diagonal and neighbours
                                                             included */
  enum { N = 40 };
  double node[N], row[N];
  for (int j = 0; j < N; ++j) /* uneven: neighbouring lengths differ by factors of up to 1.4 */
    node[j] = 0.385 * j + 0.06 * sin(2.1 * j);
  node[0] = 0.0;
  po_triangle *triangle = NULL;
  ck_assert_int_eq(po_triangle_create(N, node, &triangle), PO_OK);
  static const int PAIRS[][2] = {{1, 1},  {1, 2},  {2, 1},   {17, 17}, {17, 16}, {16, 17}, {17, 19},
                                 {3, 30}, {30, 3}, {38, 37}, {37, 38}, {5, 9},   {38, 1},  {0, 7}};
  for (size_t k = 0; k < sizeof PAIRS / sizeof *PAIRS; ++k) {
    const int i = PAIRS[k][0], j = PAIRS[k][1];
    po_triangle_influence(triangle, node[i], row, 1);
    const double expected = hat_deflection(node[j - 1], node[j], node[j + 1], node[i]);
    ck_assert_msg(fabs(row[j] / expected - 1.0) < 1e-12, "G(%d,%d) is %.16g, expected %.16g", i, j,
                  row[j], expected);
  }
  po_triangle_destroy(triangle);
}

/* Coefficients may be stored with a stride, such as in a row of a matrix. They are the same numbers
 * as without a stride, and the places in between keep their contents. */
LOOP_TEST(coefficients_do_not_depend_on_the_stride, 0, 4) {
  enum { N = 40, APART = 7 };
  static const double AT[] = {0.0, 0.31, 3.85, 200.0};
  double node[N + 1], plain[N + 1], row[APART * (N + 1)];
  for (int j = 0; j <= N; ++j)
    node[j] = 0.385 * j;
  po_triangle *triangle = NULL;
  ck_assert_int_eq(po_triangle_create(N, node, &triangle), PO_OK);
  for (int ring = 0; ring < 2; ++ring) {
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k)
      row[k] = 1e3 + (double)k;
    for (int j = 0; j < N; ++j)
      plain[j] = -2.385;
    if (ring) {
      po_ring_influence(N, node, AT[_i], plain, 1);
      po_ring_influence(N, node, AT[_i], row, APART);
    } else {
      po_triangle_influence(triangle, AT[_i], plain, 1);
      po_triangle_influence(triangle, AT[_i], row, APART);
    }
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k)
      ck_assert_double_eq(row[k],
                          k % APART == 0 && k / APART < N ? plain[k / APART] : 1e3 + (double)k);
    for (int j = 0; j < N; ++j)
      ck_assert(plain[j] > 0.0 && plain[j] < 4.0 * node[N]);
  }
  po_triangle_destroy(triangle);
}

/* Largest error of the deflection of a surface under a traction, at the nodes with r <= up_to. */
static double surface_error(po_scheme scheme, po_grading grading, size_t nodes, double outer,
                            double (*traction)(double), double (*deflection)(double),
                            double up_to) {
  po_scene scene = po_scene_default();
  scene.outer_radius = outer;
  const po_mesh mesh = {scheme, grading, nodes, 0.0};
  po_surface *s = NULL;
  ck_assert_int_eq(po_surface_create(&scene, &mesh, scene.outer_radius, true, &s), PO_OK);
  double worst = 0.0;
  for (size_t i = 0; i < s->n; ++i) {
    double u = 0.0;
    for (size_t j = 0; j < s->n; ++j)
      u += s->influence[i + s->n * j] * traction(s->node[j]);
    if (s->node[i] <= up_to)
      worst = fmax(worst, fabs(u - deflection(s->node[i])));
  }
  po_surface_destroy(s);
  return worst;
}

LOOP_TEST(schemes_converge_at_second_order, 0, 4) {
  const po_scheme scheme = _i / 2 ? PO_TRIANGLE : PO_RING;
  const po_grading grading = _i % 2 ? PO_GRADED : PO_UNIFORM;
  const double coarse =
      surface_error(scheme, grading, 101, 6.0, gauss_traction, gauss_deflection, 6.0);
  const double fine =
      surface_error(scheme, grading, 201, 6.0, gauss_traction, gauss_deflection, 6.0);
  ck_assert_double_ge(log2(coarse / fine), 1.8);
  ck_assert_double_lt(fine, 2e-3);
  if (grading == PO_GRADED)
    return;
  /* The traction of Hertz has a square root at the edge of contact, which is at a node here: the
   * order is 3/2, apart from a logarithm. */
  const size_t end = scheme == PO_TRIANGLE;
  const double rough =
      surface_error(scheme, grading, 100 + end, 2.0, hertz_traction, hertz_deflection, 1.0);
  const double smooth =
      surface_error(scheme, grading, 400 + end, 2.0, hertz_traction, hertz_deflection, 1.0);
  ck_assert_double_ge(log2(rough / smooth) / 2.0, 1.3);
}

LOOP_TEST(weights_add_up_to_the_area_of_the_disc, 0,
          4) { /* integral of r dr over the disc, and of dr */
  const po_mesh mesh = {_i / 2 ? PO_TRIANGLE : PO_RING, _i % 2 ? PO_GRADED : PO_UNIFORM, 73, 0.0};
  po_scene scene = po_scene_default();
  scene.outer_radius = 23.85;
  po_surface *s = NULL;
  ck_assert_int_eq(po_surface_create(&scene, &mesh, scene.outer_radius, true, &s), PO_OK);
  double area = 0.0, length = 0.0;
  for (size_t j = 0; j < s->n; ++j) {
    area += s->weight[j];
    length += s->length[j];
  }
  ck_assert_double_eq_tol(area, 0.5 * gsl_pow_2(scene.outer_radius), 1e-11);
  ck_assert_double_eq_tol(length, scene.outer_radius, 1e-12);
  po_surface_destroy(s);
}
