/* Materials given as tables: interconversion of modulus and compliance, and pull-off forces. */
#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "po_creep_table.h"
#include "po_elementary.h"
#include "po_solve.h"
#include "request.h"
#include "run.h"

/* The transforms of E and J times s at s, relative to the relaxed ones. */
static double modulus_at(double relaxed, const po_creep_terms *terms, double s) {
  double sum = relaxed;
  for (size_t m = 0; m < terms->count; ++m)
    sum += terms->term[m].weight / (1.0 + 1.0 / (s * terms->term[m].time));
  return sum / relaxed;
}

static double compliance_at(const po_creep_terms *terms, double s) {
  double sum = terms->instant;
  for (size_t m = 0; m < terms->count; ++m)
    sum += terms->term[m].weight / (1.0 + s * terms->term[m].time);
  return sum;
}

static void check_inverse(double relaxed, const po_creep_terms *modulus) {
  static po_creep_terms c;
  po_creep_of_modulus(relaxed, modulus, &c);
  double sum = c.instant;
  ck_assert_uint_eq(c.count, modulus->count);
  for (size_t m = 0; m < c.count; ++m) {
    sum += c.term[m].weight;
    ck_assert_double_gt(c.term[m].weight, 0.0);
    ck_assert_double_ge(c.term[m].time, modulus->term[m].time);
    ck_assert(m + 1 == c.count || c.term[m].time <= modulus->term[m + 1].time);
  }
  ck_assert_double_eq_tol(sum, 1.0, 1e-13);
  for (double s = 1e-14; s < 1e14; s *= 1.9)
    ck_assert_double_eq_tol(modulus_at(relaxed, modulus, s) * compliance_at(&c, s), 1.0, 2e-13);
}

/* Zeros in the middle, beside the shorter and beside the longer time, and pairs of times that are
 * nearly equal. */
TEST(modulus_and_compliance_are_inverse) {
  static const double WEIGHTS[][4] = {{1, 1, 1, 1},
                                      {1e-9, 1, 1e-9, 1},
                                      {1, 1e-9, 1, 1e-9},
                                      {1e4, 1e2, 1, 1e-2},
                                      {1e-3, 1, 1e3, 1e6}};
  static const double TIMES[][4] = {
      {1, 2, 3, 4}, {1e-6, 1e-2, 1, 1e5}, {1, 1.0000001, 7, 7.0000001}, {1e-12, 1e-11, 1e11, 1e12}};
  for (size_t w = 0; w < sizeof WEIGHTS / sizeof *WEIGHTS; ++w)
    for (size_t t = 0; t < sizeof TIMES / sizeof *TIMES; ++t)
      for (double relaxed = 1e-3; relaxed < 2e3; relaxed *= 1e3) {
        po_creep_terms modulus = {.count = 4};
        for (size_t m = 0; m < 4; ++m)
          modulus.term[m] = (po_creep_term){TIMES[t][m], WEIGHTS[w][m]};
        check_inverse(relaxed, &modulus);
      }
  po_creep_terms many = {.count = PO_MOST_CREEP_TERMS};
  for (size_t m = 0; m < many.count; ++m)
    many.term[m] = (po_creep_term){1e-12 * po_exp(0.3 * (double)m), 0.1 + (double)(m % 7)};
  check_inverse(3.0, &many);
}

TEST(one_time_has_its_closed_form) {
  po_creep_terms c;
  po_creep_of_modulus(2.0, &(po_creep_terms){.count = 1, .term = {{0.25, 6.0}}}, &c);
  ck_assert_double_eq_tol(c.instant, 0.25, 1e-15);
  ck_assert_double_eq_tol(c.term[0].time, 1.0, 1e-15);
  ck_assert_double_eq_tol(c.term[0].weight, 0.75, 1e-15);
}

/* The material of a table with this content. */
static po_creep material_of(const char *content) {
  static int number;
  char path[64], text[80];
  snprintf(path, sizeof path, "creep-table-%d-%d.csv", (int)getpid(), number++);
  snprintf(text, sizeof text, "prony:%s", path);
  FILE *file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs(content, file);
  fclose(file);
  po_creep creep = {0};
  ck_assert_msg(po_creep_read(text, &creep) == PO_OK, "%s", po_message());
  remove(path);
  return creep;
}

