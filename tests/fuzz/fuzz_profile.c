/* Tables of a profile: the first part of the input is a table of radii and gaps, the second its
 * scale. A profile that is accepted must have the properties on which the solver relies. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_number.h"
#include "po_profile.h"
#include "po_profile_table.h"

/* For longer and shorter lengths products and quotients of them overflow or underflow. */
static const double HUGE_LENGTH = 1e60, TINY_LENGTH = 1e-60;
/* Rounding of a cubic, relative to the largest of the numbers from which it is made. */
static const double ROUNDING = 1e-13;
/* A fall that counts as rounding, relative to the last gap. */
static const double ROUNDED_GAP = 2e-12;
/* A root is found to this part of the largest gap beside it. */
static const double ROOT = 1e-9;
/* Radii between two rows at which the cubic is looked at. */
enum { BETWEEN = 8 };

static bool is_moderate(const po_profile_table *t) {
  const size_t last = t->rows - 1;
  for (size_t k = 1; k < t->rows; ++k) {
    const double gap = fabs(t->gap[k]), step = t->r[k] - t->r[k - 1];
    if (!(step > TINY_LENGTH) || gap > HUGE_LENGTH || (gap > 0.0 && gap < TINY_LENGTH))
      return false;
  }
  return t->r[last] < HUGE_LENGTH && t->growth < 1e3;
}

/* The largest of the numbers from which the cubic of an interval is made. */
static double size_of(const po_profile_table *t, size_t k) {
  const double h = t->r[k + 1] - t->r[k];
  return fmax(fmax(fabs(t->gap[k]), fabs(t->gap[k + 1])),
              h * fmax(fabs(t->slope[k]), fabs(t->slope[k + 1])));
}

/* The cubic of the rows k and k + 1 meets both, is monotonic if the rows around it are, and no gap
 * beyond a radius is less than stated there. */
static void require_interval(const po_profile *profile, const po_profile_table *t, size_t k,
                             double *least) {
  const double slack = ROUNDING * size_of(t, k), rise = t->gap[k + 1] - t->gap[k];
  const double fall = slack + ROUNDED_GAP * t->gap[t->rows - 1];
  double before = t->gap[k];
  fuzz_require(fabs(po_profile_gap(profile, 1.0, t->r[k]) - t->gap[k]) <= slack,
               "row %zu is not on the spline", k);
  fuzz_require(t->r[k + 1] == po_profile_next_joint(profile, t->r[k]), "row %zu is no joint",
               k + 1);
  for (int i = 0; i <= BETWEEN; ++i) {
    const double r = t->r[k] + (t->r[k + 1] - t->r[k]) * i / BETWEEN;
    if (i == BETWEEN || r >= t->r[k + 1])
      break;
    const double gap = po_profile_gap(profile, 1.0, r), slope = po_profile_slope(profile, 1.0, r);
    fuzz_require(isfinite(gap) && isfinite(slope), "no gap or slope at %g", r);
    fuzz_require(fabs(po_profile_gap_exact(profile, 1.0, r).high - gap) <= slack,
                 "another gap in twice the precision at %g", r);
    fuzz_require(rise < 0.0 || isfinite(po_profile_shape(profile).detail) || gap >= before - fall,
                 "the gap falls at %g, and the profile is said to rise", r);
    before = gap;
    *least = fmin(*least, gap + slack);
  }
}

static void require_profile(const po_profile *profile, const po_profile_table *t) {
  const size_t last = t->rows - 1;
  double least = t->gap[last];
  fuzz_require(t->gap[0] == 0.0 && t->r[0] == 0.0, "the profile does not begin on the axis");
  fuzz_require(t->growth >= 0.0 && isfinite(t->growth), "the profile grows as r^%g", t->growth);
  fuzz_require(po_profile_shape(profile).end == t->r[last], "the profile ends elsewhere");
  for (size_t k = last; k-- > 0;) {
    require_interval(profile, t, k, &least);
    fuzz_require(po_profile_gap_beyond(profile, 1.0, t->r[k]) <= least + ROUNDING * size_of(t, k),
                 "from row %zu on the gap is less than stated", k);
  }
}

/* The gap at the largest radius with a gap. */
static void require_radius(const po_profile *profile, const po_profile_table *t) {
  const size_t last = t->rows - 1;
  double greatest = 0.0;
  for (size_t k = 0; k < last; ++k)
    greatest = fmax(greatest, size_of(t, k));
  for (int i = 0; i < 4; ++i) {
    const double gap = t->gap[last] * (i + 0.5) / 3.0;
    const double r = po_profile_radius_of_gap(profile, 1.0, gap);
    fuzz_require(r >= 0.0 && (isfinite(r) || t->growth < 1e-2), "a gap of %g is at %g", gap, r);
    if (r < HUGE_LENGTH)
      fuzz_require(fabs(po_profile_gap(profile, 1.0, r) - gap) <= ROOT * greatest,
                   "a gap of %g is %g at its radius", gap, po_profile_gap(profile, 1.0, r));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part parts[2];
  const size_t count = fuzz_split(data, size, parts, 2);
  const char *path = fuzz_path("profile.csv");
  po_profile profile = po_profile_sphere();
  double scale = 1.0;
  if (count > 1 && po_number_parse(parts[1].bytes, &scale))
    profile.parameter[PO_TABLE_SCALE] = scale;
  const po_profile before = profile;
  fuzz_write(path, parts[0].bytes, parts[0].size);
  const po_status status = po_profile_set_file(&profile, path);
  fuzz_require_message(status);
  fuzz_require(status == PO_OK || memcmp(&before, &profile, sizeof before) == 0,
               "a refused table changes the profile");
  if (status == PO_OK) {
    const po_status wrong = po_profile_check(&profile);
    fuzz_require_message(wrong);
    if (!wrong && is_moderate(profile.table)) {
      require_profile(&profile, profile.table);
      require_radius(&profile, profile.table);
    }
  }
  po_profile_table_clear();
  free(parts[0].bytes);
  return 0;
}
