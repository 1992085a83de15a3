#include "po_estimate.h"

#include <math.h>

#include "po_contact.h"
#include "po_elementary.h"
#include "po_far_field.h"
#include "po_initial_gap.h"
#include "po_linear.h"
#include "po_quadrature.h"
#include "po_refine.h"
#include "po_solution.h"
#include "po_trace.h"

/* Allowed distance between the branch and the cubics through its points: MISS_OF_TOLERANCE times
 * the tolerance of panels, but at least LEAST_MISS, or LEAST_OF_STAIRCASE if no curve is drawn. The
 * number of points goes as the distance to the power -1/4. Staircases use the cubics only for the
 * energies lost. */
static const double MISS_OF_TOLERANCE = 0.1, LEAST_MISS = 1e-8, LEAST_OF_STAIRCASE = 1e-5;

/* MISS_OF_TOLERANCE for loops, less because the areas between the branch and the cubics add up in
 * the work of a closed loop. */
static const double MISS_OF_LOOPS = 0.06;

double po_estimate_miss(const po_request *request) {
  const bool drawn = request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS);
  const double part = request->want & PO_WANT_HYSTERESIS ? MISS_OF_LOOPS : MISS_OF_TOLERANCE;
  return fmax(drawn ? LEAST_MISS : LEAST_OF_STAIRCASE, part * request->mesh.tolerance);
}

/* Error of the energy of a rigid scene, see po_rigid_energy. */
static const double RIGID = 1e-10;

/* Distance of a kink from the end of a panel, relative to its length, within which it is there. */
static const double AT_END = 1e-9;

/* A panel of a solution: its radii, eps, and the values at its nodes. */
typedef struct {
  double begin, size;
  double deflection[PO_TABLE_ORDER]; /* H - f */
  double traction[PO_TABLE_ORDER];
} panel;

static panel panel_of(const po_scene *scene, const po_solution *p, size_t k) {
  const po_panel place = p->panels->panel[k];
  panel here = {.begin = p->domain * po_panel_begin(place),
                .size = p->domain * po_panel_size(place)};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    here.deflection[j] = p->deflection[k * PO_TABLE_ORDER + j];
    here.traction[j] = po_law_at(&scene->law, p->state[k * PO_TABLE_ORDER + j]).traction;
  }
  return here;
}

/* Integrals over a panel, of r dr. */
typedef struct {
  double energy;  /* of phi(H) */
  double load;    /* of the traction */
  double squares; /* of the square of the traction's difference from its polynomial */
} integrals;

/* The integrals over a panel by Gauss's rule on its parts. */
static integrals by_parts(const po_scene *scene, const panel *p, const po_panel_parts *h) {
  integrals sum = {0};
  for (size_t i = 0; i < 2 * PO_TABLE_ORDER; ++i) {
    const double r = p->begin + p->size * h->node[i], weight = p->size * h->weight[i] * r;
    const double gap =
        po_initial_gap(scene, r) + po_linear_dot(PO_TABLE_ORDER, p->deflection, h->lagrange[i]);
    const double traction = po_law_at(&scene->law, gap).traction;
    const double off = traction - po_linear_dot(PO_TABLE_ORDER, p->traction, h->lagrange[i]);
    sum.energy += weight * po_law_energy(&scene->law, gap);
    sum.load += weight * traction;
    sum.squares += weight * off * off;
  }
  return sum;
}

/* The integrals of phi(H) and of the traction by the nodes of a panel. */
static integrals by_nodes(const po_scene *scene, const panel *p) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  integrals sum = {0};
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    const double r = p->begin + p->size * rule->node[j], weight = p->size * rule->weight[j] * r;
    sum.energy += weight * po_law_energy(&scene->law, po_initial_gap(scene, r) + p->deflection[j]);
    sum.load += weight * p->traction[j];
  }
  return sum;
}

/* The error of Gauss's rule for x^power ln x on (0, 1). */
static double error_of_rule(int power) {
  const po_panel_rule *rule = &po_panel_table_get()->rule;
  double sum = 1.0 / ((power + 1) * (power + 1));
  for (size_t j = 0; j < PO_TABLE_ORDER; ++j) {
    double term = rule->weight[j] * po_log(rule->node[j]);
    for (int k = 0; k < power; ++k)
      term *= rule->node[j];
    sum += term;
  }
  return fabs(sum);
}

/* On a cut surface the traction p ends with a jump. So the deflection has a part -(2/pi) coupling p
 * x ln x at the distance x from the end, and the integrand phi + p u/2 of the energy has -p/2 of
 * it. Given: the last panel. */
static double of_end(const po_scene *scene, const panel *last) {
  const double p = last->traction[PO_TABLE_ORDER - 1], end = last->begin + last->size;
  return po_scene_coupling(scene) / M_PI * p * p * last->size * last->size * end * error_of_rule(1);
}

/* The integrals over a panel by Gauss's rule on its halves, or on both sides of a kink of the
 * profile: half a panel that has the kink inside would have as large an error as the whole, and
 * their difference may vanish by chance. */
static integrals finer_integrals(const po_scene *scene, const panel *p,
                                 const po_panel_parts *halves) {
  const po_profile *profile = &scene->profile;
  if (!po_profile_has_kink_between(profile, p->begin, p->begin + p->size))
    return by_parts(scene, p, halves);
  po_panel_parts sides;
  po_panel_parts_fill(&po_panel_table_get()->rule,
                      (po_profile_shape(profile).kink - p->begin) / p->size, &sides);
  return by_parts(scene, p, &sides);
}

