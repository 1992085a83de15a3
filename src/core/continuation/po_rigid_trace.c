#include "po_rigid_trace.h"

#include <math.h>
#include <stdlib.h>

#include "po_law.h"
#include "po_rigid.h"
#include "po_root.h"

/* Error of the load relative to 1 + |load|, from the accuracy of the quadrature; and error of the
 * approach at which the rate of the load vanishes. The rate is as accurate as the load, and its
 * slope is at least 1. */
static const double QUADRATURE_ERROR = 1e-10, LOCATION_ERROR = 1e-9;

/* Ratio of successive values of 1 - approach. */
static const double STEP_RATIO = 0.97;

typedef struct {
  const po_scene *scene;
  const po_continuation_options *options;
  double begin;
  po_status *status; /* elsewhere: po_root passes on what is constant */
  bool ended;
} rigid_tracer;

static void load_at(const rigid_tracer *t, double approach, double *load, double *rate) {
  *load = *rate = 0.0;
  const po_status status = po_rigid_load(t->scene, approach, load, rate);
  *t->status = *t->status ? *t->status : status;
}

static double rate_at(double approach, const void *data) {
  double load, rate;
  load_at(data, approach, &load, &rate);
  return rate;
}

/* The load less that of the station. */
static double beyond_load(double approach, const void *data) {
  const rigid_tracer *t = data;
  double load, rate;
  load_at(t, approach, &load, &rate);
  return load - t->options->station_load;
}

/* Computes a point of the loading curve. */
static po_branch_point solve(rigid_tracer *t, double approach, po_point_kind kind) {
  po_branch_point point = {
      .kind = kind, .position = approach - t->begin, .approach = approach, .approach_rate = 1.0};
  const po_status status = po_rigid_load(t->scene, approach, &point.load, &point.load_rate);
  *t->status = *t->status ? *t->status : status;
  if (!*t->status)
    *t->status = po_rigid_energy(t->scene, approach, &point.energy);
  const double elastic = po_rigid_elastic_effect(t->scene);
  point.load_error = elastic + QUADRATURE_ERROR * (1.0 + fabs(point.load));
  point.approach_error = elastic + LOCATION_ERROR;
  return point;
}

static void visit(rigid_tracer *t, const po_branch_point *point) {
  if (!*t->status && !t->ended && t->options->visit(point, t->options->data))
    t->ended = true;
}

/* A station, or the end of the trace, between two points. */
typedef struct {
  double approach;
  po_point_kind kind;
} between;

static int by_approach(const void *left, const void *right) {
  const double a = ((const between *)left)->approach, b = ((const between *)right)->approach;
  return (a > b) - (a < b);
}

/* The station of the load between two approaches without an extremum between them, if there is one.
 * Returned: the number of stations. */
static size_t find_load(rigid_tracer *t, double from, double to, between *found) {
  if (isnan(t->options->station_load) || !(beyond_load(from, t) * beyond_load(to, t) < 0.0))
    return 0;
  *found = (between){po_root(beyond_load, t, from, to), PO_POINT_STATION_LOAD};
  return 1;
}

/* Visits the stations and the extremum of the load between two points, in their order. */
static void visit_between(rigid_tracer *t, const po_branch_point *from, const po_branch_point *to) {
  between found[PO_STATIONS + 3];
  size_t count = 0;
  double before = from->approach; /* the extremum, if there is one */
  for (size_t k = 0; k < PO_STATIONS; ++k) {
    const double station = t->options->station[k];
    if (station > from->approach && station <= to->approach)
      found[count++] = (between){station, PO_POINT_STATION};
  }
  if (from->load_rate * to->load_rate < 0.0) {
    before = po_root(rate_at, t, from->approach, to->approach);
    count += find_load(t, from->approach, before, &found[count]);
    found[count++] =
        (between){before, from->load_rate < 0.0 ? PO_POINT_LOAD_MIN : PO_POINT_LOAD_MAX};
  }
  count += find_load(t, before, to->approach, &found[count]);
  qsort(found, count, sizeof *found, by_approach);
  for (size_t k = 0; k < count; ++k) {
    const po_branch_point point = solve(t, found[k].approach, found[k].kind);
    visit(t, &point);
  }
}

po_status po_rigid_trace(const po_scene *scene, double begin,
                         const po_continuation_options *options) {
  po_status status = PO_OK;
  rigid_tracer t = {.scene = scene, .options = options, .begin = begin, .status = &status};
  const double end = options->end;
  const double closest = -po_law_numbers_of(&scene->law)->closest;
  if (!(end < closest))
    return po_fail(
        PO_BAD_INPUT,
        "approach_end is %g: expected less than %g, the greatest approach of rigid bodies", end,
        closest);
  po_branch_point from = solve(&t, begin, PO_POINT_STEP);
  visit(&t, &from);
  while (!t.ended && !status && from.approach < end) {
    double step = po_law_size(&scene->law, -from.approach) * (1.0 - STEP_RATIO);
    po_branch_point to = solve(&t, fmin(from.approach + step, end), PO_POINT_STEP);
    while (!status && po_join_sagitta(&from, &to) > options->largest_sagitta) {
      step *= 0.5;
      to = solve(&t, fmin(from.approach + step, end), PO_POINT_STEP);
    }
    visit_between(&t, &from, &to);
    visit(&t, &to);
    from = to;
  }
  return status;
}
