/* Pins: the values of this program that were last blessed. A check against pins detects every
 * change of a value; it is no evidence that the value is correct.
 *
 * The pins of a case are the table pins/NAME.csv in the folder of the case file. The table has the
 * headers of a reference, a header `blessing N` for each time the pins were set (date, user,
 * program, reason), a header `checked N` for each oracle whose checks passed then, and one row for
 * each scene and quantity. The keys in the headers and in the row identify the scene. A key that is
 * absent or "-" has no influence on the scene (see po_key_is_idle), or is the time limit, which
 * does not change the numbers of a solve that ends within it. */
#ifndef PO_PINS_H
#define PO_PINS_H

#include "po_case.h"
#include "po_reference.h"

enum { PO_PIN_NAME_LENGTH = 64, PO_WORK_COUNTERS = 5 };

/* Opens the pins of a case as a reference. Given: `solver`, the name of the external solver whose
 * pins they are, pins/SOLVER/NAME.csv; NULL: those of this program. If the file does not exist,
 * nothing is pinned yet, and the status is PO_OK. Status: PO_CANNOT_READ with file and line
 * (damaged or edited by hand). */
po_status po_pins_open(const po_case *kase, const char *name, const char *solver,
                       po_reference *reference);

/* Reports whether the file of the pins exists. */
bool po_pins_exist(const po_reference *pins);

/* Looks up the value pinned under `name` ("pull_off_force", "folds/jump_in-1/approach",
 * "work/points"...) for a scene. Status: PO_NOT_FOUND (the value is not pinned), PO_CANNOT_READ
 * (two rows with this name for the scene). */
po_status po_pins_value(const po_reference *pins, const char *name, const po_request *request,
                        double *value);

/* Returned: in `name`, the name of the pin of special point number `index` (from 0) of `quantity`.
 */
void po_pins_name_special_point(po_quantity quantity, po_special_kind kind, size_t index, bool load,
                                char name[PO_PIN_NAME_LENGTH]);

/* Name and value of each pinned counter of work. Only deterministic counters are pinned, not the
 * time. */
extern const char *const PO_WORK_COUNTER_NAMES[PO_WORK_COUNTERS];
double po_work_count(const po_work *work, int counter);

/* Returned: in `text`, the value of a key as written in a table of pins, or "-". */
void po_pins_key_text(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]);

/* Points that differ only in keys without influence have the same scene, and share its pins.
 * Returned: in `first`, for each point of the case the first point with its scene.
 * Status: PO_NO_MEMORY. */
po_status po_pins_scenes(const po_case *kase, size_t *first);

/* The stored digests of the results of a case: the table pins/NAME.digests.csv in the folder of the
 * case file, with the columns point, digest and pull_off_force ("-": none), a row each point. The
 * force says by how much a result with another digest differs. The header `scenes` is the SHA-256
 * of all scenes of the case then, without their time limits: a number names the same point only as
 * long as the scenes are the same.
 *
 * Opens the table; if there is none, the status is PO_OK. It has no rows then, nor if it is of
 * other scenes than those of the case. Returned: in `scenes`, the digest of the scenes of the case.
 * The caller closes the table with po_reference_close. Status: PO_CANNOT_READ with file and line,
 * PO_NO_MEMORY. */
po_status po_digests_open(const po_case *kase, char scenes[PO_DIGEST_LENGTH],
                          po_reference *digests);

/* Computes the digest of all scenes of a case. Status: PO_NO_MEMORY. */
po_status po_digests_scenes(const po_case *kase, char digest[PO_DIGEST_LENGTH]);

/* Looks up a point. Returned: in *digest, its digest, which belongs to the table; in *force, its
 * pull-off force in pi w R, NAN: none. Status: PO_NOT_FOUND, PO_CANNOT_READ. */
po_status po_digests_find(const po_reference *digests, size_t point, const char *id,
                          const char **digest, double *force);

#endif
