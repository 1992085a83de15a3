/* Tests of the rows of a result: that no cell is empty, that every member of a result survives
 * JSON, and that the units of all loads are converted. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_json.h"
#include "po_result_rows.h"
#include "po_si.h"
#include "po_solve.h"
#include "po_texts.h"
#include "run.h"

static void check_block(const po_block *block);

static void check_row(const po_block *block, const po_row *row) {
  ck_assert_msg(row->key && row->error && row->null && row->says, "%s: an empty cell", block->name);
  ck_assert_msg(*row->key && *row->says, "%s.%s is not described", block->name, row->key);
  ck_assert_msg((row->type == PO_ROW_NUMBER) == (row->dimension != 0), "%s.%s: dimension",
                block->name, row->key);
  ck_assert_msg(po_block_find(block, NULL, row->key).row == row, "%s.%s: twice", block->name,
                row->key);
  if (row->type == PO_ROW_WORD)
    ck_assert(row->names && (!row->word == !row->take));
  if (*row->error) {
    const po_row *bound = po_block_find(block, NULL, row->error).row;
    ck_assert_msg(bound && bound->type == PO_ROW_NUMBER && bound->dimension == row->dimension,
                  "%s.%s: no error %s", block->name, row->key, row->error);
  }
  if (row->type == PO_ROW_PART || row->type == PO_ROW_LIST)
    check_block(row->block);
}

/* Whether a row has a member of its own, rather than parts or a derived value. */
static bool has_member(const po_row *row) {
  return row->type == PO_ROW_NUMBER ? !row->alias : row->size && !row->get;
}

static void check_block(const po_block *block) {
  ck_assert(*block->name && block->size);
  for (size_t i = 0; i < block->count; ++i)
    for (size_t k = 0; has_member(&block->row[i]) && k < i; ++k)
      ck_assert_msg(!has_member(&block->row[k]) || block->row[k].offset != block->row[i].offset,
                    "%s: %s and %s are one member", block->name, block->row[k].key,
                    block->row[i].key);
  for (size_t i = 0; i < block->count; ++i)
    if (block->row[i].type == PO_ROW_INLINE)
      check_block(block->row[i].block);
    else
      check_row(block, &block->row[i]);
}

TEST(no_cell_is_empty) {
  check_block(&PO_ALL_ROWS);
}

/* A key without help has that of the next one, which has the same owner. A key that a series may
 * vary is a number with a place, or sets one. */
TEST(no_cell_of_a_key_is_empty) {
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key_row *row = &PO_KEYS[key];
    ck_assert_msg(*row->name && *row->expected && *row->value, "key %d: an empty cell", key);
    ck_assert_int_eq(po_texts_key(row->name), key);
    ck_assert_int_eq(po_key_of_name(row->name), key < PO_KEY_END ? key : -1);
    ck_assert(*row->help || PO_KEYS[key + 1].owner == row->owner);
    ck_assert(!row->varies || row->place != PO_NO_PLACE || row->target >= 0 ||
              row->owner == PO_OWNER_SI);
    for (int other = 0; other < key; ++other)
      ck_assert(row->place == PO_NO_PLACE || row->place != PO_KEYS[other].place);
  }
}

/* A number that has a unit can be given in SI units. */
TEST(keys_with_a_dimension_have_one_in_si_units) {
  const po_units units = {.length = 1, .force = 1};
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key_row *row = &PO_KEYS[key];
    const int si = po_key_in_si(key);
    const bool speed = po_key_is_of_time(key) &&
                       key != PO_KEY_VISCOELASTIC; /* in epsilon/tau_0, beside the time in s */
    ck_assert_msg((row->owner != PO_OWNER_SI && (row->dimension != PO_DIMENSION_NONE || speed)) ==
                      (si >= 0),
                  "%s", row->name);
    if (si < 0 || speed)
      continue;
    const po_key_row *twin = &PO_KEYS[si];
    char name[64];
    snprintf(name, sizeof name, "%s_%s", row->name, po_si_unit_of(&units, row->dimension).name);
    ck_assert_str_eq(twin->name, name);
    ck_assert_int_eq((int)twin->dimension, (int)row->dimension);
    ck_assert(twin->domain == row->domain || key == PO_KEY_RADIUS); /* of two bodies */
    ck_assert_uint_eq(twin->verbs, row->verbs);
    ck_assert(twin->varies == row->varies && twin->owner == PO_OWNER_SI);
  }
}

