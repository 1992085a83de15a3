#include "po_series_scenes.h"

#include <math.h>
#include <stdlib.h>

#include "po_contact.h"
#include "po_deadline.h"
#include "po_elementary.h"
#include "po_far_field.h"
#include "po_load_unit.h"
#include "po_memory.h"
#include "po_series.h"

/* Interpolates between two values, logarithmically if both are positive. */
static double between(double a, double b, double part) {
  if (a == b || isinf(a))
    return a;
  return a > 0.0 && b > 0.0 ? a * po_pow(b / a, part) : a + part * (b - a);
}

static void scene_at(void *data, double at, po_scene *scene) {
  const po_series_scenes *l = data;
  const size_t k = (size_t)fmin(floor(at), (double)(l->count - 1));
  const double part = at - (double)k;
  *scene = l->requests[k].scene;
  if (part == 0.0)
    return;
  const po_scene *a = &l->requests[k].scene, *b = &l->requests[k + 1].scene;
  scene->tabor = between(a->tabor, b->tabor, part);
  scene->amplitude = between(a->amplitude, b->amplitude, part);
  scene->wavelength = between(a->wavelength, b->wavelength, part);
  scene->radius = between(a->radius, b->radius, part);
  for (size_t w = 0; w < a->more_waves; ++w) {
    scene->more[w].amplitude = between(a->more[w].amplitude, b->more[w].amplitude, part);
    scene->more[w].length = between(a->more[w].length, b->more[w].length, part);
  }
  for (int p = 0; p < PO_PROFILE_PARAMETER_COUNT; ++p)
    if (po_profile_has(&a->profile, (po_profile_parameter)p))
      scene->profile.parameter[p] = between(a->profile.parameter[p], b->profile.parameter[p], part);
  scene->outer_radius = between(a->outer_radius, b->outer_radius, part);
  for (int p = 0; p < PO_LAW_PARAMETER_COUNT; ++p)
    if (po_law_has(&a->law, (po_law_parameter)p))
      po_law_set_parameter(&scene->law, (po_law_parameter)p,
                           between(a->law.parameter[p], b->law.parameter[p], part));
}

po_status po_series_solve(po_series_scenes scenes, po_status (*solve)(const po_series_scenes *l)) {
  po_request *solved = po_allocate(scenes.count + 1, sizeof *solved);
  for (size_t k = 0; k < scenes.count; ++k)
    scenes.results[k] = po_result_none();
  if (!solved)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < scenes.count; ++k)
    solved[k] = po_load_unit_request(&scenes.requests[k]);
  scenes.requests = solved;
  const po_status status = solve(&scenes);
  for (size_t k = 0; k < scenes.count; ++k) {
    scenes.results[k].pull_off.excess = po_request_excess(&solved[k], &scenes.results[k]);
    po_load_unit_result(&solved[k].scene, &scenes.results[k]);
  }
  free(solved);
  return status;
}

static double domain_of(void *data, const po_scene *scene) {
  (void)data;
  return po_trace_domain(scene, po_surface_core(scene, NAN));
}

static bool is_same(double a, double b) {
  return a == b || (isnan(a) && isnan(b));
}

/* Whether the panels end where those of the follower do: its domain grows smoothly with the scene,
 * and not until the far field is resolved. */
static bool has_usual_domain(const po_request *request) {
  const double core = po_surface_core(&request->scene, (double)NAN);
  return po_far_field_core(&request->scene, core, request->mesh.tolerance) == core;
}

bool po_series_alike(const po_request *a, const po_request *b) {
  return a->mesh.scheme == PO_PANEL && b->mesh.scheme == PO_PANEL && !a->want && !b->want &&
         a->creep.kind == PO_CREEP_NONE && b->creep.kind == PO_CREEP_NONE &&
         a->mesh.tolerance == b->mesh.tolerance && isnan(a->approach_end) &&
         isnan(b->approach_end) && is_same(a->preload.approach, b->preload.approach) &&
         is_same(a->preload.load, b->preload.load) &&
         po_law_index(&a->scene.law) == po_law_index(&b->scene.law) &&
         po_profile_index(&a->scene.profile) == po_profile_index(&b->scene.profile) &&
         a->scene.profile.table == b->scene.profile.table &&
         po_scene_waves(&a->scene) == po_scene_waves(&b->scene) &&
         isinf(a->scene.outer_radius) == isinf(b->scene.outer_radius) && has_usual_domain(a) &&
         has_usual_domain(b);
}

