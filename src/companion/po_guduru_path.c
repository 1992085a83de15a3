#include "po_guduru_path.h"

#include <math.h>
#include <stdlib.h>

#include "po_guduru.h"
#include "po_memory.h"
#include "po_quadrature.h"
#include "po_root.h"

/* PATH_POINTS_PER_WAVE: points of the curve in a wavelength. RULE: points of the Gauss rule for the
 * energy between two of them. MOST_LENGTHS: extensions of the curve, at most. */
enum { PATH_POINTS_PER_WAVE = 128, RULE = 8, MOST_LENGTHS = 10 };
/* The largest ratio of successive contact radii in the first wavelength. */
static const double RATIO = 1.05;
/* While the curve is too short, it is computed again up to a contact radius that is larger by this
 * factor. */
static const double LONGER = 1.6;
/* Two loads that differ by less, relatively, are the same. */
static const double SAME = 1e-9;

typedef struct {
  const po_scene *scene;
  po_path_point *point;
  size_t count, room;
  double node[RULE], weight[RULE];
  double energy, last; /* the energy at contact radius `last` */
} builder;

static double approach_rate(double a, const void *scene) {
  return po_guduru_approach_rate(scene, a);
}

static double load_rate(double a, const void *scene) {
  return po_guduru_load_rate(scene, a);
}

static po_status append(builder *b, po_path_point point) {
  if (b->count == b->room) {
    const size_t room = b->room ? 2 * b->room : 1024;
    po_path_point *moved = po_resize(b->point, room, sizeof *moved);
    if (!moved)
      return PO_NO_MEMORY;
    b->point = moved;
    b->room = room;
  }
  b->point[b->count++] = point;
  return PO_OK;
}

/* Appends the equilibrium of contact radius a. The energy is integrated from the previous one with
 * the Gauss rule. */
static po_status append_contact(builder *b, double a) {
  const double step = a - b->last;
  for (int k = 0; k < RULE; ++k) {
    const double s = b->last + step * b->node[k];
    b->energy += step * b->weight[k] * po_guduru_at(b->scene, s).load * approach_rate(s, b->scene);
  }
  b->last = a;
  const po_contact c = po_guduru_at(b->scene, a);
  return append(b, (po_path_point){.approach = c.approach,
                                   .load = c.load,
                                   .energy = b->energy,
                                   .approach_rate = approach_rate(a, b->scene),
                                   .load_rate = load_rate(a, b->scene),
                                   .contact_radius = a,
                                   .position = a});
}

/* Appends the folds and extrema between two contact radii in order, then the second contact
 * radius. */
static po_status append_up_to(builder *b, double left, double right) {
  const double fold = po_root(approach_rate, b->scene, left, right);
  const double extremum = po_root(load_rate, b->scene, left, right);
  /* NaN if there is none; fmin and fmax then return the other */
  const double first = fmin(fold, extremum), second = fmax(fold, extremum);
  po_status status = PO_OK;
  if (first > left && first < right)
    status = append_contact(b, first);
  if (!status && second > first && second < right)
    status = append_contact(b, second);
  return status ? status : append_contact(b, right);
}

/* Sets the stability and the minima of all points: an equilibrium is stable at fixed approach where
 * the approach increases with the contact radius. */
static void mark_points(builder *b) {
  for (size_t k = 0; k + 1 < b->count; ++k) {
    po_path_point *p = &b->point[k];
    p->unstable_modes = p[1].approach <= p->approach;
    p->minimum = k > 0 && p->load < p[-1].load && p->load < p[1].load;
  }
}

