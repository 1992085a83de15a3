#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_file.h"
#include "po_options.h"
#include "po_plot_scene.h"
#include "po_scan.h"
#include "po_si.h"
#include "po_solve.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff profile SCAN [OPTION]...\n"
    "Makes the profile of a body of revolution of a line scan across its apex, as profilers and\n"
    "microscopes export it: both sides, with an unknown tilt and an apex anywhere. Finds the axis\n"
    "and the tilt with which the two sides differ least, and writes radii and gaps for\n"
    "--profile-file. SCAN is a table with a column of positions and one of heights. Commas,\n"
    "semicolons, tabs or blanks between the cells, decimal points or commas, lines of text before\n"
    "the names, a line of units below them, UTF-8, UTF-16 or Latin-1, and rows in any order are\n"
    "read. Without names, --units is needed. Rows whose height is no number are left out. The\n"
    "tilt of a parabola is a displacement of its apex: only a tilt that the shape of the sides\n"
    "shows is removed.\n"
    "\n"
    "Scan:\n"
    "  --columns X,Z           names or numbers of the columns of position and height (default "
    "1,2)\n"
    "  --units X,Z             their units: m, mm, um, nm or pm (default: those at the end of "
    "their\n"
    "                          names, x_um, height [nm], or in a line below the names)\n"
    "  --apex NAME             highest or lowest point of the scan (default: by the curvature of "
    "the\n"
    "                          whole scan)\n"
    "  --no-tilt               remove no tilt\n"
    "  --end R                 the greatest radius, in the unit of x (default: the end of the "
    "shorter\n"
    "                          side)\n"
    "\n"
    "Results:\n"
    "  --side NAME             both: the mean of both sides; left or right (default both)\n"
    "  -o, --output FILE       write the table to FILE (default: standard output)\n"
    "  --plot FILE             draw both sides in FILE, which ends in .svg, .png or .pdf\n"
    "  -h, --help              print this text\n"
    "\n"
    "Force: with the options of a scene, and --output, the pull-off force of the table and that "
    "of\n"
    "each side alone, whose tables are written to FILE with .left and .right before its ending.\n"
    "@scene\n"
    "@trace\n"
    "@mesh\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff profile scan.csv --output tip.csv --plot tip.svg\n"
    "Example: pulloff profile scan.csv --output tip.csv --from-physical --modulus-pa 2e9 \\\n"
    "             --work-j-per-m2 0.05 --distance-m 3e-10\n";

typedef struct {
  po_scene_options scene;
  po_request request;
  po_scan_request scan;
  po_scan_sides sides;
  const char *output, *plot;
} profile_line;

static po_status take_apex(const char *name, void *apex) {
  const bool lowest = strcmp(optarg, "lowest") == 0;
  *(po_scan_apex *)apex = lowest ? PO_APEX_LOWEST : PO_APEX_HIGHEST;
  return lowest || strcmp(optarg, "highest") == 0
             ? PO_OK
             : po_options_refuse(name, optarg, "highest or lowest");
}

static const char *const SIDES[] = {"both", "left", "right", NULL};

static po_status take_side(const char *name, void *side) {
  for (int k = 0; SIDES[k]; ++k)
    if (strcmp(SIDES[k], optarg) == 0) {
      *(po_scan_sides *)side = (po_scan_sides)k;
      return PO_OK;
    }
  return po_options_refuse(name, optarg, "both, left or right");
}

static const po_option OPTIONS[] = {
    PO_TEXT("columns", profile_line, scan.columns, "two names or numbers, X,Z"),
    PO_TEXT("units", profile_line, scan.units, "two units, X,Z"),
    PO_TAKEN("apex", profile_line, scan.apex, take_apex),
    PO_FLAG("no-tilt", profile_line, scan.keeps_tilt),
    PO_NUMBER("end", profile_line, scan.end, 0.0, "a number > 0"),
    PO_TAKEN("side", profile_line, sides, take_side),
    PO_OUTPUT(profile_line, output, "the name of a file"),
    PO_TAKEN("plot", profile_line, plot, po_plot_take_file),
    {0}};

/* -- The tables -- */

/* FILE with .left or .right before its ending. */
static void add_name(const char *file, po_scan_sides sides, po_text *name) {
  const char *slash = strrchr(file, '/'), *ending = strrchr(slash ? slash + 1 : file, '.');
  const int stem = ending ? (int)(ending - file) : (int)strlen(file);
  if (sides == PO_SIDES_BOTH)
    po_text_add(name, "%s", file);
  else
    po_text_add(name, "%.*s.%s%s", stem, file, SIDES[sides], ending ? ending : "");
}

