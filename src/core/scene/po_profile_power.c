/* Profiles that are one power of the radius: the sphere r^2/2 over R, C r^n, and the cone t r. */
#include <math.h>

#include "po_dd.h"
#include "po_elementary.h"
#include "po_profile_kind.h"

static double sphere_gap(const po_profile *profile, double r) {
  (void)profile;
  return 0.5 * r * r;
}

static double sphere_slope(const po_profile *profile, double r) {
  (void)profile;
  return r;
}

static po_dd sphere_exact(const po_profile *profile, double r) {
  (void)profile;
  return po_dd_product(0.5 * r, r);
}

static double sphere_radius_of_gap(const po_profile *profile, double gap) {
  (void)profile;
  return sqrt(2.0 * gap);
}

const po_profile_kind PO_SPHERE = {.name = "sphere",
                                   .over_radius = true,
                                   .gap = sphere_gap,
                                   .slope = sphere_slope,
                                   .gap_exact = sphere_exact,
                                   .radius_of_gap = sphere_radius_of_gap};

/* Flatter powers than the cone have an infinite slope on the axis; steeper ones than the largest
 * are flat punches, and their powers overflow. */
static const double SMALLEST_POWER = 1.0, LARGEST_POWER = 40.0;

static double factor(const po_profile *profile) {
  return profile->parameter[PO_POWER_C];
}
static double exponent(const po_profile *profile) {
  return profile->parameter[PO_POWER_N];
}

static po_status power_check(const po_profile *profile) {
  const double n = exponent(profile);
  const po_status status = po_profile_require_positive(profile, PO_POWER_C);
  if (status)
    return status;
  if (isnan(n))
    return po_profile_require_positive(profile, PO_POWER_N);
  return n >= SMALLEST_POWER && n <= LARGEST_POWER
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "power_n is %g: expected a number from %g to %g", n,
                       SMALLEST_POWER, LARGEST_POWER);
}

static double power_gap(const po_profile *profile, double r) {
  return factor(profile) * po_pow(r, exponent(profile));
}

static double power_slope(const po_profile *profile, double r) {
  return factor(profile) * exponent(profile) * po_pow(r, exponent(profile) - 1.0);
}

static po_dd power_exact(const po_profile *profile, double r) {
  if (r == 0.0)
    return po_dd_of(0.0);
  return po_dd_times(po_dd_pow(po_dd_of(r), po_dd_of(exponent(profile))), factor(profile));
}

static double power_radius_of_gap(const po_profile *profile, double gap) {
  return po_pow(gap / factor(profile), 1.0 / exponent(profile));
}

static void power_shape(const po_profile *profile, po_shape *shape) {
  shape->growth = exponent(profile);
}

const po_profile_kind PO_POWER = {.name = "power",
                                  .parameters = 2,
                                  .first = PO_POWER_C,
                                  .check = power_check,
                                  .gap = power_gap,
                                  .slope = power_slope,
                                  .gap_exact = power_exact,
                                  .radius_of_gap = power_radius_of_gap,
                                  .shape = power_shape};

static double tangent(const po_profile *profile) {
  return profile->parameter[PO_CONE_T];
}

static double cone_gap(const po_profile *profile, double r) {
  return tangent(profile) * r;
}

static double cone_slope(const po_profile *profile, double r) {
  (void)r;
  return tangent(profile);
}

static po_dd cone_exact(const po_profile *profile, double r) {
  return po_dd_product(tangent(profile), r);
}

static double cone_radius_of_gap(const po_profile *profile, double gap) {
  return gap / tangent(profile);
}

static void cone_shape(const po_profile *profile, po_shape *shape) {
  (void)profile;
  shape->growth = 1.0;
}

const po_profile_kind PO_CONE = {.name = "cone",
                                 .parameters = 1,
                                 .first = PO_CONE_T,
                                 .gap = cone_gap,
                                 .slope = cone_slope,
                                 .gap_exact = cone_exact,
                                 .radius_of_gap = cone_radius_of_gap,
                                 .shape = cone_shape};
