#include "po_catalog.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"
#include "po_quote.h"
#include "po_suggest.h"
#include "po_text.h"

/* The ending of the name of a case file. */
static const char ENDING[] = ".yaml";

/* Returned: where the case with a name is in a catalog; NULL: it has none. */
static po_case **find_case(const po_catalog *catalog, const char *name) {
  for (size_t i = 0; i < catalog->count; ++i)
    if (strcmp(catalog->cases[i]->file->name, name) == 0)
      return &catalog->cases[i];
  return NULL;
}

/* Adds a case and takes ownership of it. Records and pins are stored under the name, so no other
 * case of this catalog, or of `other` (may be NULL), may have it. */
static po_status add_case(po_catalog *catalog, const po_catalog *other, po_case *kase) {
  po_case **twin = find_case(catalog, kase->file->name), **cases = NULL;
  if (!twin && other)
    twin = find_case(other, kase->file->name);
  po_status status = PO_NO_MEMORY;
  if (twin)
    status = po_fail(PO_BAD_INPUT, "%s: name is %s: expected another name, as %s has this one",
                     kase->shown, kase->file->name, (*twin)->shown);
  else
    cases = po_resize(catalog->cases, catalog->count + 1, sizeof *cases);
  if (!cases) {
    po_case_destroy(kase);
    return status;
  }
  catalog->cases = cases;
  cases[catalog->count++] = kase;
  return PO_OK;
}

/* Reads a file of the folder of cases. */
static po_status read_built_in(const char *folder, const char *name, po_catalog *catalog) {
  po_case *kase = NULL;
  const po_file_path path = po_path_join(folder, name), shown = po_path_join("cases", name);
  const po_status status = po_case_read(path.text, shown.text, &kase);
  return status ? status : add_case(catalog, NULL, kase);
}

/* Reads all cases of the folder. If `strict` is false, files that cannot be read are skipped. */
static po_status read_folder(const char *folder, bool strict, po_catalog *catalog) {
  char **names = NULL;
  size_t count = 0;
  po_status status = po_folder_list(folder, ENDING, &names, &count);
  for (size_t i = 0; i < count && (!status || !strict); ++i)
    status = read_built_in(folder, names[i], catalog);
  po_names_free(names, count);
  return strict || status == PO_NO_MEMORY ? status : PO_OK;
}

static bool has_ending(const char *name) {
  const size_t length = strlen(name), tail = strlen(ENDING);
  return length > tail && strcmp(name + length - tail, ENDING) == 0;
}

/* Reports whether a path leads to a case file in the folder of cases; the same file may be written
 * in several ways. */
static bool is_in_folder(const char *folder, const char *path) {
  const char *slash = strrchr(path, '/');
  const char *name = slash ? slash + 1 : path;
  return name[0] != '.' && has_ending(name) &&
         po_path_is_same(path, po_path_join(folder, name).text);
}

/* Marks a case as a file outside the folder of cases. Status: PO_NO_MEMORY. */
static po_status case_set_own(po_case *kase) {
  po_text word = {0};
  if (kase->shown[0] == '-') /* which would be an option */
    po_text_add(&word, "./");
  po_text_add_word(&word, kase->shown);
  kase->is_own = true;
  kase->word = word.data;
  return word.failed ? PO_NO_MEMORY : PO_OK;
}

/* Reads the case at a given path, unless the catalog has the case of this file. A file outside the
 * folder must have a name that no case of the folder has. */
static po_status read_given(const char *folder, const po_catalog *all, const char *path,
                            po_catalog *catalog) {
  po_case *kase = NULL;
  po_status status = po_case_read(path, path, &kase);
  if (status)
    return status;
  const bool built_in = is_in_folder(folder, path);
  po_case **twin = find_case(catalog, kase->file->name);
  const bool again = twin && po_path_is_same((*twin)->path, path); /* requested twice */
  if (!built_in)
    status = case_set_own(kase);
  if (!status && !again)
    return add_case(catalog, built_in ? NULL : all, kase);
  po_case_destroy(kase);
  return status;
}

static bool is_path(const char *name) {
  return strchr(name, '/') || has_ending(name);
}

