#include "po_estimate.h"

#include <math.h>

#include "po_far_field.h"
#include "po_observe_parts.h"

/* Greatest allowed distance of the curve from the cubics between its points, relative to the
 * tolerance of panels, and its least values. The cost is inversely proportional to its fourth root.
 * Staircases need the curve between special points for the energies lost only; with 1e-5 they take
 * a third of the points. */
static const double MISS_OF_TOLERANCE = 0.1, LEAST_MISS = 1e-8, LEAST_OF_STAIRCASE = 1e-5;

/* The same of the tolerance for loops. With 0.1 the work of a closed loop, which adds the areas
 * between the curve and its cubics, differs by up to 0.15 of the tolerance from the energy that its
 * jumps lose (mu = 2.2 and 2.385, R = 83). */
static const double MISS_OF_LOOPS = 0.06;

double po_estimate_miss(const po_request *request) {
  const bool drawn = request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS);
  const double part = request->want & PO_WANT_HYSTERESIS ? MISS_OF_LOOPS : MISS_OF_TOLERANCE;
  return fmax(drawn ? LEAST_MISS : LEAST_OF_STAIRCASE, part * request->mesh.tolerance);
}

/* Factors of the stated error of an energy lost: of the change of an energy on a finer mesh, and of
 * the difference of energies by interpolation where a jump ends. */
static const double OF_CHANGE = 3.0, OF_INTERPOLATED = 3.0;

double po_estimate_energy_lost_error(const po_request *request, const po_estimate *greatest,
                                     po_control control, const po_cycle *cycle) {
  const double place =
      control == PO_LOAD_CONTROL ? greatest->traced_load_error : greatest->traced_approach_error;
  const double precision = po_observe_precision(request->mesh.tolerance);
  return cycle->moved * place + OF_INTERPOLATED * cycle->interpolated + precision * cycle->size +
         2.0 * (double)cycle->jumps * greatest->energy_error;
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

/* The error of the contact radius by the error of the place on the branch. At an extremum of the
 * load the approach, at a fold the load, has an error of the first order in that of the place. */
static double edge_error_of_place(const po_branch_point *p) {
  const po_solution *best = p->best;
  const bool of_load = p->kind == PO_POINT_LOAD_MIN || p->kind == PO_POINT_LOAD_MAX;
  const double rate = of_load ? best->tangent[best->n] : best->load_rate;
  const double error = of_load ? p->approach_error : p->load_error;
  const size_t edges = best->edges.count;
  return edges > 0 && rate != 0.0 ? error * fabs(best->edges.rate[edges - 1] / rate) : 0.0;
}

/* Error of the energy of a rigid scene, see po_rigid_energy. */
static const double RIGID_ENERGY = 1e-10;

/* The change of the energy at given approach from the solution of the trace to the finer mesh. */
static double change_of_energy(const po_branch_point *p) {
  const double moved = po_solution_approach(p->finer) - p->approach;
  return fabs(p->finer->energy - p->energy - 0.5 * (p->finer->load + p->load) * moved);
}

po_estimate po_estimate_of(const po_request *request, double domain, const po_branch_point *p) {
  po_estimate e = {.approach = p->approach + p->approach_correction,
                   .load = p->load + p->load_correction,
                   .approach_error = p->approach_error,
                   .load_error = p->load_error,
                   .edge = edge_of(request, domain, p)};
  e.traced_approach_error = e.approach_error + fabs(p->approach_correction);
  e.traced_load_error = e.load_error + fabs(p->load_correction);
  e.energy_error = p->gap ? NAN : RIGID_ENERGY * fmax(1.0, fabs(p->energy));
  if (p->finer)
    e.energy_error = OF_CHANGE * change_of_energy(p);
  if (p->best) {
    const po_far_field far = po_far_field_error(&request->scene, domain, p->best);
    e.edge.error = fmax(e.edge.error, edge_error_of_place(p));
    e.approach_error += far.approach;
    e.load_error += far.load;
    e.far_load_error = far.load;
    e.traced_approach_error += far.approach;
    e.traced_load_error += far.load;
    e.energy_error += far.load * (1.0 + fabs(p->approach));
  }
  return e;
}
