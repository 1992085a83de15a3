/* One step of a march: an equilibrium with another gap and another coupling, see po_march.h. */
#include <math.h>
#include <string.h>

#include "po_corrector.h"
#include "po_elementary.h"
#include "po_law.h"
#include "po_linear.h"
#include "po_march_internal.h"

/* x below which phi1 and phi2 are sums of their series, whose terms beyond are below 1e-17. */
static const double SMALL_X = 0.01;

static po_creep_step creep_step(double x) {
  if (isinf(x))
    return (po_creep_step){.e = 0.0, .a = 0.0, .b = 1.0, .phi1 = 0.0, .phi2 = 0.0};
  po_creep_step s;
  if (x < SMALL_X) {
    s.phi2 = 0.5 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x / 5040))));
    s.phi1 = 1.0 - x * s.phi2;
  } else {
    s.phi1 = -po_expm1(-x) / x;
    s.phi2 = (1.0 - s.phi1) / x;
  }
  s.e = 1.0 - x * s.phi1;
  s.a = x * (s.phi1 - s.phi2);
  s.b = x * s.phi2;
  return s;
}

po_march_scene po_march_scene_of(const po_march *m, double length) {
  const po_creep_terms *t = m->options.terms;
  po_march_scene scene = {.length = length, .factor = t->instant};
  for (size_t k = 0; k < t->count; ++k) {
    scene.step[k] = creep_step(length / m->speed / t->term[k].time);
    scene.factor += t->term[k].weight * scene.step[k].b;
  }
  return scene;
}

/* The history at the nodes: what a scene adds to the initial gap. */
static void add_history(const po_march *m, const po_march_scene *scene, double *creep) {
  const size_t n = m->e->n, terms = m->options.terms->count;
  const double *instant = po_march_field(&m->here, PO_OF_INSTANT);
  const bool frozen = scene->relaxing && m->speed > 0.0;
  double now = 0.0;
  memset(creep, 0, n * sizeof *creep);
  for (size_t k = 0; k < terms; ++k) {
    const double e = frozen ? 1.0 : scene->relaxing ? 0.0 : scene->step[k].e;
    if (!scene->relaxing)
      now += m->options.terms->term[k].weight * scene->step[k].a;
    if (e > 0.0)
      po_linear_add(n, e, po_march_field(&m->here, PO_OF_CREEP + k), creep);
  }
  if (now > 0.0)
    po_linear_add(n, now, instant, creep);
  if (!scene->relaxing)
    return;
  const double *deflection = po_march_field(&m->here, PO_OF_DEFLECTION);
  for (size_t j = 0; j < n; ++j)
    creep[j] += (1.0 - scene->part) * (deflection[j] + m->here.point.approach - creep[j]);
}

/* Whether what is held depends on the load through a spring. */
static bool has_spring(const po_march *m) {
  return m->holds == PO_HOLD_BASE && !isnan(m->options.stiffness);
}

/* What is held: the approach, the load, or approach + load/stiffness, the position of the base; of
 * a step in a jump, with a part of the load. */
static double held_of(const po_equilibrium *e, const double *state, const void *data) {
  const po_march *m = data;
  if (m->holds == PO_HOLD_LOAD)
    return po_equilibrium_load(e);
  return !has_spring(m) ? state[e->n]
                        : state[e->n] + m->part * po_equilibrium_load(e) / m->options.stiffness;
}

/* The value of what is held after a step that moves the base to `base`. */
static double held_value(const po_march *m, double base) {
  return m->holds == PO_HOLD_BASE ? m->part * base + (1.0 - m->part) * m->here.point.approach
                                  : m->held_value;
}

static po_status factorize(po_march *m, const double *state) {
  po_equilibrium *e = m->e;
  po_equilibrium_evaluate(e, state);
  for (size_t j = 0; j < e->n; ++j)
    m->border[j] = m->holds == PO_HOLD_LOAD ? 2.0 / e->radius * e->surface->weight[j] * e->slope[j]
                   : has_spring(m)          ? m->part * 2.0 / e->radius * e->surface->weight[j] *
                                         e->slope[j] / m->options.stiffness
                                   : 0.0;
  m->border[e->n] = m->holds == PO_HOLD_LOAD ? 0.0 : 1.0;
  return po_corrector_factorize(e, state, m->border);
}

