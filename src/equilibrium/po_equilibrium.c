#include "po_equilibrium.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_initial_gap.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_scales.h"
#include "po_watch.h"

/* The rounding error of the sums over the influence matrix is 1e-14; this is a margin of 20. */
const double PO_FINEST_PRECISION = 2e-13;

/* Sum of the measures of the nodes that are not factorised. It costs about one iteration and saves
 * most of the matrix. */
static const double NEGLECT = 5e-3;

/* Gain of rounding above which less is neglected, in inverse proportion, and above which the
 * factors of rings and triangles are in double precision. */
static const double GAIN_OF_NEGLECT = 10.0, GAIN_OF_DOUBLE = 30.0;

/* Factors are coarse if more was neglected than this multiple of what their gain allows. */
static const double COARSE = 3.0;

/* Pivot of a changed border below which the factors are discarded. The pivot is about the cosine
 * between the tangent at the factorisation and the present one. */
static const double LEAST_PIVOT = 0.5;

void po_equilibrium_rescale(po_equilibrium *e) {
  const po_scales scales = po_scene_scales(e->scene);
  e->load_weight = 1.0 / scales.load_factor;
  e->approach_scale = 2.0 + 2.0 * scales.stretch;
}

void po_equilibrium_remesh(po_equilibrium *e) {
  const po_surface *s = e->surface;
  e->radius = e->scene->radius;
  e->amplitude = po_initial_gap_amplitude(e->scene);
  e->coupling = po_scene_coupling(e->scene);
  e->energy_at_zero = po_scene_has_infinite_energy(e->scene);
  e->n = s->n;
  e->factorized = false;
  for (size_t j = 0; j < e->n; ++j) {
    const double r = s->node[j];
    e->initial_gap[j] =
        j < s->resolved ? po_initial_gap(e->scene, r) : po_initial_gap_mean(e->scene, r);
  }
}

po_status po_equilibrium_create(const po_scene *scene, const po_surface *surface, size_t capacity,
                                po_equilibrium **equilibrium) {
  po_equilibrium *e = po_allocate(1, sizeof *e);
  *equilibrium = e;
  if (!e)
    return PO_NO_MEMORY;
  e->scene = scene;
  e->surface = surface;
  e->neglect = NEGLECT;
  e->gain = e->share = 1.0;
  po_equilibrium_rescale(e);
  e->precision = PO_FINEST_PRECISION;
  e->together = surface->hierarchy ? PO_TABLE_ORDER : 1;
  double **const vectors[] = {&e->initial_gap, &e->traction, &e->slope,   &e->deflection,
                              &e->border,      &e->right,    &e->scratch, &e->measure,
                              &e->column,      &e->row,      &e->change,  &e->response,
                              &e->source};
  bool had = true;
  for (size_t k = 0; k < sizeof vectors / sizeof *vectors; ++k)
    had = (*vectors[k] = po_reserve(capacity + 1, sizeof(double))) && had;
  e->weak = po_reserve(PO_MOST_WEAK * (capacity + 1), sizeof *e->weak);
  e->weak_functional = po_reserve(PO_MOST_WEAK * (capacity + 1), sizeof *e->weak_functional);
  had = e->weak && e->weak_functional && had;
  e->index = po_reserve(capacity, sizeof *e->index);
  if (surface->hierarchy)
    had = !po_elimination_create(surface->hierarchy, &e->elimination) && had;
  else
    had = po_factors_allocate(&e->factors, capacity + 1) && had;
  had = po_secant_allocate(&e->secant, capacity + 1) && had;
  if (!had || !e->index) {
    po_equilibrium_destroy(e);
    *equilibrium = NULL;
    return PO_NO_MEMORY;
  }
  po_equilibrium_remesh(e);
  return PO_OK;
}