/* The command that makes this table. */
static void add_command(const profile_line *line, po_scan_sides sides, po_text *made) {
  const po_scan_request *r = &line->scan;
  static const char *const APEX[] = {NULL, " --apex highest", " --apex lowest"};
  po_text_add(made, "pulloff profile ");
  po_text_add_word(made, r->path);
  const char *const name[] = {"columns", "units"}, *const value[] = {r->columns, r->units};
  for (int k = 0; k < 2; ++k)
    if (value[k]) {
      po_text_add(made, " --%s ", name[k]);
      po_text_add_word(made, value[k]);
    }
  po_text_add(made, "%s%s", r->apex ? APEX[r->apex] : "", r->keeps_tilt ? " --no-tilt" : "");
  if (!isnan(r->end))
    po_text_add(made, " --end %.17g", r->end);
  if (sides != PO_SIDES_BOTH)
    po_text_add(made, " --side %s", SIDES[sides]);
}

/* Writes a table to a file; NULL: to standard output. */
static po_status write_table(const profile_line *line, const po_scan *scan, po_scan_sides sides,
                             const char *file) {
  po_text table = {0}, made = {0};
  add_command(line, sides, &made);
  po_scan_add_table(scan, sides, po_text_string(&made), &table);
  po_status status = made.failed || table.failed ? PO_NO_MEMORY
                     : file                      ? po_file_write(file, table.data, table.length)
                                                 : po_text_print(&table);
  po_text_clear(&made);
  po_text_clear(&table);
  return status;
}

/* -- What was done -- */

/* A unit after a number. */
typedef struct {
  char text[8];
} spaced_unit;

static spaced_unit unit_of(const po_scan *s, int column) {
  spaced_unit unit;
  const char *name = s->column[column].unit;
  snprintf(unit.text, sizeof unit.text, "%s%s", *name ? " " : "", name);
  return unit;
}

static void print_scan(const po_scan *s, FILE *to) {
  const char *x = s->column[0].name, *z = s->column[1].name;
  const spaced_unit unit = unit_of(s, 0);
  fprintf(to, "scan     %zu rows, %s from %.6g to %.6g%s, heights from %s%s%s\n", s->rows, x,
          s->x[0], s->x[s->rows - 1], unit.text, strncmp(z, "column ", 7) == 0 ? "" : "column ", z,
          s->is_equidistant ? ""
                            : "; the rows are not equidistant and are joined by straight lines");
  if (s->left_out)
    fprintf(to, "         %zu rows without a height are left out\n", s->left_out);
  fprintf(to, "apex     the %s point; axis at %s = %.6g%s\n", s->is_lowest ? "lowest" : "highest",
          x, s->axis, unit.text);
}

static void print_tilt(const profile_line *line, const po_scan *s, FILE *to) {
  const double slope = s->tilt * s->column[1].size / s->column[0].size;
  if (!s->is_tilt_determined)
    fprintf(to, "tilt     none removed: the sides do not tell one\n");
  else if (line->scan.keeps_tilt)
    fprintf(to, "tilt     none removed, by --no-tilt; the sides tell one\n");
  else
    fprintf(to, "tilt     %.4g of height by position removed\n", slope);
}

/* Sides that agree this many times better than the noise: what was taken for noise is of the body.
 */
static const double BETTER = 3.0;

static bool hides_shape(const po_scan *s) {
  return BETTER * s->asymmetry < s->noise * M_SQRT1_2;
}

static void print_sides(const profile_line *line, const po_scan *s, FILE *to) {
  const spaced_unit x = unit_of(s, 0), z = unit_of(s, 1);
  const double by_noise = s->noise * M_SQRT1_2;
  fprintf(to, "noise    standard deviation of a height %.3g%s, of a gap of the table %.3g%s\n",
          s->noise, z.text, po_scan_gap_noise(s, line->sides), z.text);
  fprintf(to, "sides    rms of half their difference %.3g%s, %.3g%s by noise%s\n", s->asymmetry,
          z.text, by_noise, z.text, s->systematic > by_noise ? ": more than noise explains" : "");
  if (hides_shape(s))
    fprintf(
        to,
        "warning  the sides agree better than the noise: part of it is short waves of the body, "
        "which the rows hardly resolve; they are not smoothed\n");
  if (s->outliers)
    fprintf(to,
            "warning  far from the smooth curve: %zu of the rows, the first at x = %.6g%s: "
            "outliers, or a "
            "sharp edge of the body\n",
            s->outliers, s->outlier, x.text);
  fprintf(to, "parabola by least squares: radius %.5g%s, rms of the rest %.3g%s\n",
          s->radius * s->column[0].size / s->column[1].size, x.text, s->off_parabola, z.text);
  fprintf(to, "table    %zu rows to radius %.6g%s%s%s\n", s->count, s->r[s->count - 1], x.text,
          line->output ? " in " : "", line->output ? line->output : "");
}

