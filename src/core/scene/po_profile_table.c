#include "po_profile_table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_hermite.h"
#include "po_lock.h"
#include "po_memory.h"
#include "po_profile_columns.h"
#include "po_profile_kind.h"
#include "po_profile_thin.h"

/* A spline of every other row needs four rows. */
enum { LEAST_ROWS = 8 };

/* If the spline without some of the rows differs by more than this part of the distance between the
 * bodies, 1 + gap, the rows are too far apart, or too near to each other for their noise. */
static const double COARSEST = 0.1;

static po_status refuse(const po_csv *csv, size_t row, const char *what, double value,
                        const char *expected) {
  return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %g: expected %s", csv->path, csv->lines[row], what,
                 value, expected);
}

/* Change of the gap, relative to 1 + gap, by rounding of a row that is too large. */
static const double GREATEST_ROUNDING = 1e-9;

/* Two rows that are so near to each other that the rounding of their gaps decides the slope between
 * them are refused: by that slope the gap changes in the intervals beside. Given: the gap on the
 * axis, from which the others were subtracted. */
static po_status check_distances(const po_csv *csv, const po_profile_table *t, double axis) {
  const size_t last = t->rows - 1;
  for (size_t k = 1; k <= last; ++k) {
    const double here = t->r[k] - t->r[k - 1];
    const double before = k > 1 ? t->r[k - 1] - t->r[k - 2] : 0.0;
    const double after = k < last ? t->r[k + 1] - t->r[k] : 0.0;
    const double rounding = DBL_EPSILON * (fabs(t->gap[k]) + fabs(axis));
    if (rounding * fmax(before, after) > GREATEST_ROUNDING * (1.0 + fabs(t->gap[k])) * here)
      return refuse(csv, k, "the distance of r from that of the row before", here / t->scale,
                    "a distance at which rounding does not decide the slope: one row in place of "
                    "both");
  }
  return PO_OK;
}

static po_status allocate_rows(po_profile_table *t, size_t rows) {
  t->rows = rows;
  t->r = po_allocate(rows, sizeof *t->r);
  t->gap = po_allocate(rows, sizeof *t->gap);
  t->slope = po_allocate(rows, sizeof *t->slope);
  t->beyond = po_allocate(rows, sizeof *t->beyond);
  t->least = po_allocate(rows, sizeof *t->least);
  return t->r && t->gap && t->slope && t->beyond && t->least ? PO_OK : PO_NO_MEMORY;
}

static po_status read_rows(const po_csv *csv, const po_profile_columns *columns,
                           po_profile_table *t) {
  const int least = isnan(t->smooth) ? LEAST_ROWS : PO_SMOOTHING_LEAST;
  if (csv->row_count < (size_t)least)
    return po_fail(PO_CANNOT_READ, "%s: %zu rows are too few for a %sprofile: expected at least %d",
                   csv->path, csv->row_count, isnan(t->smooth) ? "" : "smoothed ", least);
  po_status status = allocate_rows(t, csv->row_count);
  for (size_t k = 0; k < t->rows && !status; ++k) {
    status = po_csv_number(csv, k, (size_t)columns->r, &t->r[k]);
    if (!status)
      status = po_csv_number(csv, k, (size_t)columns->gap, &t->gap[k]);
    if (status)
      return status;
    const double given = t->r[k];
    t->r[k] *= t->scale * columns->r_factor;
    t->gap[k] *= t->scale * columns->gap_factor;
    if (!isfinite(t->r[k]) || !isfinite(t->gap[k]))
      return refuse(csv, k, "the scale", t->scale, "one with which r and gap are finite");
    if (k == 0 && t->r[0] != 0.0)
      return refuse(csv, k, "the first r", given, "0");
    if (k > 0 && !(t->r[k] > t->r[k - 1]))
      return refuse(csv, k, "r", given, "more than in the row before");
  }
  return status;
}