/* Newton's method from the guess, with the present factors or new ones. Returned: m->solved. */
static po_status newton(po_march *m, double base) {
  po_equilibrium *e = m->e;
  const po_constraint constraint = {held_of, m, held_value(m, base), INFINITY};
  po_status status = PO_NOT_CONVERGED;
  for (int fresh = e->factorized ? 0 : 1; status == PO_NOT_CONVERGED && fresh < 2; ++fresh) {
    memcpy(m->solved, m->guess, (e->n + 1) * sizeof *m->solved);
    if (fresh && (status = factorize(m, m->guess)))
      break;
    status = po_equilibrium_correct_to(e, m->solved, &constraint);
    for (int k = 0;
         status == PO_NOT_CONVERGED && e->last_change < PO_NEAR_SOLUTION && k < PO_MOST_RENEWALS;
         ++k) {
      status = factorize(m, m->solved);
      if (!status)
        status = po_equilibrium_correct_to(e, m->solved, &constraint);
    }
  }
  if (status == PO_SINGULAR)
    return PO_NOT_CONVERGED;
  if (status)
    return status;
  const int orientation = e->orientation * e->secant.sign;
  if (m->orientation == 0)
    m->orientation = orientation;
  return orientation == m->orientation ? PO_OK : PO_NOT_CONVERGED;
}

/* Guesses the gap after the step by the quadratic through the last three states. */
static void predict(po_march *m, const po_march_scene *scene) {
  const po_march_state *s = &m->here;
  const size_t n = m->e->n;
  const double h = scene->relaxing ? 0.0 : scene->length, bend = 0.5 * h * (h + s->length);
  for (size_t j = 0; j < n; ++j) {
    const double gap = m->bare[j] + po_march_field(s, PO_OF_DEFLECTION)[j];
    const double guess =
        gap + h * po_march_field(s, PO_OF_RATE)[j] + bend * po_march_field(s, PO_OF_BEND)[j];
    /* a guess beyond the pole of the law, or far nearer, is none */
    m->guess[j] = guess > 0.5 * (gap - 1.0) ? guess : gap;
  }
  m->guess[n] = s->point.approach - m->direction * scene->length;
}

/* Keeps a gap at the nodes of the present mesh, as H - f, for the next mesh. */
static void keep_shape(po_march *m, const double *gap) {
  for (size_t j = 0; j < m->e->n; ++j)
    m->shape[j] = gap[j] - m->bare[j];
  po_panels_copy(po_surface_panels(m->e->surface), m->shape_panels);
}

static bool is_resolved(const po_march *m, const double *gap) {
  return po_resolution_excess(&m->resolution, po_surface_panels(m->e->surface), gap) <= 1.0;
}

/* Sets gap and coupling of the scene on the present mesh. */
static void pose(po_march *m, const po_march_scene *scene) {
  if (!m->is_here)
    po_march_bring(m);
  add_history(m, scene, m->creep);
  for (size_t j = 0; j < m->e->n; ++j)
    m->e->initial_gap[j] = m->bare[j] + m->creep[j];
}

/* The solved gap on the next mesh, as the guess there. */
static void guess_from_shape(po_march *m, size_t n, double approach) {
  po_march_interpolate(m->shape_panels, n, m->shape, 1, m->e->surface, m->guess);
  for (size_t j = 0; j < m->e->n; ++j)
    m->guess[j] += m->bare[j];
  m->guess[m->e->n] = approach;
}

po_status po_march_solve(po_march *m, const po_march_scene *scene) {
  po_equilibrium *e = m->e;
  const double coupling = m->coupling * scene->factor;
  if (coupling != e->coupling)
    e->factorized = e->factorized && fabs(coupling / e->coupling - 1.0) < 0.5;
  e->coupling = coupling;
  if (!m->is_here)
    po_march_bring(m);
  const double base = m->here.point.base - m->direction * scene->length;
  m->part = scene->relaxing ? scene->part : 1.0;
  pose(m, scene);
  predict(m, scene);
  po_status status = PO_OK;
  if (!is_resolved(m, m->guess)) {
    keep_shape(m, m->guess);
    status = po_march_remesh(m);
    if (status)
      return status;
    pose(m, scene);
    predict(m, scene);
  }
  for (int meshes = 0;; ++meshes) {
    status = newton(m, base);
    if (status || meshes == PO_MOST_MESHES_A_POINT || is_resolved(m, m->solved))
      break;
    const size_t n = e->n;
    keep_shape(m, m->solved);
    status = po_march_remesh(m);
    if (status)
      return status;
    pose(m, scene);
    guess_from_shape(m, n, m->solved[n]);
  }
  if (status)
    return status;
  po_march_state *to = &m->next;
  to->n = e->n;
  po_panels_copy(po_surface_panels(e->surface), to->panels);
  for (size_t j = 0; j < e->n; ++j)
    po_march_field(to, PO_OF_DEFLECTION)[j] = m->solved[j] - m->bare[j];
  to->point = m->here.point;
  to->point.approach = m->solved[e->n];
  to->point.load = po_equilibrium_load(e);
  to->point.base = m->holds == PO_HOLD_BASE ? base
                   : isnan(m->options.stiffness)
                       ? to->point.approach
                       : to->point.approach + to->point.load / m->options.stiffness;
  to->point.moved += scene->length;
  const double speed = m->speed;
  if (m->phase == PO_UNLOADING)
    to->point.time = speed > 0.0 && isfinite(speed) ? to->point.moved / speed : (double)NAN;
  else
    to->point.time += scene->length / speed;
  to->point.contact_radius =
      po_march_contact_radius(m, m->solved, po_march_field(to, PO_OF_DEFLECTION));
  memcpy(m->traction, e->traction, e->n * sizeof *m->traction);
  return PO_OK;
}

