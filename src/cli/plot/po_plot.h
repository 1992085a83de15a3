/* Figures: one description of a picture, drawn by gnuplot in the style of the report, or as
 * characters for a terminal; and maps. */
#ifndef PO_PLOT_H
#define PO_PLOT_H

#include "po_request.h"
#include "po_result.h"
#include "po_si.h"
#include "po_text.h"

/* The additional results that a figure of a solve shows if they are there. */
enum {
  PO_PLOT_WANTS =
      PO_WANT_CURVE | PO_WANT_PROFILE | PO_WANT_HYSTERESIS | PO_WANT_PRELOAD | PO_WANT_HISTORY,
};

/* How the points of a series are drawn: enumerator, name of the macro in
 * reports/figures/picture.gp, mark of a point among characters (0: not drawn). NAN in a coordinate
 * interrupts a line. Those from PO_PLOT_HOLDS on are single points, jumps are arrows, each from a
 * point to the next one; the gap is on the second axis, curves have error bars; curves and lines of
 * a panel differ in colour. */
// clang-format off
#define PO_PLOT_STYLES(X) \
  X(EQUILIBRIA, "equilibria", '.') X(UNSTABLE, "unstable", '.') X(STABLE, "stable", '*') X(LOADING, "loading", '+') \
  X(UNLOADING, "unloading", '*') X(JUMP_LOADING, "jump_loading", '|') X(JUMP_UNLOADING, "jump_unloading", '|') \
  X(THEORY, "theory", '.') X(STEPS, "steps", '*') X(CURVE, "curve", '*') X(LINE, "line", '*') X(TRACTION, "traction", '*') X(GAP, "gap", 0) \
  X(LEVEL, "level", '|') X(HOLDS, "holds", 'o') X(FAILS, "fails", 'x') X(UNKNOWN, "unknown", '?') X(FOLD, "fold", 'o') \
  X(PULL_OFF, "pull_off", 'X')
// clang-format on
#define PO_PLOT_ENUMERATOR(key, ...) PO_PLOT_##key,
typedef enum { PO_PLOT_STYLES(PO_PLOT_ENUMERATOR) PO_PLOT_STYLE_COUNT } po_plot_style;

typedef struct {
  double x, y, error;
} po_plot_point;

typedef struct {
  po_plot_style style;
  char title[96]; /* in the legend; "": none */
  po_plot_point *point;
  size_t count, room;
} po_plot_series;

typedef struct {
  char words[64];     /* "" : no such axis */
  const char *symbol; /* for gnuplot */
  bool si, log;
  double factor, shift;               /* (value + shift) factor is the number shown */
  char in_figure[24], in_letters[24]; /* the unit of this number; "": none */
  double low, high;                   /* the range, as the points; NAN: that of the points */
  po_text tics;                       /* names of values, for gnuplot; empty: numbers */
} po_plot_axis;

typedef struct {
  po_plot_axis x, y, second;
  po_plot_series *series; /* later ones cover earlier ones */
  size_t count, room;
} po_plot_panel;

/* A value for each pair of an x and a y; both ascend. */
typedef struct {
  const char *x_name, *y_name;
  const double *x, *y;
  size_t columns, rows; /* at least 2 each */
  const double *value;  /* columns x rows, row by row; NAN: none */
  double low, high;     /* the least and the greatest value */
} po_plot_map;

enum { PO_PLOT_MOST_PANELS = 6 };

typedef struct {
  char *caption;
  const char *load_unit; /* of the scene, po_input_load_unit */
  const po_units *units; /* of a scene in SI units; NULL: dimensionless */
  po_plot_panel panel[PO_PLOT_MOST_PANELS];
  size_t count;
  const po_plot_map *map; /* of pull-off forces, in place of panels; NULL: none */
  po_status status;       /* PO_NO_MEMORY, or why there is nothing to plot */
} po_plot_picture;

/* Returned: the prefix of a unit, "n", for numbers up to the greatest; in *factor, what a number in
 * the unit without the prefix is multiplied by. */
const char *po_plot_prefix(double greatest, double *factor);

/* Returned: the caption of a scene, to be freed: its command, or its input in SI units. NULL:
 * memory ran out. */
char *po_plot_caption(const po_request *request);

/* A picture without panels. Given: caption, which it owns. Cleared with po_plot_clear. */
po_plot_picture po_plot_begin(char *caption, const po_request *request);
void po_plot_clear(po_plot_picture *picture);

/* Add parts. The series is valid until the next one is added to the panel. */
po_plot_panel *po_plot_add_panel(po_plot_picture *picture);
po_plot_series *po_plot_add_series(po_plot_picture *picture, po_plot_panel *panel,
                                   po_plot_style style, const char *title);
void po_plot_add_point(po_plot_picture *picture, po_plot_series *series, po_plot_point point);

/* Returned: whether a style is that of jumps. */
bool po_plot_is_jump(po_plot_style style);

/* The axis of a dimension, in SI units with the prefix that fits the scene if the picture is in SI
 * units. */
po_plot_axis po_plot_axis_of(const po_plot_picture *picture, const char *words, const char *symbol,
                             po_dimension dimension);

/* Whether the values of an axis, ascending, the first one and the last one given, span so much that
 * its scale is logarithmic. */
bool po_plot_is_log(double first, double last);

/* Returned: the value of a coordinate of a point as it is shown. */
double po_plot_shown(const po_plot_axis *axis, double value);

/* Sets the ranges that are NAN to those of the points. A range without extent becomes one of length
 * 1 about its value. */
void po_plot_set_ranges(po_plot_panel *panel);

/* Returned: the picture of a solve: load over approach, through a spring also over the position of
 * its base, with the paths of loading and unloading if there are loops; the profile; the staircase.
 * PO_BAD_INPUT if the result has nothing to plot. */
po_plot_picture po_plot_of_solve(const po_request *request, const po_result *result);

/* Returned: that of the theories beside a solve. */
po_plot_picture po_plot_of_theories(const po_request *request, const po_result *result);

/* Draws a picture with gnuplot in a file, po_plot_is_figure; its ending selects the format. Given:
 * the folder of the scripts. Status: PO_MISSING_TOOL if gnuplot cannot be started or fails,
 * PO_CANNOT_READ, PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_plot_draw(po_plot_picture *picture, const char *figures, const char *file);

/* Appends a picture as plots of `columns` x `rows` characters by gnuplot. Status: PO_MISSING_TOOL,
 * PO_NO_MEMORY. */
po_status po_plot_print(po_plot_picture *picture, size_t columns, size_t rows, po_text *text);

/* Returned: whether the name of a file ends in .svg, .png or .pdf, the formats of figures. */
bool po_plot_is_figure(const char *file);

/* The unit of loads in a figure, for that of po_input_load_unit. */
const char *po_plot_load_unit(const char *load_unit);

#endif
