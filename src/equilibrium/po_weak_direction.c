/* The factors of panels in the direction in which they err most. The error of the compressed
 * interactions is some 1e-5 of the interactions. Where the Jacobian has a singular value as small
 * as that, it may be negative in the factors, or so small that no iteration converges: under
 * coupling * p' * (contact radius) = 10^4, or where a ring of tension moves freely. */
#include <math.h>

#include "po_equilibrium.h"
#include "po_linear.h"

/* Gain above which the direction is examined, and the part by which the factors must miss the
 * Jacobian there to be corrected. */
static const double GAIN_OF_EXAMINATION = 3.0, LEAST_MISS = 0.3;

/* The bordered Jacobian of Eq 15 times a change of the state last evaluated. Given: change, n + 1.
 * Returned: product, n + 1. */
static void multiply(po_equilibrium *e, const double *change, double *product) {
  const size_t n = e->n;
  for (size_t j = 0; j < n; ++j)
    e->right[j] = e->slope[j] * change[j];
  po_equilibrium_deflect(e, e->right, product);
  for (size_t i = 0; i < n; ++i)
    product[i] = change[i] + change[n] - product[i];
  product[n] = po_linear_dot(n + 1, e->border, change);
}

/* With M the factors, J the Jacobian and s the direction, M^-1 is corrected to (1 + u v') M^-1 so
 * that it takes J s to s, as in Broyden's method: v = s / (s . z), u = s - z, z = M^-1 J s. The
 * determinant of the factors is multiplied by (s . z) / (s . s). The scalar product is that of
 * changes relative to 1 + H. */
bool po_equilibrium_correct_weak(po_equilibrium *e) {
  const size_t n = e->n;
  if (!e->elimination || e->weak_count == PO_MOST_WEAK || !(e->gain > GAIN_OF_EXAMINATION))
    return false;
  const size_t at = e->weak_count * (n + 1);
  double *s = e->weak_functional + at, *z = e->weak + at, *product = e->deflection;
  const double length = sqrt(po_linear_dot(n + 1, e->scratch, e->scratch));
  for (size_t j = 0; j <= n; ++j)
    s[j] = e->scratch[j] / length;
  multiply(e, s, product);
  po_equilibrium_precondition(e, product, z);
  double square = 0.0, along = 0.0;
  for (size_t j = 0; j <= n; ++j) {
    const double part = s[j] / (e->secant.scale[j] * e->secant.scale[j]);
    square += part * s[j];
    along += part * z[j];
    z[j] = s[j] - z[j];
    s[j] = part;
  }
  if (!isfinite(along) || along == 0.0 || fabs(along / square - 1.0) < LEAST_MISS)
    return false;
  for (size_t j = 0; j <= n; ++j)
    s[j] /= along;
  ++e->weak_count;
  if (along < 0.0)
    e->orientation = -e->orientation;
  return true;
}
