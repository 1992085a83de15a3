/* What the functions of the library share; not installed. */
#ifndef PO_LIBRARY_H
#define PO_LIBRARY_H

#include "pulloff.h"

#include <fenv.h>

#include "po_json_value.h"
#include "po_result.h"
#include "po_texts.h"

struct pulloff_scene {
  char *text[PO_KEY_ALL]; /* the value of each key; NULL: not set */
  unsigned want;
  const volatile sig_atomic_t *stop;
  volatile sig_atomic_t *seen; /* number of the scenes of a series that were seen; may be NULL */
};

struct pulloff_result {
  po_request request;
  po_result result; /* empty for a closed form */
  pulloff_special_point *folds, *extrema;
  pulloff_curve_point *curve;
  pulloff_profile_point *profile;
  json_t *document;
};

/* The state of the thread before a call of the library. */
typedef struct {
  bool entered; /* the following are to be restored */
  void *locale;
  fenv_t floating_point;
} po_library_call;

/* Begins a function: turns off the error handler of GSL, unless another thread is in such a
 * function already; sets the locale and the floating-point environment of this thread to those in
 * which the program runs; forgets messages of earlier calls. Status: PO_NO_MEMORY; then nothing has
 * changed. */
po_status po_library_enter(po_library_call *call);

/* Ends it, whatever the status of its beginning: restores the state of the thread, and that of the
 * process if no other thread needs it. Otherwise as po_library_end. */
pulloff_status po_library_leave(const po_library_call *call, po_status status,
                                pulloff_message *message);

/* Ends a function that was not begun so: copies the message of a failure, or of another
 * thread-local cause, to `message`. Returned: the status for the caller of the library. */
pulloff_status po_library_end(po_status status, pulloff_message *message);

/* Appends the key that is close to an unknown one to the message. Returned: PO_BAD_INPUT. */
po_status po_library_suggest(const char *key);

/* The texts of a scene, which stay those of the scene, with a further value for one key; key -1:
 * none. It is in SI units if one of these is given; a key in another unit is then refused. */
po_texts po_library_given(const pulloff_scene *scene, int key, const char *value);

/* Makes the request of texts (po_uncertain_maker). Given: the scene that has wants and a stop. */
po_status po_library_make(const po_texts *given, const void *scene, po_request *request);

/* The units of a request in SI units. */
pulloff_units po_library_units(const po_request *request);

/* The request of a scene, with a further value for one key; key -1: none. Status: PO_BAD_INPUT,
 * PO_CANNOT_READ, PO_NO_MEMORY. */
po_status po_library_request(const pulloff_scene *scene, int key, const char *value,
                             po_request *request);

/* Turns what was solved into a result of the library, which takes over the arrays of *solved.
 * Returned: NULL if memory runs out; *solved is then cleared. */
pulloff_result *po_library_result(const po_request *request, po_result *solved);

#endif
