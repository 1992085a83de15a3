/* Loops as JSON, and the inverse. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_json.h"
#include "po_memory.h"

/* Letters of the alphabet, for the labels of unloading. */
enum { LETTERS = 26 };

void po_json_jump_label(bool loading, size_t number, char label[PO_JUMP_LABEL_LENGTH]) {
  if (loading) {
    snprintf(label, PO_JUMP_LABEL_LENGTH, "%u", (unsigned)number % 10000000);
    return;
  }
  char backwards[PO_JUMP_LABEL_LENGTH];
  size_t n = 0;
  for (; number > 0 && n + 1 < PO_JUMP_LABEL_LENGTH; number = (number - 1) / LETTERS)
    backwards[n++] = (char)('a' + (number - 1) % LETTERS);
  for (size_t k = 0; k < n; ++k)
    label[k] = backwards[n - 1 - k];
  label[n] = '\0';
}

static json_t *state(const po_path_state *s) {
  return PO_JSON_OBJECT({"approach", po_json_number(s->approach)},
                        {"load", po_json_number(s->load)},
                        {"energy", po_json_number(isinf(s->approach) ? (double)NAN : s->energy)},
                        {"contact_radius", po_json_number(s->contact_radius)},
                        {"position", po_json_number(s->position)});
}

/* A jump. Given: number, its number in loading or in unloading, from 1. */
static json_t *jump(const po_jump *j, size_t number) {
  char label[PO_JUMP_LABEL_LENGTH], from[PO_JUMP_LABEL_LENGTH], to[PO_JUMP_LABEL_LENGTH];
  po_json_jump_label(j->loading, number, label);
  po_json_jump_label(j->loading, 2 * number - 1, from);
  po_json_jump_label(j->loading, 2 * number, to);
  json_t *ends = po_json_empty_array();
  po_json_append(&ends, po_json_text(from));
  po_json_append(&ends, po_json_text(to));
  return PO_JSON_OBJECT({"phase", po_json_text(j->loading ? "loading" : "unloading")},
                        {"label", po_json_text(label)}, {"ends", ends},
                        {"before", state(&j->before)}, {"after", state(&j->after)},
                        {"energy_lost", po_json_number(j->energy_lost)},
                        {"energy_lost_error_estimate", po_json_number(j->energy_lost_error)});
}

static json_t *loop(const po_loop *l) {
  json_t *jumps = po_json_empty_array();
  for (size_t k = 0; k < l->jump_count; ++k)
    po_json_append(&jumps,
                   jump(&l->jumps[k], k < l->loading_jumps ? k + 1 : k + 1 - l->loading_jumps));
  json_t *pull_off = state(&l->pull_off);
  po_json_set(&pull_off, "force", po_json_number(fmax(0.0, -l->pull_off.load)));
  po_json_set(&pull_off, "error_estimate", po_json_number(l->pull_off_error.load));
  po_json_set(&pull_off, "approach_error_estimate", po_json_number(l->pull_off_error.approach));
  return PO_JSON_OBJECT(
      {"preload", state(&l->preload)}, {"pull_off", pull_off},
      {"energy_lost", po_json_number(l->energy_lost)},
      {"energy_lost_error_estimate", po_json_number(l->energy_lost_error)},
      {"work", po_json_number(l->work)}, {"work_error_estimate", po_json_number(l->work_error)},
      {"energy_error_estimate", po_json_number(l->energy_error)}, {"jumps", jumps});
}

static json_t *both(const po_hysteresis *h) {
  return PO_JSON_OBJECT({"displacement_control", loop(&h->displacement)},
                        {"load_control", loop(&h->load)});
}

json_t *po_json_hysteresis(const po_result *result) {
  if (!result->has_hysteresis)
    return json_null();
  json_t *object = both(&result->hysteresis);
  po_json_set(&object, "jkr",
              result->theory.has_hysteresis ? both(&result->theory.hysteresis) : json_null());
  return object;
}

/* Reads a state; a null approach means complete separation. */
static po_path_state read_state(const json_t *object) {
  po_path_state s = {po_json_read_number(object, "approach"), po_json_read_number(object, "load"),
                     po_json_read_number(object, "energy"),
                     po_json_read_number(object, "contact_radius"),
                     po_json_read_number(object, "position")};
  if (isnan(s.approach)) {
    s.approach = -INFINITY;
    s.energy = 0.0;
  }
  return s;
}

static po_status read_loop(const json_t *object, po_control control, po_loop *l) {
  const json_t *jumps = json_object_get(object, "jumps");
  const json_t *pull_off = json_object_get(object, "pull_off");
  *l = (po_loop){.control = control,
                 .preload = read_state(json_object_get(object, "preload")),
                 .pull_off = read_state(pull_off),
                 .pull_off_error = {po_json_read_number(pull_off, "approach_error_estimate"),
                                    po_json_read_number(pull_off, "error_estimate")},
                 .energy_lost = po_json_read_number(object, "energy_lost"),
                 .energy_lost_error = po_json_read_number(object, "energy_lost_error_estimate"),
                 .work = po_json_read_number(object, "work"),
                 .work_error = po_json_read_number(object, "work_error_estimate"),
                 .energy_error = po_json_read_number(object, "energy_error_estimate"),
                 .jump_count = json_array_size(jumps)};
  l->jumps = po_allocate(l->jump_count, sizeof *l->jumps);
  if (!l->jumps)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < l->jump_count; ++k) {
    const json_t *item = json_array_get(jumps, k);
    const char *phase = json_string_value(json_object_get(item, "phase"));
    const bool loading = phase && strcmp(phase, "loading") == 0;
    l->jumps[k] =
        (po_jump){.loading = loading,
                  .before = read_state(json_object_get(item, "before")),
                  .after = read_state(json_object_get(item, "after")),
                  .energy_lost = po_json_read_number(item, "energy_lost"),
                  .energy_lost_error = po_json_read_number(item, "energy_lost_error_estimate")};
    l->loading_jumps += loading;
  }
  return PO_OK;
}

static po_status read_both(const json_t *object, bool *present, po_hysteresis *h) {
  *present = json_is_object(object);
  if (!*present)
    return PO_OK;
  const po_status status = read_loop(json_object_get(object, "displacement_control"),
                                     PO_DISPLACEMENT_CONTROL, &h->displacement);
  return status ? status
                : read_loop(json_object_get(object, "load_control"), PO_LOAD_CONTROL, &h->load);
}

po_status po_json_read_hysteresis(const json_t *object, po_result *result) {
  const po_status status = read_both(object, &result->has_hysteresis, &result->hysteresis);
  return status ? status
                : read_both(json_object_get(object, "jkr"), &result->theory.has_hysteresis,
                            &result->theory.hysteresis);
}