/* Makes the gaps relative to that on the axis. */
static po_status begin_on_axis(const po_csv *csv, po_profile_table *t) {
  const double axis = t->gap[0];
  const size_t last = t->rows - 1;
  for (size_t k = 0; k <= last; ++k)
    t->gap[k] -= axis;
  if (!(t->gap[last] > 0.0 && t->gap[last] > t->gap[last - 1]))
    return refuse(csv, csv->row_count - 1, "the last gap, less that on the axis,",
                  t->gap[last] / t->scale, "more than in the row before, and more than 0");
  return check_distances(csv, t, axis);
}

/* The slopes of the spline, limited. */
static po_status slopes_of(size_t rows, const double *r, const double *gap, double *slope) {
  const po_status status = po_spline_slopes(rows, r, gap, slope);
  if (!status)
    po_spline_limit(rows, r, gap, slope);
  return status;
}

static double value_between(const double *r, const double *gap, const double *slope, size_t k,
                            double at) {
  return po_hermite_value(gap[k], slope[k], gap[k + 1], slope[k + 1], at - r[k], r[k + 1] - r[k]);
}

/* A row is left out by a comparison if its number is odd, or even; the first and the last stay. */
static bool is_left_out(const po_profile_table *t, size_t row, size_t odd) {
  return row > 0 && row + 1 < t->rows && row % 2 == odd;
}

/* Compares the spline with that without the rows that are left out, at these rows and at the thirds
 * of the intervals, where a wrong slope at their ends matters most: two rows that are near to each
 * other decide it. */
static po_status compare_without(const po_csv *csv, po_profile_table *t, size_t odd) {
  double *room = po_allocate(3 * t->rows, sizeof *room);
  if (!room)
    return PO_NO_MEMORY;
  double *const r = room, *const gap = room + t->rows, *const slope = room + 2 * t->rows;
  size_t kept = 0;
  for (size_t k = 0; k < t->rows; ++k)
    if (!is_left_out(t, k, odd)) {
      r[kept] = t->r[k];
      gap[kept++] = t->gap[k];
    }
  po_status status = slopes_of(kept, r, gap, slope);
  size_t c = 0;
  for (size_t k = 0; k + 1 < t->rows && !status; ++k) {
    double difference = 0.0;
    for (int third = 1; third < 3; ++third) {
      const double at = t->r[k] + third * (t->r[k + 1] - t->r[k]) / 3.0;
      difference = fmax(difference, fabs(value_between(r, gap, slope, c, at) -
                                         value_between(t->r, t->gap, t->slope, k, at)));
    }
    if (is_left_out(t, k + 1, odd))
      difference =
          fmax(difference, fabs(value_between(r, gap, slope, c, t->r[k + 1]) - t->gap[k + 1]));
    else
      ++c;
    t->uncertainty = fmax(t->uncertainty, difference);
    if (difference > COARSEST * (1.0 + fabs(t->gap[k + 1])))
      status =
          refuse(csv, is_left_out(t, k, odd) ? k : k + 1,
                 "without this row the gap changes; the change, in epsilon,", difference,
                 "less than a tenth of 1 + gap: rows at more equal distances, or, if the rows have "
                 "noise, smooth with its standard deviation or auto");
  }
  free(room);
  return status;
}

/* The slope at the end, with which the gap is continued. */
static po_status check_end(const po_csv *csv, const po_profile_table *t) {
  const size_t last = t->rows - 1;
  if (t->slope[last] > 0.0)
    return PO_OK;
  return refuse(csv, csv->row_count - 1, "the slope of the spline at the last r", t->slope[last],
                "more than 0, by rows nearer to each other at the end");
}

/* The least of the four Bezier points of a cubic, a lower bound of it. */
static double least_between(const po_profile_table *t, size_t k) {
  const double third = (t->r[k + 1] - t->r[k]) / 3.0;
  return fmin(fmin(t->gap[k], t->gap[k + 1]),
              fmin(t->gap[k] + third * t->slope[k], t->gap[k + 1] - third * t->slope[k + 1]));
}

