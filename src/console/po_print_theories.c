#include "po_print.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_si.h"

/* The theories of the line, at most so many, the nearest one first. Of two with the same force the
 * first one is named. */
static const po_theory KNOWN[] = {PO_THEORY_MAUGIS, PO_THEORY_JKR, PO_THEORY_GUDURU, PO_THEORY_DMT,
                                  PO_THEORY_RIGID};
enum { KNOWN_COUNT = sizeof KNOWN / sizeof *KNOWN, MOST_NAMED = 3 };
static const double SAME = 1e-6;

static void insert(const po_theory_row *row, const po_theory_row *sorted[], size_t *count) {
  size_t at = *count;
  for (size_t k = 0; k < *count; ++k)
    if (fabs(sorted[k]->force - row->force) <= SAME * row->force)
      return;
  for (; at > 0 && fabs(sorted[at - 1]->deviation) > fabs(row->deviation); --at)
    sorted[at] = sorted[at - 1];
  sorted[at] = row;
  ++*count;
}

void po_print_theories_line(const po_result *result) {
  const po_theory_row *sorted[KNOWN_COUNT];
  size_t count = 0;
  for (size_t k = 0; k < KNOWN_COUNT && result->theory_count == PO_THEORY_COUNT; ++k)
    if (isfinite(result->theories[KNOWN[k]].deviation))
      insert(&result->theories[KNOWN[k]], sorted, &count);
  for (size_t k = 0; k < count && k < MOST_NAMED; ++k)
    printf("%s%s %+.1f %%", k ? ", " : "theories ", po_theory_words(sorted[k]->theory),
           100.0 * sorted[k]->deviation);
  if (count)
    printf("; pulloff compare says more\n");
}

/* A number with its unit, or - if there is none. */
static const char *number_or_dash(const char *format, double value, char text[32]) {
  if (isnan(value))
    return "-";
  snprintf(text, 32, format, value);
  return text;
}

static void print_row(const po_theory_row *row, const po_si_unit *force) {
  static const char *const HOLDS[] = {"unknown", "no", "yes"};
  char deviation[32], error[32];
  printf("%-26s ", po_theory_words(row->theory));
  if (isnan(row->force)) {
    printf("not evaluated: %s\n", row->reason);
    return;
  }
  printf("%12.7g ", row->force);
  if (force)
    printf("%12.7g ", row->force * force->factor);
  printf("%11s %9s %-7s ", number_or_dash("%+.2f %%", 100.0 * row->deviation, deviation),
         number_or_dash("%.1e %%", 100.0 * row->deviation_error, error), HOLDS[row->holds]);
  char number[32];
  printf("%s %s, expected %s %g\n", po_assumption_words(row->decided_by),
         isnan(row->number) ? "unknown" : number_or_dash("%.4g", row->number, number),
         row->at_least ? "at least" : "at most", row->limit);
}

void po_print_theories(const po_result *result, const po_theory *only, const po_units *units) {
  const po_si_unit unit = units ? po_si_prefixed(units, PO_DIMENSION_LOAD) : (po_si_unit){0};
  char head[32] = "";
  if (units)
    snprintf(head, sizeof head, "%*s%s ", 12 - (int)strlen(unit.name), "force/", unit.text);
  printf("%-26s %12s %s%11s %9s %-7s %s\n", "theory", "force", head, "deviation", "error", "holds",
         "decided by");
  for (size_t k = 0; k < result->theory_count; ++k)
    if (!only || result->theories[k].theory == *only)
      print_row(&result->theories[k], units ? &unit : NULL);
  printf("%-26s %s\n", "theory", "source");
  for (size_t k = 0; k < result->theory_count; ++k)
    if (!only || result->theories[k].theory == *only)
      printf("%-26s %s\n", po_theory_words(result->theories[k].theory), result->theories[k].source);
}