static po_status build(builder *b, double end) {
  const double gamma = po_scene_gamma(b->scene);
  const double wave = po_scene_is_wavy(b->scene) ? fmin(b->scene->wavelength, gamma) : gamma;
  po_status status = po_gauss_rule(RULE, b->node, b->weight);
  if (!status) /* the separated bodies; the approach is set below */
    status = append(b, (po_path_point){.position = -1.0});
  if (!status)
    status = append(b, (po_path_point){.position = 0.0});
  if (!status) /* the first contact again, with the derivatives for positions above 0 */
    status = append(b, (po_path_point){.approach_rate = -1.0});
  double left = PO_GUDURU_FIRST * wave;
  if (!status)
    status = append_contact(b, left);
  while (left < end && !status) {
    const double right = fmin(RATIO * left, left + wave / PATH_POINTS_PER_WAVE);
    status = append_up_to(b, left, right);
    left = right;
  }
  double least = 0.0;
  for (size_t k = 0; k < b->count; ++k)
    least = fmin(least, b->point[k].approach);
  if (!status) {
    b->point[0].approach = 2.0 * least;
    b->point[0].approach_rate = b->point[1].approach_rate = -2.0 * least; /* by the position */
    mark_points(b);
  }
  return status;
}

po_status po_guduru_path(const po_scene *scene, double end, po_path_point **point, size_t *count) {
  builder b = {.scene = scene};
  const po_status status = build(&b, end);
  if (status)
    free(b.point);
  *point = status ? NULL : b.point;
  *count = status ? 0 : b.count;
  return status;
}

/* Returned: whether some preload gives the lowest load of the curve. */
static bool reaches_load(const po_staircase *staircase, double load) {
  const po_step *step = po_staircase_greatest(staircase);
  return step && step->pull_off.load <= load * (1.0 - SAME);
}

po_status po_guduru_staircases(const po_scene *scene, po_staircase staircase[2]) {
  po_path_point *point = NULL;
  po_path path = {NULL, 0};
  staircase[0] = (po_staircase){.control = PO_DISPLACEMENT_CONTROL};
  staircase[1] = (po_staircase){.control = PO_LOAD_CONTROL};
  if (!(scene->tabor > 0.0))
    return po_fail(PO_BAD_INPUT, "tabor is %g: expected a number > 0 for the JKR theory",
                   scene->tabor);
  const po_contact least = po_guduru_pull_off(scene);
  double end = 2.0 * fmax(least.contact_radius, po_scene_gamma(scene));
  po_status status = PO_OK;
  for (int k = 0; k < MOST_LENGTHS && !status; ++k, end *= LONGER) {
    po_staircase_clear(&staircase[0]);
    po_staircase_clear(&staircase[1]);
    status = po_guduru_path(scene, end, &point, &path.count);
    path.point = point;
    for (int c = 0; c < 2 && !status; ++c)
      status = po_staircase_read(&path, staircase[c].control, &staircase[c]);
    free(point);
    if (reaches_load(&staircase[0], least.load) && reaches_load(&staircase[1], least.load))
      break;
  }
  return status;
}

po_status po_guduru_hysteresis(const po_scene *scene, po_preload preload,
                               po_hysteresis *hysteresis) {
  *hysteresis = (po_hysteresis){.load = {.control = PO_LOAD_CONTROL}};
  if (!(scene->tabor > 0.0))
    return po_fail(PO_BAD_INPUT, "tabor is %g: expected a number > 0 for the JKR theory",
                   scene->tabor);
  const double waves = po_scene_is_wavy(scene) ? 2.0 * scene->wavelength : 0.0;
  double end = 4.0 * po_scene_gamma(scene) + waves;
  if (preload.approach > 0.0)
    end += sqrt(2.0 * preload.approach * scene->radius);
  po_status status = PO_NOT_FOUND;
  for (int k = 0; k < MOST_LENGTHS && status == PO_NOT_FOUND; ++k, end *= LONGER) {
    po_path_point *point = NULL;
    po_path path = {NULL, 0};
    status = po_guduru_path(scene, end, &point, &path.count);
    path.point = point;
    if (!status)
      status = po_hysteresis_follow(&path, preload, hysteresis);
    free(point);
  }
  return status;
}
