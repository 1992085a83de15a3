/* The description of a plan for the user. */
#ifndef PO_PLAN_WORDS_H
#define PO_PLAN_WORDS_H

#include "po_plan.h"

/* Fills plan->lines. To be called once. Status: PO_NO_MEMORY. */
po_status po_plan_describe(po_plan *plan);

#endif
