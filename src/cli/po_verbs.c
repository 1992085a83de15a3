#include "po_verbs.h"

#include <stdio.h>
#include <string.h>

#include "po_options.h"
#include "po_quadrature.h"
#include "po_quote.h"
#include "po_suggest.h"

#define VERB(name, summary) {#name, po_verb_##name, summary},
static const struct {
  const char *name;
  int (*run)(int argc, char **argv);
  const char *summary;
} VERBS[] = {PO_VERBS(VERB)};

#define VERB_NAMES                                                                                 \
  "solve, compare, follow, theory, contact-law, profile, fit, plot, list, plan, run, merge, "      \
  "verify, explain, bless, conform, seal or report"

/* The name of a verb as it is written, with dashes. */
enum { NAME_LENGTH = 16 };
static const char *shown_name(const char *name, char shown[NAME_LENGTH]) {
  size_t k = 0;
  for (; name[k] && k + 1 < NAME_LENGTH; ++k)
    shown[k] = name[k] == '_' ? '-' : name[k];
  shown[k] = '\0';
  return shown;
}

static void print_help(void) {
  char name[NAME_LENGTH];
  puts("Usage: pulloff VERB [OPTION]...\n"
       "Solves the adhesive contact of a sphere that has an axisymmetric waviness, with the\n"
       "Lennard-Jones or another traction-separation law, and checks the results against "
       "references.\n");
  for (size_t i = 0; i < sizeof VERBS / sizeof *VERBS; ++i)
    printf("  %-12s %s\n", shown_name(VERBS[i].name, name), VERBS[i].summary);
  puts("\n  -h, --help  print this text, or with VERB the options of the verb\n"
       "  --version   print the version\n\n"
       "Exit codes: 0 success, 1 a check does not pass, 2 wrong usage or wrong input,\n"
       "3 a solve failed or memory ran out, 4 a file could not be read or written or a\n"
       "program is missing, 130 interrupted.\n\n"
       "Example: pulloff solve --tabor 1 --json");
}

int po_verbs_run(int argc, char **argv) {
  char name[NAME_LENGTH];
  po_gsl_return_errors();
  if (argc < 2) {
    po_fail(PO_BAD_INPUT, "no verb is given: expected " VERB_NAMES);
    return po_options_end(PO_BAD_INPUT);
  }
  if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
    print_help();
    return PO_EXIT_OK;
  }
  if (strcmp(argv[1], "--version") == 0) {
    puts("pulloff " PULLOFF_VERSION);
    return PO_EXIT_OK;
  }
  for (size_t i = 0; i < sizeof VERBS / sizeof *VERBS; ++i)
    if (strcmp(argv[1], shown_name(VERBS[i].name, name)) == 0)
      return VERBS[i].run(argc - 1, argv + 1);
  char shown[PO_QUOTE_LENGTH];
  const po_status status =
      po_fail(PO_BAD_INPUT, "unknown verb %s: expected " VERB_NAMES, po_quote(argv[1], shown));
  return po_options_end(po_suggest(status, argv[1], VERB_NAMES));
}
