#include "po_recognise.h"

#include <math.h>
#include <stdio.h>

/* A factor: a number, times a value of the scene unless that is NULL. */
typedef struct {
  const char *name, *inverse;
  double number;
  double (*of)(const po_scene *scene);
} factor;

static const double PI = 3.14159265358979323846;

static double radius_of(const po_scene *scene) {
  return scene->radius;
}

static double tabor_of(const po_scene *scene) {
  return scene->tabor;
}

static double root_of(const po_scene *scene) {
  return sqrt(scene->radius);
}

/* In the order in which they are tried: what occurs more often in practice comes first, and those
 * that depend on the scene come before numbers, which some scenes give by chance. 4/3 belongs to
 * the modulus K = 4 E* / 3, and 3/2 turns the unit pi w R into the pull-off force of JKR theory. */
static const factor FACTORS[] = {
    {"1", "1", 1, NULL},
    {"R", "1/R", 1, radius_of},
    {"pi R", "1/(pi R)", PI, radius_of},
    {"2 pi R", "1/(2 pi R)", 2 * PI, radius_of},
    {"sqrt(R)", "1/sqrt(R)", 1, root_of},
    {"mu", "1/mu", 1, tabor_of},
    {"E* eps/w", "w/(E* eps)", 1, po_scene_stiffness},
    {"pi", "1/pi", PI, NULL},
    {"2", "1/2", 2, NULL},
    {"4/3", "3/4", 4.0 / 3, NULL},
    {"3/2", "2/3", 1.5, NULL},
    {"2 pi", "1/(2 pi)", 2 * PI, NULL},
    {"4", "1/4", 4, NULL},
    {"pi^2", "1/pi^2", PI *PI, NULL},
    {"8/3", "3/8", 8.0 / 3, NULL},
    {"10", "1/10", 10, NULL},
    {"1000", "1/1000", 1000, NULL},
    {"1e9", "1e-9", 1e9, NULL},
};
enum { FACTOR_COUNT = sizeof FACTORS / sizeof *FACTORS };

/* The values of a factor of the scene must differ by this factor between pairs; otherwise it cannot
 * be distinguished from a number. */
static const double DIFFERENT = 1.2;

/* Reports whether factor k, its inverse, or their opposite explains all pairs. Returned: in
 * *differs, whether its values differ between the pairs. */
static bool explains(const po_pair *pairs, size_t count, const factor *f, bool inverse,
                     bool negative, double tolerance, bool *differs) {
  double least = INFINITY, most = 0;
  for (size_t i = 0; i < count; ++i) {
    const double value = f->number * (f->of ? f->of(pairs[i].scene) : 1);
    if (!(value > 0) || !isfinite(value))
      return false;
    const double x = (negative ? -1 : 1) * (inverse ? 1 / value : value);
    if (!(fabs(pairs[i].obtained - x * pairs[i].expected) <=
          tolerance * fabs(x * pairs[i].expected)))
      return false;
    least = fmin(least, value);
    most = fmax(most, value);
  }
  *differs = most > DIFFERENT * least;
  return true;
}

static void describe_factor(const factor *f, bool inverse, bool negative, bool differs,
                            char name[PO_FACTOR_LENGTH]) {
  const char *what = inverse ? f->inverse : f->name;
  if (f == FACTORS)
    snprintf(name, PO_FACTOR_LENGTH, "%s", negative ? "-1 (a wrong sign)" : "1");
  else
    snprintf(name, PO_FACTOR_LENGTH, "%s%s%s%s", negative ? "-" : "", what,
             negative ? " (with a wrong sign)" : "",
             f->of && !differs ? ", or the same number, as all scenes have one value of it" : "");
}

bool po_recognise_factor(const po_pair *pairs, size_t count, double tolerance,
                         char name[PO_FACTOR_LENGTH]) {
  for (int same = 0; same < 2; ++same)
    for (int negative = 0; negative < 2; ++negative)
      for (size_t k = 0; k < FACTOR_COUNT; ++k)
        for (int inverse = 0; inverse < 2; ++inverse) {
          bool differs = false;
          if (!explains(pairs, count, &FACTORS[k], inverse, negative, tolerance, &differs) ||
              (FACTORS[k].of && differs == (same != 0)) || (!FACTORS[k].of && same))
            continue;
          describe_factor(&FACTORS[k], inverse, negative, differs, name);
          return true;
        }
  return false;
}
