/* What one profile is: the functions that po_profile.h is made of. */
#ifndef PO_PROFILE_KIND_H
#define PO_PROFILE_KIND_H

#include "po_profile.h"

struct po_profile_kind {
  const char *name;
  size_t parameters; /* it has so many, from this one on */
  po_profile_parameter first;
  /* Checks the parameters. Status: PO_BAD_INPUT with the value and what was expected. NULL: each is
   * finite and > 0. */
  po_status (*check)(const po_profile *profile);
  bool over_radius; /* the gap is that of these functions over R of the scene: of the sphere */
  double (*gap)(const po_profile *profile, double r);
  double (*slope)(const po_profile *profile, double r);
  po_dd (*gap_exact)(const po_profile *profile, double r);
  double (*gap_beyond)(const po_profile *profile, double r); /* NULL: f rises */
  double (*radius_of_gap)(const po_profile *profile, double gap);
  /* Sets the numbers that are not those of a profile as r^2: known everywhere, convex, without kink
   * and without detail. NULL: there are none. */
  void (*shape)(const po_profile *profile, po_shape *shape);
  double (*next_joint)(const po_profile *profile, double r); /* NULL: only the kink */
};

#define PO_PROFILE_KIND(profile, text) extern const po_profile_kind PO_##profile;
PO_PROFILE_ROWS(PO_PROFILE_KIND)
extern const po_profile_kind PO_TABLE;

/* Requires a finite parameter > 0. */
po_status po_profile_require_positive(const po_profile *profile, po_profile_parameter parameter);

#endif
