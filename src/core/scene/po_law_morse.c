/* The Morse law of steepness a: p = -2a (e^{-aH} - e^{-2aH}). It has no singularity, and its far
 * field falls exponentially. */
#include <math.h>

#include "po_dd.h"
#include "po_elementary.h"
#include "po_law_kind.h"
#include "po_special.h"

/* The range of the law of the paper is 1: that of a Morse law with the same stiffness at the
 * equilibrium distance, 2 a^2 = 16, is taken to be 1, too. */
static const double STEEPNESS_OF_RANGE_1 = 2.8284271247461903; /* sqrt(8) */
/* Softer laws reach farther than surfaces are meshed; e^{2aH} of steeper ones overflows. */
static const double SOFTEST = 0.05, STEEPEST = 50.0;
/* The gaps of a contact are between -DEEPEST/a and FARTHEST/a: beyond, the traction e^{-36} is
 * rounding, and no pressure of a contact is as high as e^{12}. */
static const double FARTHEST = 36.0, DEEPEST = 6.0;

static double steepness(const po_law *law) {
  return law->parameter[PO_MORSE_A];
}

static po_status check(const po_law *law) {
  const double a = steepness(law);
  if (isnan(a))
    return po_law_require(law, PO_MORSE_A);
  if (!(a >= SOFTEST && a <= STEEPEST))
    return po_fail(PO_BAD_INPUT, "morse_a is %g: expected a number from %g to %g", a, SOFTEST,
                   STEEPEST);
  return PO_OK;
}

/* Rigid bodies may be pressed to any overlap, but there the load grows as e^{2a approach}: beyond
 * the closest gap it is e^{12} times that of adhesion. */
static void derive(po_law *law) {
  const double a = steepness(law);
  law->constant = STEEPNESS_OF_RANGE_1 / a;
  law->numbers = (po_law_numbers){.peak_gap = M_LN2 / a,
                                  .closest = -DEEPEST / a,
                                  .least = -DEEPEST / a,
                                  .reach = FARTHEST / a,
                                  .factor = 2.0 * a,
                                  .exponent = INFINITY};
}

static po_law_value at(const po_law *law, double gap) {
  const double a = steepness(law), e = po_exp(-a * gap);
  return (po_law_value){.traction = -2.0 * a * (e - e * e),
                        .slope = 2.0 * a * a * (e - 2.0 * e * e)};
}

static po_dd traction(const po_law *law, double gap) {
  const double a = steepness(law);
  const po_dd e = po_dd_exp(po_dd_product(-a, gap));
  return po_dd_times(po_dd_subtract(po_dd_multiply(e, e), e), 2.0 * a);
}

static double energy(const po_law *law, double gap) {
  const double e = po_exp(-steepness(law) * gap);
  return e * e - 2.0 * e;
}

/* The mean over phi of exp(b A cos phi) is the modified Bessel function I0(b A). */
static double mean_of_exponential(double power, double gap, double amplitude) {
  const double z = power * amplitude;
  return po_exp(z - power * gap) * po_bessel_i0_scaled(z);
}

static po_law_value averaged(const po_law *law, double gap, double amplitude) {
  const double a = steepness(law), e = mean_of_exponential(a, gap, amplitude),
               e2 = mean_of_exponential(2.0 * a, gap, amplitude);
  return (po_law_value){.traction = -2.0 * a * (e - e2), .slope = 2.0 * a * a * (e - 2.0 * e2)};
}

static double energy_averaged(const po_law *law, double gap, double amplitude) {
  const double a = steepness(law);
  return mean_of_exponential(2.0 * a, gap, amplitude) -
         2.0 * mean_of_exponential(a, gap, amplitude);
}

/* The range plus the gap; of overlapping surfaces, which no singularity holds apart, the range
 * times an exponential that goes on smoothly. */
static po_law_scale scale(const po_law *law, double gap) {
  const double range = law->constant;
  if (gap >= 0.0)
    return (po_law_scale){range + gap, 1.0};
  const double e = po_exp(gap / range);
  return (po_law_scale){range * e, e};
}

static po_law_closeness closeness(const po_law *law, double gap) {
  const double a = steepness(law), e = po_exp(-a * gap);
  return (po_law_closeness){e * (2.0 - e), -2.0 * a * e * (1.0 - e)};
}

const po_law_kind PO_MORSE = {.name = "morse",
                              .parameters = 1,
                              .first = PO_MORSE_A,
                              .check = check,
                              .derive = derive,
                              .at = at,
                              .traction = traction,
                              .energy = energy,
                              .averaged = averaged,
                              .energy_averaged = energy_averaged,
                              .scale = scale,
                              .closeness = closeness};
