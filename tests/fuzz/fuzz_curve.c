/* Curves: the first part of the input is a computed curve as a record stores it, the second a
 * reference with the columns approach,load. Each is compared with the other and with itself. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_csv.h"
#include "po_curve.h"
#include "po_memory.h"
#include "po_tables.h"

/* The time of a comparison is proportional to the product of the numbers of points. */
enum { MOST_POINTS = 400 };

/* For larger coordinates their products overflow, and the distance of a curve from itself may not
 * be 0. */
static const double HUGE_EXTENT = 1e100;

/* Reads the columns of a computed curve. A rate that is not known is nan. */
static po_status read_ours(const char *path, po_result *result) {
  static const struct {
    const char *name;
    size_t place;
  } COLUMNS[] = {{"approach", offsetof(po_curve_point, approach)},
                 {"load", offsetof(po_curve_point, load)},
                 {"position", offsetof(po_curve_point, position)},
                 {"approach_rate", offsetof(po_curve_point, approach_rate)},
                 {"load_rate", offsetof(po_curve_point, load_rate)}};
  po_csv csv;
  po_status status = po_csv_read(path, "ours.csv", &csv);
  if (status)
    return status;
  result->curve = po_allocate(csv.row_count, sizeof *result->curve);
  result->curve_count = csv.row_count;
  for (size_t c = 0; !status && c < sizeof COLUMNS / sizeof *COLUMNS; ++c) {
    const int column = po_csv_find_column(&csv, COLUMNS[c].name);
    status = column < 0 ? PO_NOT_FOUND : PO_OK;
    for (size_t r = 0; !status && r < csv.row_count; ++r) {
      double value = (double)NAN;
      if (c < 2 || strcmp(po_csv_cell(&csv, r, (size_t)column), "nan") != 0)
        status = po_csv_number(&csv, r, (size_t)column, &value);
      memcpy((char *)&result->curve[r] + COLUMNS[c].place, &value, sizeof value);
    }
  }
  po_csv_clear(&csv);
  if (status)
    po_result_clear(result);
  return status;
}

static po_status read_theirs(const char *path, po_curve_point **points, size_t *count) {
  po_csv csv;
  po_status status = po_csv_read(path, "theirs.csv", &csv);
  if (status)
    return status;
  const int approach = po_csv_find_column(&csv, "approach"),
            load = po_csv_find_column(&csv, "load");
  *points = po_allocate(csv.row_count, sizeof **points);
  *count = csv.row_count;
  if (approach < 0 || load < 0)
    status = PO_NOT_FOUND;
  for (size_t r = 0; !status && r < csv.row_count; ++r) {
    status = po_csv_number(&csv, r, (size_t)approach, &(*points)[r].approach);
    if (!status)
      status = po_csv_number(&csv, r, (size_t)load, &(*points)[r].load);
  }
  po_csv_clear(&csv);
  return status;
}

static void require_verdict(const po_curve_verdict *verdict, size_t points) {
  fuzz_require(verdict->distance >= 0, "curves are apart by %g", verdict->distance);
  fuzz_require(verdict->compared + verdict->left_out <= points, "%zu of %zu points are compared",
               verdict->compared, points);
  fuzz_require_words("a note", verdict->note, false);
}

/* The squares of smaller lengths underflow, so that distances have no meaning. */
static const double TINY_EXTENT = 1e-140;

/* The diagonal of the box around a curve. */
static double extent(const po_plane_curve *curve) {
  po_plane_point least = po_plane_at(curve, 0), most = least;
  for (size_t i = 1; i < curve->count; ++i) {
    least.approach = fmin(least.approach, curve->points[i].approach);
    least.load = fmin(least.load, curve->points[i].load);
    most.approach = fmax(most.approach, curve->points[i].approach);
    most.load = fmax(most.load, curve->points[i].load);
  }
  return fmax(fmax(fabs(least.approach), fabs(most.approach)),
              fmax(fabs(least.load), fabs(most.load)));
}

/* The distance of a curve from itself is 0. */
static void require_self(const po_plane_curve *curve) {
  po_curve_verdict verdict;
  if (curve->count < 2 || extent(curve) > HUGE_EXTENT || extent(curve) < TINY_EXTENT)
    return;
  fuzz_require(po_curve_compare(curve, curve, true, 1e-9, &verdict) == PO_OK,
               "a curve cannot be compared");
  require_verdict(&verdict, curve->count);
  fuzz_require(verdict.compared == 0 || verdict.same_folds, "a curve has other folds than itself");
  fuzz_require(verdict.distance <= 1e-12 * extent(curve), "a curve is %g from itself",
               verdict.distance);
}

/* A curve that is shifted by this multiple of its size differs from the original. Without rates the
 * uncertainty of its interpolation is less than a hundred times its size. */
static const double ASIDE = 1000;

static void require_apart(const po_plane_curve *curve) {
  po_curve_verdict verdict;
  const double size = extent(curve);
  po_curve_point *moved = po_allocate(curve->count, sizeof *moved);
  for (size_t i = 0; i < curve->count; ++i)
    moved[i] = (po_curve_point){.approach = curve->points[i].approach,
                                .load = curve->points[i].load + ASIDE * size};
  const po_plane_curve other = {.points = moved, .count = curve->count};
  if (curve->count >= 2 && size >= TINY_EXTENT) {
    fuzz_require(po_curve_compare(curve, &other, true, 0, &verdict) == PO_OK,
                 "a curve cannot be compared");
    require_verdict(&verdict, curve->count);
    fuzz_require(verdict.compared == 0 || verdict.distance > 0,
                 "a curve is the same as one that is moved by %g", ASIDE * size);
  }
  free(moved);
}

static void compare(const po_result *result, const po_plane_curve *theirs) {
  const size_t count = result->curve_count;
  po_curve_verdict verdict;
  const po_plane_curve plain = {.points = result->curve, .count = count};
  const po_plane_curve ours = {result->curve, count, true};
  if (count > 0) {
    require_self(&plain);
    require_apart(&plain);
  }
  fuzz_require(po_curve_compare(&ours, theirs, true, 1e-3, &verdict) == PO_OK,
               "curves cannot be compared");
  require_verdict(&verdict, theirs->count);
  fuzz_require(po_curve_compare(&ours, theirs, false, 1e-3, &verdict) == PO_OK,
               "curves cannot be compared");
  require_verdict(&verdict, theirs->count);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part parts[2] = {{NULL, 0}, {NULL, 0}};
  const size_t count = fuzz_split(data, size, parts, 2);
  const char *ours = fuzz_path("curve.csv"), *theirs = fuzz_path("theirs.csv");
  po_result result = {0};
  po_curve_point *points = NULL;
  size_t point_count = 0;
  fuzz_write(ours, parts[0].bytes, parts[0].size);
  fuzz_write(theirs, parts[1].bytes, count > 1 ? parts[1].size : 0);
  if (read_ours(ours, &result) == PO_OK && read_theirs(theirs, &points, &point_count) == PO_OK &&
      result.curve_count <= MOST_POINTS && point_count <= MOST_POINTS) {
    const po_plane_curve reference = {.points = points, .count = point_count};
    compare(&result, &reference);
  }
  po_message_clear();
  free(points);
  po_result_clear(&result);
  free(parts[0].bytes);
  return 0;
}