/* What --smooth takes: in m if the columns have units. */
static double smooth_of(const profile_line *line, const po_scan *s) {
  return po_scan_gap_noise(s, line->sides) * s->column[1].size;
}

static void print_next(const profile_line *line, const po_scan *s, FILE *to) {
  if (!line->output)
    return;
  po_text text = {0};
  po_text_add(&text, "next     pulloff solve %s--profile-file ",
              *s->column[0].unit ? "--from-physical --modulus-pa E --work-j-per-m2 W --distance-m "
                                   "D "
                                 : "--coupling K ");
  po_text_add_word(&text, line->output);
  if (!hides_shape(s))
    po_text_add(&text, " --smooth %.3g", smooth_of(line, s));
  fprintf(to, "%s\n", po_text_string(&text));
  po_text_clear(&text);
}

/* -- The picture -- */

/* A panel of the gap of both sides; less the parabola if `less` is 1, otherwise with it. */
static void add_panel(const po_scan *s, double less, po_plot_picture *picture) {
  po_plot_panel *panel = po_plot_add_panel(picture);
  if (!panel)
    return;
  po_plot_axis *const axis[] = {&panel->x, &panel->y};
  const char *const words[] = {"radius", less > 0.0 ? "gap less the parabola" : "gap"};
  for (int k = 0; k < 2; ++k) {
    const char *unit = strcmp(s->column[k].unit, "um") == 0 ? "\xC2\xB5m" : s->column[k].unit;
    *axis[k] = (po_plot_axis){.factor = 1.0, .low = NAN, .high = NAN, .symbol = ""};
    snprintf(axis[k]->words, sizeof axis[k]->words, "%s%s%s", words[k], *unit ? ", " : "", unit);
  }
  const struct {
    po_plot_style style;
    const char *title;
  } SERIES[] = {{PO_PLOT_LOADING, "left side"},
                {PO_PLOT_UNLOADING, "right side"},
                {PO_PLOT_THEORY, "parabola"}};
  for (int i = 0; i < (less > 0.0 ? 2 : 3); ++i) {
    po_plot_series *series =
        po_plot_add_series(picture, panel, SERIES[i].style, less > 0.0 ? "" : SERIES[i].title);
    for (size_t k = 0; k < s->count; ++k) {
      const double parabola = 0.5 * s->r[k] * s->r[k] / s->radius;
      po_plot_add_point(
          picture, series,
          (po_plot_point){s->r[k], (i < 2 ? s->side[i][k] : parabola) - less * parabola, 0.0});
    }
  }
}

static po_status draw_scan(const profile_line *line, const po_scan *s) {
  po_text made = {0};
  add_command(line, PO_SIDES_BOTH, &made);
  po_plot_picture picture = po_plot_begin(po_text_take(&made), &line->request);
  add_panel(s, 0.0, &picture);
  add_panel(s, 1.0, &picture);
  return po_plot_show(picture, line->plot);
}

/* -- The force -- */

static bool has_scene(const profile_line *line) {
  bool has = line->scene.given.si;
  for (int key = 0; key < PO_KEY_ALL; ++key)
    has = has || line->scene.given.text[key];
  return has;
}

/* The scene with a table. */
static po_status read_scene(const profile_line *line, const char *file, const char *smooth,
                            po_request *request) {
  po_texts given = line->scene.given;
  given.text[PO_KEY_PROFILE_FILE] = file;
  if (!given.text[PO_KEY_SMOOTH] && strcmp(smooth, "0") != 0)
    given.text[PO_KEY_SMOOTH] = smooth;
  *request = po_input_default();
  po_status status = po_texts_read(&given, request);
  if (!status)
    status = po_texts_check_waves(&given);
  return status ? status : po_request_check(request);
}

