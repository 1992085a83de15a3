#include <stdio.h>

#include "po_options.h"
#include "po_seal.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff seal [OPTION]... FILE...\n"
    "Makes reference tables of CSV files: completes the header lines that every table must have,\n"
    "and writes the checksum. Use it only for a table whose numbers you have just checked: a "
    "table\n"
    "with a correct checksum counts as undamaged. Options are needed for the headers that the\n"
    "files do not have; they replace those that they have. reference/README.md describes the\n"
    "headers.\n"
    "\n"
    "  --what TEXT         what the numbers are\n"
    "  --source TEXT       where they come from: a citation with the equation or figure\n"
    "  --kind KIND         oracle (exact, or many digits by an independent method) or published\n"
    "  --method TEXT       how they were computed or read off\n"
    "  --units TEXT        their units\n"
    "  --uncertainty U     a bound of their error: a number, or in words with columns\n"
    "                      NAME_uncertainty\n"
    "  --date DATE         when they were made (default: today)\n"
    "  --generator TEXT    the program that made them (default: by hand)\n"
    "  --command TEXT      the command that makes them again (default: pulloff seal FILE)\n"
    "  -h, --help          print this text\n"
    "\n"
    "Example: pulloff seal --what 'pull-off of my tip' --source 'Smith 2024, Fig. 3' \\\n"
    "           --kind published --method digitised --units 'pi w R' --uncertainty 0.01 tip.csv\n";

/* The values are those of PO_SEAL_NAMES, counted from 1. */
static const struct option OPTIONS[] = {{"what", required_argument, NULL, 1},
                                        {"source", required_argument, NULL, 2},
                                        {"kind", required_argument, NULL, 3},
                                        {"method", required_argument, NULL, 4},
                                        {"units", required_argument, NULL, 5},
                                        {"uncertainty", required_argument, NULL, 6},
                                        {"date", required_argument, NULL, 7},
                                        {"generator", required_argument, NULL, 8},
                                        {"command", required_argument, NULL, 9},
                                        {"help", no_argument, NULL, PO_OPTION_HELP},
                                        {NULL, 0, NULL, 0}};

static po_status take_option(void *to, int option) {
  const char **values = to;
  return po_options_take_text(PO_SEAL_NAMES[option - 1], "a text", &values[option - 1]);
}

int po_verb_seal(int argc, char **argv) {
  const po_options options = {"seal", HELP, OPTIONS, argc, argv, NULL};
  const char *values[PO_SEAL_HEADERS] = {NULL};
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, values, &status))
    return po_options_end(status);
  if (optind == argc)
    status = po_fail(PO_BAD_INPUT, "seal needs the names of tables (see pulloff seal --help)");
  for (int i = optind; !status && i < argc; ++i) {
    status = po_seal(argv[i], values);
    if (!status)
      printf("%s is sealed\n", argv[i]);
  }
  return po_options_end(status);
}
