/* The closed forms by name: what each needs, and the numbers it gives. */
#ifndef PO_FORMS_H
#define PO_FORMS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_scene.h"

/* What a form is asked of. */
typedef struct {
  po_scene scene;
  double alpha; /* A R/lambda^2, given or of the scene; NAN: neither */
  double at;    /* the value of its variable; NAN: not given */
} po_form_input;

/* What a number is in units of. */
typedef enum {
  PO_FORM_PURE,    /* nothing */
  PO_FORM_LENGTH,  /* eps */
  PO_FORM_FORCE,   /* pi w R */
  PO_FORM_WORK,    /* w */
  PO_FORM_TENSION, /* w/eps */
} po_form_unit;

typedef struct {
  const char *name; /* "pull_off_force"... */
  po_form_unit unit;
  double value;         /* NAN or infinite where the numbers leave the range of doubles */
  bool may_be_infinite; /* that is the number */
} po_form_value;

enum { PO_FORM_MOST_VALUES = 12 };

typedef struct {
  po_form_value items[PO_FORM_MOST_VALUES];
  size_t count;
} po_form_values;

/* The variable along which a form is a curve. */
typedef enum {
  PO_FORM_AT_NOTHING,
  PO_FORM_AT_APPROACH,       /* < 1, eps */
  PO_FORM_AT_CONTACT_RADIUS, /* >= 0, eps */
  PO_FORM_AT_GAP,            /* H = h/eps - 1 > -1 */
} po_form_variable;

enum {
  PO_NEEDS_WAVES = 1, /* amplitude and wavelength; an amplitude of 0 is enough */
  PO_NEEDS_ALPHA = 2, /* or, these two */
  PO_NEEDS_AMPLITUDE = 4,
  PO_NEEDS_ELASTIC = 8 /* a Tabor parameter above 0 */
};

/* What a form depends on beside its variable; anything else would change nothing. */
enum {
  PO_TAKES_TABOR = 1,
  PO_TAKES_AMPLITUDE = 2,
  PO_TAKES_WAVELENGTH = 4,
  PO_TAKES_RADIUS = 8,
  PO_TAKES_ALPHA = 16 /* in place of the wavelength */
};

/* Both functions append. Source and accuracy of each number: at the function of this room that
 * computes it. */
typedef struct {
  const char *name;
  void (*fixed)(const po_form_input *input, po_form_values *values);
  void (*along)(const po_form_input *input, po_form_values *values); /* at input->at; or NULL */
  po_form_variable variable;
  unsigned needs, takes;
} po_form;

/* The form of that name, or NULL. */
const po_form *po_form_find(const char *name);

/* "bradley, rigid, ... or lennard-jones". */
extern const char *const PO_FORM_NAMES;

/* "approach", "contact_radius", "gap"; "" for nothing. */
const char *po_form_variable_name(po_form_variable variable);

#endif
