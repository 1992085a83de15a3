#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_catalog.h"
#include "po_environment.h"
#include "po_machine.h"
#include "po_memory.h"
#include "po_options.h"
#include "po_order.h"
#include "po_plan.h"
#include "po_print.h"
#include "po_solve.h"
#include "po_text.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff plan [--json] CASE...\n"
    "Prints what would be computed for a case, what would not, and why, and the nodes and the "
    "memory\n"
    "that a solve needs at most. Solves nothing. CASE is a name (see pulloff list) or the path of "
    "a\n"
    "YAML file.\n"
    "\n"
    "  --json       print one JSON document, with the nodes and the memory of every point, and\n"
    "               nothing else\n"
    "  -h, --help   print this text\n"
    "\n"
    "Example: pulloff plan fig03\n";

static const po_option OPTIONS[] = {{.name = "json", .kind = PO_OPTION_IS_FLAG}, {0}};

/* The most that the points of a case need. */
typedef struct {
  po_size largest;
  size_t point;    /* that needs it */
  double together; /* bytes of as many solves at the same time as there are processors */
} needs;

static po_status find_needs(const po_plan *plan, needs *found) {
  const size_t count = plan->kase->point_count, cores = (size_t)po_environment_cores();
  double *bytes = po_allocate(count, sizeof *bytes);
  if (!bytes)
    return PO_NO_MEMORY;
  *found = (needs){0};
  for (size_t i = 0; i < count; ++i) {
    const po_request request = po_plan_request(plan, i);
    const po_size size = po_request_size(&request);
    bytes[i] = size.bytes;
    if (size.bytes > found->largest.bytes) {
      found->largest = size;
      found->point = i;
    }
  }
  qsort(bytes, count, sizeof *bytes, po_order_ascending);
  for (size_t i = 1; i <= count && i <= cores; ++i)
    found->together += bytes[count - i];
  free(bytes);
  return PO_OK;
}

static double megabytes(double bytes) {
  return ceil(bytes / 1e6);
}

/* Prints what the points need, and what to do if the machine has not that much. */
static po_status print_needs(const po_plan *plan) {
  const double memory = po_machine_memory();
  needs n;
  const po_status status = find_needs(plan, &n);
  if (status)
    return status;
  printf("  need at most %zu nodes and %.0f MB of memory a solve: %s\n", n.largest.nodes,
         megabytes(n.largest.bytes), plan->kase->points[n.point].label);
  if (n.largest.nodes > PO_MOST_NODES_OF_MESH)
    printf(
        "  but a mesh has at most %zu nodes: cut the surface with outer_radius, or give a larger "
        "tolerance, if the solve ends with out_of_nodes\n",
        PO_MOST_NODES_OF_MESH);
  if (n.largest.bytes > memory)
    printf("  but this machine has %.0f MB: cut the surface with outer_radius, give a larger "
           "tolerance, or leave such points out\n",
           megabytes(memory));
  else if (n.together > memory)
    printf("  but this machine has %.0f MB for %d %s at a time: pulloff run --jobs %.0f\n",
           megabytes(memory), po_environment_cores(),
           po_one_or_more((size_t)po_environment_cores(), "solve", "solves"),
           floor(memory / n.largest.bytes));
  return PO_OK;
}

static po_status print_plan(const po_plan *plan) {
  const po_case *kase = plan->kase;
  json_t *lines = po_plan_describe(plan);
  po_status status = lines ? PO_OK : PO_NO_MEMORY;
  if (!status)
    printf("%s: %s\n", kase->file->name, kase->file->title);
  for (size_t i = 0; i < json_array_size(lines); ++i)
    printf("  %s\n", json_string_value(json_array_get(lines, i)));
  json_decref(lines);
  if (!status)
    status = print_needs(plan);
  return status;
}

static json_t *point_json(const po_plan *plan, size_t i) {
  const po_request request = po_plan_request(plan, i);
  const po_size size = po_request_size(&request);
  const po_point *point = &plan->kase->points[i];
  return PO_JSON_OBJECT({"point", po_json_text(point->id)}, {"label", po_json_text(point->label)},
                        {"nodes", po_json_count(size.nodes)},
                        {"bytes", po_json_number(size.bytes)});
}

static json_t *plan_json(const po_plan *plan) {
  const po_case_file *file = plan->kase->file;
  json_t *points = po_json_empty_array();
  for (size_t i = 0; i < plan->kase->point_count; ++i)
    po_json_append(&points, point_json(plan, i));
  return PO_JSON_OBJECT({"case", po_json_text(file->name)}, {"title", po_json_text(file->title)},
                        {"plan", po_plan_describe(plan)}, {"points", points});
}

int po_verb_plan(int argc, char **argv) {
  const po_options options = {"plan", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  po_catalog catalog = {0};
  po_status status = PO_OK;
  bool json = false;
  json_t *plans = NULL;
  if (!po_options_read(&options, &json, &status))
    return po_options_end(status);
  if (optind == argc)
    status = po_fail(PO_BAD_INPUT, "plan needs the name of a case (see pulloff plan --help)");
  if (!status)
    status = po_catalog_open(po_environment_data(), argv + optind, (size_t)(argc - optind),
                             (po_suites){0}, &catalog);
  if (json)
    plans = po_json_empty_array();
  for (size_t i = 0; !status && i < catalog.count; ++i) {
    po_plan *plan = NULL;
    status = po_plan_create(catalog.cases[i], po_environment_data(), NULL, &plan);
    if (!status && json)
      po_json_append(&plans, plan_json(plan));
    else if (!status)
      status = print_plan(plan);
    po_plan_destroy(plan);
  }
  if (json && !status)
    status = po_print_document(PO_JSON_OBJECT({"schema", po_json_text("pulloff-plan/1")},
                                              {"memory", po_json_number(po_machine_memory())},
                                              {"cases", plans}));
  else
    json_decref(plans);
  po_catalog_close(&catalog);
  return po_options_end(status);
}