/* The traction of `here`. */
static void traction_before(const po_march *m, double *traction) {
  const double *deflection = po_march_field(&m->here, PO_OF_DEFLECTION);
  double *gap = m->guess;
  for (size_t j = 0; j < m->e->n; ++j)
    gap[j] = m->bare[j] + deflection[j];
  po_equilibrium_evaluate(m->e, gap);
  memcpy(traction, m->e->traction, m->e->n * sizeof *traction);
  memcpy(m->e->traction, m->traction, m->e->n * sizeof *traction);
}

/* The local misfit, over the greatest tension, that is as much as the misfit that is allowed. A
 * narrow edge is little of the load; where it moves by more than its width in a step, it leaves a
 * trail of ripples in the history, which the mesh then has to resolve. */
static const double LOCAL = 0.3;

double po_march_misfit(const po_march *m) {
  const po_surface *s = m->e->surface;
  const double h = m->next.point.moved - m->here.point.moved;
  const double *rate = po_march_field(&m->here, PO_OF_TRACTION);
  const po_law *law = &m->e->scene->law;
  const double tension = -po_law_at(law, po_law_numbers_of(law)->peak_gap).traction;
  traction_before(m, m->other);
  double sum = 0.0, greatest = 0.0;
  for (size_t j = 0; j < m->e->n; ++j) {
    const double misfit = fabs(m->traction[j] - m->other[j] - h * rate[j]);
    sum += s->weight[j] * misfit;
    greatest = fmax(greatest, misfit);
  }
  return fmax(2.0 / m->e->radius * sum / (1.0 + fabs(m->next.point.load)),
              greatest / (LOCAL * tension) * m->options.misfit);
}

/* A traction with the weights of the load: its dot product with a deflection is 2/R times the
 * integral of both. */
static void weigh(const po_march *m, const double *traction, double *forces) {
  for (size_t j = 0; j < m->e->n; ++j)
    forces[j] = 2.0 / m->e->radius * m->e->surface->weight[j] * traction[j];
}

void po_march_measure(po_march *m) {
  po_equilibrium *e = m->e;
  const po_creep_terms *t = m->options.terms;
  po_march_state *to = &m->next;
  po_rate_energy *energy = &to->point.energy;
  memcpy(e->initial_gap, m->bare, e->n * sizeof *m->bare);
  double deflected = 0.0;
  for (size_t j = 0; j < e->n; ++j)
    deflected += e->surface->weight[j] * e->traction[j] *
                 (po_march_field(to, PO_OF_DEFLECTION)[j] + m->solved[e->n]);
  energy->adhesive = po_equilibrium_energy(e, m->solved) - deflected / e->radius;
  weigh(m, m->traction, m->forces);
  energy->stored =
      0.5 * t->instant * po_linear_dot(e->n, m->forces, po_march_field(to, PO_OF_INSTANT));
  for (size_t k = 0; k < t->count; ++k)
    if (t->term[k].weight > 0.0)
      energy->stored += 0.5 * to->square[k] / t->term[k].weight;
  energy->spring = isnan(m->options.stiffness)
                       ? 0.0
                       : 0.5 * to->point.load * to->point.load / m->options.stiffness;
}

/* Squares and dissipation of one term over a step, exact for a traction that is linear in time.
 * Given: products (with the coupling) of the tractions at both ends, p0 and p1, with that of the
 * term at the begin, z0; and among themselves. Returned: the dissipation, pi w R eps. */
