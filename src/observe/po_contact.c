#include "po_contact.h"

#include <math.h>
#include <stdbool.h>

#include "po_law.h"
#include "po_shape.h"

double po_contact_radius(size_t n, const double *node, const double *gap) {
  for (size_t j = n; j-- > 0;) {
    if (gap[j] > PO_LAW_PEAK_GAP)
      continue;
    if (j + 1 == n)
      return node[j];
    const double share = (PO_LAW_PEAK_GAP - gap[j]) / (gap[j + 1] - gap[j]);
    return node[j] + share * (node[j + 1] - node[j]);
  }
  return 0.0;
}

double po_contact_radius_rigid(const po_scene *scene, double approach) {
  const double reach = approach + PO_LAW_PEAK_GAP; /* contact where shape <= reach */
  if (reach <= 0.0)
    return 0.0;
  /* The sphere alone bounds it; inwards from there by steps that no crest is narrower than. */
  const double bound = sqrt(2.0 * scene->radius * reach);
  if (!po_scene_is_wavy(scene))
    return bound;
  enum { STEPS_A_WAVE = 256, BISECTIONS = 60 };
  const double step = fmin(scene->wavelength / STEPS_A_WAVE, bound / STEPS_A_WAVE);
  if (bound - step == bound) /* the outermost crest is nearer to it than the next double */
    return bound;
  double outside = bound, inside = bound;
  while (inside > 0.0 && po_shape(scene, inside) > reach) {
    outside = inside;
    inside = fmax(0.0, inside - step);
  }
  for (int k = 0; k < BISECTIONS; ++k) {
    const double middle = 0.5 * (inside + outside);
    if (po_shape(scene, middle) > reach)
      outside = middle;
    else
      inside = middle;
  }
  return inside;
}

size_t po_contact_rings(size_t n, const double *node, const double *gap, double level,
                        po_contact_ring *ring) {
  size_t count = 0;
  bool inside = false;
  for (size_t j = 0; j < n; ++j) {
    if ((gap[j] < level) == inside)
      continue;
    double edge = j ? node[j] : 0.0; /* the first node stands for all within */
    if (j)
      edge -= (gap[j] - level) / (gap[j] - gap[j - 1]) * (node[j] - node[j - 1]);
    inside = !inside;
    if (inside)
      ring[count].inner = edge;
    else
      ring[count++].outer = edge;
  }
  if (inside)
    ring[count++].outer = node[n - 1];
  return count;
}
