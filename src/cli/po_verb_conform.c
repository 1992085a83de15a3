#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "po_conform.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_live.h"
#include "po_options.h"
#include "po_print.h"
#include "po_text.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff conform [OPTION]... MANIFEST\n"
    "Tests whether an external solver follows the protocol and computes known scenes: starts the\n"
    "command of the manifest with an empty request, with smooth spheres that it accepts, near the\n"
    "limits of Bradley and JKR if possible, with repeats, with a scene that the manifest "
    "excludes,\n"
    "and ends it while it works. A wrong sign, unit or factor is named, and so is a manifest that\n"
    "accepts no scene with a known solution. The program of the command runs in a folder of its\n"
    "own with a minimal environment; where the kernel allows it, it can write nowhere else. The\n"
    "exit code is 1 if a line begins with wrong.\n"
    "\n"
    "  --knob VALUE      value of the knob of the manifest (default: the last one)\n"
    "  --output DIR      folder in which the solver runs (default build/run)\n"
    "  -h, --help        print this text\n"
    "\n"
    "Example: pulloff conform reference/solvers/newton.yaml\n";

typedef struct {
  const char *knob, *output;
} conform_line;

static const po_option OPTIONS[] = {PO_TEXT("knob", conform_line, knob, "a value of the knob"),
                                    PO_OUTPUT(conform_line, output, "the name of a folder"),
                                    {0}};

/* Returned: the length of the part of a path that exists. */
static size_t existing_part(po_file_path path) {
  char *part = path.text, *slash = NULL;
  while (!po_path_exists(part) && (slash = strrchr(part, '/')))
    *slash = '\0';
  return po_path_exists(part) ? strlen(part) : 0;
}

/* Removes the empty folders at the end of a path, except its first `kept` characters. */
static void remove_empty(char *path, size_t kept) {
  char *slash = NULL;
  while (strlen(path) > kept && rmdir(path) == 0 && (slash = strrchr(path, '/')))
    *slash = '\0';
}

int po_verb_conform(int argc, char **argv) {
  const po_options options = {"conform", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  conform_line line = {.output = "build/run"};
  po_solver *solver = NULL;
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  if (argc - optind != 1)
    status = po_fail(PO_BAD_INPUT, "conform needs one manifest (see pulloff conform --help)");
  if (!status)
    status = po_solver_read(argv[optind], line.knob, &solver);
  size_t wrong = 0;
  if (!status) {
    po_file_path folder = po_solver_folder(solver, line.output);
    const size_t existing = existing_part(folder);
    po_print_solver(solver, stdout);
    status = po_conform(solver, po_environment_data(), folder.text, po_interrupt_listen(), &wrong);
    remove_empty(folder.text, existing);
  }
  if (!status && wrong)
    printf("%zu %s wrong\n", wrong, po_one_or_more(wrong, "finding is", "findings are"));
  const int code = status ? po_options_end(status) : wrong ? PO_EXIT_OUTSIDE : PO_EXIT_OK;
  po_solver_destroy(solver);
  return code;
}
