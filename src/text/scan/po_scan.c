#include "po_scan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_hermite.h"
#include "po_memory.h"
#include "po_order.h"
#include "po_smoothing.h"

/* Rows whose distances differ from their mean by less than this part of it are equidistant: a
 * coordinate with three digits after the comma is. */
static const double EQUIDISTANT = 0.02;

static void look_at_spacing(po_scan *s) {
  const double first = s->x[0];
  s->spacing = (s->x[s->rows - 1] - first) / (double)(s->rows - 1);
  s->is_equidistant = true;
  for (size_t k = 0; k < s->rows; ++k)
    if (fabs(s->x[k] - first - (double)k * s->spacing) > EQUIDISTANT * s->spacing)
      s->is_equidistant = false;
}

/* The sums of least squares with the Legendre polynomial of degree 2 over places t in [-1, 1],
 * which is orthogonal to a straight line if they are dense. */
static bool is_hollow(const po_scan *s) {
  const double middle = 0.5 * (s->x[0] + s->x[s->rows - 1]), half = s->x[s->rows - 1] - middle;
  double sum = 0.0;
  for (size_t k = 0; k < s->rows; ++k) {
    const double t = (s->x[k] - middle) / half;
    const double before = k ? s->x[k] - s->x[k - 1] : 0.0;
    const double after = k + 1 < s->rows ? s->x[k + 1] - s->x[k] : 0.0;
    sum += (before + after) * (3.0 * t * t - 1.0) * (s->z[k] - s->z[0]);
  }
  return sum > 0.0;
}

/* -- The axis and the tilt with which the sides differ least -- */

/* Equidistant values of the smoothing spline, in which both are sought. */
enum { PLACES = 4097 };

typedef struct {
  double step, value[PLACES];
} samples;

/* A row that is so many typical deviations from the spline is none of the others'. */
static const double OUTLIER = 8.0, NORMAL = 1.4826; /* the latter: deviation over median modulus */

static void find_outliers(po_scan *s, const double *removed) {
  double *const size = po_allocate(s->rows, sizeof *size);
  if (!size)
    return;
  for (size_t k = 0; k < s->rows; ++k)
    size[k] = fabs(removed[k]);
  qsort(size, s->rows, sizeof *size, po_order_ascending);
  const double most = OUTLIER * NORMAL * size[s->rows / 2];
  for (size_t k = 0; k < s->rows; ++k)
    if (fabs(removed[k]) > most && s->outliers++ == 0)
      s->outlier = s->x[k];
  free(size);
}

static po_status make_samples(po_scan *s, samples *q) {
  po_smoothing f;
  po_status status = po_smoothing_make(s->rows, s->x, s->z, NAN, &f);
  s->noise = f.deviation;
  if (!status)
    find_outliers(s, f.removed);
  q->step = (s->x[s->rows - 1] - s->x[0]) / (PLACES - 1);
  for (size_t k = 0; k < PLACES && !status; ++k) {
    const double x = s->x[0] + (double)k * q->step;
    size_t i = po_order_last_up_to(f.knot, f.knots, x);
    i = i + 1 < f.knots ? i : f.knots - 2;
    q->value[k] = po_hermite_value(f.value[i], f.slope[i], f.value[i + 1], f.slope[i + 1],
                                   x - f.knot[i], f.knot[i + 1] - f.knot[i]);
  }
  po_smoothing_free(&f);
  return status;
}

/* Differences of the two sides about an axis. */
typedef struct {
  double axis, tilt, squares;
} symmetry;

/* The greatest displacement of the axis from the highest point, relative to the scan and to the
 * shorter side. */
static const double REACH = 0.125, PART_OF_SIDE = 0.5;

static symmetry symmetry_about(const samples *q, size_t axis, size_t reach, bool tilts) {
  double products = 0.0, squares = 0.0, lengths = 0.0;
  for (size_t i = 1; i <= reach; ++i) {
    const double half = 0.5 * (q->value[axis + i] - q->value[axis - i]), r = (double)i * q->step;
    products += half * r;
    squares += half * half;
    lengths += r * r;
  }
  const double tilt = tilts ? products / lengths : 0.0;
  return (symmetry){(double)axis * q->step, tilt, squares - tilt * products};
}

