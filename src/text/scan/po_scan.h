/* A line scan across the apex of a body, as profilers and microscopes export it, and the initial
 * gap of the body of revolution that follows from it. */
#ifndef PO_SCAN_H
#define PO_SCAN_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"
#include "po_text.h"

/* The apex is the highest or the lowest point of the scan, or the one of the two that the curvature
 * of the whole scan tells. */
typedef enum { PO_APEX_AUTO, PO_APEX_HIGHEST, PO_APEX_LOWEST } po_scan_apex;

/* The part of the scan of which a table is made. */
typedef enum { PO_SIDES_BOTH, PO_SIDES_LEFT, PO_SIDES_RIGHT } po_scan_sides;

typedef struct {
  const char *path;
  const char *columns; /* "X,Z": names or numbers, from 1; NULL: the first two */
  const char *units;   /* "um,nm"; NULL: those in the names of the columns */
  po_scan_apex apex;
  bool keeps_tilt; /* whether no tilt is removed */
  double end;      /* the greatest radius, in the unit of x; NAN: the end of the shorter side */
} po_scan_request;

typedef struct {
  char name[32];    /* as in the file, as far as there is space */
  const char *unit; /* "um"; "": none is known */
  double size;      /* of the unit, m; 1 without a unit */
} po_scan_column;

/* Numbers are in the units of the columns, a tilt and slopes in that of z over that of x. */
typedef struct {
  po_scan_column column[2]; /* x, z */
  size_t rows, left_out;    /* left out: rows whose height is no number */
  double *x, *z;            /* rows, x ascending */
  bool is_equidistant;
  double spacing;          /* mean distance of the rows */
  bool is_lowest;          /* whether the apex is the lowest point */
  double noise;            /* standard deviation of a height, estimated by a smoothing spline */
  size_t outliers;         /* rows that are far from the others */
  double outlier;          /* x of the first one */
  double axis;             /* x of the axis: of equidistant rows on a row or midway between two */
  bool is_tilt_determined; /* whether the sides of the scan tell its tilt: that of a parabola is a
                              displacement of its apex */
  double tilt; /* of the scan, removed; 0: none. The mean of both sides does not depend on it */
  double asymmetry;    /* rms of half the difference of the two sides at the same radius, less the
                       part that a displacement of the axis causes */
  double systematic;   /* the same of the smoothing spline: the part that is not noise */
  double radius;       /* of the parabola through the table by least squares, x^2/z in the units */
  double off_parabola; /* rms of the gap less that parabola */
  size_t count;        /* rows of the table */
  double *r, *side[2]; /* count: radius; gap on the left and on the right side */
} po_scan;

/* Reads a scan (in any form of po_csv_form.h; rows in any order) and finds its axis and tilt: those
 * with which the two sides differ least. Given: po_scan_request. Returned: scan, to be cleared
 * whatever the status. Status: PO_CANNOT_READ with the file, if it cannot be read, has no such
 * columns or units, fewer than 32 rows with a height, or if the apex is too near to an end;
 * PO_NO_MEMORY. */
po_status po_scan_read(const po_scan_request *request, po_scan *scan);
void po_scan_clear(po_scan *scan);

/* Standard deviation of a gap of a table. */
double po_scan_gap_noise(const po_scan *scan, po_scan_sides sides);

/* Returned: the gap of row k of a table. */
double po_scan_gap(const po_scan *scan, po_scan_sides sides, size_t k);

/* Appends the table of radii and gaps, as --profile-file takes it. Given: made, the command that
 * made it. */
void po_scan_add_table(const po_scan *scan, po_scan_sides sides, const char *made, po_text *text);

/* -- For po_scan.c -- */

/* Reads rows, x, z, column and left_out. */
po_status po_scan_read_rows(const po_scan_request *request, po_scan *scan);

#endif