/* All ways to write one body give the same terms. */
TEST(a_body_has_many_tables) {
  static const char *const TABLES[] = {
      "time,compliance\n0.5,0.3\n4,0.5\n",
      "time_s,compliance_per_mpa\n0,2e-1\n0.5,0.3\n4,0.5\n",
      "time_ms;compliance\n0;40\n500;60\n4000;100\n",
      "time,modulus\n0.18473488398308203,0.65750679881128268\n"
      "2.1652651160169180,0.14249320118871732\n",
      "time,modulus_pa\n0.18473488398308203,3.2875339940564134\n"
      "2.1652651160169180,0.71246600594358658\ninf,1\n",
  };
  po_creep_terms first, other;
  for (size_t k = 0; k < sizeof TABLES / sizeof *TABLES; ++k) {
    const po_creep creep = material_of(TABLES[k]);
    ck_assert_int_eq(po_creep_is_in_seconds(&creep), k == 1 || k == 2);
    po_creep_terms_fill(&creep, 1.0, k ? &other : &first);
    if (k == 0)
      continue;
    ck_assert_uint_eq(other.count, 2);
    ck_assert_double_eq_tol(other.instant, first.instant, 1e-14);
    for (size_t m = 0; m < 2; ++m) {
      ck_assert_double_eq_tol(other.term[m].time, first.term[m].time, 1e-13 * first.term[m].time);
      ck_assert_double_eq_tol(other.term[m].weight, first.term[m].weight, 1e-13);
    }
  }
  ck_assert_double_eq(po_creep_mean_time(&(po_creep){.kind = PO_CREEP_SLS}), 1.0);
  const po_creep creep = material_of(TABLES[0]);
  ck_assert_double_eq_tol(po_creep_mean_time(&creep), (0.3 * 0.5 + 0.5 * 4.0) / 0.8, 1e-13);
}

static po_result solved(po_creep creep, double speed) {
  po_request request = request_of(1.0, 0.0, 20.0, INFINITY);
  request.mesh = po_mesh_default();
  request.preload.approach = 5.0;
  request.creep = creep;
  request.unload_speed = speed;
  po_result result;
  ck_assert_msg(po_solve(&request, &result) == PO_OK, "%s", result.reason);
  ck_assert(result.has_pull_off);
  return result;
}

static void check_same(po_creep a, double speed_a, po_creep b, double speed_b, double tolerance) {
  po_result x = solved(a, speed_a), y = solved(b, speed_b);
  ck_assert_double_le(fabs(x.pull_off.force - y.pull_off.force),
                      x.pull_off.force_error + y.pull_off.force_error);
  ck_assert_double_le(fabs(x.pull_off.force - y.pull_off.force), tolerance * x.pull_off.force);
  ck_assert_double_le(fabs(x.rate.end.energy.work - y.rate.end.energy.work), 10.0 * tolerance);
  po_result_clear(&x);
  po_result_clear(&y);
}

TEST(a_table_of_the_standard_linear_solid_is_it) {
  const po_creep sls = {.kind = PO_CREEP_SLS, .ratio = 0.1};
  check_same(sls, 1.0, material_of("time,compliance\n0,0.1\n1,0.9\n"), 1.0, 0.0);
  check_same(sls, 1.0, material_of("time,modulus\n0.1,0.9\n"), 1.0, 1e-9);
  /* only speed times tau_0 matters */
  check_same(sls, 1.0, material_of("time,modulus\n100,0.9\n"), 1e-3, 1e-9);
  check_same(sls, 1.0, material_of("time_ms,modulus_mpa\n0.1,9\ninf,1\n"), 1e3, 1e-9);
}

/* The Gamma spectrum by another rule than that of the program: steps of ln 1.2 in ln(tau). */
TEST(a_table_of_a_gamma_spectrum_is_near_it) {
  static const double N = 0.6, STEP = 1.2;
  static char content[20000];
  double times[PO_MOST_CREEP_TERMS], weights[PO_MOST_CREEP_TERMS], sum = 0.0;
  size_t count = 0, length = 0;
  for (double t = 40.0 / pow(STEP, 155.0); t < 41.0; t *= STEP) {
    times[count] = t;
    weights[count] = po_exp(N * log(t) - t);
    sum += weights[count++];
  }
  length += (size_t)snprintf(content, sizeof content, "time,compliance\n0,%.17g\n", sum / 9.0);
  for (size_t m = 0; m < count; ++m)
    length += (size_t)snprintf(content + length, sizeof content - length, "%.17g,%.17g\n", times[m],
                               weights[m]);
  check_same((po_creep){.kind = PO_CREEP_GAMMA, .ratio = 0.1, .exponent = N}, 1.0,
             material_of(content), 1.0, 2e-5);
}

/* Of the independent solver: reference/make/viscoelastic.py --scene 1 0 20 100 inf
 * "terms:0.1;0.3@0.4;5@0.6" 5 1 - states 3.1553387 +- 9.5e-6 and 0.779056 +- 2.0e-5. */
TEST(two_times_pull_off_as_the_independent_solver_has_it) {
  po_result result = solved(material_of("time,compliance\n0.3,0.36\n5,0.54\n"), 1.0);
  ck_assert_uint_eq(result.rate.terms, 2);
  ck_assert_double_eq_tol(result.pull_off.force, 3.15533871618508,
                          result.pull_off.force_error + 9.5e-6);
  ck_assert_double_eq_tol(result.pull_off.approach, 0.779056058685478,
                          result.pull_off.approach_error + 2.0e-5);
  ck_assert_double_lt(result.pull_off.force_error, 1e-4);
  po_result_clear(&result);
}
