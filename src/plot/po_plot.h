/* Figures of one solve and of a run: gnuplot scripts with their data, drawn in the style of the
 * report, and plots of characters for a terminal. */
#ifndef PO_PLOT_H
#define PO_PLOT_H

#include "po_request.h"
#include "po_result.h"
#include "po_text.h"

/* The additional results that a figure shows if they are there: the branch with its special points,
 * the jumps of loading and unloading, the profile, the staircase of displacement control. */
enum {
  PO_PLOT_WANTS = PO_WANT_CURVE | PO_WANT_PROFILE | PO_WANT_HYSTERESIS | PO_WANT_PRELOAD,
};

/* Returned: whether the name of a file ends in .svg, .png or .pdf, the formats of figures. */
bool po_plot_is_figure(const char *file);

/* Appends the data of a result to a script, for reports/figures/solve.gp. Status: PO_NO_MEMORY;
 * PO_BAD_INPUT if the result has nothing to plot. */
po_status po_plot_solve(const po_request *request, const po_result *result, po_text *script);

/* Appends one curve of pull-offs to a script, for reports/figures/run.gp: rows of the value of the
 * varied key, the force and its error. The caller numbers the curves from 1. Status:
 * PO_NO_MEMORY. */
typedef struct {
  double x, force, error;
} po_plot_pull_off;
po_status po_plot_pull_offs(size_t number, const char *name, const po_plot_pull_off *point,
                            size_t count, po_text *script);

/* A map: a value for each pair of an x and a y; both ascend. */
typedef struct {
  const double *x, *y;
  size_t columns, rows; /* at least 2 each */
  const double *value;  /* columns x rows, row by row; NAN: none */
} po_plot_map;

/* Appends the data of a map to a script, for reports/figures/map.gp. Status: PO_NO_MEMORY. */
po_status po_plot_map_data(const po_plot_map *map, po_text *script);

/* Appends a map of characters, at most `columns` x `rows` of them. */
void po_plot_map_print(const po_plot_map *map, const char *x_name, const char *y_name,
                       size_t columns, size_t rows, po_text *text);

/* Appends an assignment of a text to a variable of a script. */
void po_plot_assign(po_text *script, const char *variable, const char *value);

/* The same of the unit of the loads of a request, load_unit. */
void po_plot_assign_load_unit(po_text *script, const po_request *request);

/* Runs gnuplot with a script and then with the file `name` of the folder `figures`, and writes the
 * figure. Given: `file`, po_plot_is_figure; its ending selects the format. Status: PO_MISSING_TOOL
 * if gnuplot cannot be started or fails, PO_CANNOT_READ, PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_plot_draw(const po_text *script, const char *figures, const char *name,
                       const char *file);

/* Curves of a plot of characters. NAN in a coordinate interrupts a line. */
typedef struct {
  const double *x, *y;
  size_t count;
  char mark;
  bool is_line; /* otherwise single points */
} po_plot_series;

/* Appends a plot of `columns` x `rows` characters with the ranges on both axes. Later series cover
 * earlier ones. */
void po_plot_characters(const po_plot_series *series, size_t count, const char *x_name,
                        const char *y_name, size_t columns, size_t rows, po_text *text);

/* Appends the plots of a result. Status: as po_plot_solve. */
po_status po_plot_print(const po_request *request, const po_result *result, size_t columns,
                        size_t rows, po_text *text);

#endif
