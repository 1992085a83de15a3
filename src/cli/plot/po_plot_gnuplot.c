/* A picture as commands for gnuplot, and its run. The styles are macros of
 * reports/figures/picture.gp. */
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "po_elementary.h"
#include "po_file.h"
#include "po_plot.h"

#define MACRO(key, macro, mark) macro,
static const char *const MACROS[] = {PO_PLOT_STYLES(MACRO)};
#define MARK(key, macro, mark) mark,
static const char MARKS[] = {PO_PLOT_STYLES(MARK)};
/* More titles are beside the panel in place of above it. */
enum { MOST_ABOVE = 8 };
/* The height of a picture with one row of panels, and that of each of several, pixels. */
enum { ONE_ROW = 400, ROW = 340 };

/* Appends a text as a string of gnuplot, after a word, and what follows it. gnuplot looks for
 * macros and quotes also within quotes, and reads more than three octal digits: characters that
 * could mean something are strings of their own, joined with the others. */
static void add_quoted(po_text *script, const char *word, const char *text, const char *after) {
  po_text_add(script, "%s'", word);
  for (const char *c = text; *c; ++c)
    if ((unsigned char)*c < ' ' || strchr("'\"\\@`$", *c))
      po_text_add(script, "'.\"\\%03o\".'", (unsigned)*c);
    else
      po_text_add(script, "%c", *c);
  po_text_add(script, "'%s", after);
}

static void add_label(po_text *script, const char *which, const po_plot_axis *axis,
                      const char *more) {
  const char *unit = axis->in_figure;
  po_text_add(script, "set %slabel '%s%s%s%s%s%s'%s%s\n", which, axis->words,
              *axis->symbol ? " " : "", axis->symbol,
              !*unit     ? ""
              : axis->si ? " ("
                         : "/",
              unit, *unit && axis->si ? ")" : "", *unit ? " " : " noenhanced ", more);
}

/* Appends the tics of a logarithmic axis, 'x' or 'y'. */
static void add_log_tics(po_text *script, char axis, double low, double high) {
  const char *comma = "";
  po_text_add(script, "set logscale %c\nset %ctics (", axis, axis);
  for (double power = po_pow(10.0, floor(po_log(low) / po_log(10.0))); power <= high; power *= 10.0)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * power;
      if (value < low || value > high)
        continue;
      if (digit == 1 || digit == 2 || digit == 5)
        po_text_add(script, "%s'%g' %.9g", comma, value, value);
      else
        po_text_add(script, "%s'' %.9g 1", comma, value);
      comma = ", ";
    }
  po_text_add(script, ")\n");
}

static void add_range(po_text *script, char which, const po_plot_axis *axis) {
  const double low = po_plot_shown(axis, axis->low), high = po_plot_shown(axis, axis->high);
  po_text_add(script, "unset logscale %c; set %ctics autofreq\nset %crange [%.9g:%.9g]\n", which,
              which, which, low, high);
  if (axis->log)
    add_log_tics(script, which, low, high);
  if (axis->tics.length)
    po_text_add(script, "set %ctics (%s)\n", which, axis->tics.data);
}

/* The points of a series: their coordinates, and the error or where the arrow leads. */
static void add_points(po_text *script, const po_plot_panel *panel, const po_plot_series *s) {
  const po_plot_axis *x = &panel->x, *y = s->style == PO_PLOT_GAP ? &panel->second : &panel->y;
  const size_t step = po_plot_is_jump(s->style) ? 2 : 1;
  for (size_t i = 0; i + step <= s->count; i += step) {
    const po_plot_point *p = &s->point[i], *q = p + step - 1;
    const double at[2] = {po_plot_shown(x, p->x), po_plot_shown(y, p->y)};
    if (!isfinite(p->x) || !isfinite(p->y))
      po_text_add(script, "\n");
    else if (step == 2)
      po_text_add(script, "%.9g %.9g %.9g %.9g\n", at[0], at[1], po_plot_shown(x, q->x) - at[0],
                  po_plot_shown(y, q->y) - at[1]);
    else
      po_text_add(script, "%.9g %.9g %.9g\n", at[0], at[1], p->error * y->factor);
  }
}

static void add_title(po_text *plot, const po_plot_series *s) {
  if (*s->title)
    add_quoted(plot, "title ", s->title, "");
  else
    po_text_add(plot, "notitle");
}