void po_equilibrium_destroy(po_equilibrium *e) {
  if (!e)
    return;
  double *const vectors[] = {e->initial_gap, e->traction, e->slope,          e->deflection,
                             e->border,      e->right,    e->scratch,        e->measure,
                             e->column,      e->row,      e->change,         e->response,
                             e->source,      e->weak,     e->weak_functional};
  for (size_t k = 0; k < sizeof vectors / sizeof *vectors; ++k)
    free(vectors[k]);
  po_secant_free(&e->secant);
  po_factors_free(&e->factors);
  po_elimination_destroy(e->elimination);
  free(e->index);
  free(e);
}

size_t po_equilibrium_core(const po_equilibrium *e) {
  size_t n = e->n;
  while (n > 0 && e->surface->node[n - 1] > e->surface->core_radius)
    --n;
  return n;
}

void po_equilibrium_evaluate(po_equilibrium *e, const double *state) {
  const po_law *law = &e->scene->law;
  const size_t resolved = e->surface->resolved;
  for (size_t j = 0; j < e->n; ++j) {
    const po_law_value p =
        j < resolved ? po_law_at(law, state[j]) : po_law_averaged(law, state[j], e->amplitude);
    e->traction[j] = p.traction;
    e->slope[j] = p.slope;
  }
}

void po_equilibrium_deflect(const po_equilibrium *e, const double *traction, double *deflection) {
  po_surface_apply(e->surface, traction, deflection);
  for (size_t i = 0; i < e->n; ++i)
    deflection[i] *= e->coupling;
}

/* Eq 15: the residual at each node. */
void po_equilibrium_residual(po_equilibrium *e, const double *state, double *residual) {
  po_equilibrium_evaluate(e, state);
  po_equilibrium_deflect(e, e->traction, residual);
  for (size_t i = 0; i < e->n; ++i)
    residual[i] += e->initial_gap[i] - state[e->n] - state[i];
}

double po_equilibrium_load(const po_equilibrium *e) {
  return 2.0 / e->radius * po_linear_dot(e->n, e->surface->weight, e->traction);
}

/* The energy of the interaction at a node beyond the core for the initial gap at approach 0. */
static double energy_at_zero(const po_equilibrium *e, size_t j) {
  if (e->surface->node[j] <= e->surface->core_radius)
    return 0.0;
  return j < e->surface->resolved
             ? po_law_energy(&e->scene->law, e->initial_gap[j])
             : po_law_energy_averaged(&e->scene->law, e->initial_gap[j], e->amplitude);
}

double po_equilibrium_energy(const po_equilibrium *e, const double *state) {
  const po_law *law = &e->scene->law;
  const size_t resolved = e->surface->resolved;
  const double approach = state[e->n];
  double sum = 0.0;
  for (size_t j = 0; j < e->n; ++j) {
    const double interaction = j < resolved ? po_law_energy(law, state[j])
                                            : po_law_energy_averaged(law, state[j], e->amplitude);
    const double deflection = state[j] + approach - e->initial_gap[j];
    const double zero = e->energy_at_zero ? energy_at_zero(e, j) : 0.0;
    sum += e->surface->weight[j] * (interaction - zero + 0.5 * e->traction[j] * deflection);
  }
  return 2.0 / e->radius * sum;
}

double po_equilibrium_load_rate(const po_equilibrium *e, const double *change) {
  double sum = 0.0;
  for (size_t j = 0; j < e->n; ++j)
    sum += e->surface->weight[j] * e->slope[j] * change[j];
  return 2.0 / e->radius * sum;
}

static int by_measure(const void *left, const void *right, void *data) {
  const double *measure = data;
  const double a = measure[*(const size_t *)left], b = measure[*(const size_t *)right];
  const size_t i = *(const size_t *)left, j = *(const size_t *)right;
  return a != b ? (a < b ? 1 : -1) : (i < j ? -1 : i > j); /* descending; equal measures by index */
}

/* Sorts the first `count` entries of the index by their measure. Returned: how many there are
 * without the last whose measures add up to `neglect`. */
