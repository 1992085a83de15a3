#include <stdio.h>

#include "po_catalog.h"
#include "po_environment.h"
#include "po_options.h"
#include "po_pins.h"
#include "po_plan.h"
#include "po_print.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff plan CASE...\n"
    "Prints what would be computed for a case, what would not, and why. Solves nothing. CASE is a\n"
    "name (see pulloff list) or the path of a YAML file.\n"
    "\n"
    "  -h, --help   print this text\n"
    "\n"
    "Example: pulloff plan fig03\n";

static const struct option OPTIONS[] = {{"help", no_argument, NULL, PO_OPTION_HELP},
                                        {NULL, 0, NULL, 0}};

static po_status print_plan(const po_case *kase) {
  po_plan *plan = NULL;
  const po_status status = po_plan_create(kase, po_environment_data(), &plan);
  if (status)
    return status;
  printf("%s: %s\n", kase->file->name, kase->file->title);
  for (size_t i = 0; i < plan->line_count; ++i)
    printf("  %s\n", plan->lines[i]);
  bool lacking = false;
  for (unsigned c = 0; c < kase->file->checks_count; ++c)
    lacking = lacking ||
              (po_check_is_pin(&kase->file->checks[c]) && !po_pins_exist(&plan->references[c]));
  if (lacking)
    po_print_bless(kase);
  po_plan_destroy(plan);
  return PO_OK;
}

int po_verb_plan(int argc, char **argv) {
  const po_options options = {"plan", HELP, OPTIONS, argc, argv, NULL};
  po_catalog catalog = {0};
  po_status status = PO_OK;
  if (!po_options_read(&options, NULL, NULL, &status))
    return po_options_end(status);
  if (optind == argc)
    status = po_fail(PO_BAD_INPUT, "plan needs the name of a case (see pulloff plan --help)");
  if (!status)
    status = po_catalog_open(po_environment_data(), argv + optind, (size_t)(argc - optind),
                             (po_suites){0}, &catalog);
  for (size_t i = 0; !status && i < catalog.count; ++i)
    status = print_plan(catalog.cases[i]);
  po_catalog_close(&catalog);
  return po_options_end(status);
}