/* The least slope of a cubic, times a third of the length of its interval: how far it falls, at
 * most twice. The slope is a parabola with the Bezier points s0, 3 chord - s0 - s1 and s1. */
static double steepest_fall(const po_profile_table *t, size_t k) {
  const double h = t->r[k + 1] - t->r[k], s0 = t->slope[k], s1 = t->slope[k + 1];
  const double middle = 3.0 * (t->gap[k + 1] - t->gap[k]) / h - s0 - s1;
  double least = fmin(s0, s1);
  if (middle < least)
    least = (s0 * s1 - middle * middle) / ((s0 - middle) + (s1 - middle));
  return fmax(-least, 0.0) * h / 3.0;
}

static double second_derivative(const po_profile_table *t, size_t k, bool at_end) {
  const double h = t->r[k + 1] - t->r[k], chord = (t->gap[k + 1] - t->gap[k]) / h;
  return at_end ? (2.0 * t->slope[k] + 4.0 * t->slope[k + 1] - 6.0 * chord) / h
                : (6.0 * chord - 4.0 * t->slope[k] - 2.0 * t->slope[k + 1]) / h;
}

/* Part of the second derivative of a parabola with the same end that counts as rounding. */
static const double ROUNDED = 1e-6;

/* Part of the last gap that counts as rounding where the gap falls. */
static const double ROUNDED_GAP = 1e-12;

static void derive_numbers(po_profile_table *t) {
  const size_t last = t->rows - 1;
  const double end = t->r[last];
  t->growth = end * t->slope[last] / t->gap[last];
  t->beyond[last] = t->least[last] = t->gap[last];
  t->detail = INFINITY;
  t->is_convex = true;
  const double rounding = ROUNDED * t->gap[last] / (end * end);
  const double dip = ROUNDED_GAP * t->gap[last];
  double narrowest = INFINITY;
  for (size_t k = last; k-- > 0;) {
    const double least = least_between(t, k);
    t->beyond[k] = fmin(least, t->beyond[k + 1]);
    t->least[k] = fmin(t->gap[k], t->least[k + 1]);
    narrowest = fmin(narrowest, t->r[k + 1] - t->r[k]);
    if (steepest_fall(t, k) > dip)
      t->detail = 0.0;
    if (second_derivative(t, k, false) < -rounding || second_derivative(t, k, true) < -rounding)
      t->is_convex = false;
  }
  if (t->detail == 0.0)
    t->detail = narrowest;
}

void po_profile_table_free(po_profile_table *t) {
  if (!t)
    return;
  free(t->path);
  free(t->r);
  free(t->gap);
  free(t->slope);
  free(t->beyond);
  free(t->least);
  free(t->measured);
  po_profile_table_free(t->thin);
  po_smoothing_free(&t->smoothing);
  free(t);
}

/* The spline on fewer knots, if few are enough. */
static po_status thin_rows(po_profile_table *t) {
  if (t->rows <= PO_THIN_LEAST)
    return PO_OK;
  size_t *const kept = po_allocate(t->rows, sizeof *kept);
  po_profile_table *const thin = t->thin = po_allocate(1, sizeof *thin);
  po_status status = kept && thin ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = allocate_rows(thin, po_profile_thin(t, kept));
  for (size_t k = 0; !status && k < thin->rows; ++k) {
    thin->r[k] = t->r[kept[k]];
    thin->gap[k] = t->gap[kept[k]];
    thin->slope[k] = t->slope[kept[k]];
  }
  if (!status)
    thin->growth = t->growth;
  free(kept);
  return status;
}

/* Derives all that follows from the rows and the slopes. */
static po_status derive(po_profile_table *t) {
  derive_numbers(t);
  return thin_rows(t);
}

/* A stated deviation that is wrong by more than this factor is refused. */
static const double MOST_WRONG = 3.0;