/* The force of one table, with its standard uncertainty by the noise. */
typedef struct {
  po_units units; /* of a scene in SI units */
  double force, deviation;
} side_force;

static po_status solve_side(const profile_line *line, const po_scan *scan, po_scan_sides sides,
                            side_force *of) {
  po_text name = {0};
  char smooth[32];
  po_request request;
  po_result result = {0};
  add_name(line->output, sides, &name);
  snprintf(smooth, sizeof smooth, "%.3g",
           hides_shape(scan) ? 0.0 : po_scan_gap_noise(scan, sides) * scan->column[1].size);
  po_status status = name.failed ? PO_NO_MEMORY : PO_OK;
  if (!status && sides != PO_SIDES_BOTH)
    status = write_table(line, scan, sides, po_text_string(&name));
  if (!status)
    status = read_scene(line, po_text_string(&name), smooth, &request);
  if (!status) {
    status = po_solve(&request, &result);
    if (status)
      status = po_fail(status, "the solve failed: %s", result.reason);
    *of = (side_force){request.units, result.pull_off.force, result.uncertainty};
  }
  po_result_clear(&result);
  po_text_clear(&name);
  return status;
}

static po_status print_force(const profile_line *line, const po_scan *scan, FILE *to) {
  side_force of[3];
  for (int sides = 0; sides < 3; ++sides) {
    const po_status status = solve_side(line, scan, (po_scan_sides)sides, &of[sides]);
    if (status)
      return status;
  }
  po_si_unit unit = {.factor = 1.0};
  const bool si = line->scene.given.si;
  double value[3];
  for (int k = 0; k < 3; ++k) /* the units of a scene without a radius follow from the table */
    value[k] = si ? of[k].force * of[k].units.force / of[0].units.force : of[k].force;
  if (si)
    unit = po_si_readable(&of[0].units, PO_DIMENSION_LOAD, value[0]);
  for (int k = 0; k < 3; ++k)
    value[k] = po_si_value(&unit, value[k]);
  const char *text = si ? unit.text : "pi w epsilon";
  fprintf(to, "force    %.6g %s, standard uncertainty by the noise ", value[0], text);
  if (isnan(of[0].deviation))
    fprintf(to, "not known\n");
  else
    fprintf(to, "%.2g %s\n", po_si_value(&unit, of[0].deviation), text);
  fprintf(
      to,
      "         of the left side alone %.6g, of the right side alone %.6g: uncertain by %.2g %s "
      "because they differ\n",
      value[1], value[2], 0.5 * fabs(value[1] - value[2]), text);
  return PO_OK;
}

static po_status make_profile(const profile_line *line) {
  po_scan scan;
  po_status status = po_scan_read(&line->scan, &scan);
  FILE *const to = line->output ? stdout : stderr;
  if (!status && line->scene.given.si && !*scan.column[0].unit)
    status = po_fail(PO_BAD_INPUT, "the columns %s and %s have no units: expected --units",
                     scan.column[0].name, scan.column[1].name);
  if (!status && line->output && po_path_is_same(line->output, line->scan.path))
    status =
        po_fail(PO_BAD_INPUT, "--output is %s: expected another file than the scan", line->output);
  if (!status) {
    print_scan(&scan, to);
    print_tilt(line, &scan, to);
    print_sides(line, &scan, to);
    status = write_table(line, &scan, line->sides, line->output);
  }
  if (!status && line->plot)
    status = draw_scan(line, &scan);
  if (!status && has_scene(line))
    status = print_force(line, &scan, to);
  else if (!status)
    print_next(line, &scan, to);
  po_scan_clear(&scan);
  return status;
}

int po_verb_profile(int argc, char **argv) {
  const po_options options = {
      "profile", HELP, OPTIONS, argc, argv, 1, NULL, PO_FOR_COMPARE, po_scene_options_take};
  profile_line line = {
      .request = po_input_default(), .scene = po_scene_options_begin(), .scan.end = NAN};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  line.scan.path = argv[optind];
  if (!line.scan.path)
    status = po_fail(PO_BAD_INPUT, "no scan is named: expected the name of a file");
  else if (has_scene(&line) && !line.output)
    status = po_fail(PO_BAD_INPUT, "a force needs --output, the file of the table");
  else if (has_scene(&line) && line.sides != PO_SIDES_BOTH)
    status = po_fail(PO_BAD_INPUT, "--side is %s: a force is computed of both", SIDES[line.sides]);
  if (!status)
    status = make_profile(&line);
  return po_options_end(status);
}
