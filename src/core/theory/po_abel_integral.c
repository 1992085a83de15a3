/* Integrals over the Abel transform of the initial gap. */
#include <math.h>

#include "po_abel.h"
#include "po_deadline.h"
#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_order.h"
#include "po_profile_table.h"
#include "po_quadrature.h"

/* Points of the rule in a piece. */
enum { PIECE_POINTS = 16 };
static const double MOST_PIECES = 1e6;
/* Near the axis g is a power of x, so that pieces grow from the axis: the first is the part
 * FIRST_PIECE of the whole, each further one ends at PIECE_GROWTH times its beginning, or after
 * PIECE_OF_WAVE of a wave. */
static const double PIECE_GROWTH = 4.0, FIRST_PIECE = 1e-5, PIECE_OF_WAVE = 0.5;

typedef struct {
  const po_scene *scene;
  po_profile profile; /* on the knots of the transform */
  po_abel_integrand f;
  const void *data;
  bool to_edge; /* with the weight 1/sqrt(to^2 - x^2) */
  double to;
  double node[PIECE_POINTS], weight[PIECE_POINTS];
} integral;

/* The end of the piece that begins at x. */
static double piece_end(const integral *q, double x) {
  double end = fmin(q->to, fmax(PIECE_GROWTH * x, FIRST_PIECE * q->to));
  end = fmin(end, po_profile_next_joint(&q->profile, x));
  for (size_t k = 0; k < po_scene_waves(q->scene); ++k)
    end = fmin(end, x + PIECE_OF_WAVE * po_scene_wave(q->scene, k).length);
  return end;
}

/* Beyond a kink or a row g is smooth in the square root of the distance from it, in which the rule
 * is applied. The weight goes by the angle arccos(x/to). */
static double piece(const integral *q, double from, double to) {
  const double first = q->to_edge ? po_abel_angle(from, q->to) : from,
               whole = (q->to_edge ? po_abel_angle(to, q->to) : to) - first;
  double sum = 0.0;
  for (int i = 0; i < PIECE_POINTS; ++i) {
    const double v = q->node[i], place = first + whole * v * v;
    const double x = fmin(fmax(q->to_edge ? q->to * po_cos(place) : place, from), to);
    sum += q->weight[i] * 2.0 * v * fabs(whole) * q->f(x, po_abel_at(q->scene, x), q->data);
  }
  return sum;
}

double po_abel_integral(const po_scene *scene, double from, double to, bool to_edge,
                        po_abel_integrand f, const void *data) {
  integral q = {.scene = scene,
                .profile = scene->profile,
                .f = f,
                .data = data,
                .to_edge = to_edge,
                .to = to};
  q.profile.table = po_abel_table(scene);
  if (!(from < to))
    return from == to ? 0.0 : NAN;
  if (po_gauss_rule(PIECE_POINTS, q.node, q.weight))
    return NAN;
  double sum = 0.0, pieces = 0.0;
  for (double x = from; x < to;) {
    const double end = piece_end(&q, x);
    if (!(end > x) || ++pieces > MOST_PIECES || po_deadline_check())
      return NAN;
    sum += piece(&q, x, end);
    x = end;
  }
  return sum;
}

static double less(double x, po_abel t, const void *data) {
  (void)x;
  return t.g - *(const double *)data;
}

/* The beginning of the piece below a that ends at x: pieces lie between the joints, are not longer
 * than their distance from a, and the one at a is not longer than the ring, from a to c. */
static double piece_begin(const integral *q, double below, double a, double x) {
  double begin = fmax(below, x < a ? x - (a - x) : a - (q->to - a));
  for (size_t k = 0; k < po_scene_waves(q->scene); ++k)
    begin = fmax(begin, x - PIECE_OF_WAVE * po_scene_wave(q->scene, k).length);
  return fmax(begin, 0.0);
}

/* The integral of f'(s) atan(sqrt((c^2 - a^2)/(a^2 - s^2))) over a piece. In the square root of the
 * distance from its end the integrand is smooth at a, too. */
static double opened_by(const integral *q, const po_scene *scene, double a, double from,
                        double to) {
  const double ring = sqrt((q->to - a) * (q->to + a));
  double sum = 0.0;
  for (int i = 0; i < PIECE_POINTS; ++i) {
    const double v = q->node[i], s = to - (to - from) * v * v;
    const double inside = sqrt((a - to + (to - from) * v * v) * (a + s));
    sum += q->weight[i] * 2.0 * v * (to - from) * po_initial_gap_slope(scene, s) *
           po_atan2(ring, inside);
  }
  return sum;
}

/* With g as the integral of f', the order of both integrals is changed. That of one radius s inside
 * is an arc tangent, that of one outside pi/2, so that no transform is needed. */
static double opened(const integral *q, double a) {
  po_scene scene = *q->scene;
  scene.profile = q->profile;
  const po_profile_table *t = q->profile.table;
  double sum = M_PI_2 * (po_initial_gap(&scene, q->to) - po_initial_gap(&scene, a));
  size_t row = po_order_last_up_to(t->r, t->rows, a);
  for (double to = a, from; to > 0.0; to = from) {
    if (t->r[row] == to)
      --row;
    from = piece_begin(q, t->r[row], a, to);
    sum += opened_by(q, &scene, a, from, to);
  }
  return sum;
}

double po_abel_opening(const po_scene *scene, double a, double approach, double c) {
  integral q = {.scene = scene, .profile = scene->profile, .to = c};
  q.profile.table = po_abel_table(scene);
  if (!q.profile.table || !(a > 0.0) || !(piece_end(&q, a) < c))
    return po_abel_integral(scene, a, c, true, less, &approach);
  if (po_gauss_rule(PIECE_POINTS, q.node, q.weight) || po_deadline_check())
    return NAN;
  return opened(&q, a) - approach * po_abel_angle(a, c);
}

double po_abel_gap(const po_scene *scene, double a, double approach, double r) {
  return M_2_PI * po_abel_opening(scene, a, approach, r);
}
