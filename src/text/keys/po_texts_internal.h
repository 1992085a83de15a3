/* Private to po_texts.c and po_texts_si.c. */
#ifndef PO_TEXTS_INTERNAL_H
#define PO_TEXTS_INTERNAL_H

#include "po_texts.h"

/* Refuses a key with its value, or because it is missing. Returned: PO_BAD_INPUT. */
po_status po_texts_refuse(po_texts *given, int key, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Sets what a key says in the request, if it is given. */
po_status po_texts_set_key(po_texts *given, int key, po_request *request);

/* Adds the waves to those of the scene. Given: the unit of their lengths, in epsilon or 1 over it.
 */
po_status po_texts_add_waves(po_texts *given, double distance, po_scene *scene);

/* The value of a key in SI units in that of the key that it sets. */
double po_texts_without_unit(int key, double value, const po_units *units);

/* Computes the scene from values in SI units, but for its law (po_texts_si.c). */
po_status po_texts_set_physical(po_texts *given, po_request *request);

/* Sets the keys in SI units that do not belong to the scene. */
po_status po_texts_set_in_si(po_texts *given, po_request *request);

/* Sets the usual length and force of a scene in SI units: of a profile that is not a sphere, from
 * the unit of its solve. */
void po_texts_set_usual_units(po_request *request);

/* Refuses a table of moduli in another range than the modulus of the scene, of which only the
 * ratios would be used: a slip of the unit, or another material. */
po_status po_texts_check_material(po_texts *given, const po_request *request);

#endif
