#include "po_estimate.h"

#include <math.h>

#include "po_energy_error.h"
#include "po_observe_parts.h"

/* Allowed distance between the branch and the cubics through its points: MISS_OF_TOLERANCE times
 * the tolerance of panels, but at least LEAST_MISS, or LEAST_OF_STAIRCASE if no curve is drawn. The
 * number of points goes as the distance to the power -1/4. Staircases use the cubics only for the
 * energies lost; with 1e-5 in place of 1e-8 they take a third of the points. */
static const double MISS_OF_TOLERANCE = 0.1, LEAST_MISS = 1e-8, LEAST_OF_STAIRCASE = 1e-5;

/* MISS_OF_TOLERANCE for loops. With 0.1 the work of a closed loop, in which the areas between the
 * branch and the cubics add up, differs by up to 0.15 of the tolerance from the energy that its
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

double po_estimate_loss_error(const po_request *request, const po_estimate *greatest,
                              po_control control, const po_loss *loss) {
  /* A spring jumps between the special points, at a place of the cubics. */
  const bool inside = control != PO_LOAD_CONTROL && isfinite(control);
  const double miss = inside ? po_estimate_miss(request) : 0.0;
  const double place =
      po_held(control, greatest->traced_approach_error + miss, greatest->traced_load_error + miss);
  const double precision = po_observe_precision(request->mesh.tolerance);
  if (isnan(loss->energy)) /* unbounded */
    return NAN;
  return loss->moved * place + OF_INTERPOLATED * loss->doubt.interpolated + loss->doubt.of_points +
         precision * loss->size + (double)loss->jumps * greatest->traced_energy_error;
}

/* The greatest error of the energies of the points of the path beside a state. */
static double energy_error_at(const po_path *path, const po_path_state *state) {
  size_t k = 0;
  if (!isfinite(state->position))
    return 0.0; /* separated */
  while (k + 2 < path->count && path->point[k + 1].position <= state->position)
    ++k;
  return fmax(path->point[k].energy_error, path->point[k + 1].energy_error);
}

/* The work of a closed loop is the energy that its jumps lose, computed by another way. */
void po_estimate_loop(const po_request *request, const po_path *path, const po_estimate *greatest,
                      po_loop *loop) {
  po_loss all = {0};
  double energy = energy_error_at(path, &loop->preload);
  for (size_t k = 0; k < loop->jump_count; ++k) {
    po_jump *jump = &loop->jumps[k];
    const po_loss loss = po_loss_of_jump(loop->control, &jump->before, &jump->after, jump->doubt);
    jump->energy_lost_error = po_estimate_loss_error(request, greatest, loop->control, &loss);
    all = po_loss_sum(all, loss);
    energy = fmax(energy, energy_error_at(path, &jump->before));
    energy = fmax(energy, energy_error_at(path, &jump->after));
  }
  loop->energy_lost_error = po_estimate_loss_error(request, greatest, loop->control, &all);
  loop->work_error = loop->energy_lost_error + fabs(loop->work - loop->energy_lost);
  loop->energy_error = energy + OF_INTERPOLATED * loop->interpolated;
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

/* The error of the contact radius of an extremum of the load by the error of its place on the
 * branch, in which the error of its approach is of the first order. The place of a fold is certain:
 * its approach turns quickly. */
static double edge_error_of_place(const po_branch_point *p) {
  const po_solution *best = p->best;
  const bool of_load = p->kind == PO_POINT_LOAD_MIN || p->kind == PO_POINT_LOAD_MAX;
  const double rate = best->tangent[best->n];
  const size_t edges = best->edges.count;
  return of_load && edges > 0 && rate != 0.0
             ? p->approach_error * fabs(best->edges.rate[edges - 1] / rate)
             : 0.0;
}

/* The change of the energy at given approach from a point to the solution on the finer mesh. */
static double change_of_energy(double approach, double load, double energy,
                               const po_solution *finer) {
  const double moved = po_solution_approach(finer) - approach;
  return fabs(finer->energy - energy - 0.5 * (finer->load + load) * moved);
}

/* Energies and their errors. Given: e with the stated approach and load. The energy is that of the
 * best solution, moved to the stated approach. */
static void estimate_energy(const po_request *request, const po_branch_point *p, po_estimate *e) {
  double from = p->approach, energy = p->energy, change = NAN;
  e->traced_energy_error = NAN;
  if (!p->gap)
    e->traced_energy_error = change = po_energy_error(&request->scene, NAN, NAN, p);
  if (p->finer && p->best) {
    from = po_solution_approach(p->best);
    energy = p->best->energy;
    change = OF_CHANGE * change_of_energy(from, p->best->load, energy, p->finer);
    e->traced_energy_error =
        OF_CHANGE * change_of_energy(p->approach, p->load, p->energy, p->finer);
  }
  e->energy = energy + e->load * (e->approach - from);
  e->energy_error = change + fabs(e->load) * e->approach_error +
                    po_observe_precision(request->mesh.tolerance) * (1.0 + fabs(e->load));
}

po_estimate po_estimate_of(const po_request *request, double domain, const po_branch_point *p) {
  po_estimate e = {.approach = p->approach + p->approach_correction,
                   .load = p->load + p->load_correction,
                   .approach_error = p->approach_error,
                   .load_error = p->load_error,
                   .edge = edge_of(request, domain, p)};
  e.traced_approach_error = e.approach_error + fabs(p->approach_correction);
  e.traced_load_error = e.load_error + fabs(p->load_correction);
  estimate_energy(request, p, &e);
  if (p->best) {
    const po_far_field far = po_far_field_error(&request->scene, domain, p->best);
    e.edge.error = fmax(e.edge.error, edge_error_of_place(p));
    const double far_energy = far.load * (1.0 + fabs(p->approach));
    e.approach_error += far.approach;
    e.load_error += far.load;
    e.far_load_error = far.load;
    e.traced_approach_error += far.approach;
    e.traced_load_error += far.load;
    e.energy_error += far_energy + fabs(e.load) * far.approach;
    e.traced_energy_error += far_energy;
  }
  return e;
}
