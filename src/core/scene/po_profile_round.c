/* Bodies that are round at the tip and steep far out: the sphere as it is, R - sqrt(R^2 - r^2), and
 * the hyperboloid t (sqrt(r^2 + b^2) - b), a cone with a blunt tip. */
#include <math.h>

#include "po_elementary.h"
#include "po_profile_kind.h"

static double sphere_radius(const po_profile *profile) {
  return profile->parameter[PO_EXACT_SPHERE_R];
}

/* The sphere ends at its equator, where its slope is infinite. From this part of R on, which is
 * 0.044 R above the equator, the gap is continued by the parabola with the same value and slope,
 * 23: a body that is as steep there and has a gap everywhere. What attracts beyond the end is less
 * than (R/eps)^-2 of the pull-off force; an outer radius R leaves it out. It is 1 - 2^-10, so that
 * the distance from the equator, on which the height depends, has no rounding error. */
static const double END = 1023.0 / 1024.0;

/* The end of the sphere, and its height over the equator, which is r over the slope there. */
typedef struct {
  double r, height;
} sphere_end;

static sphere_end end_of(const po_profile *profile) {
  const double R = sphere_radius(profile), r = END * R;
  return (sphere_end){r, sqrt((R - r) * (R + r))};
}

/* In a form that does not cancel near the axis. */
static double cap(double R, double r) {
  return r * (r / (R + sqrt((R - r) * (R + r))));
}

static double sphere_gap(const po_profile *profile, double r) {
  const double R = sphere_radius(profile);
  const sphere_end end = end_of(profile);
  return r <= end.r ? cap(R, r) : cap(R, end.r) + 0.5 * (r - end.r) * ((r + end.r) / end.height);
}

static double sphere_slope(const po_profile *profile, double r) {
  const double R = sphere_radius(profile);
  const sphere_end end = end_of(profile);
  return r / (r <= end.r ? sqrt((R - r) * (R + r)) : end.height);
}

static po_dd cap_exact(double R, double r) {
  const po_dd square = po_dd_multiply(po_dd_sum(R, -r), po_dd_sum(R, r));
  return po_dd_divide(po_dd_product(r, r), po_dd_add(po_dd_of(R), po_dd_sqrt(square)));
}

static po_dd sphere_exact(const po_profile *profile, double r) {
  const double R = sphere_radius(profile);
  const sphere_end end = end_of(profile);
  if (r <= end.r)
    return cap_exact(R, r);
  const po_dd product = po_dd_multiply(po_dd_sum(r, -end.r), po_dd_sum(r, end.r));
  return po_dd_add(cap_exact(R, end.r),
                   po_dd_divide(po_dd_times(product, 0.5), po_dd_of(end.height)));
}

static double sphere_radius_of_gap(const po_profile *profile, double gap) {
  const double R = sphere_radius(profile);
  const sphere_end end = end_of(profile);
  const double more = gap - cap(R, end.r);
  return more <= 0.0 ? sqrt(gap * (2.0 * R - gap)) : sqrt(end.r * end.r + 2.0 * end.height * more);
}

static void sphere_shape(const po_profile *profile, po_shape *shape) {
  shape->kink = end_of(profile).r;
}

/* Beside the end, joints at distances from the equator that double: there f is analytic, but has
 * its singularity so near that a quadrature needs pieces of that length. */
enum { JOINTS = 11 };

static double sphere_next_joint(const po_profile *profile, double r) {
  const double R = sphere_radius(profile), least = R - end_of(profile).r;
  for (int k = JOINTS - 2; k >= 0; --k)
    if (R - ldexp(least, k) > r)
      return R - ldexp(least, k);
  for (int k = 0; k < JOINTS; ++k)
    if (R + ldexp(least, k) > r)
      return R + ldexp(least, k);
  return INFINITY;
}

const po_profile_kind PO_EXACT_SPHERE = {.name = "exact_sphere",
                                         .parameters = 1,
                                         .first = PO_EXACT_SPHERE_R,
                                         .gap = sphere_gap,
                                         .slope = sphere_slope,
                                         .gap_exact = sphere_exact,
                                         .radius_of_gap = sphere_radius_of_gap,
                                         .shape = sphere_shape,
                                         .next_joint = sphere_next_joint};

static double slope_far_out(const po_profile *profile) {
  return profile->parameter[PO_HYPERBOLOID_T];
}
static double tip(const po_profile *profile) {
  return profile->parameter[PO_HYPERBOLOID_B];
}

static double blunt_gap(const po_profile *profile, double r) {
  const double b = tip(profile);
  return slope_far_out(profile) * r * (r / (po_hypot(r, b) + b));
}

static double blunt_slope(const po_profile *profile, double r) {
  return slope_far_out(profile) * (r / po_hypot(r, tip(profile)));
}

static po_dd blunt_exact(const po_profile *profile, double r) {
  const double b = tip(profile);
  const po_dd square = po_dd_product(r, r);
  const po_dd root = po_dd_sqrt(po_dd_add(square, po_dd_product(b, b)));
  return po_dd_times(po_dd_divide(square, po_dd_add(root, po_dd_of(b))), slope_far_out(profile));
}

static double blunt_radius_of_gap(const po_profile *profile, double gap) {
  const double h = gap / slope_far_out(profile);
  return sqrt(h * (h + 2.0 * tip(profile)));
}

static void blunt_shape(const po_profile *profile, po_shape *shape) {
  (void)profile;
  shape->growth = 1.0;
}

const po_profile_kind PO_HYPERBOLOID = {.name = "hyperboloid",
                                        .parameters = 2,
                                        .first = PO_HYPERBOLOID_T,
                                        .gap = blunt_gap,
                                        .slope = blunt_slope,
                                        .gap_exact = blunt_exact,
                                        .radius_of_gap = blunt_radius_of_gap,
                                        .shape = blunt_shape};
