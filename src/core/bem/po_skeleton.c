#include "po_skeleton.h"

#include <math.h>
#include <string.h>

#include "po_kernel.h"
#include "po_linear.h"

/* The functions L are polynomials on pieces that shrink towards both ends of the cell: 7 pieces on
 * each side, each half as long as the next, and the last twice. */
enum { HALVINGS = 8, PIECES = 2 * HALVINGS, SAMPLES = 8, PLACES = PIECES * SAMPLES };
/* Places of a source: distances 1, 1/2, 1/4, ... from both ends of cells that are 0, 1, 3, and 1000
 * of their lengths from the axis, and three places farther away. */
enum { CELLS = 4, NEAR = 13, FAR = 3, SOURCES = 2 * CELLS * (NEAR + FAR) + 1 };
enum { N = PO_TABLE_ORDER, K = PO_SKELETON_NODES };

static const double CELL[CELLS] = {0.0, 1.0, 3.0, 1000.0};
static const double FAR_PLACE[FAR] = {2.0, 4.0, 16.0};

static double piece_begin(int piece) {
  if (piece == 0 || piece == PIECES)
    return piece ? 1.0 : 0.0;
  return piece <= HALVINGS ? ldexp(1.0, piece - 1 - HALVINGS)
                           : 1.0 - ldexp(1.0, HALVINGS - 1 - piece);
}

typedef struct {
  double node[SAMPLES], weight[SAMPLES], barycentric[SAMPLES];
  double place[PLACES], size[PLACES]; /* size: weight of the place in an integral over the cell */
} samples;

static po_status fill_samples(samples *s) {
  const po_status status = po_gauss_rule(SAMPLES, s->node, s->weight);
  if (status)
    return status;
  po_barycentric_weights(SAMPLES, s->node, s->barycentric);
  for (int piece = 0; piece < PIECES; ++piece) {
    const double begin = piece_begin(piece), length = piece_begin(piece + 1) - begin;
    for (int q = 0; q < SAMPLES; ++q) {
      s->place[piece * SAMPLES + q] = begin + length * s->node[q];
      s->size[piece * SAMPLES + q] = length * s->weight[q];
    }
  }
  return PO_OK;
}

/* Samples of the kernel for all sources, in the scale of an integral over the cell; a source counts
 * by its distance, as a panel that near does by its length. */
static void fill_kernel(const samples *s, double sample[PLACES][SOURCES]) {
  for (int p = 0; p < PLACES; ++p) {
    const double scale = sqrt(s->size[p]);
    int to = 0;
    for (int c = 0; c < CELLS; ++c)
      for (int k = 0; k < NEAR + FAR; ++k) {
        const double distance = k < NEAR ? ldexp(1.0, -k) : FAR_PLACE[k - NEAR];
        const double r = CELL[c] + s->place[p], size = CELL[c] + 0.5;
        const double before = CELL[c] - distance, after = CELL[c] + 1.0 + distance;
        const double factor = scale * size * fmin(1.0, distance);
        sample[p][to++] =
            before > 0.0 ? factor * po_kernel(r + before, s->place[p] + distance) : 0.0;
        sample[p][to++] = factor * po_kernel(r + after, 1.0 + distance - s->place[p]);
      }
    sample[p][to] = 10.0 * scale; /* constants, which the approach adds to the gap, exactly */
  }
}

/* Chooses K places whose samples span those of all places, by Gram and Schmidt's process with
 * pivoting. Returned: chosen, and the coefficients that give the samples of each place from those
 * chosen. */
static void choose(double sample[PLACES][SOURCES], int chosen[K], double coefficient[PLACES][K]) {
  double triangle[PLACES][K] = {{0.0}};
  for (int k = 0; k < K; ++k) {
    double largest = -1.0;
    for (int p = 0; p < PLACES; ++p) {
      const double size = po_linear_dot(SOURCES, sample[p], sample[p]);
      if (size > largest) {
        largest = size;
        chosen[k] = p;
      }
    }
    double unit[SOURCES];
    for (int j = 0; j < SOURCES; ++j)
      unit[j] = sample[chosen[k]][j] / sqrt(largest);
    for (int p = 0; p < PLACES; ++p) {
      triangle[p][k] = po_linear_dot(SOURCES, unit, sample[p]);
      po_linear_add(SOURCES, -triangle[p][k], unit, sample[p]);
    }
  }
  for (int p = 0; p < PLACES; ++p) /* coefficient . triangle[chosen] = triangle[p] */
    for (int k = K - 1; k >= 0; --k) {
      double sum = triangle[p][k];
      for (int m = k + 1; m < K; ++m)
        sum -= coefficient[p][m] * triangle[chosen[m]][k];
      coefficient[p][k] = sum / triangle[chosen[k]][k];
    }
}

/* The functions L at x. */
static void evaluate(const samples *s, double function[PLACES][K], double x, double value[K]) {
  int piece = 0;
  while (piece + 1 < PIECES && piece_begin(piece + 1) <= x)
    ++piece;
  const double begin = piece_begin(piece), length = piece_begin(piece + 1) - begin;
  double weight[SAMPLES];
  po_lagrange(SAMPLES, s->node, s->barycentric, (x - begin) / length, weight);
  for (int k = 0; k < K; ++k) {
    value[k] = 0.0;
    for (int q = 0; q < SAMPLES; ++q)
      value[k] += weight[q] * function[piece * SAMPLES + q][k];
  }
}

const po_skeleton *po_skeleton_make(const po_panel_rule *rule) {
  static po_skeleton skeleton;
  static double sample[PLACES][SOURCES], function[PLACES][K];
  samples s;
  if (fill_samples(&s))
    return NULL;
  int chosen[K];
  fill_kernel(&s, sample);
  choose(sample, chosen, function);
  for (int p = 0; p < PLACES; ++p)
    for (int k = 0; k < K; ++k)
      function[p][k] *= sqrt(s.size[chosen[k]] / s.size[p]);
  double value[K];
  for (int k = 0; k < K; ++k)
    skeleton.node[k] = s.place[chosen[k]];
  for (int i = 0; i < N; ++i) {
    evaluate(&s, function, rule->node[i], value);
    for (int k = 0; k < K; ++k)
      skeleton.value[i + N * k] = value[k];
  }
  for (int child = 0; child < 2; ++child)
    for (int i = 0; i < K; ++i) {
      evaluate(&s, function, 0.5 * (skeleton.node[i] + child), value);
      for (int k = 0; k < K; ++k)
        skeleton.from_parent[child][i + K * k] = skeleton.to_parent[child][k + K * i] = value[k];
    }
  memset(skeleton.moment, 0, sizeof skeleton.moment);
  for (int p = 0; p < PLACES; ++p) {
    double polynomial[N];
    po_lagrange(N, rule->node, rule->barycentric, s.place[p], polynomial);
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < K; ++k)
        skeleton.moment[k + K * j] += s.size[p] * function[p][k] * polynomial[j];
  }
  return &skeleton;
}
