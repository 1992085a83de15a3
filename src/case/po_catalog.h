/* The cases there are, and choosing among them. */
#ifndef PO_CATALOG_H
#define PO_CATALOG_H

#include "po_case.h"

typedef struct {
  po_case **cases;
  size_t count;
} po_catalog;

/* Which cases a command is about when it names none. */
typedef struct {
  const char *names; /* those of these suites, separated by commas; NULL: of any */
  bool
      only_named; /* without `names`: not those that are of the suite random alone, which is long */
} po_suites;

/* Reads and checks the cases asked for. A name without '/' and ".yaml" is a case of
 * data_folder/cases, of which then all files are read, so that an error in any of them is reported;
 * else it is the path of a case file: one of that folder, or one of the user's own (is_own), whose
 * name must differ from those of that folder, as records and pins are stored under the name.
 * Without names: the cases of the folder that belong to one of `suites`. Status: PO_BAD_INPUT (a
 * bad file, an unknown name, a suite of no case, a name in two files), PO_CANNOT_READ. */
po_status po_catalog_open(const char *data_folder, char *const *names, size_t name_count,
                          po_suites suites, po_catalog *catalog);
void po_catalog_close(po_catalog *catalog);

#endif
