#include <math.h>

#include "po_element.h"
#include "po_kernel.h"

uint64_t po_ring_influence(size_t n, const double *edge, double r, double *row, size_t stride) {
  double inner = po_disc_deflection(edge[0], r);
  for (size_t j = 0; j < n; ++j) {
    const double outer = po_disc_deflection(edge[j + 1], r);
    row[j * stride] = 4.0 / M_PI * (outer - inner); /* Eq A4 */
    inner = outer;
  }
  return n + 1;
}
