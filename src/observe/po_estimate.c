#include "po_estimate.h"

#include <math.h>

#include "po_far_field.h"
#include "po_observe_parts.h"

/* Greatest allowed distance of the curve from the cubics between its points, relative to the
 * tolerance of panels, and its least values. The cost is inversely proportional to its fourth root.
 * Staircases need the curve between special points for the energies lost only; with 1e-5 they take
 * a third of the points. */
static const double MISS_OF_TOLERANCE = 0.1, LEAST_MISS = 1e-8, LEAST_OF_STAIRCASE = 1e-5;

double po_estimate_miss(const po_request *request) {
  const bool drawn = request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS);
  return fmax(drawn ? LEAST_MISS : LEAST_OF_STAIRCASE, MISS_OF_TOLERANCE * request->mesh.tolerance);
}

double po_estimate_energy_error(const po_request *request, double fold_error, double error_factor) {
  return error_factor *
         (po_estimate_miss(request) + fold_error + MISS_OF_TOLERANCE * request->mesh.tolerance);
}

static po_contact_edge edge_on_panels(const po_request *request, double domain,
                                      const po_branch_point *p) {
  const po_contact_gap best = po_contact_gap_on_panels(&request->scene, domain, p->best);
  const po_contact_gap finer = po_contact_gap_on_panels(&request->scene, domain, p->finer);
  /* an error of the approach is an error of the gap */
  const po_contact_doubt doubt = {&finer, po_observe_precision(request->mesh.tolerance),
                                  po_far_field_error(&request->scene, domain, p->best).approach};
  return po_contact_estimate(&best, &doubt);
}

static po_contact_edge edge_of(const po_request *request, double domain, const po_branch_point *p) {
  if (p->finer)
    return edge_on_panels(request, domain, p);
  const po_contact_gap gap = po_contact_gap_of(&request->scene, domain, p);
  if (!p->gap &&
      isfinite(p->approach_error)) /* rigid: the error of the gap is that of the approach */
    return po_contact_estimate(&gap, &(po_contact_doubt){.constant = p->approach_error});
  return (po_contact_edge){po_contact_radius(&gap), NAN, NAN};
}

po_estimate po_estimate_of(const po_request *request, double domain, const po_branch_point *p) {
  po_estimate e = {.approach = p->approach + p->approach_correction,
                   .load = p->load + p->load_correction,
                   .approach_error = p->approach_error,
                   .load_error = p->load_error,
                   .edge = edge_of(request, domain, p)};
  if (p->best) {
    const po_far_field far = po_far_field_error(&request->scene, domain, p->best);
    e.approach_error += far.approach;
    e.load_error += far.load;
    e.far_load_error = far.load;
  }
  return e;
}
