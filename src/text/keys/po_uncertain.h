/* Numbers with a standard uncertainty among the texts of a scene: 0.08+-0.01. */
#ifndef PO_UNCERTAIN_H
#define PO_UNCERTAIN_H

#include "po_texts.h"

typedef struct {
  int key;
  int body; /* of numbers with commas between, from 0 */
  double value, deviation;
} po_uncertain_number;

typedef struct {
  po_uncertain_number *number; /* in the order of the keys */
  size_t count, room;
  char *text[PO_KEY_ALL];  /* the texts without their uncertainties; NULL: it has none */
  po_variation *variation; /* one a number */
  po_request *moved;       /* the request with each number less and more */
} po_uncertain_inputs;

/* Whether a number may be uncertain: one of the scene, in SI units or not, of the preload, or a
 * speed or time of a viscoelastic body. */
bool po_uncertain_may(int key);

/* Reads the uncertainties of the texts and cuts them off. Returned: in `given` the texts without,
 * which `inputs` owns; inputs, to be cleared whatever the status. Status: PO_BAD_INPUT with key,
 * value and what was expected; PO_NO_MEMORY. */
po_status po_uncertain_read(po_texts *given, po_uncertain_inputs *inputs);

/* Makes a request of texts. */
typedef po_status po_uncertain_maker(const po_texts *given, const void *user, po_request *request);

/* Completes a request that was made of the texts: adds the requests with each number less and more
 * by PO_VARIATION_REACH times its uncertainty. Given: the texts without uncertainties. The request
 * is valid until the inputs are cleared. Status: PO_BAD_INPUT, also of a number that is refused
 * when it is moved; that of the maker; PO_NO_MEMORY. */
po_status po_uncertain_vary(po_uncertain_inputs *inputs, const po_texts *given,
                            po_uncertain_maker *maker, const void *user, po_request *request);

void po_uncertain_clear(po_uncertain_inputs *inputs);

#endif
