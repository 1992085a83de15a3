#include "po_corrector.h"

#include <math.h>
#include <string.h>

#include "po_linear.h"
#include "po_prediction.h"
#include "po_scaled_tangent.h"

enum { MOST_FACTORS = 2 };

const double PO_NEAR_SOLUTION = 0.1;

po_status po_corrector_allocate(po_corrector *c, po_equilibrium *e, po_allowance allowed) {
  const size_t size = e->surface->capacity + 1;
  *c = (po_corrector){
      .e = e, .resolution = po_resolution_of(e, allowed), .direction = 1, .farthest = INFINITY};
  c->border = po_arena_reserve(&c->arrays, size, sizeof *c->border);
  c->guess = po_arena_reserve(&c->arrays, size, sizeof *c->guess);
  c->coordinate = po_arena_reserve(&c->arrays, size, sizeof *c->coordinate);
  return c->arrays.ran_out ? PO_NO_MEMORY : PO_OK;
}

po_status po_corrector_mesh(po_corrector *c, const po_panels *panels) {
  if (po_panels_equal(panels, po_surface_panels(c->e->surface)))
    return PO_OK;
  c->trouble = po_surface_mesh(c->e->surface, panels);
  if (c->trouble)
    return c->trouble;
  po_equilibrium_remesh(c->e);
  ++c->e->work.meshes;
  return PO_OK;
}

const double PO_MESH_MARGIN = 0.2;

po_status po_corrector_adapt(po_corrector *c, const po_gap_field *field, po_panels *panels) {
  po_resolution margin = c->resolution;
  margin.allowed.gap *= PO_MESH_MARGIN;
  margin.allowed.load *= PO_MESH_MARGIN;
  return c->trouble = po_resolution_panels(&margin, field, panels);
}

po_status po_corrector_want_mesh(po_corrector *c, po_solution *p) {
  if (!po_surface_panels(c->e->surface))
    return PO_OK;
  po_solution_field solved = {p, c->e->scene, 0};
  po_panels_copy(p->panels, p->wanted);
  return po_corrector_adapt(c, &(po_gap_field){po_solution_gap, &solved}, p->wanted);
}

bool po_corrector_is_resolved(const po_corrector *c, const po_solution *p) {
  return !po_surface_panels(c->e->surface) ||
         po_resolution_excess(&c->resolution, p->panels, p->state) <= 1.0;
}

po_status po_corrector_follow_solved(po_corrector *c, po_solution *p, po_solution *spare) {
  po_status status = po_corrector_want_mesh(c, p);
  if (status)
    return status;
  po_solution_copy(p, spare);
  status = po_corrector_mesh(c, spare->wanted);
  if (!status)
    po_corrector_guess(c, spare);
  return status;
}

size_t po_corrector_moving_nodes(const po_corrector *c) {
  const po_panels *panels = po_surface_panels(c->e->surface);
  return panels ? panels->count * PO_TABLE_ORDER : 0;
}

void po_corrector_guess(po_corrector *c, const po_solution *p) {
  po_solution_field field = {p, c->e->scene, 0};
  const size_t core = po_corrector_moving_nodes(c), n = c->e->n;
  for (size_t j = 0; j < core; ++j)
    c->guess[j] = po_solution_gap(&field, c->e->surface->node[j]);
  for (size_t back = 0; back <= n - core;
       ++back) /* nodes of the panel to infinity, and the approach, are copied */
    c->guess[n - back] = p->state[p->n - back];
}

void po_corrector_guess_near(po_corrector *c, const po_solution *p, double distance) {
  po_prediction prediction;
  if (p->edges.count > 0 && po_prediction_make(c->e, p, NULL, distance, &prediction)) {
    po_prediction_state(&prediction, c->e->surface, po_corrector_moving_nodes(c), c->guess);
    return;
  }
  for (size_t j = 0; j <= p->n; ++j)
    c->guess[j] = p->state[j] + distance * p->tangent[j];
}

typedef struct {
  const po_solution *from;
  double *coordinate; /* work */
} place;

/* The arclength functional of a point, evaluated at a state. */
static double functional_progress(const po_equilibrium *e, const double *state, const void *data) {
  const place *p = data;
  const po_solution *from = p->from;
  po_arclength_coordinates(from->arclength, e, state, p->coordinate);
  for (size_t i = 0; i < from->coordinates; ++i)
    p->coordinate[i] -= from->coordinate[i];
  return po_arclength_along(from->coordinates, from->rate, p->coordinate);
}

double po_corrector_place_of_guess(po_corrector *c, const po_solution *from) {
  po_equilibrium_evaluate(c->e, c->guess);
  return functional_progress(c->e, c->guess, &(place){from, c->coordinate});
}

/* The factors of panels in the direction in which they err most. The error of the compressed
 * interactions is some 1e-5 of the interactions. Where the Jacobian has a singular value as small
 * as that, it may be negative in the factors, or so small that no iteration converges: under
 * coupling * p' * (contact radius) = 10^4, or where a ring of tension moves freely. */

/* Gain above which the direction is examined, and the part by which the factors must miss the
 * Jacobian there to be corrected. */
static const double GAIN_OF_EXAMINATION = 3.0, LEAST_MISS = 0.3;

