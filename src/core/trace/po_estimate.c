#include "po_estimate.h"

#include <math.h>

#include "po_contact.h"
#include "po_far_field.h"
#include "po_margins.h"
#include "po_panel_errors.h"
#include "po_refine.h"
#include "po_solution.h"
#include "po_trace.h"

/* Allowed distance between the branch and the cubics through its points: PO_PART_OF_TOLERANCE times
 * the tolerance of panels, but at least LEAST_MISS, or LEAST_OF_STAIRCASE if no curve is drawn. The
 * number of points goes as the distance to the power -1/4. Staircases use the cubics only for the
 * energies lost. */
static const double LEAST_MISS = 1e-8, LEAST_OF_STAIRCASE = 1e-5;

/* The part for loops, less because the areas between the branch and the cubics add up in the work
 * of a closed loop. */
static const double PART_OF_LOOPS = 0.06;

double po_estimate_miss(const po_request *request) {
  const bool drawn = request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS);
  const double part = request->want & PO_WANT_HYSTERESIS ? PART_OF_LOOPS : PO_PART_OF_TOLERANCE;
  return fmax(drawn ? LEAST_MISS : LEAST_OF_STAIRCASE, part * request->mesh.tolerance);
}

/* Error of the energy of a rigid scene, see po_rigid_energy. */
static const double RIGID = 1e-10;

po_point_error po_point_error_of(const po_request *request, const po_branch_point *p) {
  const po_scene *scene = &request->scene;
  const double precision = po_trace_precision(request->mesh.tolerance);
  if (!p->gap)
    return (po_point_error){
        RIGID * fmax(1.0, fabs(p->energy)) + po_far_field_rigid_energy(scene, p->approach), 0.0};
  if (!p->solution)
    return (po_point_error){NAN, NAN};
  const po_solution *s = p->solution;
  const po_far_field far = po_far_field_of(scene, s);
  const double deflection =
      isinf(scene->outer_radius) ? s->deflection[s->n - 1] + p->approach : 0.0;
  const po_point_error panels = po_panel_errors(scene, s);
  return (po_point_error){panels.energy + precision * (1.0 + fabs(p->load)) + far.energy +
                              0.5 * far.load * fabs(deflection),
                          panels.load + far.load};
}

double po_energy_error(const po_request *request, const po_branch_point *point) {
  return po_point_error_of(request, point).energy;
}

/* The larger of two errors; NAN if the first is not known. */
static double larger(double error, double other) {
  return error < other ? other : error;
}

static po_contact_edge edge_on_panels(const po_request *request, const po_branch_point *p,
                                      double joints) {
  const po_contact_gap best = po_contact_gap_on_panels(&request->scene, p->best);
  const po_contact_gap finer = po_contact_gap_on_panels(&request->scene, p->finer);
  /* an error of the approach is an error of the gap */
  const po_contact_doubt doubt = {&finer, po_trace_precision(request->mesh.tolerance),
                                  po_far_field_of(&request->scene, p->best).approach + joints};
  return po_contact_estimate(&best, &doubt);
}

static po_contact_edge edge_of(const po_request *request, const po_branch_point *p, double joints) {
  if (p->finer)
    return edge_on_panels(request, p, joints);
  const po_contact_gap gap = po_contact_gap_of(&request->scene, p);
  if (!p->gap &&
      isfinite(p->approach_error)) /* rigid: the error of the gap is that of the approach */
    return po_contact_estimate(&gap, &(po_contact_doubt){.constant = p->approach_error});
  return (po_contact_edge){po_contact_radius(&gap), NAN, NAN};
}

/* The error of the contact radius by the error of the place on the branch, in which that of the
 * approach of an extremum of the load, and of the load of a fold, is of the first order. */
static double edge_error_of_place(const po_branch_point *p, const po_special_point *of) {
  const po_solution *best = p->best;
  const bool of_load = p->kind == PO_POINT_LOAD_MIN || p->kind == PO_POINT_LOAD_MAX;
  const double rate = of_load ? best->tangent[best->n] : best->load_rate;
  const double error = of_load ? of->approach_error : of->load_error;
  const size_t edges = best->edges.count;
  return edges > 0 && rate != 0.0 ? error * fabs(best->edges.rate[edges - 1] / rate) : 0.0;
}

