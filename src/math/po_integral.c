#include "po_integral.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* The nodes of the rule on (-1, 1) and their weights; every other node, from the second on, belongs
 * to Gauss's rule of 10 points. It is exact for polynomials of degree 31
 * (tests/unit/test_quadrature.c). */
enum { PAIRS = 10 };
static const double NODE[PAIRS] = {0.9956571630258081, 0.9739065285171717, 0.9301574913557082,
                                   0.8650633666889845, 0.7808177265864169, 0.6794095682990244,
                                   0.5627571346686047, 0.4333953941292472, 0.2943928627014602,
                                   0.14887433898163122};
static const double KRONROD[PAIRS + 1] = {
    0.011694638867371874, 0.032558162307964725, 0.054755896574351995, 0.07503967481091996,
    0.0931254545836976,   0.10938715880229764,  0.12349197626206584,  0.13470921731147334,
    0.14277593857706009,  0.1477391049013385,   0.1494455540029169};
static const double GAUSS[PAIRS / 2] = {0.06667134430868814, 0.1494513491505806,
                                        0.21908636251598204, 0.26926671930999635,
                                        0.29552422471475287};

typedef struct {
  double from, to, integral, error;
  double rounding; /* of the integral: what the error can at least be told from */
} piece;

/* The estimate of QUADPACK: the difference of the two rules, which is the error of Gauss's, is
 * reduced by the power 3/2 if it is small against the variation of the function. */
static double reduced(double difference, double variation) {
  if (variation == 0.0 || difference == 0.0)
    return difference;
  const double part = 200.0 * difference / variation;
  return part < 1.0 ? variation * part * sqrt(part) : variation;
}

static piece rule(po_integrand f, void *data, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from), at_middle = f(middle, data);
  double low[PAIRS], high[PAIRS];
  double kronrod = KRONROD[PAIRS] * at_middle, gauss = 0.0, size = fabs(kronrod);
  for (int k = 0; k < PAIRS; ++k) {
    low[k] = f(middle - half * NODE[k], data);
    high[k] = f(middle + half * NODE[k], data);
    kronrod += KRONROD[k] * (low[k] + high[k]);
    size += KRONROD[k] * (fabs(low[k]) + fabs(high[k]));
    if (k % 2 == 1)
      gauss += GAUSS[k / 2] * (low[k] + high[k]);
  }
  const double mean = 0.5 * kronrod;
  double variation = KRONROD[PAIRS] * fabs(at_middle - mean);
  for (int k = 0; k < PAIRS; ++k)
    variation += KRONROD[k] * (fabs(low[k] - mean) + fabs(high[k] - mean));
  const double length = fabs(half), rounding = 50.0 * DBL_EPSILON * size * length;
  return (piece){from, to, kronrod * half,
                 fmax(rounding, reduced(fabs(kronrod - gauss) * length, variation * length)),
                 rounding};
}

po_status po_integrate(po_integrand f, void *data, double from, double to, double absolute,
                       double relative, double *integral) {
  enum { PIECES = 200 };
  piece pieces[PIECES];
  pieces[0] = rule(f, data, from, to);
  for (size_t count = 1;; ++count) {
    double sum = 0.0, error = 0.0, rounding = 0.0;
    size_t worst = 0;
    for (size_t k = 0; k < count; ++k) {
      sum += pieces[k].integral;
      error += pieces[k].error;
      rounding += pieces[k].rounding;
      if (pieces[k].error - pieces[k].rounding > pieces[worst].error - pieces[worst].rounding)
        worst = k;
    }
    *integral = sum;
    if (error <= fmax(absolute, relative * fabs(sum)) || error <= 2.0 * rounding)
      return PO_OK;
    const piece p = pieces[worst];
    const double middle = 0.5 * (p.from + p.to);
    if (count == PIECES || !isfinite(sum) || middle == p.from || middle == p.to)
      return PO_NOT_CONVERGED;
    pieces[worst] = rule(f, data, p.from, middle);
    pieces[count] = rule(f, data, middle, p.to);
  }
}
