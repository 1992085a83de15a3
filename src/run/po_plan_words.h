/* The plan in words. */
#ifndef PO_PLAN_WORDS_H
#define PO_PLAN_WORDS_H

#include "po_plan.h"

/* Fills plan->lines. */
po_status po_plan_tell(po_plan *plan);

#endif
