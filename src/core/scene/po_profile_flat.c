/* Profiles that are flat to a radius b: the punch with a rounded edge, (r - b)^2/(2R) beyond b, and
 * the truncated sphere, (r^2 - b^2)/(2R) beyond b. */
#include <math.h>

#include "po_profile_kind.h"

static double punch_flat(const po_profile *profile) {
  return profile->parameter[PO_PUNCH_B];
}
static double punch_edge(const po_profile *profile) {
  return profile->parameter[PO_PUNCH_R];
}

static double punch_gap(const po_profile *profile, double r) {
  const double beyond = r - punch_flat(profile);
  return beyond > 0.0 ? 0.5 * beyond * beyond / punch_edge(profile) : 0.0;
}

static double punch_slope(const po_profile *profile, double r) {
  return fmax(r - punch_flat(profile), 0.0) / punch_edge(profile);
}

static po_dd punch_exact(const po_profile *profile, double r) {
  const po_dd beyond = po_dd_sum(r, -punch_flat(profile));
  return beyond.high > 0.0 ? po_dd_divide(po_dd_times(po_dd_multiply(beyond, beyond), 0.5),
                                          po_dd_of(punch_edge(profile)))
                           : po_dd_of(0.0);
}

static double punch_radius_of_gap(const po_profile *profile, double gap) {
  return punch_flat(profile) + sqrt(2.0 * punch_edge(profile) * gap);
}

static void punch_shape(const po_profile *profile, po_shape *shape) {
  shape->kink = punch_flat(profile);
}

const po_profile_kind PO_PUNCH = {.name = "punch",
                                  .parameters = 2,
                                  .first = PO_PUNCH_B,
                                  .gap = punch_gap,
                                  .slope = punch_slope,
                                  .gap_exact = punch_exact,
                                  .radius_of_gap = punch_radius_of_gap,
                                  .shape = punch_shape};

static double cut_flat(const po_profile *profile) {
  return profile->parameter[PO_TRUNCATED_B];
}
static double cut_radius(const po_profile *profile) {
  return profile->parameter[PO_TRUNCATED_R];
}

static double cut_gap(const po_profile *profile, double r) {
  const double b = cut_flat(profile);
  return r > b ? 0.5 * (r - b) * (r + b) / cut_radius(profile) : 0.0;
}

static double cut_slope(const po_profile *profile, double r) {
  return r > cut_flat(profile) ? r / cut_radius(profile) : 0.0;
}

static po_dd cut_exact(const po_profile *profile, double r) {
  const double b = cut_flat(profile);
  const po_dd product = po_dd_multiply(po_dd_sum(r, -b), po_dd_sum(r, b));
  return r > b ? po_dd_divide(po_dd_times(product, 0.5), po_dd_of(cut_radius(profile)))
               : po_dd_of(0.0);
}

static double cut_radius_of_gap(const po_profile *profile, double gap) {
  const double b = cut_flat(profile);
  return sqrt(b * b + 2.0 * cut_radius(profile) * gap);
}

static void cut_shape(const po_profile *profile, po_shape *shape) {
  shape->kink = cut_flat(profile);
}

const po_profile_kind PO_TRUNCATED = {.name = "truncated",
                                      .parameters = 2,
                                      .first = PO_TRUNCATED_B,
                                      .gap = cut_gap,
                                      .slope = cut_slope,
                                      .gap_exact = cut_exact,
                                      .radius_of_gap = cut_radius_of_gap,
                                      .shape = cut_shape};