static double dissipate(const po_creep_step *s, double c, double p0z0, double p1z0,
                        const double pp[3], double *square) {
  const double p1z1 = s->e * p1z0 + c * (s->a * pp[1] + s->b * pp[2]);
  const double after =
      s->e * s->e * *square + 2.0 * s->e * c * (s->a * p0z0 + s->b * p1z0) +
      c * c * (s->a * s->a * pp[0] + 2.0 * s->a * s->b * pp[1] + s->b * s->b * pp[2]);
  /* tau times the integral of <p', z'>, by the change of z over x */
  const double moved = -s->phi1 * (p1z0 - p0z0) +
                       c * ((s->phi1 - s->phi2) * (pp[1] - pp[0]) + s->phi2 * (pp[2] - pp[1]));
  const double work = p1z1 - p0z0 - 0.5 * c * (pp[2] - pp[0]) + moved;
  const double lost = work - 0.5 * (after - *square) / c;
  *square = after;
  return lost;
}

void po_march_finish(po_march *m, const po_march_scene *scene) {
  const po_creep_terms *t = m->options.terms;
  const size_t n = m->e->n;
  const double h = scene->length;
  po_march_state *from = &m->here, *to = &m->next;
  double *now = po_march_field(to, PO_OF_INSTANT);
  const double *before = po_march_field(from, PO_OF_INSTANT);
  traction_before(m, m->other);
  for (size_t j = 0; j < n; ++j) {
    const double deflection = po_march_field(to, PO_OF_DEFLECTION)[j];
    const double rate = (deflection - po_march_field(from, PO_OF_DEFLECTION)[j]) / h;
    now[j] = (deflection + m->solved[n] - m->creep[j]) / scene->factor;
    po_march_field(to, PO_OF_RATE)[j] = rate;
    po_march_field(to, PO_OF_BEND)[j] =
        from->length > 0.0 ? 2.0 * (rate - po_march_field(from, PO_OF_RATE)[j]) / (h + from->length)
                           : 0.0;
    po_march_field(to, PO_OF_TRACTION)[j] = (m->traction[j] - m->other[j]) / h;
  }
  to->length = h;
  memcpy(to->square, from->square, sizeof to->square);
  weigh(m, m->other, m->forces_before);
  weigh(m, m->traction, m->forces);
  const double pp[3] = {
      po_linear_dot(n, m->forces_before, before),
      0.5 * (po_linear_dot(n, m->forces_before, now) + po_linear_dot(n, m->forces, before)),
      po_linear_dot(n, m->forces, now)};
  double lost = 0.0;
  for (size_t k = 0; k < t->count; ++k) {
    const po_creep_step *s = &scene->step[k];
    const double c = t->term[k].weight;
    const double *u = po_march_field(from, PO_OF_CREEP + k);
    double *v = po_march_field(to, PO_OF_CREEP + k);
    if (c > 0.0)
      lost += dissipate(s, c, po_linear_dot(n, m->forces_before, u), po_linear_dot(n, m->forces, u),
                        pp, &to->square[k]);
    for (size_t j = 0; j < n; ++j)
      v[j] = s->e * u[j] + c * (s->a * before[j] + s->b * now[j]);
  }
  to->point.energy.dissipated += lost;
  to->point.energy.work += po_march_work(m, &from->point, h);
  po_march_measure(m);
}

double po_march_work(const po_march *m, const po_rate_point *from, double length) {
  const po_rate_point *to = &m->next.point;
  const double moved = m->holds == PO_HOLD_BASE ? -m->direction * length : to->base - from->base;
  return 0.5 * moved * (from->load + to->load);
}

double po_march_creep(po_march *m, double length) {
  const po_creep_terms *t = m->options.terms;
  const po_march_scene scene = po_march_scene_of(m, length);
  po_march_bring(m);
  po_march_state *s = &m->here;
  const double *instant = po_march_field(s, PO_OF_INSTANT);
  traction_before(m, m->other);
  weigh(m, m->other, m->forces);
  const double pp = po_linear_dot(s->n, m->forces, instant), all[3] = {pp, pp, pp};
  double lost = 0.0;
  for (size_t k = 0; k < t->count; ++k) {
    const po_creep_step *step = &scene.step[k];
    const double c = t->term[k].weight;
    double *u = po_march_field(s, PO_OF_CREEP + k);
    const double pz = po_linear_dot(s->n, m->forces, u);
    if (c > 0.0)
      lost += dissipate(step, c, pz, pz, all, &s->square[k]);
    for (size_t j = 0; j < s->n; ++j)
      u[j] = step->e * u[j] + c * (1.0 - step->e) * instant[j];
  }
  po_march_state *held = &m->held;
  held->n = s->n;
  po_panels_copy(po_surface_panels(m->e->surface), held->panels);
  memcpy(held->field, s->field, m->fields * s->n * sizeof *s->field);
  memcpy(held->square, s->square, sizeof s->square);
  return lost;
}
