#include "po_curve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_elementary.h"
#include "po_memory.h"
#include "po_text.h"

/* A curve, the part of it that is compared, and the folds in that part. */
typedef struct {
  po_plane_curve curve;
  size_t first, last; /* indices of the first and the last compared point */
  size_t *folds;      /* indices of points at which the approach has an extremum */
  size_t fold_count;
} po_track;

/* Returned: the last point that can be compared: the one at which the approach first exceeds the
 * end of the other curve, if that end has the greatest approach of the other curve. On a wavy
 * sphere the approach of later points may be below it again. */
static size_t first_passage(const po_track *track, double end, const po_track *other) {
  for (size_t i = 0; i < other->curve.count; ++i)
    if (other->curve.points[i].approach > end)
      return track->curve.count - 1;
  for (size_t i = 0; i < track->curve.count; ++i)
    if (track->curve.points[i].approach > end)
      return i;
  return track->curve.count - 1;
}

/* Determines the compared part of a curve. The branch begins at large separation, with small
 * approach, and ends in contact, with large approach. Points before the start or beyond the end of
 * the other curve have no counterpart. Where the curve is steep, a point can lie beyond the end in
 * load rather than in approach, so the nearest point is tested as well. */
static void track_trim(po_track *track, const po_track *other) {
  const po_stretch whole = po_plane_whole(&other->curve);
  const double start = other->curve.points[0].approach,
               end = other->curve.points[other->curve.count - 1].approach;
  track->first = 0;
  track->last = first_passage(track, end, other);
  while (track->first < track->last &&
         (track->curve.points[track->first].approach < start ||
          po_plane_foot(po_plane_at(&track->curve, track->first), &whole).before))
    track->first += 1;
  while (track->last > track->first &&
         (track->curve.points[track->last].approach > end ||
          po_plane_foot(po_plane_at(&track->curve, track->last), &whole).beyond))
    track->last -= 1;
}

static po_status track_find_folds(po_track *track) {
  track->folds = po_allocate(track->curve.count, sizeof *track->folds);
  if (!track->folds)
    return PO_NO_MEMORY;
  double before = 0;
  for (size_t i = track->first; i < track->last; ++i) {
    const double step = track->curve.points[i + 1].approach - track->curve.points[i].approach;
    if (step * before < 0)
      track->folds[track->fold_count++] = i;
    if (step != 0)
      before = step;
  }
  return PO_OK;
}

static double chord(const po_track *track, size_t i) {
  const po_plane_point p = po_plane_at(&track->curve, i), q = po_plane_at(&track->curve, i + 1);
  return po_hypot(q.approach - p.approach, q.load - p.load);
}

/* Returned: the larger distance of the point of fold k from its neighbours. The true fold may lie
 * at this distance from the point. A fold is never the first or the last point. */
static double track_spacing(const po_track *track, size_t k) {
  return fmax(chord(track, track->folds[k] - 1), chord(track, track->folds[k]));
}

/* Returned: the stretch of `track` that is compared with stretch k of `other`: from fold k - 1 to
 * fold k of `track`; the first and the last stretch extend to the ends of the curve. The true fold
 * of either curve lies beside the point that is taken for it. Therefore the stretch is extended
 * over each fold by one element, and by further elements that cover the spacing of `other` at its
 * fold. The first element alone does not suffice, because it can be arbitrarily short. */
static po_stretch track_stretch(const po_track *track, const po_track *other, size_t k) {
  po_stretch stretch = po_plane_whole(&track->curve);
  if (k > 0) {
    double rest = track_spacing(other, k - 1);
    for (stretch.from = track->folds[k - 1] - 1; stretch.from > 0 && rest > 0; --stretch.from)
      rest -= chord(track, stretch.from - 1);
  }
  if (k < track->fold_count) {
    double rest = track_spacing(other, k);
    for (stretch.to = track->folds[k] + 1; stretch.to + 1 < track->curve.count && rest > 0;
         ++stretch.to)
      rest -= chord(track, stretch.to);
  }
  return stretch;
}

/* Returned: the number of the stretch to which point i belongs. */
static size_t track_stretch_of(const po_track *track, size_t i) {
  size_t k = 0;
  while (k < track->fold_count && i > track->folds[k])
    ++k;
  return k;
}

/* The distance of a point from a curve, less the uncertainty of the interpolation between the
 * points of the curve. Infinite if numbers are so large that the distance or the uncertainty is not
 * a number, as that is no evidence that the curves agree. */
static double excess(po_plane_point point, const po_stretch *stretch) {
  const po_foot foot = po_plane_foot(point, stretch);
  const double uncertainty = po_plane_uncertainty(&stretch->curve, foot.index);
  return isfinite(foot.distance) && isfinite(uncertainty) ? fmax(0.0, foot.distance - uncertainty)
                                                          : (double)INFINITY;
}

