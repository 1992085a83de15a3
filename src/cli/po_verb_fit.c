#include <stdio.h>
#include <string.h>

#include "po_file.h"
#include "po_number.h"
#include "po_options.h"
#include "po_plot_scene.h"
#include "po_python.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff fit CURVE --radius-m R [OPTION]...\n"
    "Finds work of adhesion, range of the attraction, modulus E* and the zeros of the instrument\n"
    "from a measured force curve of a sphere on a flat, with standard errors, by least squares\n"
    "with the full law: both stable parts of the branch and the two jumps between them. Finds its\n"
    "start itself, for stiff and for soft samples. Where the contact radius exceeds 0.3 of the\n"
    "radius, the sphere itself is fitted, too, in place of the paraboloid. The part in contact is\n"
    "also fitted by JKR, DMT and Maugis-Dugdale, and a line says whether the data prefer one of\n"
    "them. Needs Python with NumPy and SciPy.\n"
    "\n"
    "CURVE is a table with units at the end of the names of its columns, in a line below them or\n"
    "by --units: position and force or deflection, the way in and then the way out (z_nm,force_nN);\n"
    "or three columns, position, way in, way out; or a table of pulloff solve --loop. Directions\n"
    "and zeros are found.\n"
    "\n"
    "  --radius-m R            radius of the sphere, m\n"
    "  --stiffness-n-per-m K   stiffness of the cantilever at whose base the position is "
    "measured,\n"
    "                          N/m; also turns a deflection into a force (default: the position "
    "is\n"
    "                          the approach)\n"
    "  --columns NAMES         names or numbers of the two or three columns, with commas between\n"
    "                          (default: the first ones with units)\n"
    "  --units UNITS           units of these columns, such as um,nN (default: those in their "
    "names,\n"
    "                          or in a line below the names)\n"
    "  --baseline KIND         level; sloping: the force far from the sample drifts linearly with\n"
    "                          the position of the base, and its slope is fitted; auto: sloping "
    "if\n"
    "                          the slope exceeds 4 standard errors (default auto)\n"
    "  --plot FILE             draw curve and fits in FILE, which ends in .svg, .png or .pdf "
    "(needs\n"
    "                          matplotlib)\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n"
    "Example: pulloff fit curve.csv --radius-m 3e-8 --stiffness-n-per-m 2 --plot fit.svg\n";

typedef struct {
  double radius, stiffness;
  const char *columns, *units, *baseline, *plot;
  bool json;
} fit_line;

static po_status take_baseline(const char *name, void *baseline) {
  *(const char **)baseline = optarg;
  return strcmp(optarg, "auto") == 0 || strcmp(optarg, "level") == 0 ||
                 strcmp(optarg, "sloping") == 0
             ? PO_OK
             : po_options_refuse(name, optarg, "auto, level or sloping");
}

static const po_option OPTIONS[] = {
    PO_NUMBER("radius-m", fit_line, radius, 0.0, "a number > 0"),
    PO_NUMBER("stiffness-n-per-m", fit_line, stiffness, 0.0, "a number > 0"),
    PO_TEXT("columns", fit_line, columns, "two or three names or numbers"),
    PO_TEXT("units", fit_line, units, "two or three units"),
    PO_TAKEN("baseline", fit_line, baseline, take_baseline),
    PO_TAKEN("plot", fit_line, plot, po_plot_take_file),
    PO_FLAG("json", fit_line, json),
    {0}};

static int run_fit(const fit_line *line, char *curve) {
  char radius[PO_NUMBER_LENGTH], stiffness[PO_NUMBER_LENGTH];
  po_number_print(line->radius, radius);
  po_number_print(line->stiffness, stiffness);
  const struct {
    const char *option, *value; /* NULL: not given */
  } items[] = {{"--radius-m", radius},
               {"--stiffness-n-per-m", line->stiffness > 0.0 ? stiffness : NULL},
               {"--columns", line->columns},
               {"--units", line->units},
               {"--baseline", line->baseline},
               {"--plot", line->plot}};
  enum { ITEMS = sizeof items / sizeof *items, BEFORE = 4 };
  char *argv[BEFORE + 2 * ITEMS + 2] = {(char *)po_python(), "-m", "pulloff.fit", curve};
  int count = BEFORE;
  for (int k = 0; k < ITEMS; ++k)
    if (items[k].value) {
      argv[count++] = (char *)items[k].option;
      argv[count++] = (char *)items[k].value;
    }
  if (line->json)
    argv[count++] = "--json";
  return po_python_run(argv);
}

int po_verb_fit(int argc, char **argv) {
  const po_options options = {"fit", HELP, OPTIONS, argc, argv, 1};
  fit_line line = {0};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  if (!argv[optind])
    status = po_fail(PO_BAD_INPUT, "no curve is named: expected the name of a file");
  else if (!(line.radius > 0.0))
    status = po_fail(PO_BAD_INPUT, "--radius-m is missing: expected the radius of the sphere, m");
  else if (!po_path_exists(argv[optind]))
    status = po_fail(PO_CANNOT_READ, "%s does not exist: expected a table", argv[optind]);
  else if (!*po_program_find(po_python()).text)
    status = po_fail(PO_MISSING_TOOL, "%s was not found: expected Python, which fits the curve",
                     po_python());
  return status ? po_options_end(status) : run_fit(&line, argv[optind]);
}
