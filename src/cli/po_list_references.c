#include "po_list_references.h"

#include <stdio.h>
#include <string.h>

#include "po_environment.h"
#include "po_print.h"
#include "po_quote.h"
#include "po_reference_list.h"

/* Whether a check of the case has the table as its reference. */
static bool uses(const po_case *kase, const char *name) {
  for (unsigned i = 0; i < kase->file->checks_count; ++i)
    if (strcmp(kase->file->checks[i].reference, name) == 0)
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
    printf("%-34s %-10s %5zu  %-22s %s\n", name, po_ledger_name(entry->ledger), entry->rows,
           *cases ? cases : "-", state_of(entry));
  else
    printf("%-34s %-10s %5s  %-22s damaged: %s\n", name, "-", "-", *cases ? cases : "-",
           entry->message);
}

static json_t *entry_json(const po_reference_entry *entry, const po_catalog *catalog) {
  json_t *object = PO_JSON_OBJECT(
      {"table", po_json_text(entry->name)}, {"intact", po_json_flag(entry->intact)},
      {"in_index", po_json_flag(entry->listed)}, {"cases", users(catalog, entry->name)});
  if (entry->intact) {
    po_json_set(&object, "kind", po_json_text(po_ledger_name(entry->ledger)));
    po_json_set(&object, "rows", po_json_count(entry->rows));
    po_json_set(&object, "uncertainty", po_json_text(entry->uncertainty));
  } else {
    po_json_set(&object, "reason", po_json_text(entry->message));
  }
  return object;
}

static po_status print_json(const po_reference_list *list, const po_catalog *catalog) {
  json_t *tables = po_json_empty_array();
  for (size_t i = 0; i < list->count; ++i)
    po_json_append(&tables, entry_json(&list->entries[i], catalog));
  return po_print_document(
      PO_JSON_OBJECT({"schema", po_json_text("pulloff-references/1")}, {"references", tables}));
}

po_status po_list_references_check(const po_reference_list *list) {
  const po_reference_entry *first = NULL;
  size_t damaged = 0;
  for (size_t i = 0; i < list->count; ++i)
    if (!list->entries[i].intact) {
      first = first ? first : &list->entries[i];
      damaged += 1;
    }
  if (!first)
    return PO_OK;
  char more[64] = "";
  if (damaged > 1)
    snprintf(more, sizeof more, " (and %zu more: pulloff list --references)", damaged - 1);
  return po_fail(PO_CANNOT_READ, "%s%s", first->message, more);
}

po_status po_list_references(const po_catalog *catalog, bool json) {
  po_reference_list list;
  po_status status = po_reference_list_open(po_environment_data(), &list);
  if (status)
    return status;
  if (json) {
    status = print_json(&list, catalog);
  } else {
    printf("%-34s %-10s %5s  %-22s %s\n", "table", "kind", "rows", "cases", "state");
    for (size_t i = 0; i < list.count; ++i)
      print_entry(&list.entries[i], catalog);
  }
  if (!status)
    status = po_list_references_check(&list);
  po_reference_list_close(&list);
  return status;
}
