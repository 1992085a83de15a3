#include "po_plane.h"

#include <math.h>

#include "po_elementary.h"

static po_plane_point minus(po_plane_point a, po_plane_point b) {
  return (po_plane_point){a.approach - b.approach, a.load - b.load};
}

static double dot(po_plane_point a, po_plane_point b) {
  return a.approach * b.approach + a.load * b.load;
}

static double length(po_plane_point a) {
  return po_hypot(a.approach, a.load);
}

static po_plane_point times(double factor, po_plane_point a) {
  return (po_plane_point){factor * a.approach, factor * a.load};
}

/* Returned: the derivative at point i with respect to the length of the chords. */
static po_plane_point tangent(const po_plane_curve *s, size_t i) {
  const size_t middle = i == 0 ? 1 : i == s->count - 1 ? s->count - 2 : i;
  if (s->count < 3 || length(minus(po_plane_at(s, middle), po_plane_at(s, middle - 1))) == 0 ||
      length(minus(po_plane_at(s, middle + 1), po_plane_at(s, middle))) == 0) {
    const size_t j = i + 1 < s->count ? i : i - 1;
    const po_plane_point chord = minus(po_plane_at(s, j + 1), po_plane_at(s, j));
    const double size = length(chord);
    return size > 0 ? (po_plane_point){chord.approach / size, chord.load / size} : chord;
  }
  const po_plane_point left = minus(po_plane_at(s, middle), po_plane_at(s, middle - 1)),
                       right = minus(po_plane_at(s, middle + 1), po_plane_at(s, middle));
  const double l = length(left), r = length(right);
  /* Slopes of the two chords, blended by the parabola through the three points. */
  const double at = i < middle ? -l : i > middle ? r : 0;
  const double a = (r - 2 * at) / (l + r), b = (l + 2 * at) / (l + r);
  return (po_plane_point){a * left.approach / l + b * right.approach / r,
                          a * left.load / l + b * right.load / r};
}

/* A Hermite cubic on t in [0, 1]: its ends p and q, and its derivatives u and v there. */
typedef struct {
  po_plane_point p, q, u, v;
} po_cubic;

static po_cubic cubic_of(const po_plane_curve *s, size_t i) {
  const po_plane_point p = po_plane_at(s, i), q = po_plane_at(s, i + 1);
  if (s->rates) {
    const po_curve_point *a = &s->points[i], *b = &s->points[i + 1];
    const double step = b->position - a->position;
    return (po_cubic){p, q, times(step, (po_plane_point){a->approach_rate, a->load_rate}),
                      times(step, (po_plane_point){b->approach_rate, b->load_rate})};
  }
  const double size = length(minus(q, p));
  return (po_cubic){p, q, times(size, tangent(s, i)), times(size, tangent(s, i + 1))};
}

static double hermite(double p, double q, double u, double v, double t) {
  const double rest = q - p;
  return p + t * (u + t * ((3 * rest - 2 * u - v) + t * (u + v - 2 * rest)));
}

static double hermite_slope(double p, double q, double u, double v, double t) {
  const double rest = q - p;
  return u + t * (2 * (3 * rest - 2 * u - v) + t * 3 * (u + v - 2 * rest));
}

static po_plane_point cubic_at(const po_cubic *c, double t) {
  return (po_plane_point){hermite(c->p.approach, c->q.approach, c->u.approach, c->v.approach, t),
                          hermite(c->p.load, c->q.load, c->u.load, c->v.load, t)};
}

static po_plane_point cubic_slope(const po_cubic *c, double t) {
  return (po_plane_point){
      hermite_slope(c->p.approach, c->q.approach, c->u.approach, c->v.approach, t),
      hermite_slope(c->p.load, c->q.load, c->u.load, c->v.load, t)};
}

static double clamp(double t) {
  return t < 0 ? 0 : t > 1 ? 1 : t;
}

static double chord_parameter(po_plane_point point, po_plane_point p, po_plane_point q) {
  const po_plane_point chord = minus(q, p);
  const double square = dot(chord, chord);
  return square > 0 ? clamp(dot(minus(point, p), chord) / square) : 0;
}

