/* Pins: our own last blessed values, tight, to notice change. They are no evidence of being right.
 *
 * Those of a case are the table pins/NAME.csv beside its file: headers as of any reference, one
 * `blessing N` for each time they were set (when, who, with what, why), one `checked N` for each
 * oracle that held then, and a row a point and quantity. A row is of the scene whose keys it and
 * the headers name; a key that is "-", or not named, is one that need not be said of the scene (see
 * po_key_is_idle), or the time limit, which changes no number of a solve that ends within it. */
#ifndef PO_PINS_H
#define PO_PINS_H

#include "po_case.h"
#include "po_reference_table.h"

enum { PO_PIN_NAME_LENGTH = 64, PO_WORK_COUNTERS = 5 };

/* Opens the pins of a case as a reference. That there is no such file is no failure: nothing is
 * pinned yet. Status: PO_CANNOT_READ with file and line (damaged, edited by hand). */
po_status po_pins_open(const po_case *kase, const char *name, po_reference *reference);

/* Whether there is a file of these pins. */
bool po_pins_exist(const po_reference *pins);

/* The value pinned under `name` ("pull_off_force", "folds/jump_in-1/approach", "work/points"...)
 * for a scene. Status: PO_NOT_FOUND; PO_CANNOT_READ: two rows for the same. */
po_status po_pins_value(const po_reference *pins, const char *name, const po_request *request,
                        double *value);

/* As po_reference_find and po_reference_points. */
po_status po_pins_find(const po_reference *pins, po_quantity quantity, const po_request *request,
                       po_reference_number *number);
po_status po_pins_points(const po_reference *pins, po_quantity quantity, const po_request *request,
                         po_reference_point **points, size_t *count);

/* How the special point number `index` (from 0) of `quantity` is called among the pins. */
void po_pins_name_special_point(po_quantity quantity, po_special_kind kind, size_t index, bool load,
                                char name[PO_PIN_NAME_LENGTH]);

/* The counters of work that are pinned: all that is deterministic, so never the time. */
const char *po_work_name(int counter);
double po_work_count(const po_work *work, int counter);

/* The key of a scene as pins write it: its value, or "-". */
void po_pins_key_text(const po_request *request, po_key key, char text[PO_NUMBER_LENGTH]);

#endif