/* Appends the part of the plot command of a series, and as characters. */
static void add_series(po_text *plot, const po_plot_series *s, size_t number, double shade) {
  const char *macro = MACROS[s->style];
  if (s->style == PO_PLOT_CURVE)
    po_text_add(plot,
                "$series%zu using 1:2:3 @%s_error palette frac %.3f notitle, "
                "$series%zu using 1:2 @%s palette frac %.3f ",
                number, macro, shade, number, macro, shade);
  else if (s->style == PO_PLOT_LINE)
    po_text_add(plot, "$series%zu using 1:2 @%s palette frac %.3f ", number, macro, shade);
  else
    po_text_add(plot, "$series%zu using %s @%s ", number,
                po_plot_is_jump(s->style) ? "1:2:3:4" : "1:2", macro);
  add_title(plot, s);
}

static void add_marks(po_text *plot, const po_plot_series *s, size_t number) {
  if (po_plot_is_jump(s->style))
    po_text_add(plot, "$series%zu using 1:2:3:4 with vectors nohead ", number);
  else if (s->style < PO_PLOT_HOLDS && s->count > 1)
    po_text_add(plot, "$series%zu using 1:2 with lines ", number);
  else
    po_text_add(plot, "$series%zu using 1:2 with points pointtype '%c' ", number, MARKS[s->style]);
  add_title(plot, s);
}

/* Appends the data of a panel to the script, and its plot command to `plot`; the gap has a second
 * axis, which characters lack. Returned: the number of titles. */
static size_t add_all_series(po_plot_panel *panel, bool characters, po_text *script,
                             po_text *plot) {
  size_t titles = 0, drawn = 0;
  po_plot_set_ranges(panel);
  for (size_t k = 0; k < panel->count; ++k) {
    const po_plot_series *s = &panel->series[k];
    if (!s->count || (characters && s->style == PO_PLOT_GAP))
      continue;
    titles += *s->title != '\0';
    po_text_add(script, "$series%zu << EOD\n", drawn);
    add_points(script, panel, s);
    po_text_add(script, "EOD\n");
    po_text_add(plot, drawn ? ", \\\n  " : "plot ");
    if (characters)
      add_marks(plot, s, drawn++);
    else
      add_series(plot, s, drawn++, panel->count > 1 ? (double)k / (double)(panel->count - 1) : 0.0);
  }
  return titles;
}

static void add_panel(po_text *script, po_plot_panel *panel) {
  po_text plot = {0};
  const size_t titles = add_all_series(panel, false, script, &plot);
  add_label(script, "x", &panel->x, "offset 0,0.4");
  if (panel->y.tics.length)
    po_text_add(script, "unset ylabel\n");
  else
    add_label(script, "y", &panel->y, "offset 1,0");
  add_range(script, 'x', &panel->x);
  add_range(script, 'y', &panel->y);
  if (*panel->second.words)
    add_label(script, "y2", &panel->second, "offset -1,0");
  po_text_add(script, "has_second = %d; has_names = %d; titles = %s\n@place\n%s\n@after\n",
              *panel->second.words != '\0', panel->y.tics.length > 0,
              titles < 2            ? "'none'"
              : titles > MOST_ABOVE ? "'beside'"
                                    : "'above'",
              po_text_string(&plot));
  script->failed = script->failed || plot.failed;
  po_text_clear(&plot);
}

/* -- Maps -- */

/* Part of a step by which a cell is larger on the right and above: a drawing program leaves a pale
 * line between two cells that only touch. */
static const double OVERLAP = 0.1;

/* The border between two values of an axis, or beyond an end of it: half a step away. Given:
 * `more`, steps farther. */
static double border(const double *value, size_t count, size_t index, double more) {
  const bool log_scale = po_plot_is_log(value[0], value[count - 1]);
  const size_t inner = index == 0 ? 1 : index == count ? count - 1 : index;
  const double a = value[inner - 1], b = value[inner];
  const double part = (index == 0 ? -0.5 : index == count ? 1.5 : 0.5) + more;
  return log_scale ? a * po_pow(b / a, part) : a + part * (b - a);
}

static void add_map_axis(po_text *script, char axis, const double *value, size_t count) {
  const double low = border(value, count, 0, 0.0), high = border(value, count, count, 0.0);
  po_text_add(script, "set %crange [%.9g:%.9g]\n", axis, low, high);
  if (po_plot_is_log(value[0], value[count - 1]))
    add_log_tics(script, axis, low, high);
}

