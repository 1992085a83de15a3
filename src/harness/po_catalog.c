#include "po_catalog.h"

#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"
#include "po_text.h"

/* Adds a case; takes it. A name may stand for one case only. */
static po_status add(po_catalog *catalog, po_case *kase) {
  for (size_t i = 0; i < catalog->count; ++i)
    if (strcmp(catalog->cases[i]->file->name, kase->file->name) == 0) {
      const po_status status =
          po_fail(PO_BAD_INPUT, "%s: name is %s: expected another, it is that of %s", kase->shown,
                  kase->file->name, catalog->cases[i]->shown);
      po_case_destroy(kase);
      return status;
    }
  po_case **cases = po_resize(catalog->cases, catalog->count + 1, sizeof(po_case *));
  if (!cases) {
    po_case_destroy(kase);
    return PO_NO_MEMORY;
  }
  catalog->cases = cases;
  cases[catalog->count++] = kase;
  return PO_OK;
}

static po_status read_and_add(po_catalog *catalog, const char *path, const char *shown) {
  po_case *kase = NULL;
  const po_status status = po_case_read(path, shown, &kase);
  return status ? status : add(catalog, kase);
}

static po_status read_folder(const char *data_folder, po_catalog *catalog) {
  char **names = NULL;
  size_t count = 0;
  char *folder = po_path_join(data_folder, "cases");
  po_status status = folder ? po_folder_list(folder, ".yaml", &names, &count) : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < count; ++i) {
    char *path = po_path_join(folder, names[i]), *shown = po_path_join("cases", names[i]);
    status = path && shown ? read_and_add(catalog, path, shown) : PO_NO_MEMORY;
    free(path);
    free(shown);
  }
  po_names_free(names, count);
  free(folder);
  return status;
}

static bool is_path(const char *name) {
  const size_t length = strlen(name);
  return strchr(name, '/') || (length > 5 && strcmp(name + length - 5, ".yaml") == 0);
}

static po_status refuse_name(const po_catalog *all, const char *name) {
  po_text known = {0};
  for (size_t i = 0; i < all->count; ++i)
    po_text_add(&known, "%s%s", i ? ", " : "", all->cases[i]->file->name);
  const po_status status = po_fail(PO_BAD_INPUT, "no case is named %s: expected one of %s", name,
                                   po_text_string(&known));
  po_text_clear(&known);
  return status;
}

/* Moves the case of that name from one catalog to another. */
static po_status move(po_catalog *from, const char *name, po_catalog *to) {
  for (size_t i = 0; i < to->count; ++i)
    if (strcmp(to->cases[i]->file->name, name) == 0)
      return PO_OK; /* asked for twice */
  for (size_t i = 0; i < from->count; ++i)
    if (strcmp(from->cases[i]->file->name, name) == 0) {
      po_case *kase = from->cases[i];
      memmove(&from->cases[i], &from->cases[i + 1], (from->count - i - 1) * sizeof *from->cases);
      from->count -= 1;
      return add(to, kase);
    }
  return refuse_name(from, name);
}

static po_status take_suites(po_catalog *all, unsigned suites, po_catalog *catalog) {
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < all->count;) {
    if (!suites || (all->cases[i]->suites & suites))
      status = move(all, all->cases[i]->file->name, catalog);
    else
      ++i;
  }
  return status;
}

po_status po_catalog_open(const char *data_folder, char *const *names, size_t name_count,
                          unsigned suites, po_catalog *catalog) {
  po_catalog all = {0};
  *catalog = (po_catalog){0};
  bool needs_folder = name_count == 0;
  for (size_t i = 0; i < name_count; ++i)
    needs_folder = needs_folder || !is_path(names[i]);
  po_status status = needs_folder ? read_folder(data_folder, &all) : PO_OK;
  if (!status && name_count == 0)
    status = take_suites(&all, suites, catalog);
  for (size_t i = 0; !status && i < name_count; ++i)
    status = is_path(names[i]) ? read_and_add(catalog, names[i], names[i])
                               : move(&all, names[i], catalog);
  po_catalog_close(&all);
  if (status)
    po_catalog_close(catalog);
  return status;
}

void po_catalog_close(po_catalog *catalog) {
  for (size_t i = 0; i < catalog->count; ++i)
    po_case_destroy(catalog->cases[i]);
  free(catalog->cases);
  *catalog = (po_catalog){0};
}