static po_status check_deviation(const po_profile_table *t) {
  const double residual = t->smoothing.residual / t->scale;
  if (isinf(t->smooth) ||
      (residual <= MOST_WRONG * t->smooth && t->smooth <= MOST_WRONG * residual))
    return PO_OK;
  return po_fail(PO_CANNOT_READ,
                 "%s: smooth is %g, but the rows are off the smoothing spline by %.3g, both in %s: "
                 "expected a deviation within a factor of 3 of that, or auto",
                 t->path, t->smooth, residual, t->in_metres ? "m" : "the unit of the file");
}

/* Puts the smoothing spline in the place of the rows. */
static po_status smooth_rows(po_profile_table *t) {
  po_smoothing *s = &t->smoothing;
  const double deviation = isinf(t->smooth) ? (double)NAN : t->smooth * t->scale;
  po_status status = po_smoothing_make(t->rows, t->r, t->gap, deviation, s);
  if (!status)
    status = po_smoothing_uncertainty(s, &t->uncertainty);
  if (!status)
    status = check_deviation(t);
  if (status)
    return status;
  t->measured = t->r;
  free(t->gap);
  free(t->slope);
  free(t->beyond);
  free(t->least);
  t->gap = t->slope = t->beyond = t->least = NULL;
  status = allocate_rows(t, s->knots);
  if (status)
    return status;
  memcpy(t->r, s->knot, s->knots * sizeof *t->r);
  memcpy(t->gap, s->value, s->knots * sizeof *t->gap);
  memcpy(t->slope, s->slope, s->knots * sizeof *t->slope);
  return PO_OK;
}

/* The spline through all rows. */
static po_status join_rows(const po_csv *csv, po_profile_table *t) {
  po_status status = slopes_of(t->rows, t->r, t->gap, t->slope);
  if (!status)
    status = compare_without(csv, t, 1);
  return status ? status : compare_without(csv, t, 0);
}

static po_status make(const char *path, double scale, double smooth, const po_csv *csv,
                      const po_profile_columns *columns, po_profile_table **table) {
  po_profile_table *t = *table = po_allocate(1, sizeof *t);
  if (!t)
    return PO_NO_MEMORY;
  t->scale = scale;
  t->smooth = smooth;
  t->in_metres = columns->in_metres;
  memcpy(t->digest, csv->digest, sizeof t->digest);
  t->path = po_copy_text(path);
  po_status status = t->path ? read_rows(csv, columns, t) : PO_NO_MEMORY;
  if (!status && !isnan(smooth))
    status = smooth_rows(t);
  if (!status)
    status = begin_on_axis(csv, t);
  if (!status && isnan(smooth))
    status = join_rows(csv, t);
  if (!status)
    status = check_end(csv, t);
  if (!status)
    status = derive(t);
  if (!status)
    return PO_OK;
  po_profile_table_free(t);
  *table = NULL;
  return status;
}

size_t po_profile_table_points(const po_profile_table *t) {
  return t->smoothing.knots ? t->smoothing.points : t->rows;
}

/* A table with the numbers of another one, without rows. */
static po_status begin_copy(const po_profile_table *t, po_profile_table **copy) {
  po_profile_table *d = *copy = po_allocate(1, sizeof *d);
  if (!d)
    return PO_NO_MEMORY;
  *d = (po_profile_table){.scale = t->scale, .smooth = t->smooth, .uncertainty = t->uncertainty};
  memcpy(d->digest, t->digest, sizeof d->digest);
  d->path = po_copy_text(t->path);
  return d->path ? PO_OK : PO_NO_MEMORY;
}

/* Completes a copy, unless it failed. */
static po_status end_copy(po_status status, po_profile_table **copy) {
  if (!status)
    status = derive(*copy);
  if (!status)
    return PO_OK;
  po_profile_table_free(*copy);
  *copy = NULL;
  return status;
}

po_status po_profile_table_displace(const po_profile_table *t, const double *change,
                                    double multiple, po_profile_table **displaced) {
  po_status status = begin_copy(t, displaced);
  po_profile_table *d = *displaced;
  if (!status)
    status = allocate_rows(d, t->rows);
  for (size_t k = 0; k < t->rows && !status; ++k) {
    d->r[k] = t->r[k];
    d->gap[k] = t->gap[k] + multiple * (change[k] - change[0]);
    d->slope[k] = t->slope[k] + multiple * change[t->rows + k];
  }
  return end_copy(status, displaced);
}