/* Appends the data of a map, for reports/figures/map.gp. */
static void add_map(const po_plot_map *map, po_text *script) {
  po_text_add(script, "$map << EOD\n");
  for (size_t j = 0; j < map->rows; ++j)
    for (size_t i = 0; i < map->columns; ++i)
      if (isfinite(map->value[j * map->columns + i]))
        po_text_add(script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", map->x[i], map->y[j],
                    border(map->x, map->columns, i, 0.0),
                    border(map->x, map->columns, i + 1, OVERLAP), border(map->y, map->rows, j, 0.0),
                    border(map->y, map->rows, j + 1, OVERLAP), map->value[j * map->columns + i]);
  po_text_add(script, "EOD\n");
  add_map_axis(script, 'x', map->x, map->columns);
  add_map_axis(script, 'y', map->y, map->rows);
  /* gnuplot would leave out cells whose overlap ends beyond the axes */
  if (map->low < map->high)
    po_text_add(script, "set cbrange [%.9g:%.9g]\n", map->low, map->high);
}

/* -- The run of gnuplot -- */

static const char *ending_of(const char *file) {
  const char *point = strrchr(file, '.');
  return point && strlen(point) == 4 ? point + 1 : "";
}

bool po_plot_is_figure(const char *file) {
  const char *ending = ending_of(file);
  return strcmp(ending, "svg") == 0 || strcmp(ending, "png") == 0 || strcmp(ending, "pdf") == 0;
}

/* Starts gnuplot, which reads one file and writes the other. Returned: its process; -1: errno. */
static pid_t start_gnuplot(int script, int figure) {
  const pid_t child = fork();
  if (child)
    return child;
  dup2(script, STDIN_FILENO);
  dup2(figure, STDOUT_FILENO);
  /* In the locale C gnuplot warns of the characters of its own tables. */
  setenv("LC_ALL", "C.UTF-8", 1);
  execlp("gnuplot", "gnuplot", "-", (char *)NULL);
  _exit(127);
}

/* Runs gnuplot: its standard input and its standard output are files in memory. */
static po_status run_gnuplot(const po_text *script, po_text *figure) {
  const int from = memfd_create("script", MFD_CLOEXEC), to = memfd_create("figure", MFD_CLOEXEC);
  pid_t child = -1;
  int ending = 0;
  char bytes[1 << 14];
  ssize_t got = 0;
  for (size_t put = 0; put < script->length && got >= 0; put += (size_t)got)
    got = pwrite(from, script->data + put, script->length - put, (off_t)put);
  if (got >= 0 && to >= 0)
    child = start_gnuplot(from, to);
  if (child < 0)
    po_fail(PO_MISSING_TOOL, "gnuplot cannot be started: %s", strerror(errno));
  while (child > 0 && waitpid(child, &ending, 0) < 0 && errno == EINTR)
    continue;
  while (!figure->failed && (got = pread(to, bytes, sizeof bytes, (off_t)figure->length)) > 0)
    po_text_add_bytes(figure, bytes, (size_t)got);
  close(from);
  close(to);
  if (child < 0)
    return PO_MISSING_TOOL;
  if (WIFEXITED(ending) && WEXITSTATUS(ending) == 127)
    return po_fail(PO_MISSING_TOOL,
                   "gnuplot was not found: expected it in PATH, to draw the figure");
  if (figure->failed)
    return PO_NO_MEMORY;
  return !WIFEXITED(ending) || WEXITSTATUS(ending) || !figure->length
             ? po_fail(PO_MISSING_TOOL, "gnuplot failed, see its message above")
             : PO_OK;
}

/* Appends a file to the script, because gnuplot would search other folders for it. */
static po_status add_file(po_text *script, const char *folder, const char *name) {
  char *content = NULL;
  size_t size = 0;
  const po_status status = po_file_read(po_path_join(folder, name).text, &content, &size);
  if (!status)
    po_text_add_bytes(script, content, size);
  po_text_add(script, "\n");
  free(content);
  return status;
}