static size_t sort_active(po_equilibrium *e, size_t count) {
  for (size_t k = 0; k < count; ++k)
    e->index[k] = k;
  qsort_r(e->index, count, sizeof *e->index, by_measure, e->measure);
  double left_out = 0.0;
  for (; count > 0; --count) {
    left_out += e->measure[e->index[count - 1]];
    if (!(left_out <= e->neglect))
      break;
  }
  return count;
}

/* The measure of a node: the largest change of a gap by a change of its own. */
static double measure_of(const po_equilibrium *e, size_t j) {
  return e->coupling * fabs(e->slope[j]) * e->surface->reach[j];
}

static void choose_active(po_equilibrium *e) {
  for (size_t j = 0; j < e->n; ++j)
    e->measure[j] = measure_of(e, j);
  e->active = sort_active(e, e->n);
}

/* The border as the last row of the matrix of the active nodes, active + 1 values. The gaps of the
 * other nodes are eliminated by their own linearised equations,
 *
 *   dH_i = -d(approach) + coupling * sum_j G_ij p'(H_j) dH_j,   j active,
 *
 * which distributes their part of the border to the active nodes and the approach. */
static void fill_row(po_equilibrium *e, double *row) {
  const size_t m = e->active;
  row[m] = e->border[e->n];
  memset(e->scratch, 0, e->n * sizeof *e->scratch);
  for (size_t b = m; b < e->n; ++b) {
    e->scratch[e->index[b]] = e->border[e->index[b]];
    row[m] -= e->border[e->index[b]];
  }
  po_surface_apply_transposed(e->surface, e->scratch, e->right);
  for (size_t b = 0; b < m; ++b) {
    const size_t j = e->index[b];
    row[b] = e->border[j] + e->coupling * e->slope[j] * e->right[j];
  }
}

/* Assembles the bordered Jacobian of Eq 15 for the active nodes, column by column. */
static po_status assemble(po_equilibrium *e) {
  const size_t m = e->active;
  fill_row(e, e->row);
  e->changed = false;
  if (!po_factors_begin(&e->factors, m + 1))
    return PO_NO_MEMORY;
  for (size_t b = 0; b < m; ++b) {
    const size_t j = e->index[b];
    const double *influence = e->surface->influence + e->n * j;
    const double factor = e->coupling * e->slope[j];
    for (size_t a = 0; a < m; ++a)
      e->column[a] = -factor * influence[e->index[a]];
    e->column[b] += 1.0;
    e->column[m] = e->row[b];
    po_factors_put(&e->factors, b, e->column);
  }
  for (size_t a = 0; a < m; ++a)
    e->column[a] = 1.0;
  e->column[m] = e->row[m];
  po_factors_put(&e->factors, m, e->column);
  return PO_OK;
}

/* Replaces the border of the factors. Returned: the determinant over that before. */
static double change_row(po_equilibrium *e) {
  const size_t m = e->active;
  fill_row(e, e->change);
  memset(e->response, 0, m * sizeof *e->response);
  e->response[m] = 1.0;
  po_factors_solve(&e->factors, e->response);
  e->pivot = 1.0;
  for (size_t k = 0; k <= m; ++k) {
    e->change[k] -= e->row[k];
    e->pivot += e->change[k] * e->response[k];
  }
  e->changed = true;
  return e->pivot;
}

void po_equilibrium_change_border(po_equilibrium *e, const double *border) {
  memcpy(e->border, border, (e->n + 1) * sizeof *border);
  e->weak_count = 0;
  const double ratio =
      e->elimination ? po_elimination_border(e->elimination, border) / e->pivot : change_row(e);
  e->factorized = ratio > LEAST_PIVOT;
}

static po_status factorize_dense(po_equilibrium *e) {
  choose_active(e);
  po_status status = assemble(e);
  if (!status)
    status = po_factors_compute(&e->factors);
  e->orientation = status ? 0 : po_factors_sign(&e->factors);
  return status;
}