/* The place, relative to place k, at which the parabola through the sums of squares about three
 * places is least. */
static double best_shift(const samples *q, size_t k, size_t reach, bool tilts) {
  const double before = symmetry_about(q, k - 1, reach, tilts).squares,
               here = symmetry_about(q, k, reach, tilts).squares,
               after = symmetry_about(q, k + 1, reach, tilts).squares;
  const double bend = before - 2.0 * here + after;
  return bend > 0.0 ? fmin(fmax(0.5 * (before - after) / bend, -0.5), 0.5) : 0.0;
}

/* The symmetry with a tilt at a shift from place k, by parabolas through three places. */
static symmetry shifted(const samples *q, size_t k, size_t reach, double shift) {
  const symmetry before = symmetry_about(q, k - 1, reach, true),
                 here = symmetry_about(q, k, reach, true),
                 after = symmetry_about(q, k + 1, reach, true);
  const double bend = before.squares - 2.0 * here.squares + after.squares;
  return (symmetry){
      here.axis + shift * q->step, here.tilt + 0.5 * shift * (after.tilt - before.tilt),
      fmax(here.squares + 0.5 * shift * (after.squares - before.squares + shift * bend), 0.0)};
}

/* -- The rows about an axis -- */

/* The height at x: of equidistant rows that of the nearest one, otherwise on the straight line
 * between two, which has no more noise than a row. */
static double height_at(const po_scan *s, double x) {
  if (s->is_equidistant)
    return s->z[(size_t)fmin(fmax((x - s->x[0]) / s->spacing + 0.5, 0.0), (double)(s->rows - 1))];
  size_t k = po_order_last_up_to(s->x, s->rows, x);
  k = k + 1 < s->rows ? k : s->rows - 2;
  return s->z[k] + (s->z[k + 1] - s->z[k]) * ((x - s->x[k]) / (s->x[k + 1] - s->x[k]));
}

/* An axis on a row or midway between two, so that the rows of the sides are at the same radii. The
 * mean of both sides changes by half the square of the displacement times the change of curvature.
 */
static double axis_among_rows(const po_scan *s, double axis) {
  const double half = 0.5 * s->spacing;
  return s->is_equidistant ? s->x[0] + half * round((axis - s->x[0]) / half) : axis;
}

/* Radius of pair k about an axis. */
static double pair_radius(const po_scan *s, double axis, size_t k) {
  const double rows = (axis - s->x[0]) / s->spacing;
  const bool between = s->is_equidistant && fabs(rows - round(rows)) > 0.25;
  return s->spacing * ((double)k + (between ? 0.5 : 0.0));
}

/* The places among which the axis is sought, and how far the sides are compared. */
typedef struct {
  size_t first, last, reach;
} span;

/* The part of the height of the lower side, from the top, that counts as the top. */
static const double TOP = 0.3;

/* The middle of the places near the top: of a flat its middle, not the highest noise. */
static size_t middle_of_top(const samples *q) {
  double most = -INFINITY, sum = 0.0;
  size_t count = 0;
  for (size_t k = 0; k < PLACES; ++k)
    most = fmax(most, q->value[k]);
  const double level = most - TOP * (most - fmax(q->value[0], q->value[PLACES - 1]));
  for (size_t k = 0; k < PLACES; ++k)
    if (q->value[k] >= level) {
      sum += (double)k;
      ++count;
    }
  return (size_t)(sum / (double)count + 0.5);
}

static po_status find_span(const po_scan_request *request, const po_scan *s, const samples *q,
                           span *of) {
  const size_t top = middle_of_top(q);
  const size_t side = top < PLACES - 1 - top ? top : PLACES - 1 - top;
  const size_t window = (size_t)fmin(REACH * (double)(PLACES - 1), PART_OF_SIDE * (double)side);
  *of = (span){top - window, top + window, side - window};
  return of->reach > 2 && window > 1
             ? PO_OK
             : po_fail(PO_CANNOT_READ,
                       "%s: the %s part is at x = %g, the end of the scan: expected a scan across "
                       "the apex, or the other kind of apex",
                       request->path, s->is_lowest ? "lowest" : "highest",
                       s->x[0] + (double)top * q->step);
}