po_status po_plot_draw(po_plot_picture *picture, const char *figures, const char *file) {
  const po_plot_map *map = picture->map;
  po_text script = {0}, figure = {0};
  add_quoted(&script, "figure_terminal = ", ending_of(file), "\n");
  add_quoted(&script, "figure_output = ", "", "\n");
  add_quoted(&script, "caption = ", picture->caption, "\n");
  if (map) {
    add_quoted(&script, "x_name = ", map->x_name, "\n");
    add_quoted(&script, "y_name = ", map->y_name, "\n");
    add_quoted(&script, "load_unit = ", po_plot_load_unit(picture->load_unit), "\n");
    add_map(map, &script);
  } else
    po_text_add(&script, "panel_count = %zu\nfigure_height = %d\n", picture->count,
                picture->count > 2 ? ROW * (int)((picture->count + 1) / 2) : ONE_ROW);
  po_status status = add_file(&script, figures, "style.gp");
  if (!status)
    status = add_file(&script, figures, map ? "map.gp" : "picture.gp");
  for (size_t k = 0; k < picture->count; ++k)
    add_panel(&script, &picture->panel[k]);
  if (!map)
    po_text_add(&script, "unset multiplot\nunset output\n");
  if (!status && script.failed)
    status = PO_NO_MEMORY;
  if (!status)
    status = run_gnuplot(&script, &figure);
  if (!status)
    status = po_file_write(file, figure.data, figure.length);
  po_text_clear(&script);
  po_text_clear(&figure);
  return status;
}

/* -- Characters -- */

/* Of a map, from the smallest to the greatest value. */
static const char SHADES[] = ".:-=+*#%@";
enum { SHADE_COUNT = sizeof SHADES - 1 };

static void add_panel_of_characters(po_text *script, po_plot_panel *panel) {
  const po_plot_axis *x = &panel->x, *y = &panel->y;
  po_text plot = {0};
  add_all_series(panel, true, script, &plot);
  add_range(script, 'x', x);
  add_range(script, 'y', y);
  po_text_add(script, "set tics autofreq\n"); /* names of values would overlap */
  po_text_add(script, "set title '%s%s%s against %s%s%s'\n%s\n", y->words,
              *y->in_letters ? " in " : "", y->in_letters, x->words, *x->in_letters ? " in " : "",
              x->in_letters, po_text_string(&plot));
  script->failed = script->failed || plot.failed;
  po_text_clear(&plot);
}

static void add_map_of_characters(po_text *script, const po_plot_picture *picture) {
  const po_plot_map *map = picture->map;
  const double step = (map->high - map->low) / SHADE_COUNT;
  add_map(map, script);
  po_text_add(script,
              "set title 'pull-off force in %s, %s from %.4g in steps of %.4g'\n"
              "set xlabel '%s'; set ylabel '%s'; set tics scale 0 autofreq\n"
              "shade(z) = z < 1 ? 1 : z > %d ? %d : int(z)\n"
              "plot $map using 1:2:(substr('%s', shade(1 + ($7 - %.9g) / %.9g), "
              "shade(1 + ($7 - %.9g) / %.9g))) with labels notitle\n",
              picture->load_unit, SHADES, map->low, step, map->x_name, map->y_name, SHADE_COUNT,
              SHADE_COUNT, SHADES, map->low, fmax(step, DBL_MIN), map->low, fmax(step, DBL_MIN));
}

/* Appends what gnuplot printed without its form feeds and the blanks at the ends of lines. */
static void add_lines(po_text *text, const po_text *printed) {
  const char *line = po_text_string(printed);
  while (*line) {
    line += strspn(line, "\f");
    const size_t whole = strcspn(line, "\n");
    size_t length = whole;
    while (length && line[length - 1] == ' ')
      --length;
    if (length)
      po_text_add(text, "%.*s\n", (int)length, line);
    line += whole + (line[whole] == '\n');
  }
}

po_status po_plot_print(po_plot_picture *picture, size_t columns, size_t rows, po_text *text) {
  po_text script = {0}, printed = {0};
  po_text_add(&script,
              "set encoding utf8\nset terminal dumb noenhanced size %zu,%zu\nset tics nomirror\n"
              "set key above horizontal samplen 1\n",
              columns, rows);
  if (picture->map)
    add_map_of_characters(&script, picture);
  for (size_t k = 0; k < picture->count; ++k)
    add_panel_of_characters(&script, &picture->panel[k]);
  po_status status = script.failed ? PO_NO_MEMORY : run_gnuplot(&script, &printed);
  if (!status)
    add_lines(text, &printed);
  po_text_clear(&script);
  po_text_clear(&printed);
  return status ? status : text->failed ? PO_NO_MEMORY : PO_OK;
}
