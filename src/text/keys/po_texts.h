/* A scene as a user gives it: the text of each key. Options, case files, JSON and the library fill
 * the texts; one reader turns them into a request, whether they are dimensionless or in SI units.
 */
#ifndef PO_TEXTS_H
#define PO_TEXTS_H

#include "po_forms.h"
#include "po_input.h"

enum { PO_KEY_NAME_LENGTH = 48 };

typedef struct {
  const char *text[PO_KEY_ALL]; /* NULL: not given */
  const char
      *prefix; /* of names in messages: "--" of options, whose names have dashes, and of which
                  further waves may be given beside an amplitude; of others "", or a path */
  bool si;     /* the scene is in SI units: its lengths are given in m */
  bool mixed;  /* preload and range of the trace may be dimensionless beside a scene in SI units */
  bool any_modulus, any_radius; /* it may be missing: nothing depends on it */
  int wrong;                    /* the key that was refused last */
} po_texts;

/* Turns the texts into a request, which must have the defaults. The request has the units of a
 * scene in SI units. Its values are not checked against each other (po_request_check). Status:
 * PO_BAD_INPUT, PO_CANNOT_READ: the table of a profile, PO_NO_MEMORY; the message names the key,
 * its value and what was expected. */
po_status po_texts_read(po_texts *given, po_request *request);

/* The contact modulus, Pa, the radius, m, and the work of adhesion, J/m^2, that follow from two
 * bodies: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, K. L. Johnson, Contact Mechanics, Eq 4.9; 1/R =
 * 1/R1 + 1/R2; w = gamma1 + gamma2 - gamma12. NAN: the texts have no moduli of bodies, no radius,
 * no surface energies. Given: texts that were read. Returned: whether they have moduli of bodies,
 * surface energies or two radii. */
bool po_texts_bodies(const po_texts *given, double *modulus, double *radius, double *work);

/* Whether a key is given, in its own unit or in SI units. */
bool po_texts_has(const po_texts *given, po_key key);

/* Returned: the dimensionless number of a key; NAN: not given. Given: the units, if the scene is in
 * SI units. */
double po_texts_number(const po_texts *given, po_key key, const po_units *units);

/* Writes the name of a key in messages, with its prefix: --work-j-per-m2. */
void po_texts_write_name(const po_texts *given, int key, char name[PO_KEY_NAME_LENGTH]);

/* The name of a key in messages, which is that in SI units if the scene is. */
void po_texts_name(const po_texts *given, po_key key, char name[PO_KEY_NAME_LENGTH]);

/* Refuses an amplitude > 0 without a wavelength > 0, and a wavelength without an amplitude, which
 * has no effect. With amplitude 0 any wavelength or none is accepted: it may be the smooth end of a
 * series. Status: PO_BAD_INPUT. */
po_status po_texts_check_waves(po_texts *given);

/* Whether profile, waves or law are given, or the form takes the scene so: the closed forms of any
 * profile apply. */
bool po_texts_is_general(const po_texts *given, const po_form *form, const po_scene *scene);

/* -- Options and keys that have no effect. If one were ignored silently, the user would misread the
 * result. -- */

/* An option or a key, whether it was given, and whether it has an effect in the present use. */
typedef struct {
  char name[48]; /* with the dashes of an option */
  bool given, taken;
} po_use;

/* Refuses the first one that was given although it has no effect on `what`, and names those that
 * have an effect. Status: PO_BAD_INPUT, PO_OK. */
po_status po_use_check(const char *what, const po_use *uses, size_t count);

/* Refuses keys on which a closed form does not depend. Given: whether alpha is given in place of
 * what it is computed of; other inputs of the form. Status: PO_BAD_INPUT. */
po_status po_texts_check_form(const po_texts *given, const po_form *form, bool alpha,
                              const po_use *others, size_t count);

/* Refuses an input without the material, the speed or the finite preload that a form needs. */
po_status po_texts_check_rate(const po_texts *given, const po_form *form,
                              const po_form_input *input);

#endif
