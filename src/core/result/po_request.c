#include "po_request.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_profile_kind.h"

po_request po_request_default(void) {
  return (po_request){.scene = po_scene_default(),
                      .mesh = po_mesh_default(),
                      .approach_start = NAN,
                      .approach_end = NAN,
                      .profile_approach = NAN,
                      .profile_load = NAN,
                      .preload = {NAN, NAN},
                      .stiffness = NAN,
                      .unload_speed = NAN,
                      .load_speed = NAN,
                      .dwell = NAN,
                      .time_limit = NAN};
}

const char *const PO_RANGES[] = {
    [PO_RANGE_AUTO] = "auto", [PO_RANGE_EXACT] = "exact", [PO_RANGE_REDUCED] = "reduced", NULL};

const char *const PO_WANTS[] = {"curve",   "profile",  "hysteresis", "diagnostics",
                                "preload", "theories", "loop",       "history"};

bool po_want_read(const char *list, unsigned *want) {
  unsigned found = 0;
  for (const char *item = list;; ++item) {
    const size_t length = strcspn(item, ",");
    int k = 0;
    while (k < PO_WANT_COUNT &&
           (strlen(PO_WANTS[k]) != length || strncmp(item, PO_WANTS[k], length) != 0))
      ++k;
    if (k == PO_WANT_COUNT)
      return false;
    found |= 1u << k;
    item += length;
    if (*item == '\0')
      break;
  }
  *want |= found;
  return true;
}

const double PO_USUAL_PRELOAD = 1.0;

/* The error by steps in time goes as their misfit, which is the root of the tolerance (po_march.h):
 * at a tolerance of 1e-6 it is some 1e-5 of the force, and a tenth of this tolerance. */
static const double OF_STEPS = 0.1;

double po_request_tolerance(const po_request *request) {
  const double tolerance = request->mesh.tolerance;
  return request->creep.kind == PO_CREEP_NONE ? tolerance : OF_STEPS * sqrt(tolerance);
}

double po_request_excess(const po_request *request, const po_result *result) {
  return result->has_pull_off ? result->pull_off.force_error /
                                    (po_request_tolerance(request) * result->pull_off.force)
                              : (double)NAN;
}

po_preload po_request_preload(const po_request *request) {
  if (!isnan(request->preload.approach) || !isnan(request->preload.load))
    return request->preload;
  if (!isnan(request->approach_end))
    return (po_preload){request->approach_end, (double)NAN};
  return (po_preload){(double)NAN, PO_USUAL_PRELOAD};
}

static void choose_search(po_request *request) {
  if (!(request->want & ~(unsigned)PO_WANT_THEORIES) && isnan(request->preload.approach) &&
      isnan(request->preload.load))
    request->search = PO_SEARCH_SOME;
}

po_search po_request_search(const po_request *request) {
  return isinf(request->preload.approach) || request->want & PO_WANT_PRELOAD ? PO_SEARCH_ALL
                                                                             : request->search;
}

/* Checks what belongs to a viscoelastic body. */
static po_status check_viscoelastic(const po_request *request) {
  static const char *const NAMES[] = {"unload_speed", "load_speed", "dwell"};
  const double values[] = {request->unload_speed, request->load_speed, request->dwell};
  for (int k = 0; k < 3; ++k) {
    if (!isnan(values[k]) && request->creep.kind == PO_CREEP_NONE)
      return po_fail(PO_BAD_INPUT, "%s is %g: expected it beside viscoelastic", NAMES[k],
                     values[k]);
    if (values[k] < 0.0)
      return po_fail(PO_BAD_INPUT, "%s is %g: expected a number >= 0, or inf", NAMES[k], values[k]);
  }
  if (request->creep.kind == PO_CREEP_NONE) {
    return request->want & PO_WANT_HISTORY
               ? po_fail(PO_BAD_INPUT, "history is wanted: expected it beside viscoelastic")
               : PO_OK;
  }
  if (isnan(request->unload_speed))
    return po_fail(PO_BAD_INPUT, "unload_speed is missing: expected a number >= 0, or inf, beside "
                                 "viscoelastic");
  if (request->scene.tabor == 0.0)
    return po_fail(PO_BAD_INPUT, "viscoelastic is given for a rigid scene: expected tabor > 0");
  if (request->mesh.scheme != PO_PANEL)
    return po_fail(PO_BAD_INPUT, "viscoelastic is given with the scheme %s: expected panel",
                   PO_SCHEMES[request->mesh.scheme]);
  if (isinf(request->preload.approach))
    return po_fail(PO_BAD_INPUT, "preload is inf beside viscoelastic: expected a finite number");
  const unsigned others =
      request->want & ~(unsigned)(PO_WANT_HISTORY | PO_WANT_THEORIES | PO_WANT_PROFILE);
  return others
             ? po_fail(PO_BAD_INPUT, "a result other than history, profile and theories is wanted "
                                     "beside viscoelastic: expected only these")
             : PO_OK;
}

