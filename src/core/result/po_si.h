/* Dimensionless numbers in SI units: the unit of each dimension, with a prefix that fits the scene.
 */
#ifndef PO_SI_H
#define PO_SI_H

#include <stdbool.h>
#include <stddef.h>

#include "po_dimension.h"
#include "po_physical.h"

/* The unit in which the numbers of a dimension are written. */
typedef struct {
  double factor; /* (number + shift) factor is the value in this unit */
  double shift;  /* 1 for a gap, whose number is H = h/epsilon - 1; otherwise 0 */
  char text[8];  /* for people, in UTF-8: "nm", "µN", "N/m"; "" for numbers without unit */
  char name[12]; /* at the end of names of columns: "nm", "uN", "N_per_m"; "" for such numbers */
} po_si_unit;

/* The unit without a prefix; its name is in lower case, as in the keys of options, case files and
 * documents: "n_per_m". The factor of the traction of a rigid scene is INFINITY. */
po_si_unit po_si_unit_of(const po_units *units, po_dimension dimension);

/* The unit with the prefix for files and figures. It depends on the scene alone, so
 * that all numbers of a dimension, in all tables of a scene, have the same one: the size of
 * pi w R (the usual force of other profiles), of epsilon max(1, mu), or of what follows from them,
 * lies between 1 and 1000, that of lengths between 0.1 and 100, because contact radii are greater.
 */
po_si_unit po_si_prefixed(const po_units *units, po_dimension dimension);

/* The unit with the prefix for numbers of one kind on the terminal. Given: `greatest`, the greatest
 * magnitude among them. It is that of the scene if the greatest number then is from 0.1 to 1000, or
 * if it is 0 or not finite; else that with which it is from 1 to 1000. */
po_si_unit po_si_readable(const po_units *units, po_dimension dimension, double greatest);

/* The same for approaches, in epsilon: the unit is that of the scene, too, if all of them are 0 but
 * for rounding. */
po_si_unit po_si_readable_approach(const po_units *units, double greatest);

/* Takes the magnitude of a number into account, unless it is not finite. */
void po_si_take(double *greatest, double number);

/* Returned: the value of a dimensionless number in a unit. */
double po_si_value(const po_si_unit *unit, double number);

/* Finds the unit at the end of the name of a column: "force_nN", or in lower case as in keys:
 * "force_n". Returned: whether there is one; *stem, the length of the rest of the name; the
 * dimension; *size, the unit in SI units: 1e-9. */
bool po_si_parse(const char *name, size_t *stem, po_dimension *dimension, double *size);

#endif
