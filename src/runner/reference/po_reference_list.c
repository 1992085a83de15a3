#include "po_reference_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"

static const char FOLDER[] = "reference", INDEX[] = "reference/index.txt",
                  PUBLISHED[] = "reference/published";

static po_reference_entry *find_entry(const po_reference_list *list, const char *name) {
  for (size_t i = 0; i < list->count; ++i)
    if (strcmp(list->entries[i].name, name) == 0)
      return &list->entries[i];
  return NULL;
}

/* Adds folder/name, unless the list already contains it. */
static po_status add_entry(po_reference_list *list, const char *folder, const char *name,
                           bool listed) {
  const po_file_path whole = po_path_join(folder, name);
  if (find_entry(list, whole.text))
    return PO_OK;
  po_reference_entry *entries = po_resize(list->entries, list->count + 1, sizeof *entries);
  if (!entries)
    return PO_NO_MEMORY;
  list->entries = entries;
  po_reference_entry *entry = &entries[list->count++];
  *entry = (po_reference_entry){.name = po_copy_text(whole.text), .listed = listed};
  return entry->name ? PO_OK : PO_NO_MEMORY;
}

static po_status add_listed(const char *data_folder, po_reference_list *list) {
  char *text = NULL, *rest = NULL;
  size_t size = 0;
  po_status status = po_file_read(po_path_join(data_folder, INDEX).text, &text, &size);
  for (char *line = status ? NULL : strtok_r(text, "\r\n", &rest); !status && line;
       line = strtok_r(NULL, "\r\n", &rest))
    if (line[0] != '#')
      status = add_entry(list, FOLDER, line, true);
  free(text);
  return status;
}

/* Adds the tables of a folder; PUBLISHED may be absent. */
static po_status add_found(const char *data_folder, const char *folder, po_reference_list *list) {
  char **names = NULL;
  size_t count = 0;
  const po_file_path path = po_path_join(data_folder, folder);
  po_status status = PO_OK;
  if (folder != PUBLISHED || po_path_exists(path.text))
    status = po_folder_list(path.text, ".csv", &names, &count);
  for (size_t i = 0; !status && i < count; ++i)
    status = add_entry(list, folder, names[i], false);
  po_names_free(names, count);
  return status;
}

static void read_entry(const char *data_folder, po_reference_entry *entry) {
  po_reference reference;
  const po_status status = po_reference_open(data_folder, entry->name, &reference);
  entry->intact = status == PO_OK;
  if (status) {
    snprintf(entry->message, sizeof entry->message, "%s", po_message());
    return;
  }
  entry->ledger = reference.ledger;
  entry->rows = reference.table.row_count;
  snprintf(entry->uncertainty, sizeof entry->uncertainty, "%s",
           po_csv_find_header(&reference.table, "uncertainty")->value);
  po_reference_close(&reference);
}

static int by_name(const void *a, const void *b) {
  const po_reference_entry *x = a, *y = b;
  return strcmp(x->name, y->name);
}

po_status po_reference_list_open(const char *data_folder, po_reference_list *list) {
  *list = (po_reference_list){0};
  po_status status = add_listed(data_folder, list);
  if (!status)
    status = add_found(data_folder, FOLDER, list);
  if (!status)
    status = add_found(data_folder, PUBLISHED, list);
  for (size_t i = 0; !status && i < list->count; ++i)
    read_entry(data_folder, &list->entries[i]);
  if (status)
    po_reference_list_close(list);
  else if (list->count)
    qsort(list->entries, list->count, sizeof *list->entries, by_name);
  return status;
}

po_status po_reference_list_check(const po_reference_list *list) {
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

void po_reference_list_close(po_reference_list *list) {
  for (size_t i = 0; i < list->count; ++i)
    free(list->entries[i].name);
  free(list->entries);
  *list = (po_reference_list){0};
}
