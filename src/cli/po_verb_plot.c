#include <string.h>

#include "po_plot.h"
#include "po_plot_scene.h"
#include "po_solve_line.h"
#include "po_verbs.h"

static const char PLOT_HELP[] =
    "Usage: pulloff plot [OPTION]... [FILE]\n"
    "       pulloff plot [--run DIR] CASE [FILE]\n"
    "Plots one scene, which is given by the options of pulloff solve, or the pull-off forces of a\n"
    "case against the number that varies in it, or as a map if two numbers vary. FILE ends in\n"
    ".svg, .png or .pdf and is drawn with gnuplot; without FILE, the plot is printed as\n"
    "characters. Axes are in SI units after --from-physical.\n"
    "\n"
    "  --want LIST       what is plotted, separated by commas (default: curve,hysteresis):\n"
    "                      curve        load against approach: the branch, its folds, the "
    "pull-off\n"
    "                      hysteresis   the paths of loading and unloading with their jumps; with\n"
    "                                   --stiffness also over the position of the base\n"
    "                      profile      gap and traction against radius at pull-off\n"
    "                      preload      the pull-off force for every preload\n"
    "  --run DIR         folder of the records of CASE (default build/run); points without a\n"
    "                    result are solved\n"
    "  -h, --help        print this text\n"
    "\n"
    "The options of the scene, the preload and the discretisation are those of pulloff solve.\n"
    "\n"
    "Example: pulloff plot --tabor 3 --amplitude 1 --wavelength 20 wavy.svg\n"
    "         pulloff plot --tabor 3 --amplitude 1 --wavelength 20 --stiffness 0.3 spring.pdf\n"
    "         pulloff plot fig15\n";

/* Beside the options of keys. */
static const po_option OPTIONS[] = {
    PO_TEXT("run", po_solve_line, run, "the name of a folder"), PO_SOLVE_LINE_OPTIONS, {0}};

/* Takes the operands of plot: a case, a figure, or both in this order. */
static po_status take_operands(po_solve_line *line, const po_options *options, char **name) {
  const int count = options->argc - optind;
  char **operand = options->argv + optind;
  const bool figure = count > 0 && po_plot_is_figure(operand[count - 1]);
  if (count > 2 || (count == 2 && !figure))
    return po_fail(PO_BAD_INPUT,
                   "plot takes a case and a file that ends in .svg, .png or .pdf (see "
                   "pulloff plot --help)");
  line->plot = figure ? operand[count - 1] : NULL;
  *name = count > figure ? operand[0] : NULL;
  if (line->run && !*name)
    return po_fail(PO_BAD_INPUT, "--run is given without a case: expected both");
  return line->json
             ? po_fail(PO_BAD_INPUT, "--json has no effect on plot: expected it to be left out")
             : PO_OK;
}

/* Solves the scene and plots it. */
static po_status plot(po_solve_line *line) {
  po_result result = {0};
  po_status status = po_solve_line_observe(line, &result);
  if (!status)
    status = po_plot_of_solve(&line->request, &result, line->plot);
  po_result_clear(&result);
  return status;
}

/* Whether the preload is inf, for which there is no hysteresis. */
static bool seeks_all(const po_given *given) {
  const char *preload = given->text[given->si ? PO_KEY_PRELOAD_M : PO_KEY_PRELOAD];
  return preload && strcmp(preload, "inf") == 0;
}

int po_verb_plot(int argc, char **argv) {
  const po_options options = {"plot", PLOT_HELP, OPTIONS,      argc,
                              argv,   NULL,      PO_FOR_SOLVE, po_solve_line_take_key};
  po_solve_line line = po_solve_line_begin();
  char *name = NULL;
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  const bool scene = optind > (line.run ? 3 : 1); /* options other than --run DIR */
  status = take_operands(&line, &options, &name);
  if (!status && name && scene)
    status =
        po_fail(PO_BAD_INPUT, "options of a scene have no effect on a case: expected them to be "
                              "left out");
  if (!status && name)
    return po_options_end(po_plot_case(name, line.run, line.plot));
  po_solve_line_add_wants(&line);
  if (!(line.request.want & PO_PLOT_WANTS))
    line.request.want |=
        seeks_all(&line.scene.given) ? PO_WANT_CURVE : PO_WANT_CURVE | PO_WANT_HYSTERESIS;
  else if (line.request.want & PO_WANT_HYSTERESIS)
    line.request.want |= PO_WANT_CURVE;
  if (!status)
    status = po_solve_line_end(&line);
  return po_options_end(status ? status : plot(&line));
}
