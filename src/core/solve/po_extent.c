/* The end of a rigid trace, the part of the surface that may come into contact (the core), and the
 * size of the domain of the panels; the accuracy of the solve; and the nodes and the memory that it
 * needs. */
#include <math.h>

#include "po_elementary.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_panel_table.h"
#include "po_panels.h"
#include "po_reduced.h"
#include "po_rigid.h"
#include "po_scales.h"
#include "po_solve.h"
#include "po_solve_internal.h"
#include "po_special_point.h"

/* If the repulsion of the central crest is PUSH_PER_LOAD times the load plus PUSH_BEYOND_LOAD, it
 * exceeds the load and all attraction. For Lennard-Jones the attraction is at most the term
 * 8/(3 x^2) of Eq 23, at the x at which the repulsive term 2/(3 x^8) has that value; of another law
 * its own attraction is taken off (po_law_approach_of_push). */
static const double PUSH_PER_LOAD = 1.1, PUSH_BEYOND_LOAD = 8.0;

/* Bisections of the approach at which the load of rigid bodies has a value. */
enum { BISECTIONS = 30 };

/* The same for any profile: the approach at which the load itself has that value. */
static double end_of_load(const po_scene *scene, double push) {
  double low = 0.0, high = -po_law_numbers_of(&scene->law)->closest;
  for (int k = 0; k < BISECTIONS; ++k) {
    const double middle = 0.5 * (low + high);
    double load, rate;
    if (po_rigid_load(scene, middle, &load, &rate) || load > push)
      high = middle;
    else
      low = middle;
  }
  return low;
}

double po_solve_rigid_end(const po_scene *scene, double load) {
  const double push = PUSH_PER_LOAD * load + PUSH_BEYOND_LOAD;
  return po_profile_is_sphere(&scene->profile) ? po_rigid_approach_of_crest(scene, push)
                                               : end_of_load(scene, push);
}

/* A panel ends at the kink of a profile if the kink is at k/2^l of the domain: panels are made by
 * halving it. Up to this denominator such a domain is looked for. */
enum { KINK_PARTS = 64 };

/* The smallest domain of at least `least` in which the kink is at the end of a panel. */
static double with_kink(double kink, double least) {
  const double part = fmin(kink / least, 1.0);
  for (double parts = 1.0; parts <= KINK_PARTS; parts *= 2.0)
    if (part * parts >= KINK_PARTS / 4)
      return kink * parts / floor(part * parts);
  return part * KINK_PARTS >= 1.0 ? kink * KINK_PARTS / floor(part * KINK_PARTS) : least;
}

double po_solve_domain(const po_scene *scene, double core) {
  if (isfinite(scene->outer_radius))
    return core;
  const double kink = po_profile_shape(&scene->profile).kink;
  const double averaging = po_averaging_radius(scene, po_averaging_phase(scene, core));
  /* the phase of the waves at the end of the domain matters unless nothing acts beyond */
  const bool free = !po_scene_is_wavy(scene) || isinf(po_law_numbers_of(&scene->law)->exponent);
  return !isnan(kink) && free ? with_kink(kink, averaging) : averaging;
}

/* Greatest contact radius on an unbounded surface, relative to the radius of the domain: beyond,
 * the panel to infinity does not represent the far field. */
static const double GREATEST_CONTACT = 0.9, LARGER_THAN_CONTACT = 1.15;

bool po_solve_is_cut_off(const po_scene *scene, double contact_radius, double core) {
  return isinf(scene->outer_radius) && contact_radius > GREATEST_CONTACT * core;
}

static double finite_or_none(double value) {
  return isfinite(value) ? value : (double)NAN;
}

/* The core for a search reaches to the contact at which the search is complete for a pull-off force
 * of SEARCHED_FORCE, pi w R, if that is at most LARGEST_CORE times the core without a search. */
static const double SEARCHED_FORCE = 1.0, LARGEST_CORE = 1.6;

double po_solve_core(const po_request *request) {
  const po_scene *scene = &request->scene;
  const double deepest = fmax(fmax(request->approach_end, request->profile_approach),
                              finite_or_none(request->preload.approach));
  const double core = po_surface_core(scene, deepest);
  if (po_request_search(request) == PO_SEARCH_NONE || !request->theories ||
      po_scene_is_simple(scene) || isfinite(scene->outer_radius))
    return core;
  const double enough = LARGER_THAN_CONTACT * po_request_bound(request, -SEARCHED_FORCE);
  return enough < LARGEST_CORE * core ? fmax(core, enough) : core;
}

/* Allowed error of the gap, eps, divided by the square root of the relative tolerance of the
 * pull-off force, and its greatest value at any tolerance. The square root, because the error of
 * the load goes as the square of the last Legendre coefficients. Where the curve is steeper or the
 * contact edge sharper, the panel itself asks for less (RIPPLE in po_resolution.c). */