TEST(paths_lead_to_numbers) {
  po_step step = {.preload = {.approach = -1.5}, .pull_off = {.load = -0.75}};
  po_cycle cycle = {.loss = {.energy = 2.385}};
  ck_assert_double_eq(po_block_number(&PO_STEP_ROWS, &step, "preload.approach"), -1.5);
  ck_assert_double_eq(po_block_number(&PO_STEP_ROWS, &step, "force"), 0.75);
  ck_assert_double_eq(po_block_number(&PO_STEP_ROWS, &step, "cycles"), 0.0);
  ck_assert_double_nan(po_block_number(&PO_STEP_ROWS, &step, "cycles.0.energy_lost"));
  step.cycle = &cycle;
  step.cycle_count = 1;
  ck_assert_double_eq(po_block_number(&PO_STEP_ROWS, &step, "cycles.0.energy_lost"), 2.385);
  static const char *const WRONG[] = {
      "cycles.energy_lost", "cycles.0", "preload.", "forc", "force.x", ""};
  for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; ++i)
    ck_assert_ptr_null(po_block_find(&PO_STEP_ROWS, &step, WRONG[i]).row);
}

/* -- Every member survives JSON -- */

/* Compares two structures word by word, except for some words. Given: names of members that are
 * compared otherwise or that no document has. */
typedef struct {
  size_t offset, size;
} part;
#define WITHOUT(S, member)                                                                         \
  { offsetof(S, member), sizeof(((S *)0)->member) }
#define SAME(S, a, b, ...)                                                                         \
  compare(#S, a, b, sizeof(S), (const part[]){__VA_ARGS__},                                        \
          sizeof((const part[]){__VA_ARGS__}) / sizeof(part))

static void compare(const char *name, const void *a, const void *b, size_t size,
                    const part *without, size_t count) {
  for (size_t at = 0; at < size; at += sizeof(double)) {
    double left, right;
    memcpy(&left, (const char *)a + at, sizeof left);
    memcpy(&right, (const char *)b + at, sizeof right);
    bool skipped = false;
    for (size_t k = 0; k < count; ++k)
      skipped = skipped ||
                (at + sizeof left > without[k].offset && at < without[k].offset + without[k].size);
    ck_assert_msg(skipped || memcmp(&left, &right, sizeof left) == 0 ||
                      (isnan(left) && isnan(right)),
                  "%s: the member at %zu was %.17g and is read as %.17g", name, at, left, right);
  }
}

static void same_state(const po_path_state *a, const po_path_state *b) {
  SAME(po_path_state, a, b, {0, 0});
}

/* Documents have neither energy nor contact radius of these states. */
static void same_place(const po_path_state *a, const po_path_state *b) {
  SAME(po_path_state, a, b, WITHOUT(po_path_state, energy), WITHOUT(po_path_state, contact_radius));
}

static void same_loop(const po_loop *a, const po_loop *b) {
  ck_assert(a->control == b->control);
  SAME(po_loop, a, b, WITHOUT(po_loop, control), WITHOUT(po_loop, jumps),
       WITHOUT(po_loop, has_rows), WITHOUT(po_loop, row), WITHOUT(po_loop, interpolated),
       WITHOUT(po_loop, preload), WITHOUT(po_loop, pull_off));
  same_state(&a->preload, &b->preload);
  same_state(&a->pull_off, &b->pull_off);
  for (size_t k = 0; k < a->jump_count; ++k) {
    ck_assert(a->jumps[k].loading == b->jumps[k].loading);
    SAME(po_jump, &a->jumps[k], &b->jumps[k], WITHOUT(po_jump, loading), WITHOUT(po_jump, doubt));
  }
  ck_assert(a->has_rows == b->has_rows && a->has_rows == (a->row_count > 0));
  for (size_t k = 0; k < a->row_count; ++k) {
    ck_assert(a->row[k].loading == b->row[k].loading && a->row[k].jump == b->row[k].jump);
    SAME(po_loop_row, &a->row[k], &b->row[k], {0, offsetof(po_loop_row, state)},
         WITHOUT(po_loop_row, state.energy), WITHOUT(po_loop_row, state.position));
  }
}

