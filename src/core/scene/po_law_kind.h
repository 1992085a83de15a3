/* What one law is: the functions that po_law.h is made of. */
#ifndef PO_LAW_KIND_H
#define PO_LAW_KIND_H

#include "po_law.h"

struct po_law_kind {
  const char *name;
  size_t parameters; /* it has so many, from this one on */
  po_law_parameter first;
  /* Checks the parameters. Status: PO_BAD_INPUT with the value and what was expected. NULL: there
   * is nothing to check. */
  po_status (*check)(const po_law *law);
  /* Its numbers. The peak and the far field are exact, as they define the contact and the load; the
   * other gaps are bounds only, and the factor of an exponential is not used. */
  po_law_numbers numbers;
  /* Sets the numbers and the constant that depend on parameters. NULL: none does. */
  void (*derive)(po_law *law);
  /* The law, its energy and their averages: exact, to rounding. */
  po_law_value (*at)(const po_law *law, double gap);
  po_dd (*traction)(const po_law *law, double gap);
  double (*energy)(const po_law *law, double gap);
  po_law_value (*averaged)(const po_law *law, double gap, double amplitude);
  double (*energy_averaged)(const po_law *law, double gap, double amplitude);
  /* Scale and closeness only measure steps and changes. Scale NULL: it is 1 + H, for laws of powers
   * only; every other law gives its scale, and sets closest, least and reach. */
  po_law_scale (*scale)(const po_law *law, double gap);
  po_law_closeness (*closeness)(const po_law *law, double gap); /* at gaps > 0 */
  /* The approach of po_law_approach_of_push by the repulsion alone, which exceeds all attraction at
   * the loads for which it is called; NULL: it is found from the energy. */
  double (*approach_of_push)(double share, double load);
};

/* Gaps of a law of powers of 1 + H: the least one is a tenth of the distance from the singularity.
 * Beyond 20 it is its attractive power to a part of 21^-(n-m), 1.2e-8 for (3, 9). A larger
 * remainder is left to the polynomial of the panel to infinity. */
#define PO_GAPS_OF_POWERS .closest = -1.0, .least = -0.9, .reach = 20.0

#define PO_LAW_KIND(law, text) extern const po_law_kind PO_##law;
PO_LAW_ROWS(PO_LAW_KIND)

/* Status: PO_BAD_INPUT with a message if the parameter was not given. */
po_status po_law_require(const po_law *law, po_law_parameter parameter);

#endif