/* Refuses a name that is not among the known ones, which are cleared. */
static po_status refuse_unknown(const char *what, const char *name, po_text *known) {
  char shown[PO_QUOTE_LENGTH];
  const po_status status = po_suggest(po_fail(PO_BAD_INPUT, "no case %s %s: expected one of %s",
                                              what, po_quote(name, shown), po_text_string(known)),
                                      name, po_text_string(known));
  po_text_clear(known);
  return status;
}

static po_status refuse_name(const po_catalog *all, const char *name) {
  po_text known = {0};
  for (size_t i = 0; i < all->count; ++i)
    po_text_add(&known, "%s%s", i ? ", " : "", all->cases[i]->file->name);
  return refuse_unknown("is named", name, &known);
}

/* Moves the case with a name from one catalog to another. */
static po_status move_case(po_catalog *from, const char *name, po_catalog *to) {
  if (find_case(to, name))
    return PO_OK; /* requested twice */
  po_case **place = find_case(from, name);
  if (!place)
    return refuse_name(from, name);
  po_case *kase = *place;
  from->count -= 1;
  memmove(place, place + 1, (size_t)(from->cases + from->count - place) * sizeof *place);
  return add_case(to, NULL, kase);
}

/* The suites that run only when they are named, because they take long. */
static const char LONG[] = "random,theories,rate";

/* Reports whether a list of names, separated by commas, contains the first `length` characters of
 * `name`. */
static bool has_name(const char *names, const char *name, size_t length) {
  while (*names) {
    const size_t found = strcspn(names, ",");
    if (found == length && strncmp(names, name, length) == 0)
      return true;
    names += found + (names[found] == ',');
  }
  return false;
}

static bool is_of_suites(const po_case *kase, po_suites suites) {
  for (unsigned k = 0; k < kase->file->suite_names_count; ++k) {
    const char *suite = kase->file->suite_names[k];
    if (suites.names ? has_name(suites.names, suite, strlen(suite))
                     : !(suites.only_named && has_name(LONG, suite, strlen(suite))))
      return true;
  }
  return false;
}

/* Returned: the first suite after a name in the order of the alphabet; NULL if there is none. */
static const char *next_suite(const po_catalog *all, const char *after) {
  const char *next = NULL;
  for (size_t i = 0; i < all->count; ++i)
    for (unsigned k = 0; k < all->cases[i]->file->suite_names_count; ++k) {
      const char *name = all->cases[i]->file->suite_names[k];
      if (strcmp(name, after) > 0 && (!next || strcmp(name, next) < 0))
        next = name;
    }
  return next;
}

/* Refuses a suite to which no case belongs. */
static po_status refuse_suite(const po_catalog *all, const char *name, size_t length) {
  po_text known = {0};
  for (const char *suite = ""; (suite = next_suite(all, suite)) != NULL;)
    po_text_add(&known, "%s%s", known.length ? ", " : "", suite);
  char given[64];
  snprintf(given, sizeof given, "%.*s", (int)length, name);
  return refuse_unknown("belongs to the suite", given, &known);
}

static po_status check_suites(const po_catalog *all, const char *names) {
  for (const char *at = names; at && *at;) {
    const size_t length = strcspn(at, ",");
    const char *suite = next_suite(all, "");
    while (suite && !has_name(suite, at, length))
      suite = next_suite(all, suite);
    if (!suite)
      return refuse_suite(all, at, length);
    at += length + (at[length] == ',');
  }
  return PO_OK;
}

static po_status take_suites(po_catalog *all, po_suites suites, po_catalog *catalog) {
  po_status status = check_suites(all, suites.names);
  for (size_t i = 0; !status && i < all->count;) {
    if (is_of_suites(all->cases[i], suites))
      status = move_case(all, all->cases[i]->file->name, catalog);
    else
      ++i;
  }
  return status;
}

po_status po_catalog_open(const char *data_folder, char *const *names, size_t name_count,
                          po_suites suites, po_catalog *catalog) {
  po_catalog all = {0};
  *catalog = (po_catalog){0};
  bool strict = name_count == 0;
  for (size_t i = 0; i < name_count; ++i)
    strict = strict || !is_path(names[i]);
  const po_file_path folder = po_path_join(data_folder, "cases");
  po_status status = read_folder(folder.text, strict, &all);
  if (!status && name_count == 0)
    status = take_suites(&all, suites, catalog);
  for (size_t i = 0; !status && i < name_count; ++i)
    status = is_path(names[i]) ? read_given(folder.text, &all, names[i], catalog)
                               : move_case(&all, names[i], catalog);
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
