/* The list of pins of a case with the values of a run. */
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

/* Lists all values that the checks of the case pin, each once. Status: PO_NO_MEMORY. */
po_status po_pin_list_make(const po_case_run *run, po_pin_list *list);
void po_pin_list_clear(po_pin_list *list);

/* Adds the line of column names and the rows of the table; adds, as headers, the keys that have the
 * same value for all scenes of the list. */
void po_pin_list_rows(const po_case *kase, const po_pin_list *list, po_text *rows);
void po_pin_list_headers(const po_case *kase, const po_pin_list *list, po_text *text);

#endif
