#include <stdio.h>
#include <string.h>

#include "po_environment.h"
#include "po_json.h"
#include "po_print.h"
#include "po_quote.h"
#include "po_reference_list.h"
#include "po_session.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff list [OPTION]...\n"
    "Lists the cases with their number of points and checks, or the reference tables.\n"
    "\n"
    "  --suite S[,S]   list only the cases of these suites (default: all cases)\n"
    "  --references    list the reference tables instead, and check them; exit code 4 if a table\n"
    "                  is missing, truncated or altered\n"
    "  --json          print one JSON document and nothing else\n"
    "  -h, --help      print this text\n"
    "\n"
    "Example: pulloff list --suite paper\n";

typedef struct {
  const char *suites; /* NULL: all */
  bool json, references;
} list_line;

static const po_option OPTIONS[] = {PO_TEXT("suite", list_line, suites, "names of suites"),
                                    PO_FLAG("references", list_line, references),
                                    PO_FLAG("json", list_line, json),
                                    {0}};

/* Whether a check of the case has the table, or a row of it, as its reference. */
static bool uses(const po_case *kase, const char *name) {
  for (unsigned i = 0; i < kase->file->checks_count; ++i)
    if (strcmp(po_reference_file(kase->file->checks[i].reference).text, name) == 0)
      return true;
  return false;
}

static json_t *users(const po_catalog *catalog, const char *name) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < catalog->count; ++i)
    if (uses(catalog->cases[i], name))
      po_json_append(&array, po_json_text(catalog->cases[i]->file->name));
  return array;
}

static const char *state_of(const po_reference_entry *entry) {
  return !entry->intact ? "damaged" : entry->listed ? "intact" : "intact, not in the index";
}

static void print_entry(const po_reference_entry *entry, const po_catalog *catalog) {
  char cases[200] = "", name[256];
  po_quote_text(entry->name, name, sizeof name);
  for (size_t i = 0; i < catalog->count; ++i)
    if (uses(catalog->cases[i], entry->name) && strlen(cases) < 130)
      snprintf(cases + strlen(cases), sizeof cases - strlen(cases), "%s%s", *cases ? "," : "",
               catalog->cases[i]->file->name);
  if (entry->intact)
    printf("%-34s %-10s %5zu  %-22s %s\n", name, PO_LEDGERS[entry->ledger], entry->rows,
           *cases ? cases : "-", state_of(entry));
  else
    printf("%-34s %-10s %5s  %-22s damaged: %s\n", name, "-", "-", *cases ? cases : "-",
           entry->message);
}

static json_t *entry_json(const po_reference_entry *entry, const po_catalog *catalog) {
  json_t *object = PO_JSON_OBJECT(
      {"table", po_json_text(entry->name)}, {"intact", json_boolean(entry->intact)},
      {"in_index", json_boolean(entry->listed)}, {"cases", users(catalog, entry->name)});
  if (entry->intact) {
    po_json_set(&object, "kind", po_json_text(PO_LEDGERS[entry->ledger]));
    po_json_set(&object, "rows", po_json_count(entry->rows));
    po_json_set(&object, "uncertainty", po_json_text(entry->uncertainty));
  } else {
    po_json_set(&object, "reason", po_json_text(entry->message));
  }
  return object;
}

static po_status print_references_json(const po_reference_list *list, const po_catalog *catalog) {
  json_t *tables = po_json_empty_array();
  for (size_t i = 0; i < list->count; ++i)
    po_json_append(&tables, entry_json(&list->entries[i], catalog));
  return po_print_document(
      PO_JSON_OBJECT({"schema", po_json_text("pulloff-references/1")}, {"references", tables}));
}

/* Prints every reference table, whether it is intact, and which cases use it. Status: after all
 * tables have been printed, PO_CANNOT_READ if one is not intact. */
static po_status print_references(const po_catalog *catalog, bool json) {
  po_reference_list list;
  po_status status = po_reference_list_open(po_environment_data(), &list);
  if (status)
    return status;
  if (json) {
    status = print_references_json(&list, catalog);
  } else {
    printf("%-34s %-10s %5s  %-22s %s\n", "table", "kind", "rows", "cases", "state");
    for (size_t i = 0; i < list.count; ++i)
      print_entry(&list.entries[i], catalog);
  }
  if (!status)
    status = po_reference_list_check(&list);
  po_reference_list_close(&list);
  return status;
}

static void print_table(const po_catalog *catalog) {
  printf("%-20s %-7s %6s %6s  %-20s %s\n", "case", "figure", "points", "checks", "suites", "title");
  for (size_t i = 0; i < catalog->count; ++i) {
    const po_case *kase = catalog->cases[i];
    po_text suites = {0};
    for (unsigned k = 0; k < kase->file->suite_names_count; ++k)
      po_text_add(&suites, "%s%s", k ? "," : "", kase->file->suite_names[k]);
    printf("%-20s %-7s %6zu %6u  %-20s %s\n", kase->file->name,
           kase->file->figure ? kase->file->figure : "-", kase->point_count,
           kase->file->checks_count, po_text_string(&suites), kase->file->title);
    po_text_clear(&suites);
  }
}

static json_t *case_json(const po_case *kase) {
  const po_case_file *file = kase->file;
  return PO_JSON_OBJECT({"case", po_json_text(file->name)}, {"title", po_json_text(file->title)},
                        {"file", po_json_text(kase->shown)}, {"figure", po_json_text(file->figure)},
                        {"equations", po_json_text(file->equations)},
                        {"suites", po_json_texts(file->suite_names, file->suite_names_count)},
                        {"points", po_json_count(kase->point_count)},
                        {"checks", po_json_count(file->checks_count)});
}

static po_status print_json(const po_catalog *catalog) {
  json_t *cases = po_json_empty_array();
  for (size_t i = 0; i < catalog->count; ++i)
    po_json_append(&cases, case_json(catalog->cases[i]));
  return po_print_document(
      PO_JSON_OBJECT({"schema", po_json_text("pulloff-list/1")}, {"cases", cases}));
}

int po_verb_list(int argc, char **argv) {
  const po_options options = {"list", HELP, OPTIONS, argc, argv};
  po_catalog catalog = {0};
  list_line line = {0};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  status =
      po_catalog_open(po_environment_data(), NULL, 0, (po_suites){.names = line.suites}, &catalog);
  if (!status && line.references)
    status = print_references(&catalog, line.json);
  else if (!status && line.json)
    status = print_json(&catalog);
  else if (!status)
    print_table(&catalog);
  po_catalog_close(&catalog);
  return po_options_end(status);
}
