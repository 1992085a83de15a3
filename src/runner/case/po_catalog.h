/* All cases of a data folder, and the selection of those that a command is applied to. */
#ifndef PO_CATALOG_H
#define PO_CATALOG_H

#include "po_case.h"

typedef struct {
  po_case **cases;
  size_t count;
} po_catalog;

/* The suites whose cases are selected when a command names no case. */
typedef struct {
  const char *names; /* names of suites, separated by commas; NULL: all suites */
  bool only_named;   /* if `names` is NULL: without cases that belong to random or theories alone;
                        that   suite takes long and runs only when it is named */
} po_suites;

/* Reads and checks the requested cases.
 * Given: `names`, each the name of a case in data_folder/cases, or, if it contains '/' or ends in
 * ".yaml", the path of a case file. If a name is given, all files of that folder are read, so that
 * an error in any of them is reported. A file outside the folder (is_own) must have a name that no
 * case of the folder has, because records and pins are stored under the name. Without names, the
 * cases of the folder that belong to one of `suites` are selected.
 * Status: PO_BAD_INPUT (a bad file, an unknown name, a suite without cases, two files with the same
 * name), PO_CANNOT_READ. */
po_status po_catalog_open(const char *data_folder, char *const *names, size_t name_count,
                          po_suites suites, po_catalog *catalog);
void po_catalog_close(po_catalog *catalog);

#endif
