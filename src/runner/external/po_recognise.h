/* Recognises a wrong sign, factor or unit in numbers that should equal those of a reference. */
#ifndef PO_RECOGNISE_H
#define PO_RECOGNISE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_scene.h"

/* A number of a solver beside the expected one. */
typedef struct {
  double obtained, expected;
  const po_scene *scene;
} po_pair;

/* Finds a factor that turns all expected numbers into the obtained ones: 1, pi, 2, 4/3 and others,
 * R, pi R, the Tabor parameter and others of the scene, their inverses, each with either sign.
 * Given: at least one pair; `tolerance`, relative.
 * Returned: false if there is none; in `name`, the factor in words: "1" if the numbers agree,
 * "-1 (a wrong sign)", "pi", "1/R". */
enum { PO_FACTOR_LENGTH = 120 };
bool po_recognise_factor(const po_pair *pairs, size_t count, double tolerance,
                         char name[PO_FACTOR_LENGTH]);

#endif
