/* The pins of a case as a run would have them. */
#ifndef PO_BLESS_LIST_H
#define PO_BLESS_LIST_H

#include "po_pins.h"
#include "po_run.h"
#include "po_text.h"

typedef struct {
  size_t point;
  char name[PO_PIN_NAME_LENGTH];
  double value; /* NAN: the solve did not deliver it */
} po_pin;

typedef struct {
  po_pin *items;
  size_t count;
} po_pin_list;

/* All values the checks of the case pin, each once. Status: PO_NO_MEMORY. */
po_status po_pin_list_make(const po_case_run *run, po_pin_list *list);
void po_pin_list_clear(po_pin_list *list);

/* The line of column names and the rows of the table; and the keys that all scenes of the list
 * share, as headers. */
void po_pin_list_rows(const po_case *kase, const po_pin_list *list, po_text *rows);
void po_pin_list_headers(const po_case *kase, const po_pin_list *list, po_text *text);

#endif