/* Corrects the factors of panels in the direction in which they respond most, by the product of the
 * Jacobian with it, if they are wrong there. Called after po_equilibrium_measure_noise, which finds
 * the direction. Returned: whether they were corrected; noise and gain must then be measured
 * again.
 * With M the factors, J the Jacobian and s the direction, M^-1 is corrected to (1 + u v') M^-1 so
 * that it takes J s to s, as in Broyden's method: v = s / (s . z), u = s - z, z = M^-1 J s. The
 * determinant of the factors is multiplied by (s . z) / (s . s). The scalar product is that of
 * changes relative to 1 + H. */
static bool correct_weak(po_equilibrium *e) {
  const size_t n = e->n;
  if (!e->elimination || e->weak_count == PO_MOST_WEAK || !(e->gain > GAIN_OF_EXAMINATION))
    return false;
  const size_t at = e->weak_count * (n + 1);
  double *s = e->weak_functional + at, *z = e->weak + at, *product = e->deflection;
  const double length = sqrt(po_linear_dot(n + 1, e->scratch, e->scratch));
  for (size_t j = 0; j <= n; ++j)
    s[j] = e->scratch[j] / length;
  po_equilibrium_multiply(e, s, product);
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

po_status po_corrector_factorize(po_equilibrium *e, const double *state, const double *border) {
  po_status status = po_equilibrium_factorize(e, state, border);
  for (int k = 0; k < MOST_FACTORS && !status; ++k) {
    po_equilibrium_measure_noise(e, state);
    while (correct_weak(e))
      po_equilibrium_measure_noise(e, state);
    if (!po_equilibrium_is_coarse(e))
      break;
    status = po_equilibrium_factorize(e, state, border);
  }
  return status;
}

static po_status factorize_at(po_corrector *c, const po_solution *from, const double *state) {
  po_equilibrium_evaluate(c->e, state);
  po_arclength_border(from->arclength, c->e, state, from->rate, c->border);
  const po_status status = po_corrector_factorize(c->e, state, c->border);
  if (status && status != PO_SINGULAR)
    c->trouble = status;
  return status;
}

/* Lets linear systems be solved by GMRES from now on, if that may help: on panels of a wavy scene,
 * where an annulus may form, with narrow contact edges or after the step has become short. Given:
 * the length of the step. Returned: whether they were not before. */
static bool turn_to_krylov(po_equilibrium *e, double step) {
  if (!e->elimination || e->by_krylov || po_scene_is_simple(e->scene) ||
      !(e->narrow || fabs(step) < PO_SHORT_STEP))
    return false;
  e->by_krylov = true;
  return true;
}

/* Newton's method from the state in `out`. If it contracts too slowly near a solution, the Jacobian
 * is factorised there, which costs less than a shorter step. If it then still does, the factors are
 * too inaccurate. */
static po_status correct(po_corrector *c, const po_solution *from, double distance,
                         po_solution *out) {
  const place along = {from, c->coordinate};
  const po_constraint constraint = {functional_progress, &along, distance, c->farthest};
  const double greatest = fmin(PO_NEAR_SOLUTION, c->farthest);
  po_status status = po_equilibrium_correct_to(c->e, out->state, &constraint);
  for (int k = 0;
       status && c->e->last_change < greatest &&
       (k < PO_MOST_RENEWALS || (status == PO_NOT_CONVERGED && turn_to_krylov(c->e, distance)));
       ++k) {
    if (factorize_at(c, from, out->state))
      return PO_NOT_CONVERGED;
    status = po_equilibrium_correct_to(c->e, out->state, &constraint);
  }
  return status;
}

/* Fills the solution from its state. */
static po_status find_tangent(po_corrector *c, const po_solution *from, double precision,
                              po_solution *out) {
  po_equilibrium *e = c->e;
  po_solution_take_state(out, e);
  if (po_surface_panels(e->surface) && e->narrow && out->edges.count > 0)
    return po_scaled_tangent(e, from->rate, precision, out);
  const po_status status = po_equilibrium_tangent(e, precision, out->tangent);
  if (!status)
    po_solution_take_tangent(out, e);
  return status;
}

po_status po_corrector_solve(po_corrector *c, const po_solution *from, double distance,
                             bool keep_factors, double precision, po_solution *out) {
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = keep_factors && c->e->factorized ? 0 : 1; status && fresh < 2; ++fresh) {
    memcpy(out->state, c->guess, (c->e->n + 1) * sizeof *out->state);
    if (fresh && factorize_at(c, from, c->guess))
      return PO_NOT_CONVERGED;
    status = correct(c, from, distance, out);
    if (!status) {
      status = find_tangent(c, from, precision, out);
      if (status == PO_NOT_CONVERGED && turn_to_krylov(c->e, distance))
        status = find_tangent(c, from, precision, out);
    }
  }
  if (status)
    return status;
  /* the sign of the determinant, by the factors and the updates since */
  const int orientation = c->e->orientation * c->e->secant.sign;
  return c->direction == 0 || orientation * c->direction > 0 ? PO_OK : PO_NOT_CONVERGED;
}

po_sample po_corrector_sample(const po_solution *from, const po_solution *p) {
  const double per_distance = 1.0 / po_solution_cosine(from, p);
  return (po_sample){.at = po_solution_progress(from, p),
                     .edges = p->edges.all,
                     .value = {p->state[p->n], p->load},
                     .rate = {p->tangent[p->n] * per_distance, p->load_rate * per_distance}};
}