/* The axes at which the difference of the sides is least among their neighbours, and the one where
 * it is least without a tilt. */
enum { MOST_AXES = 256 };

typedef struct {
  symmetry level, tilted[MOST_AXES];
  size_t count;
} axes;

static void find_axes(const samples *q, const span *of, axes *found) {
  double least = INFINITY, before[2] = {INFINITY, INFINITY};
  size_t place = of->first + 1;
  found->count = 0;
  for (size_t k = of->first + 1; k < of->last; ++k) {
    const double flat = symmetry_about(q, k, of->reach, false).squares,
                 here = symmetry_about(q, k, of->reach, true).squares;
    if (flat < least) {
      least = flat;
      place = k;
    }
    if (before[1] <= before[0] && before[1] < here && k > of->first + 2 && found->count < MOST_AXES)
      found->tilted[found->count++] =
          shifted(q, k - 1, of->reach, best_shift(q, k - 1, of->reach, true));
    before[0] = before[1];
    before[1] = here;
  }
  found->level = shifted(q, place, of->reach, best_shift(q, place, of->reach, false));
}

/* A tilt is removed if the rms of the difference of the sides halves by it and its square falls by
 * so many variances of a half difference: 5 standard deviations of one parameter. */
static const double LESS_SQUARES = 4.0, SIGNIFICANT = 25.0;

/* With a tilt a parabola with a wave is symmetric about every crest and every trough: of the axes
 * that are not significantly worse than the best, the one with the least tilt is taken. The squares
 * are those of the smoothing spline; the rows have noise beside. Given: the pairs of rows. */
static symmetry choose_axis(po_scan *s, const axes *found, double pairs, double places) {
  const double variance = 0.5 * s->noise * s->noise, noise = pairs * variance;
  double least = found->level.squares;
  for (size_t k = 0; k < found->count; ++k)
    least = fmin(least, found->tilted[k].squares);
  const double rows = pairs / places, smallest = noise + rows * least;
  const double greatest =
      fmax(LESS_SQUARES * smallest, smallest + SIGNIFICANT * fmax(variance, smallest / pairs));
  symmetry chosen = found->level;
  s->is_tilt_determined = noise + rows * chosen.squares > greatest;
  if (s->is_tilt_determined)
    chosen.tilt = INFINITY;
  for (size_t k = 0; k < found->count && s->is_tilt_determined; ++k)
    if (noise + rows * found->tilted[k].squares <= greatest &&
        fabs(found->tilted[k].tilt) < fabs(chosen.tilt))
      chosen = found->tilted[k];
  return chosen;
}

/* The slope on the axis of half the difference of the sides, s r + q r^2 by least squares. */
static double slope_about(const samples *q, size_t axis, size_t reach) {
  double r2 = 0.0, r3 = 0.0, r4 = 0.0, by_r = 0.0, by_r2 = 0.0;
  for (size_t i = 1; i <= reach; ++i) {
    const double half = 0.5 * (q->value[axis + i] - q->value[axis - i]), r = (double)i * q->step;
    by_r += half * r;
    by_r2 += half * r * r;
    r2 += r * r;
    r3 += r * r * r;
    r4 += r * r * r * r;
  }
  return (by_r * r4 - by_r2 * r3) / (r2 * r4 - r3 * r3);
}

/* The place nearest to `axis` at which the apex is level: there the sides of a body that is not
 * quite one of revolution begin with one slope. `axis`, if there is none. */
static double level_apex(const samples *q, const span *of, double axis) {
  double nearest = INFINITY, before = NAN;
  for (size_t k = of->first; k <= of->last; ++k) {
    const double here = slope_about(q, k, of->reach);
    if (before > 0.0 && here <= 0.0) {
      const double at = ((double)k - here / (here - before)) * q->step;
      nearest = fabs(at - axis) < fabs(nearest - axis) ? at : nearest;
    }
    before = here;
  }
  return isfinite(nearest) ? nearest : axis;
}