/* The change of the energy at given approach from a point to the solution on the finer mesh. */
static double change_of_energy(double approach, double load, double energy,
                               const po_solution *finer) {
  const double moved = po_solution_approach(finer) - approach;
  return fabs(finer->energy - energy - 0.5 * (finer->load + load) * moved);
}

/* Energies and their errors. Given: e with the stated approach and load; the least error of the
 * energy. The energy is that of the best solution, moved to the stated approach. */
static void estimate_energy(const po_request *request, const po_branch_point *p, double least,
                            po_estimate *e) {
  po_special_point *point = &e->point;
  double from = p->approach, energy = p->energy, change = NAN;
  e->traced_energy_error = NAN;
  if (!p->gap)
    e->traced_energy_error = change = po_energy_error(request, p);
  if (p->finer && p->best) {
    from = po_solution_approach(p->best);
    energy = p->best->energy;
    change = PO_SAFETY * change_of_energy(from, p->best->load, energy, p->finer);
    e->traced_energy_error =
        PO_SAFETY * change_of_energy(p->approach, p->load, p->energy, p->finer);
    change = larger(change, least);
    e->traced_energy_error = larger(e->traced_energy_error, least);
  }
  point->energy = energy + point->load * (point->approach - from);
  point->energy_error = change + fabs(point->load) * point->approach_error +
                        po_trace_precision(request->mesh.tolerance) * (1.0 + fabs(point->load));
}

/* Adds the errors that the solution on the finer mesh does not show. */
static void add_far_field(const po_request *request, const po_branch_point *p, po_estimate *e) {
  const po_far_field far = po_far_field_of(&request->scene, p->best);
  /* the second is that of the energy of the deflection, too */
  const double far_energy = fmax(far.energy, far.load * (1.0 + fabs(p->approach)));
  e->point.contact_radius_error =
      fmax(e->point.contact_radius_error, edge_error_of_place(p, &e->point));
  e->point.approach_error += far.approach;
  e->point.load_error += far.load;
  e->far_load_error = far.load;
  e->traced_approach_error += far.approach;
  e->traced_load_error += far.load;
  e->point.energy_error += far_energy + fabs(e->point.load) * far.approach;
  e->traced_energy_error += far_energy;
}

static const po_special_kind KINDS[] = {[PO_POINT_APPROACH_MAX] = PO_JUMP_IN,
                                        [PO_POINT_APPROACH_MIN] = PO_JUMP_OUT,
                                        [PO_POINT_LOAD_MAX] = PO_MAXIMUM,
                                        [PO_POINT_LOAD_MIN] = PO_MINIMUM};

po_estimate po_estimate_of(const po_request *request, const po_branch_point *p) {
  const po_joint_errors joints = po_joint_errors_of(&request->scene, p);
  const po_contact_edge edge = edge_of(request, p, joints.gap);
  const double approach_error = larger(p->approach_error, joints.approach);
  const double load_error = larger(p->load_error, joints.load);
  po_estimate e = {.point = {.kind = KINDS[p->kind],
                             .approach = p->approach + p->approach_correction,
                             .load = p->load + p->load_correction,
                             .approach_error = approach_error,
                             .load_error = load_error,
                             .contact_radius = edge.radius,
                             .contact_radius_error = edge.error,
                             .contact_radius_other = edge.other,
                             .position = p->position,
                             .unstable_modes = p->unstable_modes},
                   .traced_approach_error = approach_error + fabs(p->approach_correction),
                   .traced_load_error = load_error + fabs(p->load_correction)};
  estimate_energy(request, p, joints.energy, &e);
  if (p->best)
    add_far_field(request, p, &e);
  return e;
}

void po_estimate_pull_off(const po_estimate *minimum, po_result *o) {
  const po_special_point *point = &minimum->point;
  o->has_pull_off = true;
  o->pull_off.force = fabs(point->load);
  o->pull_off.approach = point->approach;
  o->pull_off.contact_radius = point->contact_radius;
  o->pull_off.force_error = point->load_error;
  o->pull_off.far_force_error = minimum->far_load_error;
  o->pull_off.approach_error = point->approach_error;
  o->pull_off.contact_radius_error = point->contact_radius_error;
  o->pull_off.contact_radius_other = point->contact_radius_other;
}
