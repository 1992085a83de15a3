/* A trace with a greater range of the attraction takes hundreds to thousands of points, more with
 * each smaller range, most of them unstable equilibria between two jumps. Of a test only few
 * special points matter. They are followed from one range to the next, each in one to some steps of
 * parameter continuation (po_follow.h). */
#include <math.h>
#include <stdlib.h>

#include "po_adjoint.h"
#include "po_elementary.h"
#include "po_follow.h"
#include "po_memory.h"
#include "po_reduced_internal.h"

/* The parameter is the logarithm of the range. */
struct po_range_course {
  const po_ranges *ranges;
  const po_range_trace *trace;
  po_follower *follower;
  double domain,
      radius; /* of the panels of the trace and of the sphere, in the unit of its range */
  const po_kept_point *point; /* that is followed, as traced */
  int at;                     /* index of the present range */
};

static void scene_at(void *data, double at, po_scene *scene) {
  const po_range_course *c = data;
  *scene = po_reduced_request(c->ranges->request, po_exp(at)).scene;
}

static double domain_of(void *data, const po_scene *scene) {
  const po_range_course *c = data;
  return c->domain * (scene->radius / c->radius);
}

static double unit_at(void *data, double at) {
  (void)data;
  return po_exp(at);
}

static double parameter(const po_range_course *c, int at) {
  return po_log(c->ranges->range[at]);
}

po_status po_range_course_create(const po_ranges *ranges, const po_range_trace *trace,
                                 po_range_course **course) {
  po_range_course *c = *course = po_allocate(1, sizeof *c);
  if (!c)
    return PO_NO_MEMORY;
  const po_request request = po_reduced_request(ranges->request, ranges->range[trace->at]);
  *c = (po_range_course){.ranges = ranges,
                         .trace = trace,
                         .domain = trace->kept.points[0].point.domain,
                         .radius = request.scene.radius,
                         .at = trace->at};
  const po_follow_options options = {.scene_at = scene_at,
                                     .domain_of = domain_of,
                                     .unit_at = unit_at,
                                     .data = c,
                                     .allowed = po_trace_allowance(trace->kept.tolerance),
                                     .precision = po_trace_precision(request.mesh.tolerance),
                                     .sharpness = request.mesh.tolerance};
  const po_status status = po_follow_create(&options, parameter(c, c->at), &c->follower);
  if (!status)
    return PO_OK;
  free(c);
  *course = NULL;
  return status;
}

void po_range_course_destroy(po_range_course *c, po_work *work) {
  if (!c)
    return;
  const po_work done = po_follow_work(c->follower);
  po_work_add(&done, work);
  po_follow_destroy(c->follower);
  free(c);
}

/* Adds the special point at the present range to its track. Status: PO_NO_MEMORY. */
static po_status record(po_range_course *c, po_range_track *t) {
  const po_request request = po_reduced_request(c->ranges->request, c->ranges->range[c->at]);
  const po_branch_point here = po_follow_point(c->follower, false);
  po_status status = PO_OK;
  t->has_sensitivity[c->at] = false;
  if (here.kind == PO_POINT_LOAD_MIN) {
    po_result result = po_result_none();
    status = po_adjoint_note(&request.scene, po_follow_surface(c->follower), &here, &result);
    t->has_sensitivity[c->at] = result.pull_off.has_sensitivity;
    t->sensitivity[c->at] = result.pull_off.sensitivity;
    po_result_clear(&result);
  }
  po_branch_point judged = po_follow_point(c->follower, true);
  judged.position = c->point->position;
  judged.unstable_modes = c->point->unstable_modes;
  t->at[c->at] = po_estimate_of(&request, &judged);
  return status;
}

static po_event_kind event_of(po_point_kind kind) {
  return kind == PO_POINT_LOAD_MIN || kind == PO_POINT_LOAD_MAX ? PO_OF_LOAD : PO_OF_APPROACH;
}

po_status po_range_course_again(po_range_course *c, const po_kept_point *point) {
  c->at = c->trace->at;
  c->point = point;
  return po_follow_begin(c->follower, &point->point, event_of(point->kind), parameter(c, c->at));
}

po_status po_range_course_begin(po_range_course *c, const po_kept_point *point,
                                po_range_track *track) {
  const po_status status = po_range_course_again(c, point);
  track->first = track->last = c->at;
  return status ? status : record(c, track);
}

po_status po_range_course_next(po_range_course *c, bool smaller, po_range_track *track) {
  const int at = c->at + (smaller ? 1 : -1);
  po_status status = po_follow_to(c->follower, parameter(c, at));
  if (status)
    return status;
  c->at = at;
  status = record(c, track);
  if (smaller)
    track->last = at;
  else
    track->first = at;
  return status;
}
