#include "po_pull_off_sensitivity.h"

#include <math.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_law.h"

bool po_pull_off_sensitivity(const po_scene *scene, const po_surface *surface, const po_solution *p,
                             po_sensitivity *made) {
  const size_t n = p->n;
  const double rate = p->tangent[n], averaged = po_initial_gap_amplitude(scene);
  *made = (po_sensitivity){.residual = NAN, .rounding = NAN};
  if (surface->n != n || memcmp(surface->node, p->node, n * sizeof *p->node) != 0 || rate == 0.0)
    return false;
  for (size_t j = 0; j < n; ++j) {
    const double gap = p->state[j];
    const bool resolved = j < surface->resolved;
    const double slope =
        (resolved ? po_law_at(&scene->law, gap) : po_law_averaged(&scene->law, gap, averaged))
            .slope;
    const double adjoint = -2.0 / scene->radius * surface->weight[j] * slope * p->tangent[j] / rate;
    const po_sensitivity s =
        po_sensitivity_sources(scene, p->node[j], resolved, p->deflection[j] + p->state[n]);
    made->tabor += adjoint * s.tabor;
    made->amplitude += adjoint * s.amplitude;
    made->wavelength += adjoint * s.wavelength;
    made->radius += adjoint * s.radius;
  }
  made->radius -= p->load; /* the 1/R of Eq 17 */
  double *const parts[] = {&made->tabor, &made->amplitude, &made->wavelength, &made->radius};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k)
    *parts[k] /= p->load;
  return true;
}