static po_status find_axis(const po_scan_request *request, po_scan *s) {
  samples *const q = po_allocate(1, sizeof *q);
  axes *const found = po_allocate(1, sizeof *found);
  span of;
  po_status status = q && found ? make_samples(s, q) : PO_NO_MEMORY;
  if (!status)
    status = find_span(request, s, q, &of);
  if (!status) {
    find_axes(q, &of, found);
    const double places = (double)of.reach;
    symmetry chosen = choose_axis(s, found, places * q->step / s->spacing, places);
    if (request->keeps_tilt)
      chosen = found->level;
    else if (!s->is_tilt_determined)
      chosen.axis = level_apex(q, &of, chosen.axis);
    s->axis = axis_among_rows(s, s->x[0] + chosen.axis);
    s->tilt = s->is_tilt_determined && !request->keeps_tilt ? chosen.tilt : 0.0;
    s->systematic = sqrt(chosen.squares / places);
    const double margin = 2.0 * q->step;
    if (chosen.axis < (double)of.first * q->step + margin ||
        chosen.axis > (double)of.last * q->step - margin)
      status = po_fail(PO_CANNOT_READ,
                       "%s: no axis was found about which the two sides agree: the best one, x = "
                       "%g, is where the search ends",
                       request->path, s->axis);
  }
  free(found);
  free(q);
  return status;
}

/* -- The sides -- */

/* Rounding of a radius, relative to the distance of rows. */
static const double ROUNDING = 1e-6;

/* The height on the axis: of a row there, otherwise by the even parabola through the means of the
 * first two pairs. */
static double height_on_axis(const po_scan *s, const double *mean) {
  return pair_radius(s, s->axis, 0) > 0.0 ? (9.0 * mean[0] - mean[1]) / 8.0 : height_at(s, s->axis);
}

static po_status fill_sides(po_scan *s, double end) {
  const bool between = pair_radius(s, s->axis, 0) > 0.0;
  const size_t most = s->rows + 2;
  s->r = po_allocate(most, sizeof *s->r);
  s->side[0] = po_allocate(most, sizeof *s->r);
  s->side[1] = po_allocate(most, sizeof *s->r);
  if (!s->r || !s->side[0] || !s->side[1])
    return PO_NO_MEMORY;
  s->count = between; /* the first row, on the axis, is filled in below */
  for (size_t k = 0; s->count < most; ++k) {
    const double r = pair_radius(s, s->axis, k);
    if (r > end + ROUNDING * s->spacing)
      break;
    s->r[s->count] = r;
    for (int side = 0; side < 2; ++side) {
      const double x = side ? r : -r;
      s->side[side][s->count] = height_at(s, s->axis + x) - s->tilt * x;
    }
    s->count += 1;
  }
  double mean[2];
  for (size_t k = 0; k < 2; ++k)
    mean[k] = 0.5 * (s->side[0][k + between] + s->side[1][k + between]);
  const double top = height_on_axis(s, mean);
  if (between)
    s->r[0] = 0.0, s->side[0][0] = s->side[1][0] = top;
  for (size_t k = 0; k < s->count; ++k)
    for (int side = 0; side < 2; ++side)
      s->side[side][k] = top - s->side[side][k];
  return PO_OK;
}

double po_scan_gap(const po_scan *s, po_scan_sides sides, size_t k) {
  return sides == PO_SIDES_BOTH ? 0.5 * (s->side[0][k] + s->side[1][k])
                                : s->side[sides == PO_SIDES_RIGHT][k];
}

/* Removes s r from half the difference of the sides, s r + q r^2 by least squares: what the
 * displacement of the axis to the rows leaves. */
static void level_sides(po_scan *s) {
  double r2 = 0.0, r3 = 0.0, r4 = 0.0, by_r = 0.0, by_r2 = 0.0;
  for (size_t k = 0; k < s->count; ++k) {
    const double half = 0.5 * (s->side[1][k] - s->side[0][k]), r = s->r[k];
    by_r += half * r;
    by_r2 += half * r * r;
    r2 += r * r;
    r3 += r * r * r;
    r4 += r * r * r * r;
  }
  const double slope = (by_r * r4 - by_r2 * r3) / (r2 * r4 - r3 * r3);
  for (size_t k = 0; k < s->count; ++k) {
    s->side[0][k] += slope * s->r[k];
    s->side[1][k] -= slope * s->r[k];
  }
}