/* The slopes of the spline that is level on the axis: that of the rows and their mirror images. */
static po_status level_slopes(po_profile_table *t) {
  const size_t last = t->rows - 1, count = 2 * last + 1;
  double *const r = po_allocate(3 * count, sizeof *r);
  if (!r)
    return PO_NO_MEMORY;
  double *const gap = r + count, *const slope = gap + count;
  for (size_t k = 0; k <= last; ++k) {
    r[last - k] = -t->r[k];
    r[last + k] = t->r[k];
    gap[last - k] = gap[last + k] = t->gap[k];
  }
  const po_status status = slopes_of(count, r, gap, slope);
  if (!status)
    memcpy(t->slope, slope + last, t->rows * sizeof *slope);
  t->slope[0] = 0.0;
  free(r);
  return status;
}

po_status po_profile_table_read_again(const po_profile_table *t, po_reading reading,
                                      po_profile_table **again) {
  po_status status = begin_copy(t, again);
  po_profile_table *d = *again;
  if (!status)
    status = allocate_rows(d, t->rows);
  size_t kept = 0;
  for (size_t k = 0; k < t->rows && !status; ++k)
    if (reading == PO_ROUND_APEX || !is_left_out(t, k, reading == PO_WITHOUT_ODD)) {
      d->r[kept] = t->r[k];
      d->gap[kept++] = t->gap[k];
    }
  if (!status) {
    d->rows = kept;
    status = reading == PO_ROUND_APEX ? level_slopes(d) : slopes_of(kept, d->r, d->gap, d->slope);
  }
  if (!status && !(d->slope[kept - 1] > 0.0)) /* the continuation needs it */
    d->slope[kept - 1] = t->slope[t->rows - 1];
  return end_copy(status, again);
}

/* All tables that were read. */
static po_profile_table *tables;

static bool has_numbers(const po_profile_table *t, const char *path, double scale, double smooth) {
  return strcmp(t->path, path) == 0 && t->scale == scale &&
         (t->smooth == smooth || (isnan(t->smooth) && isnan(smooth)));
}

/* The table that was read before from a file with these bytes, or without a file from this pipe. */
static const po_profile_table *find(const char *path, const po_csv *csv, uint64_t pipe,
                                    double scale, double smooth) {
  const po_profile_table *t = tables;
  while (t && !(has_numbers(t, path, scale, smooth) &&
                (csv ? strcmp(t->digest, csv->digest) == 0 : pipe && t->pipe == pipe)))
    t = t->next;
  return t;
}

static po_status read_table(const char *path, uint64_t pipe, double scale, double smooth,
                            const po_profile_table **table) {
  po_csv csv;
  po_profile_columns columns;
  po_profile_table *made;
  po_status status = po_profile_columns_read(path, &csv, &columns);
  if (status)
    return status;
  *table = find(path, &csv, pipe, scale, smooth);
  if (!*table) {
    status = make(path, scale, smooth, &csv, &columns, &made);
    if (!status) {
      made->pipe = pipe;
      made->next = tables;
      *table = tables = made;
    }
  }
  po_csv_clear(&csv);
  return status;
}

po_status po_profile_table_read(const char *path, double scale, double smooth,
                                const po_profile_table **table) {
  const uint64_t pipe = po_path_pipe(path);
  po_lock_take(PO_LOCK_TABLES);
  *table = find(path, NULL, pipe, scale, smooth);
  const po_status status = *table ? PO_OK : read_table(path, pipe, scale, smooth, table);
  po_lock_release(PO_LOCK_TABLES);
  return status;
}

void po_profile_table_clear(void) {
  po_lock_take(PO_LOCK_TABLES);
  while (tables) {
    po_profile_table *t = tables;
    tables = t->next;
    po_profile_table_free(t);
  }
  po_lock_release(PO_LOCK_TABLES);
}
