/* The closed forms by name: the input that each needs, and the numbers that it returns. */
#ifndef PO_FORMS_H
#define PO_FORMS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_creep.h"
#include "po_loops.h"
#include "po_scene.h"
#include "po_status.h"

/* What is given of a state in place of its contact radius. */
typedef enum { PO_FORM_HOLDS_NOTHING, PO_FORM_HOLDS_LOAD, PO_FORM_HOLDS_APPROACH } po_form_held;

/* The input of a closed form. */
typedef struct {
  po_scene scene;
  double alpha;   /* A R/lambda^2, given or computed from the scene; NAN: neither */
  double at;      /* the value of the variable of the form; NAN: not given */
  double tension; /* of Maugis-Dugdale, w/eps; not > 0: the peak of the law */
  bool general; /* profile, waves or law are given: the forms of any profile apply; they also apply
                   to every scene that is not of the paper */
  po_form_held held; /* not beside `at` */
  double value;      /* of what is held, pi w R or eps */
  bool has_preload;
  po_preload preload;  /* with a finite approach or load */
  po_creep creep;      /* of a viscoelastic body */
  double unload_speed; /* eps/tau_0, or INFINITY; NAN: not given */
} po_form_input;

/* The unit of a number. */
typedef enum {
  PO_FORM_PURE,    /* dimensionless */
  PO_FORM_LENGTH,  /* eps */
  PO_FORM_FORCE,   /* pi w R */
  PO_FORM_WORK,    /* w */
  PO_FORM_TENSION, /* w/eps */
} po_form_unit;

typedef struct {
  const char *name; /* for example "pull_off_force" */
  po_form_unit unit;
  double value;         /* NAN or infinite outside the range of doubles */
  bool may_be_infinite; /* an infinite value is the correct limit, not an overflow */
} po_form_value;

enum { PO_FORM_MOST_VALUES = 32 };

typedef struct {
  po_form_value items[PO_FORM_MOST_VALUES];
  size_t count;
  po_status status; /* of a failure with a message, if any */
} po_form_values;

/* The variable of a form that is a curve. */
typedef enum {
  PO_FORM_AT_NOTHING,
  PO_FORM_AT_APPROACH,       /* < 1, eps */
  PO_FORM_AT_CONTACT_RADIUS, /* >= 0, eps */
  PO_FORM_AT_GAP,            /* H = h/eps - 1 > -1 */
} po_form_variable;

enum {
  PO_NEEDS_WAVES =
      1, /* amplitude and wavelength; the wavelength is not needed if the amplitude is 0 */
  PO_NEEDS_ALPHA = 2, /* alpha, or amplitude and wavelength */
  PO_NEEDS_AMPLITUDE = 4,
  PO_NEEDS_ELASTIC = 8, /* a Tabor parameter above 0 */
  PO_NEEDS_RATE = 16    /* a viscoelastic material, and the speed of unloading */
};

/* The keys of the scene on which a form depends, besides its variable. Command line and library
 * refuse other keys. */
enum {
  PO_TAKES_TABOR = 1,
  PO_TAKES_AMPLITUDE = 2,
  PO_TAKES_WAVELENGTH = 4,
  PO_TAKES_RADIUS = 8,
  PO_TAKES_ALPHA = 16,   /* alpha in place of the wavelength */
  PO_TAKES_PROFILE = 32, /* any profile and any waves */
  PO_TAKES_LAW = 64,
  PO_TAKES_TENSION = 128,
  PO_TAKES_PRELOAD = 256,
  PO_TAKES_STATE = 512,  /* a load or an approach, of which the contact radius follows */
  PO_TAKES_CURVE = 1024, /* the form has a curve of states over the contact radius */
  PO_TAKES_RATE = 2048   /* a viscoelastic material, the speed, and the preload from which the body
                            is unloaded; without a preload that of po_request_preload */
};

/* A closed form. Both functions append to `values`. Source and accuracy of each number are stated
 * at the function of this folder that computes it. */
typedef struct {
  const char *name;
  void (*fixed)(const po_form_input *input, po_form_values *values);
  /* appends the values at input->at; NULL if the form has no variable */
  void (*along)(const po_form_input *input, po_form_values *values);
  po_form_variable variable;
  unsigned needs, takes;
  const char *source;  /* the equation and who derived it, for people */
  const char *preload; /* which preload the pull-off belongs to, for people; NULL: it has none */
} po_form;

/* Returned: the form with this name, or NULL. */
const po_form *po_form_find(const char *name);

/* Refuses the name of no form. Status: PO_BAD_INPUT. */
po_status po_form_refuse(const char *name);

/* Whether an input lacks the material or the speed that a form needs. */
bool po_form_lacks_rate(const po_form *form, const po_form_input *input);

/* Returned: the keys on which a form depends. With alpha it does not depend on the wavelength, nor
 * on the other keys that alpha replaces. */
unsigned po_form_takes(const po_form *form, bool alpha_is_given);

/* Evaluates a form, at input->at if it is not NAN, or in the stable state with the load or approach
 * that is held, and after the preload. Given: an input in the domain of the form.
 * Status: PO_BAD_INPUT, naming the number that is NaN or infinite because an intermediate value
 * exceeds the range of doubles, or the state that does not exist. */
po_status po_form_evaluate(const po_form *form, const po_form_input *input, po_form_values *values);

/* The preload that the results of po_form_evaluate assume, for people; NULL: there is none. */
const char *po_form_preload(const po_form *form, const po_form_input *input);

/* Which of several equilibria with the load or approach that is held was evaluated, for people;
 * NULL: nothing is held. */
const char *po_form_branch(const po_form_input *input);

/* A point of the curve of a form, and whether it is stable at given approach, and at given load. */
typedef struct {
  double approach, load, contact_radius;
  bool stable_at_approach, stable_at_load;
} po_form_point;

/* The curve of a form that has one, from contact radius 0 to that of the preload, without one to
 * twice the contact radius at pull-off (of DMT, whose pull-off has none, to load 1). The points at
 * which its stability changes are among them. Returned: *points, to be freed with free(). Status:
 * as po_form_evaluate; PO_NO_MEMORY; PO_TOO_MANY_POINTS. */
po_status po_form_curve(const po_form *form, const po_form_input *input, po_form_point **points,
                        size_t *count);

/* The names of all forms as a list for messages: "bradley, rigid, ... or lennard-jones". */
extern const char *const PO_FORM_NAMES;

extern const char *const PO_FORM_VARIABLES[]; /* names; "" for PO_FORM_AT_NOTHING */

#endif