static double chord_distance(po_plane_point point, po_plane_point p, po_plane_point q) {
  const double t = chord_parameter(point, p, q);
  return length(minus(point, (po_plane_point){p.approach + t * (q.approach - p.approach),
                                              p.load + t * (q.load - p.load)}));
}

/* Gauss-Newton iteration for the nearest point of a cubic. It starts at the nearest point of the
 * chord and needs two or three steps. */
static double cubic_foot(po_plane_point point, const po_cubic *c, double *foot) {
  enum { STEPS = 8 };
  double t = chord_parameter(point, c->p, c->q);
  double least = length(minus(point, cubic_at(c, t)));
  *foot = t;
  for (int i = 0; i < STEPS; ++i) {
    const po_plane_point slope = cubic_slope(c, t);
    const double square = dot(slope, slope);
    if (square == 0)
      break;
    t = clamp(t + dot(minus(point, cubic_at(c, t)), slope) / square);
    const double distance = length(minus(point, cubic_at(c, t)));
    if (distance <= least) {
      least = distance;
      *foot = t;
    }
  }
  return least;
}

static size_t nearest_chord(po_plane_point point, const po_stretch *stretch) {
  size_t nearest = stretch->from;
  double least = (double)INFINITY;
  for (size_t i = stretch->from; i < stretch->to; ++i) {
    const double distance =
        chord_distance(point, po_plane_at(&stretch->curve, i), po_plane_at(&stretch->curve, i + 1));
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

po_foot po_plane_foot(po_plane_point point, const po_stretch *stretch) {
  const po_plane_curve *curve = &stretch->curve;
  if (stretch->to <= stretch->from)
    return (po_foot){.distance = length(minus(point, po_plane_at(curve, stretch->from))),
                     .index = stretch->from};
  const size_t nearest = nearest_chord(point, stretch);
  /* The cubic deviates from its chord, so the nearest point may lie in a neighbouring element. */
  const size_t from = nearest > stretch->from ? nearest - 1 : nearest;
  const size_t to = nearest + 1 < stretch->to ? nearest + 1 : nearest;
  po_foot foot = {.distance = (double)INFINITY};
  for (size_t i = from; i <= to; ++i) {
    const po_cubic cubic = cubic_of(curve, i);
    double t = 0;
    const double distance = cubic_foot(point, &cubic, &t);
    if (!(distance < foot.distance)) /* also if it is NAN */
      continue;
    const size_t last = curve->count - 2;
    foot = (po_foot){
        .distance = distance,
        .index = i,
        .before = i == 0 && t == 0 && dot(minus(point, cubic.p), cubic.u) < 0,
        .beyond = i == last && t == 1 && dot(minus(point, cubic.q), cubic.v) > 0,
    };
  }
  return foot;
}

/* Returned: the distance of point i from the cubic through its two neighbours on either side. */
static double omission_error(const po_plane_curve *curve, size_t i) {
  po_curve_point around[4];
  size_t count = 0, before = 0;
  for (size_t k = i < 2 ? 0 : i - 2; k <= i + 2 && k < curve->count; ++k) {
    before += k < i;
    if (k != i)
      around[count++] = curve->points[k];
  }
  if (i >= curve->count || before == 0 || before == count)
    return 0.0;
  const po_stretch across = {{.points = around, .count = count}, before - 1, before};
  return po_plane_foot(po_plane_at(curve, i), &across).distance;
}

double po_plane_uncertainty(const po_plane_curve *curve, size_t index) {
  /* With evenly spaced points the interpolation error is a sixteenth of the error with every other
   * point omitted. With unevenly spaced points, or where the error changes sign, errors up to six
   * times the distance of the omitted points were found (curves of Feng's problem and of the wavy
   * sphere). */
  static const double OMISSION_FACTOR = 8.0;
  double most = 0.0;
  for (size_t i = index > 0 ? index - 1 : 0; !curve->rates && i <= index + 2; ++i)
    most = fmax(most, omission_error(curve, i));
  return OMISSION_FACTOR * most;
}
