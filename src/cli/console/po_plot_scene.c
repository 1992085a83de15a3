#include "po_plot_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_options.h"

po_status po_plot_take_file(const char *name, void *file) {
  *(const char **)file = optarg;
  return po_plot_is_figure(optarg)
             ? PO_OK
             : po_options_refuse(name, optarg,
                                 "the name of a file that ends in .svg, .png or .pdf");
}

/* The size of a plot in characters: that of the terminal, within limits. */
static void find_size(size_t *columns, size_t *rows) {
  enum { COLUMNS = 80, ROWS = 26, LEAST = 20 };
  struct winsize window;
  *columns = COLUMNS;
  *rows = ROWS;
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col &&
      window.ws_row) {
    *columns = window.ws_col > LEAST ? window.ws_col : LEAST;
    *rows = window.ws_row > LEAST + 1 ? window.ws_row - 1U : LEAST;
  }
}

static po_status print_picture(po_plot_picture *picture) {
  size_t columns, rows;
  po_text text = {0};
  find_size(&columns, &rows);
  const po_status status = po_plot_print(picture, columns, rows, &text);
  enum { LINE = 80 }; /* that of a scene is longer, and known to whoever gave it */
  if (!status && strlen(picture->caption) < LINE)
    puts(picture->caption);
  if (!status)
    fputs(po_text_string(&text), stdout);
  po_text_clear(&text);
  return status;
}

po_status po_plot_show(po_plot_picture picture, const char *file) {
  const po_file_path folder = po_path_join(po_environment_data(), "reports/figures");
  const po_status status = picture.status ? picture.status
                           : file         ? po_plot_draw(&picture, folder.text, file)
                                          : print_picture(&picture);
  po_plot_clear(&picture);
  return status;
}

/* The units at the end of the names of options, longer ones first, and as figures write them. */
static const struct {
  const char *end, *unit;
} UNITS[] = {{"-j-per-m2", "J/m²"}, {"-m-per-s", "m/s"}, {"-pa", "Pa"}, {"-m", "m"}, {"-s", "s"}};
enum { UNIT_COUNT = sizeof UNITS / sizeof *UNITS };

/* The axis of the parameter that varies, whose name has words in place of dashes; in SI units with
 * the prefix of its greatest value. */
static po_plot_axis varied_axis(const po_plot_picture *picture, const po_printed_series *series) {
  const double ends[] = {series->values[0], series->values[series->count - 1]};
  const size_t length = strlen(series->name);
  po_plot_axis axis = po_plot_axis_of(picture, series->name, "", PO_DIMENSION_NONE);
  for (size_t k = 0; picture->units && k < UNIT_COUNT; ++k) {
    const size_t end = strlen(UNITS[k].end);
    if (length <= end || strcmp(series->name + length - end, UNITS[k].end) != 0)
      continue;
    axis.words[length - end] = '\0';
    const char *prefix = po_plot_prefix(fmax(fabs(ends[0]), fabs(ends[1])), &axis.factor);
    snprintf(axis.in_figure, sizeof axis.in_figure, "%s%s", prefix, UNITS[k].unit);
    snprintf(axis.in_letters, sizeof axis.in_letters, "%s", axis.in_figure);
    break;
  }
  for (char *c = axis.words; picture->units && *c; ++c)
    *c = *c == '-' ? ' ' : *c;
  axis.log = po_plot_is_log(fmin(ends[0], ends[1]), fmax(ends[0], ends[1]));
  return axis;
}

/* The points of one curve: the pull-off forces, or the approaches of a fold. Units may differ from
 * scene to scene: the numbers are in those of the first one. */
static void add_curve(po_plot_picture *picture, po_plot_series *to, const po_printed_series *series,
                      const size_t *fold) {
  for (size_t k = 0; k < series->count; ++k) {
    const po_result *o = &series->results[k];
    const po_units *u = &series->requests[k].units, *first = picture->units;
    const double ratio = !first ? 1.0 : fold ? u->length / first->length : u->force / first->force;
    const double value = fold && *fold < o->fold_count ? o->folds[*fold].approach
                         : !fold && o->has_pull_off    ? o->pull_off.force
                                                       : (double)NAN;
    const double error = fold ? 0.0 : fmax(0.0, o->pull_off.force_error);
    po_plot_add_point(picture, to,
                      (po_plot_point){series->values[k], value * ratio, error * ratio});
  }
}

po_plot_picture po_plot_of_series(const po_printed_series *series, bool folds) {
  po_plot_picture picture =
      po_plot_begin(po_plot_caption(&series->requests[0]), &series->requests[0]);
  po_plot_panel *panel = po_plot_add_panel(&picture);
  panel->x = varied_axis(&picture, series);
  po_text caption = {0};
  po_text_add(&caption, "%s varies", panel->x.words);
  if (picture.units)
    po_text_add(&caption, " from %.5g to %.5g %s", series->values[0] * panel->x.factor,
                series->values[series->count - 1] * panel->x.factor, panel->x.in_figure);
  po_text_add(&caption, "; the first scene: %s", picture.caption ? picture.caption : "");
  free(picture.caption);
  picture.caption = po_text_take(&caption);
  picture.status = picture.caption ? picture.status : PO_NO_MEMORY;
  panel->y = folds ? po_plot_axis_of(&picture, "approach", "Δ", PO_DIMENSION_LENGTH)
                   : po_plot_axis_of(&picture, "pull-off force", "", PO_DIMENSION_LOAD);
  for (size_t k = 0; folds && k < series->results[0].fold_count; ++k)
    add_curve(&picture,
              po_plot_add_series(&picture, panel, PO_PLOT_CURVE,
                                 PO_SPECIAL_KINDS[series->results[0].folds[k].kind]),
              series, &k);
  if (!folds)
    add_curve(&picture, po_plot_add_series(&picture, panel, PO_PLOT_CURVE, ""), series, NULL);
  return picture;
}