/* Panels whose measures add up to `neglect` are left out of the factors. */
static po_status factorize_panels(po_equilibrium *e) {
  const size_t panels = e->n / PO_TABLE_ORDER;
  for (size_t k = 0; k < panels; ++k) {
    e->measure[k] = 0.0;
    for (size_t j = k * PO_TABLE_ORDER; j < (k + 1) * PO_TABLE_ORDER; ++j)
      e->measure[k] += measure_of(e, j);
  }
  const size_t active = sort_active(e, panels);
  e->active = active * PO_TABLE_ORDER;
  memset(e->scratch, 0, e->n * sizeof *e->scratch);
  const double factor = e->coupling * e->surface->core_radius;
  for (size_t k = 0; k < active; ++k)
    for (size_t j = e->index[k] * PO_TABLE_ORDER, i = 0; i < PO_TABLE_ORDER; ++i)
      e->scratch[j + i] = factor * e->slope[j + i];
  const po_status status = po_elimination_factorize(e->elimination, e->scratch);
  if (status)
    return status;
  e->pivot = po_elimination_border(e->elimination, e->border);
  e->orientation =
      e->pivot < 0.0 ? -po_elimination_sign(e->elimination) : po_elimination_sign(e->elimination);
  return e->pivot != 0.0 ? PO_OK : PO_SINGULAR;
}

static double neglect_of(const po_equilibrium *e) {
  return NEGLECT * fmin(1.0, GAIN_OF_NEGLECT / e->gain);
}

bool po_equilibrium_is_coarse(const po_equilibrium *e) {
  const bool is_double = e->elimination || e->factors.is_double;
  return (e->gain > GAIN_OF_DOUBLE && !is_double) || e->neglect > COARSE * neglect_of(e);
}

po_status po_equilibrium_factorize(po_equilibrium *e, const double *state, const double *border) {
  const po_status stopped = po_watch_look();
  if (stopped)
    return stopped;
  po_equilibrium_evaluate(e, state);
  if (border != e->border)
    memcpy(e->border, border, (e->n + 1) * sizeof *border);
  po_secant_clear(&e->secant, e->n + 1);
  for (size_t j = 0; j < e->n; ++j)
    e->secant.scale[j] = po_law_size(&e->scene->law, state[j]);
  e->weak_count = 0;
  e->neglect = neglect_of(e);
  e->factors.in_double = e->gain > GAIN_OF_DOUBLE;
  const po_status status = e->elimination ? factorize_panels(e) : factorize_dense(e);
  e->factorized = !status;
  const size_t order = e->active + 1;
  ++e->work.factorizations;
  if (order > e->work.factorized_nodes)
    e->work.factorized_nodes = order;
  return status;
}

void po_equilibrium_precondition(po_equilibrium *e, const double *residual, double *change) {
  const size_t n = e->n, m = e->active;
  double *right = e->right;
  if (e->elimination) {
    memcpy(change, residual, (n + 1) * sizeof *change);
    po_elimination_solve(e->elimination, change);
    for (size_t k = 0; k < e->weak_count * (n + 1); k += n + 1)
      po_linear_add(n + 1, po_linear_dot(n + 1, e->weak_functional + k, change), e->weak + k,
                    change);
    return;
  }
  for (size_t a = 0; a < m; ++a)
    right[a] = residual[e->index[a]];
  right[m] = residual[n];
  po_factors_solve(&e->factors, right);
  if (e->changed) {
    const double excess = po_linear_dot(m + 1, e->change, right) / e->pivot;
    for (size_t a = 0; a <= m; ++a)
      right[a] -= excess * e->response[a];
  }
  for (size_t a = 0; a < m; ++a)
    change[e->index[a]] = right[a];
  change[n] = right[m];
  for (size_t b = m; b < n; ++b)
    change[e->index[b]] = residual[e->index[b]] - change[n];
}
