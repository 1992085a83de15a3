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
  void (*derive)(po_law *law); /* sets the constants; NULL: there are none */
  /* The law, its energy and their averages: exact, to rounding. */
  po_law_value (*at)(const po_law *law, double gap);
  po_two (*traction)(const po_law *law, double gap);
  double (*energy)(const po_law *law, double gap);
  po_law_value (*averaged)(const po_law *law, double gap, double amplitude);
  double (*energy_averaged)(const po_law *law, double gap, double amplitude);
  /* Scale and closeness only measure steps and changes; closest gap and reach bound gaps. Scale,
   * closest gap and reach may be NULL in a law of powers of 1 + H: then the scale is 1 + H, the
   * closest gap -1, and the reach 20. Every other law must give all three. */
  po_law_scale (*scale)(const po_law *law, double gap);
  po_law_closeness (*closeness)(const po_law *law, double gap); /* at gaps > 0 */
  double (*peak_gap)(const po_law *law);                        /* exact: it defines the contact */
  double (*closest)(const po_law *law); /* given: also the least gap at which it is evaluated */
  double (*reach)(const po_law *law);
  po_law_far (*far_field)(const po_law *law); /* exact; the factor of an exponential is not used */
  /* An estimate: where a rigid trace ends, and how large the domain is. */
  double (*approach_of_push)(const po_law *law, double share, double load);
};

#define PO_LAW_KIND(law, text) extern const po_law_kind PO_##law;
PO_LAW_ROWS(PO_LAW_KIND)

/* Status: PO_BAD_INPUT with a message if the parameter was not given. */
po_status po_law_require(const po_law *law, po_law_parameter parameter);

double po_law_approach_of_distance(double distance); /* from the singularity of a power */

#endif
