/* The special points of a result, folds and extrema of the load, with their stated values and
 * errors; and the pull-off, which is one of the minima. */
#ifndef PO_SPECIAL_LIST_H
#define PO_SPECIAL_LIST_H

#include "po_branch_point.h"
#include "po_estimate.h"
#include "po_result.h"

/* Sizes of the lists of the result. */
typedef struct {
  size_t fold_room, extremum_room;
  size_t unmet_folds;   /* number of folds that were not found on a finer mesh */
  po_estimate greatest; /* the greatest errors of all special points; NAN: none was estimated */
} po_special_list;

/* An empty list. */
po_special_list po_special_list_begin(void);

/* Adds a special point to the folds or the extrema of the result. Status: PO_NO_MEMORY. */
po_status po_special_list_add(po_special_list *list, const po_branch_point *point,
                              const po_estimate *estimate, po_result *result);

/* Makes a minimum of the load the pull-off of the result. */
void po_special_list_pull_off(const po_estimate *estimate, po_result *result);

#endif
