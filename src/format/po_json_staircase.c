/* Staircases as JSON, and the inverse. */
#include <math.h>

#include "po_json.h"
#include "po_json_parts.h"
#include "po_memory.h"

/* A state of the branch with its position, by which it can be found on the curve; after complete
 * separation the approach is null. */
static json_t *state(const po_path_state *s) {
  return PO_JSON_OBJECT({"approach", po_json_number(s->approach)},
                        {"load", po_json_number(s->load)},
                        {"position", po_json_number(s->position)});
}

static po_path_state read_state(const json_t *object) {
  po_path_state s = {.approach = po_json_read_number(object, "approach"),
                     .load = po_json_read_number(object, "load"),
                     .position = po_json_read_number(object, "position")};
  if (isnan(s.approach))
    s.approach = -INFINITY;
  return s;
}

static json_t *cycle(const po_cycle *c) {
  return PO_JSON_OBJECT({"preload", state(&c->preload)},
                        {"energy_lost", po_json_number(c->loss.energy)},
                        {"energy_lost_error_estimate", po_json_number(c->energy_error)},
                        {"jumps", po_json_count(c->loss.jumps)});
}

static json_t *step(const po_step *s) {
  json_t *cycles = po_json_empty_array();
  for (size_t k = 0; k < s->cycle_count; ++k)
    po_json_append(&cycles, cycle(&s->cycle[k]));
  json_t *preload = state(&s->preload);
  po_json_set(&preload, "error_estimate", po_json_number(s->preload_error.approach));
  po_json_set(&preload, "load_error_estimate", po_json_number(s->preload_error.load));
  return PO_JSON_OBJECT({"preload", preload},
                        {"decided_by", po_json_text(s->jumped ? "jump" : "minimum")},
                        {"until", state(&s->until)}, {"open", po_json_flag(s->open)},
                        {"force", po_json_number(fmax(0.0, -s->pull_off.load))},
                        {"error_estimate", po_json_number(s->pull_off_error.load)},
                        {"approach", po_json_number(s->pull_off.approach)},
                        {"approach_error_estimate", po_json_number(s->pull_off_error.approach)},
                        {"position", po_json_number(s->pull_off.position)}, {"cycles", cycles});
}

static json_t *staircase(const po_staircase *s) {
  json_t *steps = po_json_empty_array();
  for (size_t k = 0; k < s->count; ++k)
    po_json_append(&steps, step(&s->step[k]));
  return PO_JSON_OBJECT({"steps", steps}, {"reached", state(&s->reached)});
}

static json_t *both(const po_staircase s[2]) {
  return PO_JSON_OBJECT({"displacement_control", staircase(&s[0])},
                        {"load_control", staircase(&s[1])});
}

json_t *po_json_staircases(const po_result *result) {
  json_t *object = both(result->staircase);
  po_json_set(&object, "jkr",
              result->theory.has_staircases ? both(result->theory.staircase) : json_null());
  return object;
}

static po_status read_step(const json_t *item, po_step *s) {
  const json_t *preload = json_object_get(item, "preload");
  const json_t *cycles = json_object_get(item, "cycles");
  const char *by = json_string_value(json_object_get(item, "decided_by"));
  *s = (po_step){.preload = read_state(preload),
                 .preload_error = {po_json_read_number(preload, "error_estimate"),
                                   po_json_read_number(preload, "load_error_estimate")},
                 .until = read_state(json_object_get(item, "until")),
                 .jumped = by && by[0] == 'j',
                 .open = json_is_true(json_object_get(item, "open")),
                 .pull_off = {.load = -po_json_read_number(item, "force"),
                              .approach = po_json_read_number(item, "approach"),
                              .position = po_json_read_number(item, "position")},
                 .pull_off_error = {po_json_read_number(item, "approach_error_estimate"),
                                    po_json_read_number(item, "error_estimate")}};
  s->cycle = po_allocate(json_array_size(cycles), sizeof *s->cycle);
  if (!s->cycle)
    return PO_NO_MEMORY;
  s->cycle_count = json_array_size(cycles);
  for (size_t k = 0; k < s->cycle_count; ++k) {
    const json_t *c = json_array_get(cycles, k);
    s->cycle[k] = (po_cycle){.preload = read_state(json_object_get(c, "preload")),
                             .loss = {.energy = po_json_read_number(c, "energy_lost"),
                                      .jumps = (size_t)po_json_count_of(c, "jumps")},
                             .energy_error = po_json_read_number(c, "energy_lost_error_estimate")};
  }
  return PO_OK;
}

static po_status read_staircase(const json_t *object, po_control control, po_staircase *s) {
  const json_t *steps = json_object_get(object, "steps");
  *s = (po_staircase){.control = control,
                      .reached = read_state(json_object_get(object, "reached")),
                      .step = po_allocate(json_array_size(steps), sizeof *s->step)};
  if (!s->step)
    return PO_NO_MEMORY;
  po_status status = PO_OK;
  for (size_t k = 0; k < json_array_size(steps) && !status; ++k) {
    status = read_step(json_array_get(steps, k), &s->step[k]);
    ++s->count;
  }
  return status;
}

static po_status read_both(const json_t *object, bool *present, po_staircase staircase[2]) {
  *present = json_is_object(object);
  if (!*present)
    return PO_OK;
  const po_status status = read_staircase(json_object_get(object, "displacement_control"),
                                          PO_DISPLACEMENT_CONTROL, &staircase[0]);
  return status ? status
                : read_staircase(json_object_get(object, "load_control"), PO_LOAD_CONTROL,
                                 &staircase[1]);
}

po_status po_json_read_staircases(const json_t *object, po_result *result) {
  const po_status status = read_both(object, &result->has_staircases, result->staircase);
  return status ? status
                : read_both(json_object_get(object, "jkr"), &result->theory.has_staircases,
                            result->theory.staircase);
}
