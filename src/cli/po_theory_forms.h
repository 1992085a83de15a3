/* The closed forms by name: what each needs of the command line and what it prints. */
#ifndef PO_THEORY_FORMS_H
#define PO_THEORY_FORMS_H

#include <jansson.h>

#include "po_scene_flags.h"

/* One command line of `pulloff theory`, put together. */
typedef struct {
  po_scene_flags flags;
  po_scene scene;
  double alpha; /* A R/lambda^2, given or of the scene; NAN: neither */
  json_t *out;  /* what was found, by name */
  json_t *si;   /* the same in SI units, of what has one; NULL unless the scene is physical */
} po_theory_line;

enum {
  PO_NEEDS_WAVES = 1, /* amplitude and wavelength; an amplitude of 0 is enough */
  PO_NEEDS_ALPHA = 2, /* or, these two */
  PO_NEEDS_AMPLITUDE = 4,
  PO_NEEDS_ELASTIC = 8 /* a Tabor parameter above 0 */
};

typedef struct {
  const char *name;
  void (*print)(po_theory_line *line); /* adds to out and si */
  unsigned needs;
} po_theory_form;

/* The form of that name, or NULL. */
const po_theory_form *po_theory_find(const char *name);

#endif