/* Finds the largest distance of the compared points of `a` from `b`; from the corresponding stretch
 * if the numbers of folds agree. If such a point is within the tolerance of another stretch, the
 * note reports a different branch. */
static void measure_distance(const po_track *a, const po_track *b, double tolerance,
                             po_curve_verdict *verdict) {
  for (size_t i = a->first; i <= a->last; ++i) {
    const po_plane_point point = po_plane_at(&a->curve, i);
    const po_stretch stretch = verdict->same_folds ? track_stretch(b, a, track_stretch_of(a, i))
                                                   : po_plane_whole(&b->curve);
    const double distance = excess(point, &stretch);
    if (distance > verdict->distance) {
      verdict->distance = distance;
      verdict->where = point;
    }
    if (distance > tolerance && verdict->same_folds && !verdict->note[0]) {
      const po_stretch whole = po_plane_whole(&b->curve);
      if (excess(point, &whole) <= tolerance)
        snprintf(verdict->note, sizeof verdict->note,
                 "different branch near approach %.4g, load %.4g", point.approach, point.load);
    }
  }
}

static double fold_distance(const po_track *a, size_t i, const po_track *b, size_t j) {
  const po_plane_point p = po_plane_at(&a->curve, a->folds[i]),
                       q = po_plane_at(&b->curve, b->folds[j]);
  return po_hypot(p.approach - q.approach, p.load - q.load);
}

/* If the numbers of folds differ: names the fold of the longer list that is furthest from all folds
 * of the other list. Folds come in pairs; the note names one of them and states both numbers. */
static void name_fold(const po_track *ours, const po_track *reference, po_curve_verdict *verdict) {
  const bool missing = reference->fold_count > ours->fold_count;
  const po_track *more = missing ? reference : ours, *fewer = missing ? ours : reference;
  double furthest = -1;
  size_t named = 0;
  for (size_t i = 0; i < more->fold_count; ++i) {
    double nearest = (double)INFINITY;
    for (size_t j = 0; j < fewer->fold_count; ++j)
      nearest = fmin(nearest, fold_distance(more, i, fewer, j));
    if (nearest > furthest) {
      furthest = nearest;
      named = i;
    }
  }
  const po_plane_point fold = po_plane_at(&more->curve, more->folds[named]);
  snprintf(verdict->note, sizeof verdict->note,
           "%s fold near approach %.4g, load %.4g (%zu %s, reference %zu)",
           missing ? "missing" : "spurious", fold.approach, fold.load, ours->fold_count,
           po_one_or_more(ours->fold_count, "fold", "folds"), reference->fold_count);
}

/* Finds the largest distance of points in no order from our curve. */
static void scatter(const po_plane_curve *ours, const po_plane_curve *points,
                    po_curve_verdict *verdict) {
  *verdict = (po_curve_verdict){.same_folds = true};
  if (ours->count < 2)
    return;
  const po_stretch whole = po_plane_whole(ours);
  for (size_t i = 0; i < points->count; ++i) {
    const po_plane_point point = po_plane_at(points, i);
    const po_foot foot = po_plane_foot(point, &whole);
    if (foot.before || foot.beyond) {
      verdict->left_out += 1;
      continue;
    }
    verdict->compared += 1;
    if (foot.distance >= verdict->distance) {
      verdict->distance = foot.distance;
      verdict->where = point;
    }
  }
}

po_status po_curve_compare(const po_plane_curve *ours, const po_plane_curve *reference,
                           bool ordered, double tolerance, po_curve_verdict *verdict) {
  *verdict = (po_curve_verdict){0};
  if (!ordered)
    scatter(ours, reference, verdict);
  if (!ordered || ours->count < 2 || reference->count < 2)
    return PO_OK;
  po_track a = {.curve = *ours}, b = {.curve = *reference};
  track_trim(&a, &b);
  track_trim(&b, &a);
  po_status status = PO_OK;
  if (a.last - a.first < 1 || b.last - b.first < 1)
    goto done;
  status = track_find_folds(&a);
  if (!status)
    status = track_find_folds(&b);
  if (status)
    goto done;
  verdict->compared = b.last - b.first + 1;
  verdict->left_out = reference->count - verdict->compared;
  verdict->same_folds = a.fold_count == b.fold_count;
  if (!verdict->same_folds)
    name_fold(&a, &b, verdict);
  measure_distance(&b, &a, tolerance, verdict);
  measure_distance(&a, &b, tolerance, verdict);
done:
  free(a.folds);
  free(b.folds);
  return status;
}
