/* The keys of a scene as a user writes them: in case files, flags, JSON and reference tables.
 *
 * One table says for each key its name, what is expected of its value, and where it lives in a
 * request, so that every reader refuses and prints the same things. */
#ifndef PO_INPUT_H
#define PO_INPUT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_number.h"
#include "po_request.h"

typedef enum {
  PO_KEY_TABOR,
  PO_KEY_AMPLITUDE,
  PO_KEY_WAVELENGTH,
  PO_KEY_RADIUS,
  PO_KEY_OUTER_RADIUS,
  PO_KEY_SCHEME,
  PO_KEY_GRADING,
  PO_KEY_NODES,
  PO_KEY_TOLERANCE,
  PO_KEY_APPROACH_START,
  PO_KEY_APPROACH_END,
  PO_KEY_PRELOAD,
  PO_KEY_PRELOAD_LOAD,
  PO_KEY_TIME_LIMIT,
  PO_KEY_COUNT,
  /* Groups of these, in sweeps, conditions and reference tables: each sets one of them. */
  PO_KEY_ALPHA = PO_KEY_COUNT, /* A R / lambda^2, Eq 6: sets the wavelength */
  PO_KEY_AMPLITUDE_RATIO,      /* A / lambda: sets the amplitude */
  PO_KEY_OUTER_RATIO,          /* r_max / R: sets the outer radius */
  PO_KEY_END
} po_key;

/* A request with every field at its default, and the JKR theory as its companion. */
po_request po_input_default(void);

/* The key of that name, a group or not, or -1. */
int po_key_of_name(const char *name);

/* "tabor", "outer_radius"... */
const char *po_key_name(po_key key);

/* What a value must be, e.g. "a finite number > 0", as messages put it after "expected ". */
const char *po_key_expected(po_key key);

/* Whether the key holds a number (else a name, as scheme does). */
bool po_key_is_number(po_key key);

/* Whether a key is a group, and the key it sets (else the key itself). A group is set when all
 * others are. */
bool po_key_is_group(int key);
po_key po_key_target(po_key key);

/* Puts the value written as `text` into a request. False when the text is no value of that key;
 * then the request is unchanged. */
bool po_key_set(po_request *request, po_key key, const char *text);

/* The value as text; "auto" for an approach the solver chooses, "none" for no time limit. */
void po_key_print(const po_request *request, po_key key, char text[PO_NUMBER_LENGTH]);

/* The value as a number (of nodes also); for a name its number in the enumeration. */
double po_key_number(const po_request *request, po_key key);

/* Whether the request has for `key` the value written as `text`: for numbers to a few ulp, so that
 * 0.1 in one file meets 0.1 in another however it was computed. False when `text` is no value. */
bool po_key_matches(const po_request *request, po_key key, const char *text);

/* Whether a key need not be said of a scene: the solver chooses it, or nothing looks at it. */
bool po_key_is_idle(const po_request *request, po_key key);

/* Whether a key says nothing of the request's scheme: panels are meshed to a tolerance, rings and
 * triangles by a number of nodes. */
bool po_key_is_of_other_scheme(const po_request *request, po_key key);

/* "pulloff solve --tabor 1 ...", as a line one can paste, which repeats the solve and does not go
 * on beyond its preload; free it. NULL without memory. */
char *po_input_command(const po_request *request);

#endif