/* The parabola c + r^2/(2 R) through the table, and by how much the sides differ. */
static void describe_scan(po_scan *s) {
  const double n = (double)s->count;
  double u = 0.0, g = 0.0, uu = 0.0, ug = 0.0, difference = 0.0, off = 0.0;
  for (size_t k = 0; k < s->count; ++k) {
    u += 0.5 * s->r[k] * s->r[k] / n;
    g += po_scan_gap(s, PO_SIDES_BOTH, k) / n;
  }
  for (size_t k = 0; k < s->count; ++k) {
    const double at = 0.5 * s->r[k] * s->r[k] - u;
    const double half = 0.5 * (s->side[0][k] - s->side[1][k]);
    uu += at * at;
    ug += at * (po_scan_gap(s, PO_SIDES_BOTH, k) - g);
    difference += half * half;
  }
  for (size_t k = 0; k < s->count; ++k) {
    const double rest =
        po_scan_gap(s, PO_SIDES_BOTH, k) - g - ug / uu * (0.5 * s->r[k] * s->r[k] - u);
    off += rest * rest;
  }
  s->radius = uu / ug;
  s->asymmetry = sqrt(difference / n);
  s->off_parabola = sqrt(off / n);
}

/* Rows of a table, with that on the axis. */
enum { LEAST_COUNT = 16 };

static po_status make_sides(const po_scan_request *request, po_scan *s) {
  const double shorter = fmin(s->axis - s->x[0], s->x[s->rows - 1] - s->axis);
  const bool cuts = !isnan(request->end);
  if (cuts && !(request->end > 0.0 && request->end <= shorter))
    return po_fail(PO_BAD_INPUT,
                   "end is %g: expected a radius up to %.6g, where the shorter side "
                   "of the scan ends",
                   request->end, shorter);
  const po_status status = fill_sides(s, cuts ? request->end : shorter);
  if (status)
    return status;
  if (s->count < LEAST_COUNT)
    return po_fail(PO_CANNOT_READ,
                   "%s: %zu rows on a side are too few: expected at least %d, of a scan whose "
                   "apex is not near its end",
                   request->path, s->count, LEAST_COUNT);
  if (!request->keeps_tilt)
    level_sides(s);
  describe_scan(s);
  return s->radius > 0.0
             ? PO_OK
             : po_fail(PO_CANNOT_READ,
                       "%s: the gap falls with the radius: expected the other kind of apex, or the "
                       "columns of position and height in this order",
                       request->path);
}

po_status po_scan_read(const po_scan_request *request, po_scan *s) {
  *s = (po_scan){.noise = NAN};
  po_status status = po_scan_read_rows(request, s);
  if (status)
    return status;
  look_at_spacing(s);
  s->is_lowest = request->apex == PO_APEX_AUTO ? is_hollow(s) : request->apex == PO_APEX_LOWEST;
  for (size_t k = 0; k < s->rows && s->is_lowest; ++k)
    s->z[k] = -s->z[k];
  status = find_axis(request, s);
  return status ? status : make_sides(request, s);
}

void po_scan_clear(po_scan *s) {
  free(s->x);
  free(s->z);
  free(s->r);
  free(s->side[0]);
  free(s->side[1]);
  *s = (po_scan){0};
}

double po_scan_gap_noise(const po_scan *s, po_scan_sides sides) {
  return sides == PO_SIDES_BOTH ? s->noise * M_SQRT1_2 : s->noise;
}

void po_scan_add_table(const po_scan *s, po_scan_sides sides, const char *made, po_text *text) {
  static const char *const SIDES[] = {"the mean of both sides", "the left side", "the right side"};
  const char *const unit[2] = {s->column[0].unit, s->column[1].unit};
  po_text_add(text, "# made_by: %s\n# sides: %s\n# noise: standard deviation of a gap %.3g%s%s\n",
              made, SIDES[sides], po_scan_gap_noise(s, sides), *unit[1] ? " " : "", unit[1]);
  po_text_add(text, "r%s%s,gap%s%s\n", *unit[0] ? "_" : "", unit[0], *unit[1] ? "_" : "", unit[1]);
  for (size_t k = 0; k < s->count; ++k)
    po_text_add(text, "%.12g,%.12g\n", s->r[k], po_scan_gap(s, sides, k));
}