static void same_stairs(const po_staircase *a, const po_staircase *b) {
  ck_assert(a->control == b->control);
  ck_assert_uint_eq(a->count, b->count);
  same_place(&a->reached, &b->reached);
  for (size_t k = 0; k < a->count; ++k) {
    const po_step *s = &a->step[k], *t = &b->step[k];
    ck_assert(s->jumped == t->jumped && s->open == t->open);
    SAME(po_step, s, t, WITHOUT(po_step, preload), WITHOUT(po_step, until),
         WITHOUT(po_step, jumped), WITHOUT(po_step, open), WITHOUT(po_step, pull_off),
         WITHOUT(po_step, cycle));
    same_place(&s->preload, &t->preload);
    same_place(&s->until, &t->until);
    same_place(&s->pull_off, &t->pull_off);
    for (size_t j = 0; j < s->cycle_count; ++j) {
      const po_cycle *c = &s->cycle[j], *d = &t->cycle[j];
      same_place(&c->preload, &d->preload);
      SAME(po_cycle, c, d, WITHOUT(po_cycle, preload), WITHOUT(po_cycle, loss.moved),
           WITHOUT(po_cycle, loss.size), WITHOUT(po_cycle, loss.of_held),
           WITHOUT(po_cycle, loss.doubt));
    }
  }
}

static void same_special_points(const po_special_point *a, const po_special_point *b,
                                size_t count) {
  for (size_t k = 0; k < count; ++k) {
    ck_assert(a[k].kind == b[k].kind && a[k].unstable_modes == b[k].unstable_modes);
    ck_assert(a[k].has_base == b[k].has_base && a[k].base_modes == b[k].base_modes);
    SAME(po_special_point, &a[k], &b[k], WITHOUT(po_special_point, kind),
         WITHOUT(po_special_point, unstable_modes), WITHOUT(po_special_point, has_base),
         WITHOUT(po_special_point, base_modes));
  }
}

static void same_diagnostics(const po_diagnostics *a, const po_diagnostics *b) {
  ck_assert(a->has_sensitivity == b->has_sensitivity);
  SAME(po_diagnostics, a, b, WITHOUT(po_diagnostics, states),
       WITHOUT(po_diagnostics, has_sensitivity), WITHOUT(po_diagnostics, force),
       WITHOUT(po_diagnostics, reverse_trace));
  if (a->has_sensitivity)
    SAME(po_sensitivity, &a->force, &b->force, {0, 0});
  for (size_t k = 0; k < a->state_count; ++k) {
    ck_assert_int_eq(a->states[k].at, b->states[k].at);
    SAME(po_diagnosed_state, &a->states[k], &b->states[k], WITHOUT(po_diagnosed_state, at));
  }
  const po_reverse_trace *r = &a->reverse_trace, *q = &b->reverse_trace;
  ck_assert(r->made == q->made && r->status == q->status && r->same == q->same);
  ck_assert_str_eq(r->reason, q->reason);
  if (r->made)
    SAME(po_reverse_trace, r, q, WITHOUT(po_reverse_trace, made), WITHOUT(po_reverse_trace, status),
         WITHOUT(po_reverse_trace, reason), WITHOUT(po_reverse_trace, same));
}

static void same_theories(const po_result *a, const po_result *b) {
  ck_assert(a->theory_count == PO_THEORY_OF_RATE && b->theory_count == PO_THEORY_OF_RATE);
  for (size_t k = 0; k < PO_THEORY_OF_RATE; ++k) {
    const po_theory_row *r = &a->theories[k], *q = &b->theories[k];
    ck_assert(r->theory == q->theory && r->holds == q->holds && r->decided_by == q->decided_by &&
              r->at_least == q->at_least);
    ck_assert_str_eq(r->source, q->source);
    ck_assert_str_eq(r->reason, q->reason);
    SAME(po_theory_row, r, q, WITHOUT(po_theory_row, theory), WITHOUT(po_theory_row, source),
         WITHOUT(po_theory_row, holds), WITHOUT(po_theory_row, decided_by),
         WITHOUT(po_theory_row, at_least), WITHOUT(po_theory_row, reason));
  }
  ck_assert_uint_eq(a->parabola.theory_count, b->parabola.theory_count);
  for (size_t k = 0; k < a->parabola.theory_count; ++k)
    ck_assert(a->parabola.theories[k].theory == b->parabola.theories[k].theory);
}