/* Where the slope of the profile jumps, that of the traction jumps by the response dp/dH times as
 * much, s. So the deflection has a part -(1/pi) coupling s x^2 ln |x| at the distance x from a
 * kink, and -(1/2) coupling s r^2 ln r at a tip. The integrand of the energy has p/2 of it. Given:
 * a panel, and whether it has the kink at its beginning or at its end. */
static double of_corner(const po_scene *scene, const panel *p, bool at_end, double jump) {
  const size_t nearest = at_end ? PO_TABLE_ORDER - 1 : 0;
  const double at = at_end ? p->begin + p->size : p->begin;
  const double gap = po_initial_gap(scene, at) + p->deflection[nearest];
  const double s = po_law_at(&scene->law, gap).slope * jump;
  const double part =
      0.5 * fabs(p->traction[nearest] * s) * po_scene_coupling(scene) * p->size * p->size * p->size;
  return at > 0.0 ? part / M_PI * at * error_of_rule(2) : part / 2.0 * p->size * error_of_rule(3);
}

/* That of both ends of a panel. */
static double of_corners(const po_scene *scene, const panel *p) {
  const po_profile *profile = &scene->profile;
  const double kink = po_profile_shape(profile).kink, end = p->begin + p->size;
  double sum = 0.0;
  if (p->begin == 0.0)
    sum += of_corner(scene, p, false, po_initial_gap_slope(scene, 0.0));
  for (int at_end = 0; at_end < 2; ++at_end)
    if (fabs(kink - (at_end ? end : p->begin)) < AT_END * p->size)
      sum += of_corner(scene, p, at_end, po_profile_slope_jump(profile, scene->radius));
  return sum;
}

/* U is stationary for the solution, so that the energy of the interpolated solution, integrated on
 * panels that are halved, differs from the true one in the second order. The energy on the mesh
 * differs from it by the integral of phi, because the traction of the mesh is a polynomial on each
 * panel and is integrated exactly against the deflection; and by the energy of the tractions e that
 * these polynomials lack. They change sign about as often as a panel has nodes n, so that they
 * deflect the surface by about coupling e size / n. The moduli of the panels are added: their
 * errors may cancel by chance. */
static po_point_error of_panels(const po_scene *scene, const po_solution *p) {
  const double coupling = po_scene_coupling(scene);
  double change = 0.0, lacking = 0.0, load = 0.0;
  const po_panel_parts *halves = &po_panel_table_get()->halves;
  for (size_t k = 0; k < p->panels->count; ++k) {
    const panel here = panel_of(scene, p, k);
    const integrals finer = finer_integrals(scene, &here, halves);
    const integrals nodes = by_nodes(scene, &here);
    change += fabs(finer.energy - nodes.energy);
    load += fabs(finer.load - nodes.load);
    lacking += coupling * here.size / PO_TABLE_ORDER * finer.squares;
    lacking += of_corners(scene, &here);
    if (k + 1 == p->panels->count && isfinite(scene->outer_radius))
      lacking += of_end(scene, &here);
  }
  const double factor = PO_SAFETY * 2.0 / scene->radius;
  return (po_point_error){factor * (change + lacking), factor * load};
}

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
  const po_point_error panels = of_panels(scene, s);
  return (po_point_error){panels.energy + precision * (1.0 + fabs(p->load)) + far.energy +
                              0.5 * far.load * fabs(deflection),
                          panels.load + far.load};
}

double po_energy_error(const po_request *request, const po_branch_point *point) {
  return po_point_error_of(request, point).energy;
}

static po_contact_edge edge_on_panels(const po_request *request, const po_branch_point *p) {
  const po_contact_gap best = po_contact_gap_on_panels(&request->scene, p->best);
  const po_contact_gap finer = po_contact_gap_on_panels(&request->scene, p->finer);
  /* an error of the approach is an error of the gap */
  const po_contact_doubt doubt = {&finer, po_trace_precision(request->mesh.tolerance),
                                  po_far_field_of(&request->scene, p->best).approach};
  return po_contact_estimate(&best, &doubt);
}

static po_contact_edge edge_of(const po_request *request, const po_branch_point *p) {
  if (p->finer)
    return edge_on_panels(request, p);
  const po_contact_gap gap = po_contact_gap_of(&request->scene, p);
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
  e->point.contact_radius_error = fmax(e->point.contact_radius_error, edge_error_of_place(p));
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
  const po_contact_edge edge = edge_of(request, p);
  po_estimate e = {.point = {.kind = KINDS[p->kind],
                             .approach = p->approach + p->approach_correction,
                             .load = p->load + p->load_correction,
                             .approach_error = p->approach_error,
                             .load_error = p->load_error,
                             .contact_radius = edge.radius,
                             .contact_radius_error = edge.error,
                             .contact_radius_other = edge.other,
                             .position = p->position,
                             .unstable_modes = p->unstable_modes},
                   .traced_approach_error = p->approach_error + fabs(p->approach_correction),
                   .traced_load_error = p->load_error + fabs(p->load_correction)};
  estimate_energy(request, p, &e);
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
