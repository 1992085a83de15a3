/* A profile read from a table of radii and gaps.
 *
 * Between the rows the gap is a cubic spline with continuous second derivative (not-a-knot at both
 * ends). Where the rows rise or fall over three successive intervals, at the ends over two, its
 * slopes are limited by the filter of Hyman (SIAM J. Sci. Stat. Comput. 4 (1983) 645), so that the
 * spline rises or falls with them. If the rows have noise, the spline does not pass through them:
 * it is a smoothing spline (po_smoothing.h), whose knots are then the rows. Beyond the last row the
 * gap is continued by the power of the radius with the same value and slope. */
#ifndef PO_PROFILE_TABLE_H
#define PO_PROFILE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_digest.h"
#include "po_smoothing.h"
#include "po_status.h"

typedef struct po_profile_table {
  char *path;     /* as it was given */
  double scale;   /* the unit of the file, eps; 1 m if the names of its columns have units */
  bool in_metres; /* whether they have */
  double smooth;  /* standard deviation of the noise in the unit of the file; INFINITY: it is
                     estimated; NAN: none */
  char digest[PO_DIGEST_LENGTH];
  uint64_t pipe; /* from which it was read (po_path_pipe); 0: a file */
  size_t rows;
  double *r, *gap; /* rows: ascending from 0; gap less that at r = 0 */
  double *slope;   /* rows: of the spline */
  double *beyond;  /* rows: a lower bound of the gap from this row on */
  double *least;   /* rows: the least of the gaps of this row and of those that follow */
  double growth;   /* the power of the continuation */
  double detail;   /* the smallest interval; INFINITY if the spline rises everywhere */
  bool is_convex;
  double uncertainty; /* greatest difference between this spline and those without the rows of odd
                         and of even number; greatest standard uncertainty of a smoothing spline;
                         eps */
  po_smoothing smoothing;        /* of rows with noise, eps; no knots: none */
  double *measured;              /* the radii of the rows with noise */
  struct po_profile_table *thin; /* fewer knots (po_profile_thin.h), only r, gap, slope and growth
                                    are set; NULL: all rows are needed */
  struct po_profile_table *next;
} po_profile_table;

/* Reads a table, or finds it among those that were read: a file (po_csv.h) with the columns `r`
 * and `gap`. Given: their unit in epsilon, 1 m if their names have units; smooth, as above. A file
 * that was read with the same bytes and numbers gives the same table, and so does a pipe that can
 * be read only once. The table stays in memory until the program ends, so that scenes can be
 * copied. Thread-safe. Status: PO_CANNOT_READ, with file and line, if the file cannot be read, a
 * number is not finite, r does not start at 0 or does not rise, there are fewer than 8 rows, the
 * rows are too far from each other or too near, or the gap or its spline does not rise at the end;
 * PO_NO_MEMORY.
 */
po_status po_profile_table_read(const char *path, double scale, double smooth,
                                const po_profile_table **table);

/* The number of rows of the file. */
size_t po_profile_table_points(const po_profile_table *table);

/* Other splines that the rows of a table without noise allow as well. */
typedef enum {
  PO_WITHOUT_ODD,  /* without the rows of odd number, but for the last one; the first is row 0 */
  PO_WITHOUT_EVEN, /* without those of even number, but for the first and the last one */
  PO_ROUND_APEX,   /* through all rows and level on the axis, as a body without a tip is */
  PO_READINGS
} po_reading;

/* Reads the rows of a table again, to be passed to po_profile_table_free. Status: PO_NO_MEMORY. */
po_status po_profile_table_read_again(const po_profile_table *table, po_reading reading,
                                      po_profile_table **again);

/* A radius, eps, and the weight of the gap there. */
typedef struct {
  double r, weight;
} po_gap_weight;

/* The standard deviation that noise causes in the sum of weight times gap over some radii. Given: a
 * smoothed table; weights, count. Returned: deviation; change, 2 rows, of the gaps and then of
 * the slopes: the most probable one by which the sum grows by the deviation. Status: PO_NO_MEMORY.
 */
po_status po_profile_table_noise(const po_profile_table *table, size_t count,
                                 const po_gap_weight *weights, double *deviation, double *change);

/* A smoothed table whose gaps and slopes are changed by a multiple of such a change, to be passed
 * to po_profile_table_free. Status: PO_NO_MEMORY. */
po_status po_profile_table_displace(const po_profile_table *table, const double *change,
                                    double multiple, po_profile_table **displaced);
void po_profile_table_free(po_profile_table *table);

/* Releases all tables that were read. No profile set from one may be used after it. */
void po_profile_table_clear(void);

#endif
