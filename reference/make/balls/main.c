/* The contact laws and rigid bodies of the adhesion sheet in ball arithmetic: proven intervals.
 *
 *     sheet_balls PROBLEM NAME=VALUE...      prints one line a quantity: its name and its interval
 *
 * Parameters are decimal numbers; they are enclosed, not rounded. Every function is evaluated with
 * all errors bounded (F. Johansson, IEEE Trans. Comput. 66, 1281 (2017): Arb), roots are isolated
 * by bisection with proven signs of values and derivatives, integrals are enclosed by Gauss rules
 * with bounds in the complex plane. Shares nothing with src/ nor with the second route,
 * sheet_laws.py. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "balls.h"

void fail(const char *what, const char *which) {
  fprintf(stderr, "sheet_balls: %s%s\n", what, which);
  exit(1);
}

void take(arb_t value, const parameters *p, const char *name) {
  for (size_t k = 0; k < p->count; ++k)
    if (strcmp(p->name[k], name) == 0) {
      arb_set(value, p->value[k]);
      return;
    }
  fail("missing parameter ", name);
}

void answer(const char *name, const arb_t value) {
  char *digits = arb_get_str(value, 40, ARB_STR_MORE);
  printf("%s %s\n", name, digits);
  flint_free(digits);
}

void answer_negative(const char *name, const arb_t value) {
  arb_t minus;
  arb_init(minus);
  arb_neg(minus, value);
  answer(name, minus);
  arb_clear(minus);
}

static void read_parameter(parameters *p, char *word) {
  char *equal = strchr(word, '=');
  if (!equal || p->count == MOST)
    fail("expected at most 16 words NAME=VALUE, not ", word);
  *equal = '\0';
  p->name[p->count] = word;
  arb_init(p->value[p->count]);
  if (arb_set_str(p->value[p->count], equal + 1, BITS) != 0)
    fail("not a number: ", equal + 1);
  ++p->count;
}

int main(int count, char **words) {
  static const struct {
    const char *name;
    problem *solve;
  } problems[] = {{"law-jkr", law_jkr},
                  {"law-dmt", law_dmt},
                  {"law-maugis", law_maugis},
                  {"law-cone", law_cone},
                  {"law-power", law_power},
                  {"law-flat-punch", law_flat_punch},
                  {"law-exact-sphere", law_exact_sphere},
                  {"law-hyperboloid", law_hyperboloid},
                  {"rigid-sphere", rigid_sphere},
                  {"rigid-truncated", rigid_truncated},
                  {"rigid-wavy", rigid_wavy}};
  parameters p = {0};
  for (int k = 2; k < count; ++k)
    read_parameter(&p, words[k]);
  for (size_t k = 0; count > 1 && k < sizeof problems / sizeof *problems; ++k)
    if (strcmp(problems[k].name, words[1]) == 0) {
      problems[k].solve(&p);
      for (size_t i = 0; i < p.count; ++i)
        arb_clear(p.value[i]);
      flint_cleanup();
      return 0;
    }
  fail("unknown problem ", count > 1 ? words[1] : "");
}