po_status po_series_course_begin(po_series_course *c, size_t first, double tolerance) {
  const po_follow_options options = {.scene_at = scene_at,
                                     .domain_of = domain_of,
                                     .data = (void *)c->scenes,
                                     .allowed = po_trace_allowance(tolerance),
                                     .precision = po_trace_precision(tolerance),
                                     .sharpness = tolerance};
  return po_follow_create(&options, (double)first, &c->follower);
}

/* Adds the work since the last call. Given: seconds, its elapsed time. */
static void add_work(po_series_course *c, double seconds, po_work *work) {
  const po_work now = po_follow_work(c->follower), before = c->counted;
  work->points += now.points - before.points;
  work->newton_iterations += now.newton_iterations - before.newton_iterations;
  work->factorizations += now.factorizations - before.factorizations;
  work->meshes += now.meshes - before.meshes;
  work->kernel_evaluations += now.kernel_evaluations - before.kernel_evaluations;
  work->factorized_nodes = now.factorized_nodes;
  work->seconds += seconds;
  c->counted = now;
}

/* Records the point at which the follower is. Status: PO_OUT_OF_DOMAIN. */
static po_status record(const po_series_course *c, size_t index) {
  const po_scene *scene = &c->scenes->requests[index].scene;
  const po_branch_point p = po_follow_point(c->follower, false);
  const po_contact_gap gap = po_contact_gap_of(scene, &p);
  if (po_trace_is_cut_off(scene, po_contact_radius(&gap), p.solution->domain))
    return PO_OUT_OF_DOMAIN;
  c->record(c->data, index, &p);
  return PO_OK;
}

typedef struct {
  po_series_progress *progress;
  bool is_seen;
} scene_mark;

static void see_scene(void *watcher, double approach, double load) {
  (void)approach, (void)load;
  scene_mark *mark = watcher;
  mark->progress->seen += !mark->is_seen;
  mark->is_seen = true;
  mark->progress->show(mark->progress->user, mark->progress->seen);
}

void *po_series_watch(po_request *requests, size_t count, po_series_progress *progress) {
  scene_mark *marks = po_allocate(count, sizeof *marks);
  for (size_t k = 0; marks && k < count; ++k) {
    marks[k].progress = progress;
    requests[k].watch = see_scene;
    requests[k].watcher = &marks[k];
  }
  return marks;
}

po_status po_series_follow(po_series_course *c, const po_solution *point, size_t first,
                           size_t last) {
  double begin = po_clock_wall();
  po_status status = po_follow_begin(c->follower, point, c->of, (double)first);
  for (size_t k = first; k != last && !status;) {
    k = first < last ? k + 1 : k - 1;
    const po_request *request = &c->scenes->requests[k];
    if (request->stop && *request->stop)
      return po_fail(PO_INTERRUPTED, "interrupted in a series of scenes");
    if (request->watch)
      request->watch(request->watcher, (double)NAN, (double)NAN);
    const po_deadline before = po_deadline_begin(request->stop, po_trace_deadline(request));
    status = po_follow_to(c->follower, (double)k);
    po_deadline_end(before);
    if (!status)
      status = record(c, k);
    const double now = po_clock_wall();
    add_work(c, now - begin, &c->scenes->results[k].work);
    begin = now;
  }
  return status;
}

po_estimate po_series_estimate(const po_series_course *c, size_t index) {
  const po_branch_point p = po_follow_point(c->follower, true);
  return po_estimate_of(&c->scenes->requests[index], &p);
}
