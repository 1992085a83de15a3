/* Pins: what the results of a case were when they were last accepted (pulloff bless). Of each point
 * its digest, its pull-off force and its counters of work. They show every change of a result and
 * of its cost; they are no evidence that a result is correct.
 *
 * The pins of a case are the table pins/NAME.csv in the folder of the case file, a row each point.
 * Its header says who accepted the results, when and why; earlier versions of the table are in the
 * history of the source tree. The header `scenes` is the SHA-256 of all scenes of the case then,
 * without their time limits: a number names the same point only as long as the scenes are the same.
 */
#ifndef PO_PINS_H
#define PO_PINS_H

#include "po_case.h"
#include "po_csv.h"
#include "po_file.h"
#include "po_result.h"

/* The counters of work that are pinned. Only deterministic ones are, not the time. */
enum { PO_WORK_COUNTERS = 5 };
extern const char *const PO_WORK_COUNTER_NAMES[PO_WORK_COUNTERS];
double po_work_count(const po_work *work, int counter);

typedef struct {
  po_csv table;                  /* no rows: nothing is stored, or only results of other scenes */
  po_file_path path, shown;      /* of the file; its name in messages */
  char scenes[PO_DIGEST_LENGTH]; /* of the scenes of the case */
  bool other_scenes;             /* the stored results are of other scenes */
} po_pins;

/* The pins of a point. */
typedef struct {
  const char *digest;            /* belongs to the table */
  double force;                  /* pull-off force in pi w R; NAN: none */
  double work[PO_WORK_COUNTERS]; /* NAN: none */
} po_pin;

/* Opens the pins of a case. If there is no file, nothing is pinned yet, and the status is PO_OK.
 * The caller closes them in any case. Status: PO_CANNOT_READ with file and line (damaged or edited
 * by hand), PO_NO_MEMORY. */
po_status po_pins_open(const po_case *kase, po_pins *pins);
void po_pins_close(po_pins *pins);

/* Finds the row of point number `point` with name `id`. Returned: false if there is none. */
bool po_pins_find(const po_pins *pins, size_t point, const char *id, size_t *row);

/* Reads a row. Status: PO_CANNOT_READ. */
po_status po_pins_read(const po_pins *pins, size_t row, po_pin *pin);

/* Adds the line of column names. */
void po_pins_add_columns(po_text *text);

/* Adds the row of a result. */
void po_pins_add(const char *id, const char *digest, const po_result *result, po_text *text);

/* Adds a row as it is stored, in the form of po_pins_add. */
void po_pins_add_stored(const po_pins *pins, size_t row, po_text *text);

#endif
