#include "po_kernel.h"

#include <math.h>

double po_kernel(double sum, double difference) {
  double a = sum, b = fabs(difference);
  if (b == 0.0)
    return INFINITY;
  /* The iteration converges quadratically: when a - b is below the square root of the rounding unit
   * (1.5e-8), one more mean is exact to rounding. */
  while (a - b > 1.5e-8 * a) {
    const double mean = 0.5 * (a + b);
    b = sqrt(a * b);
    a = mean;
  }
  return 4.0 / (a + b);
}

/* Ratios b/a from which on 0, 1, 2... steps of the arithmetic-geometric mean are enough for (a +
 * b)/2 to be exact to rounding: 1 - 1.5e-8, and what a step raises to the ratio before. */
static const double ENOUGH[] = {0.999999985,
                                0.99965364982939431,
                                0.94871579836330886,
                                0.51960643900830777,
                                0.078512630480415333,
                                0.001545826385841385,
                                5.9739551755302881e-7,
                                8.9220351098128708e-14,
                                1.9900677625183392e-27,
                                9.9009242485368718e-55,
                                2.4507075243816355e-109,
                                1.5014918425151911e-218};

/* Returned: the number of steps that are enough for ratios from `ratio` on. */
static int steps_for(double ratio) {
  int steps = 0;
  while (steps < (int)(sizeof ENOUGH / sizeof *ENOUGH) && ratio < ENOUGH[steps])
    ++steps;
  return steps;
}

/* Kernels that are computed together, so that the compiler can vectorise the loops. */
enum { BLOCK = 64 };

/* The kernel from `count` sums a and moduli b of the differences, which are overwritten. */
static void kernel_block(size_t count, double *a, double *b, double *kernel) {
  double least = 1.0;
  for (size_t j = 0; j < count; ++j) {
    const double ratio = b[j] / a[j];
    least = ratio < least ? ratio : least;
  }
  for (int steps = steps_for(least); steps > 0; --steps)
    for (size_t j = 0; j < count; ++j) {
      const double mean = 0.5 * (a[j] + b[j]);
      b[j] = sqrt(a[j] * b[j]);
      a[j] = mean;
    }
  for (size_t j = 0; j < count; ++j)
    kernel[j] = 4.0 / (a[j] + b[j]);
}

void po_kernels(size_t n, const double *sum, const double *difference, double *kernel) {
  for (size_t first = 0; first < n; first += BLOCK) {
    const size_t count = n - first < BLOCK ? n - first : BLOCK;
    double a[BLOCK], b[BLOCK];
    for (size_t j = 0; j < count; ++j) {
      a[j] = sum[first + j];
      b[j] = fabs(difference[first + j]);
    }
    kernel_block(count, a, b, kernel + first);
  }
}

void po_kernel_row(double r, const double *s, const double *apart, size_t n, double *kernel) {
  for (size_t first = 0; first < n; first += BLOCK) {
    const size_t count = n - first < BLOCK ? n - first : BLOCK;
    double a[BLOCK], b[BLOCK];
    for (size_t j = 0; j < count; ++j) {
      a[j] = r + s[first + j];
      b[j] = fabs(apart ? apart[first + j] : r - s[first + j]);
    }
    kernel_block(count, a, b, kernel + first);
  }
}

/* The complete elliptic integrals K and E of modulus k. Given: kp = sqrt(1 - k^2) > 0, computed by
 * the caller without cancellation. Formula: E = K (1 - sum 2^(n-1) c_n^2) over the steps of the
 * arithmetic-geometric mean, c_0 = k (Abramowitz and Stegun 17.6). */
static void elliptic(double k, double kp, double *K, double *E) {
  double a = 1.0, b = kp, c = k, power = 0.5, sum = power * c * c;
  while (fabs(c) > 1e-9) { /* c converges quadratically: the next term is below 1e-18 */
    c = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = sqrt(a * b);
    a = mean;
    power *= 2.0;
    sum += power * c * c;
  }
  *K = M_PI_2 / a;
  *E = *K * (1.0 - sum);
}

double po_disc_deflection(double c, double r) {
  if (c == 0.0)
    return 0.0;
  if (r == c)
    return c;
  const double large = c > r ? c : r, small = c > r ? r : c;
  const double k = small / large, kp = sqrt((large - small) * (large + small)) / large;
  double K, E;
  elliptic(k, kp, &K, &E);
  return c > r ? c * E : r * (E - kp * kp * K);
}