/* Given: a result of panels with everything wanted. */
static void same_result(const po_result *a, const po_result *b) {
  ck_assert(a->status == b->status && a->rigid == b->rigid && a->followed == b->followed);
  ck_assert_str_eq(a->reason, b->reason);
  ck_assert(a->ended.cause == b->ended.cause && a->has_pull_off == b->has_pull_off);
  ck_assert(a->pull_off_any.is_known == b->pull_off_any.is_known &&
            a->pull_off_any.complete == b->pull_off_any.complete);
  ck_assert(a->has_hysteresis && b->has_hysteresis && a->has_staircases && b->has_staircases);
  ck_assert(a->theory.has_hysteresis == b->theory.has_hysteresis &&
            a->theory.has_staircases == b->theory.has_staircases);
  SAME(po_result, a, b, {0, offsetof(po_result, start)}, WITHOUT(po_result, ended.cause),
       WITHOUT(po_result, has_pull_off), WITHOUT(po_result, pull_off.far_force_error),
       WITHOUT(po_result, pull_off.full_disc), WITHOUT(po_result, pull_off.has_sensitivity),
       WITHOUT(po_result, pull_off.sensitivity), WITHOUT(po_result, pull_off_any.is_known),
       WITHOUT(po_result, pull_off_any.complete), WITHOUT(po_result, folds),
       WITHOUT(po_result, extrema), WITHOUT(po_result, curve), WITHOUT(po_result, curve_count),
       WITHOUT(po_result, profile), WITHOUT(po_result, profile_count),
       WITHOUT(po_result, annuli.compressed), WITHOUT(po_result, annuli.held),
       WITHOUT(po_result, rate), WITHOUT(po_result, has_hysteresis), WITHOUT(po_result, hysteresis),
       WITHOUT(po_result, has_staircases), WITHOUT(po_result, staircase),
       WITHOUT(po_result, theory), WITHOUT(po_result, theories), WITHOUT(po_result, diagnostics),
       WITHOUT(po_result, parabola.theories), WITHOUT(po_result, interpolation),
       WITHOUT(po_result, seconds_beside));
  same_special_points(a->folds, b->folds, a->fold_count);
  same_special_points(a->extrema, b->extrema, a->extremum_count);
  for (size_t k = 0; k < a->annuli.held_count; ++k)
    SAME(po_contact_annulus, &a->annuli.held[k], &b->annuli.held[k], {0, 0});
  for (size_t k = 0; k < a->annuli.compressed_count; ++k)
    SAME(po_contact_annulus, &a->annuli.compressed[k], &b->annuli.compressed[k], {0, 0});
  same_loop(&a->hysteresis.of[PO_AT_APPROACH], &b->hysteresis.of[PO_AT_APPROACH]);
  same_loop(&a->hysteresis.of[PO_AT_LOAD], &b->hysteresis.of[PO_AT_LOAD]);
  if (a->theory.has_hysteresis) {
    same_loop(&a->theory.hysteresis.of[PO_AT_APPROACH], &b->theory.hysteresis.of[PO_AT_APPROACH]);
    same_loop(&a->theory.hysteresis.of[PO_AT_LOAD], &b->theory.hysteresis.of[PO_AT_LOAD]);
  }
  ck_assert(a->hysteresis.has_spring == b->hysteresis.has_spring &&
            a->staircase.has_spring == b->staircase.has_spring);
  if (a->hysteresis.has_spring)
    same_loop(&a->hysteresis.of[PO_THROUGH_SPRING], &b->hysteresis.of[PO_THROUGH_SPRING]);
  for (int k = 0; k < 2 + a->staircase.has_spring; ++k) {
    same_stairs(&a->staircase.of[k], &b->staircase.of[k]);
    if (a->theory.has_staircases)
      same_stairs(&a->theory.staircase.of[k], &b->theory.staircase.of[k]);
  }
  same_diagnostics(&a->diagnostics, &b->diagnostics);
  same_theories(a, b);
}

static po_request everything(double tabor, double radius) {
  po_request request = po_input_default();
  request.scene.tabor = tabor;
  request.scene.amplitude = 0.8;
  request.scene.wavelength = 11.0;
  request.scene.radius = radius;
  request.mesh.tolerance = 1e-4;
  request.want = ((1u << PO_WANT_COUNT) - 1u) & ~(unsigned)PO_WANT_HISTORY;
  return request;
}

/* Solves a scene. Returned: its document, to be released. */
static json_t *document_of(const po_request *request, po_result *result) {
  *result = po_result_none();
  ck_assert_int_eq(po_solve(request, result), PO_OK);
  json_t *document = po_json_document(request, result), *parsed = NULL;
  po_text text = {0};
  ck_assert_int_eq(po_json_print(document, &text), PO_OK);
  ck_assert_int_eq(po_json_parse(text.data, text.length, &parsed), PO_OK);
  json_decref(document);
  po_text_clear(&text);
  return parsed;
}

