/* Integrals over the Abel transform. */
#include "po_abel.h"

#include <math.h>

#include "po_elementary.h"
#include "po_quadrature.h"
#include "po_watch.h"

/* Points of the rule in a piece. */
enum { POINTS = 16 };
static const double MOST_PIECES = 1e6;
/* Near the axis g is a power of x, so that pieces grow from the axis: the first is the part FIRST
 * of the whole, each further one ends at GROWTH times its beginning, or after PART_OF_WAVE of a
 * wave. */
static const double GROWTH = 4.0, FIRST = 1e-5, PART_OF_WAVE = 0.5;

typedef struct {
  const po_scene *scene;
  po_abel_integrand f;
  const void *data;
  bool to_edge; /* with the weight 1/sqrt(to^2 - x^2) */
  double to;
  double node[POINTS], weight[POINTS];
} integral;

/* The end of the piece that begins at x. */
static double piece_end(const integral *q, double x) {
  double end = fmin(q->to, fmax(GROWTH * x, FIRST * q->to));
  end = fmin(end, po_profile_next_joint(&q->scene->profile, x));
  for (size_t k = 0; k < po_scene_waves(q->scene); ++k)
    end = fmin(end, x + PART_OF_WAVE * po_scene_wave(q->scene, k).length);
  return end;
}

/* arccos(x/to) */
static double angle_of(const integral *q, double x) {
  return po_atan2(sqrt((q->to - x) * (q->to + x)), x);
}

/* Beyond a kink or a row g is smooth in the square root of the distance from it, in which the rule
 * is applied. The weight goes by the angle arccos(x/to). */
static double piece(const integral *q, double from, double to) {
  const double first = q->to_edge ? angle_of(q, from) : from,
               whole = (q->to_edge ? angle_of(q, to) : to) - first;
  double sum = 0.0;
  for (int i = 0; i < POINTS; ++i) {
    const double v = q->node[i], place = first + whole * v * v;
    const double x = fmin(fmax(q->to_edge ? q->to * po_cos(place) : place, from), to);
    sum += q->weight[i] * 2.0 * v * fabs(whole) * q->f(x, po_abel_at(q->scene, x), q->data);
  }
  return sum;
}

double po_abel_integral(const po_scene *scene, double from, double to, bool to_edge,
                        po_abel_integrand f, const void *data) {
  integral q = {.scene = scene, .f = f, .data = data, .to_edge = to_edge, .to = to};
  if (!(from < to))
    return from == to ? 0.0 : NAN;
  if (po_gauss_rule(POINTS, q.node, q.weight))
    return NAN;
  double sum = 0.0, pieces = 0.0;
  for (double x = from; x < to;) {
    const double end = piece_end(&q, x);
    if (!(end > x) || ++pieces > MOST_PIECES || po_watch_look())
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

double po_abel_gap(const po_scene *scene, double a, double approach, double r) {
  return M_2_PI * po_abel_integral(scene, a, r, true, less, &approach);
}