po_status po_request_check(const po_request *request) {
  po_status status = po_scene_check(&request->scene);
  if (!status)
    status = po_mesh_check(&request->mesh);
  if (status)
    return status;
  if (isinf(request->approach_start))
    return po_fail(PO_BAD_INPUT, "approach_start is %g: expected a finite number",
                   request->approach_start);
  if (isinf(request->approach_end))
    return po_fail(PO_BAD_INPUT, "approach_end is %g: expected a finite number",
                   request->approach_end);
  status = check_viscoelastic(request);
  if (status)
    return status;
  if (request->approach_start >= request->approach_end)
    return po_fail(PO_BAD_INPUT, "approach_end is %g: expected more than approach_start, %g",
                   request->approach_end, request->approach_start);
  if (isinf(request->preload.approach) &&
      (!isnan(request->preload.load) || !isnan(request->approach_end)))
    return po_fail(PO_BAD_INPUT, "preload is inf beside %s: expected one of both",
                   isnan(request->preload.load) ? "approach_end" : "preload_load");
  if (isinf(request->preload.approach) && request->want & PO_WANT_HYSTERESIS)
    return po_fail(PO_BAD_INPUT,
                   "preload is inf: expected a finite number for the hysteresis, whose "
                   "loading is reversed there");
  if (request->preload.approach > request->approach_end && isfinite(request->preload.approach))
    return po_fail(PO_BAD_INPUT, "approach_end is %g: expected at least the preload, %g",
                   request->approach_end, request->preload.approach);
  if (isinf(request->profile_approach))
    return po_fail(PO_BAD_INPUT, "profile_approach is %g: expected a finite number",
                   request->profile_approach);
  if (isinf(request->profile_load))
    return po_fail(PO_BAD_INPUT, "profile_load is %g: expected a finite number",
                   request->profile_load);
  if (!isnan(request->profile_approach) && !isnan(request->profile_load))
    return po_fail(PO_BAD_INPUT, "profile_load is %g beside profile_approach: expected one of both",
                   request->profile_load);
  if (request->preload.approach == -INFINITY)
    return po_fail(PO_BAD_INPUT, "preload is %g: expected a finite number, or inf",
                   request->preload.approach);
  if (request->preload.load < 0.0 || isinf(request->preload.load))
    return po_fail(PO_BAD_INPUT, "preload_load is %g: expected a finite number >= 0",
                   request->preload.load);
  if (request->time_limit <= 0.0 || isinf(request->time_limit))
    return po_fail(PO_BAD_INPUT, "time_limit is %g: expected a finite number > 0",
                   request->time_limit);
  return PO_OK;
}

po_status po_request_complete(po_request *request) {
  const bool elastic = request->creep.kind == PO_CREEP_NONE;
  if ((!isnan(request->stiffness) && elastic) || request->want & PO_WANT_LOOP)
    request->want |= PO_WANT_HYSTERESIS;
  if (!isnan(request->profile_approach) || !isnan(request->profile_load))
    request->want |= PO_WANT_PROFILE;
  if (elastic)
    choose_search(request);
  return po_request_check(request);
}

double po_request_bound(const po_request *request, double load) {
  const po_theories *theories = request->theories;
  return theories ? theories->bound(&request->scene, load) : (double)NAN;
}

/* Part of R. At this contact radius the gap of the sphere exceeds that of the parabola by 2 %, and
 * the pull-off force of the parabola by JKR theory that of the sphere by 4 %. */
const double PO_WIDE_CONTACT = 0.3;

double po_request_wide_contact(const po_request *request, const po_result *result) {
  const po_scene *scene = &request->scene;
  const bool is_wide = po_profile_is_sphere(&scene->profile) && result->has_pull_off &&
                       result->pull_off.contact_radius > PO_WIDE_CONTACT * scene->radius;
  return is_wide ? result->pull_off.contact_radius / scene->radius : 0.0;
}

po_status po_request_find_parabola(const po_request *request, po_result *result) {
  const double wide = po_request_wide_contact(request, result);
  size_t count = 0;
  for (size_t k = 0; k < result->theory_count; ++k)
    count += isfinite(result->theories[k].force) && result->theories[k].holds == PO_HOLDS_YES;
  free(result->parabola.theories);
  result->parabola = po_result_none().parabola;
  if (!(wide > 0.0) || count == 0)
    return PO_OK;
  po_parabola_theory *held = po_allocate(count, sizeof *held);
  if (!held)
    return PO_NO_MEMORY;
  result->parabola.wide = wide;
  result->parabola.limit = PO_WIDE_CONTACT;
  result->parabola.sphere = request->scene.radius;
  result->parabola.theories = held;
  for (size_t k = 0; k < result->theory_count; ++k)
    if (isfinite(result->theories[k].force) && result->theories[k].holds == PO_HOLDS_YES)
      held[result->parabola.theory_count++].theory = result->theories[k].theory;
  return PO_OK;
}