/* -INFINITY (separated) and NAN (unknown) are both null in JSON, so that documents alone do not
 * show whether they are read back right. A member of a result without a row is found, too. */
LOOP_TEST(every_member_survives_json, 0, 2) {
  po_request request = everything(_i ? 0.0 : 2.385, 57.0);
  request.stiffness = _i ? NAN : 0.4;
  po_result solved, again;
  json_t *document = document_of(&request, &solved);
  ck_assert(_i || solved.hysteresis.of[PO_AT_APPROACH].jump_count > 1);
  ck_assert(_i || (solved.hysteresis.has_spring && solved.staircase.has_spring));
  ck_assert_int_eq(po_json_read_result(document, &again), PO_OK);
  same_result(&solved, &again);
  json_decref(document);
  po_result_clear(&solved);
  po_result_clear(&again);
}

/* -- Units of loads -- */

static bool is_one_of(const char *key, const char *const *list) {
  for (; *list; ++list)
    if (strcmp(key, *list) == 0)
      return true;
  return false;
}

/* The factor of a number if its unit of load is `unit` times smaller. */
static double factor_of(const char *key, const json_t *object, double unit) {
  static const char *const LOADS[] = {"load",
                                      "force",
                                      "load_error_estimate",
                                      "energy",
                                      "energy_error_estimate",
                                      "energy_lost",
                                      "energy_lost_error_estimate",
                                      "work",
                                      "work_error_estimate",
                                      "area_error_estimate",
                                      "stiffness",
                                      "load_rate",
                                      "fold_load_change",
                                      "extremum_load_change",
                                      NULL};
  if (strcmp(key, "traction") == 0)
    return 1.0 / cbrt(unit);
  const bool of_force = strcmp(key, "error_estimate") == 0 && json_object_get(object, "force");
  return of_force || is_one_of(key, LOADS) ? unit : 1.0;
}

static void compare_units(const json_t *a, const json_t *b, double unit) {
  static const char *const OTHER[] = {"input", "moved", "sensitivity", "seconds", "digest", NULL};
  const char *key;
  json_t *value;
  if (json_is_array(a)) {
    ck_assert_uint_eq(json_array_size(a), json_array_size(b));
    for (size_t k = 0; k < json_array_size(a); ++k)
      compare_units(json_array_get(a, k), json_array_get(b, k), unit);
  } else if (json_is_object(a)) {
    json_object_foreach((json_t *)a, key, value) {
      const json_t *other = json_object_get(b, key);
      if (is_one_of(key, OTHER))
        continue;
      if (json_is_real(value))
        ck_assert_msg(json_real_value(value) * factor_of(key, a, unit) == json_real_value(other),
                      "%s: %.17g and %.17g", key, json_real_value(value), json_real_value(other));
      else
        compare_units(value, other, unit);
    }
  } else {
    ck_assert(json_equal(a, b));
  }
}

/* The paraboloid r^2/2R with the reference length R and with the reference length epsilon is the
 * same sphere, so that the numbers differ in the unit of load only: R = 64 epsilon, and exact
 * powers of two. A load that had been forgotten was wrong for every profile but the sphere. */
TEST(all_loads_have_the_unit_of_the_scene) {
  po_request sphere = everything(2.0, 64.0), other = everything(0.5, 1.0);
  ck_assert(po_profile_set(&sphere.scene.profile, "power:0.0078125,2"));
  ck_assert(po_profile_set(&other.scene.profile, "power:0.0078125,2"));
  po_result in_r, in_epsilon;
  json_t *a = document_of(&sphere, &in_r), *b = document_of(&other, &in_epsilon);
  compare_units(a, b, 64.0);
  for (int k = 0; k < 2; ++k) /* documents do not have these */
    ck_assert_double_eq(in_r.staircase.of[k].reached.energy * 64.0,
                        in_epsilon.staircase.of[k].reached.energy);
  ck_assert_double_eq(in_r.staircase.of[0].step[0].pull_off.energy * 64.0,
                      in_epsilon.staircase.of[0].step[0].pull_off.energy);
  json_decref(a);
  json_decref(b);
  po_result_clear(&in_r);
  po_result_clear(&in_epsilon);
}