static const double ERROR_OF_TOLERANCE = 0.3, COARSEST_ERROR = 3e-4;

/* Allowed error of the load of a panel, divided by the tolerance. The estimate of this error is
 * usually too large. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* Precision of Newton's method, relative to 1 + H, divided by the tolerance. */
static const double PRECISION_OF_TOLERANCE = 1e-4;

po_allowance po_solve_allowance(double tolerance) {
  return (po_allowance){fmin(COARSEST_ERROR, ERROR_OF_TOLERANCE * sqrt(tolerance)),
                        fmin(COARSEST_ERROR, LOAD_OF_TOLERANCE * tolerance)};
}

/* Never coarser than special points are located. */
double po_solve_precision(double tolerance) {
  return fmax(PO_FINEST_PRECISION, fmin(PO_LOCATED, PRECISION_OF_TOLERANCE * tolerance));
}

/* -- Nodes and memory -- */

/* Panels of the finest mesh, fitted to random scenes, whose meshes had between 0.5 and 2.2 times as
 * many. A contact edge is 1/coupling wide; the mesh is halved towards the edges, and within each
 * wave as far as the amplitude asks for it. */
static const double PANELS = 4.5, PANELS_A_HALVING = 2.9, PANELS_A_WAVE = 1.0,
                    PANELS_A_HALVING_OF_WAVE = 1.9;

/* The error of a panel of 12 nodes goes as its length to the power 24 (the load). */
static const double TOLERANCE_POWER = 1.0 / 24.0, USUAL_TOLERANCE = 1e-6;
static const double PANELS_MARGIN = 2.5;

/* Memory: of the program and its libraries; for a node, factors, lists and states; and blocks of
 * influence coefficients of former meshes, which are kept as far as MOST_BLOCKS of po_hierarchy.c.
 */
static const double PROGRAM_BYTES = 12e6, NODE_BYTES = 8e3, BLOCK_BYTES = 80e6,
                    BLOCK_BYTES_A_NODE = 32e3;

const size_t PO_MOST_NODES_OF_MESH = (size_t)PO_MOST_PANELS * PO_TABLE_ORDER;

/* Nodes of rings and triangles: of a wave beyond the core, and of the panel to infinity. */
enum { WAVE_NODES = 12, TAIL_NODES = 16 };

/* The radius of the part of the surface that may come into contact. */
static double contact_part(const po_request *request) {
  po_request unbounded = *request;
  unbounded.scene.outer_radius = INFINITY;
  return fmin(po_solve_core(&unbounded), request->scene.outer_radius);
}

static double panels_of(const po_request *request) {
  const po_scene *scene = &request->scene;
  const double core = contact_part(request);
  double panels = PANELS + PANELS_A_HALVING * po_log1p(core * po_scene_coupling(scene)) / M_LN2;
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    panels += core / wave.length *
              (PANELS_A_WAVE + PANELS_A_HALVING_OF_WAVE * po_log1p(wave.amplitude) / M_LN2);
  }
  return PANELS_MARGIN * panels *
         po_pow(USUAL_TOLERANCE / request->mesh.tolerance, TOLERANCE_POWER);
}

/* Rings and triangles, whose matrices are dense. */
static po_size size_of_fixed(const po_request *request) {
  const po_scene *scene = &request->scene;
  double nodes = (double)request->mesh.nodes;
  if (isinf(scene->outer_radius)) {
    const double core = po_solve_core(request);
    const double beyond = po_averaging_radius(scene, po_averaging_phase(scene, core)) - core;
    nodes += TAIL_NODES;
    if (po_scene_is_wavy(scene))
      nodes += WAVE_NODES * ceil(beyond / po_initial_gap_detail(scene));
  }
  return (po_size){(size_t)nodes, PROGRAM_BYTES + 2.0 * sizeof(double) * nodes * nodes};
}

po_size po_request_size(const po_request *asked) {
  const po_request narrowest = po_reduced_narrowest(asked);
  const po_request *request = po_reduced_is_chosen(asked) ? &narrowest : asked;
  if (po_rigid_suffices(&request->scene))
    return (po_size){0, PROGRAM_BYTES};
  if (request->mesh.scheme != PO_PANEL)
    return size_of_fixed(request);
  const double nodes = PO_TABLE_ORDER * ceil(panels_of(request));
  double bytes = PROGRAM_BYTES + NODE_BYTES * nodes + fmin(BLOCK_BYTES, BLOCK_BYTES_A_NODE * nodes);
  if (request->want & PO_WANT_DIAGNOSTICS) /* a dense matrix and its factors */
    bytes += 2.0 * sizeof(double) * nodes * nodes;
  return (po_size){(size_t)nodes, bytes};
}
