/* Diagnostics as JSON, and the inverse. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_json.h"
#include "po_json_parts.h"
#include "po_memory.h"
#include "po_quote.h"

static json_t *state_json(const po_diagnosed_state *s) {
  return PO_JSON_OBJECT({"at", po_json_text(po_kept_name(s->at))},
                        {"approach", po_json_number(s->approach)},
                        {"load", po_json_number(s->load)}, {"nodes", po_json_count(s->nodes)},
                        {"residual", po_json_number(s->found.residual)},
                        {"rounding", po_json_number(s->found.rounding)},
                        {"condition", po_json_number(s->found.condition)},
                        {"bordered_condition", po_json_number(s->found.bordered_condition)});
}

static json_t *sensitivity_json(const po_diagnostics *d) {
  if (!d->has_sensitivity)
    return json_null();
  return PO_JSON_OBJECT(
      {"tabor", po_json_number(d->force.tabor)}, {"amplitude", po_json_number(d->force.amplitude)},
      {"wavelength", po_json_number(d->force.wavelength)},
      {"radius", po_json_number(d->force.radius)}, {"residual", po_json_number(d->force.residual)},
      {"rounding", po_json_number(d->force.rounding)});
}

static json_t *moved_json(const po_moved *m) {
  return PO_JSON_OBJECT({"solves", po_json_count(m->solves)}, {"failed", po_json_count(m->failed)},
                        {"force_change", po_json_number(m->change)},
                        {"force_excess", po_json_number(m->excess)},
                        {"force_change_predicted", po_json_number(m->predicted)},
                        {"digits_kept", po_json_number(po_digits_left(m->change))},
                        {"digits_predicted", po_json_number(po_digits_left(m->predicted))},
                        {"fold_change", po_json_number(m->folds)});
}

/* The reverse trace; null if there was none. */
static json_t *reverse_trace_json(const po_reverse_trace *w) {
  if (!w->made)
    return json_null();
  return PO_JSON_OBJECT({"status", po_json_text(po_status_name(w->status))},
                        {"reason", po_json_text(w->reason)}, {"points", po_json_count(w->points)},
                        {"folds", po_json_count(w->folds)}, {"extrema", po_json_count(w->extrema)},
                        {"same", po_json_flag(w->same)},
                        {"fold_approach_change", po_json_number(w->fold_approach)},
                        {"fold_load_change", po_json_number(w->fold_load)},
                        {"extremum_approach_change", po_json_number(w->extremum_approach)},
                        {"extremum_load_change", po_json_number(w->extremum_load)},
                        {"excess", po_json_number(w->excess)});
}

json_t *po_json_diagnostics(const po_result *result) {
  const po_diagnostics *d = &result->diagnostics;
  json_t *states = po_json_empty_array();
  for (size_t k = 0; k < d->state_count; ++k)
    po_json_append(&states, state_json(&d->states[k]));
  return PO_JSON_OBJECT({"residual", po_json_number(d->residual)},
                        {"rounding", po_json_number(d->rounding)},
                        {"undiagnosed", po_json_count(d->undiagnosed)}, {"states", states},
                        {"sensitivity", sensitivity_json(d)}, {"moved", moved_json(&d->moved)},
                        {"energy_defect", po_json_number(d->energy_defect)},
                        {"energy_defect_at", po_json_number(d->energy_defect_at)},
                        {"reverse_trace", reverse_trace_json(&d->reverse_trace)},
                        {"seconds", po_json_number(d->seconds)});
}

static po_kept_kind kind_of(const char *name) {
  po_kept_kind kind = PO_KEPT_START;
  while (kind < PO_KEPT_END && strcmp(name ? name : "", po_kept_name(kind)) != 0)
    ++kind;
  return kind;
}

static void read_state(const json_t *object, po_diagnosed_state *s) {
  *s = (po_diagnosed_state){
      .at = kind_of(json_string_value(json_object_get(object, "at"))),
      .approach = po_json_read_number(object, "approach"),
      .load = po_json_read_number(object, "load"),
      .nodes = (size_t)po_json_count_of(object, "nodes"),
      .found = {.residual = po_json_read_number(object, "residual"),
                .rounding = po_json_read_number(object, "rounding"),
                .condition = po_json_read_number(object, "condition"),
                .bordered_condition = po_json_read_number(object, "bordered_condition")}};
}

static void read_sensitivity(const json_t *object, po_diagnostics *d) {
  d->has_sensitivity = json_is_object(object);
  if (d->has_sensitivity)
    d->force = (po_sensitivity){.tabor = po_json_read_number(object, "tabor"),
                                .amplitude = po_json_read_number(object, "amplitude"),
                                .wavelength = po_json_read_number(object, "wavelength"),
                                .radius = po_json_read_number(object, "radius"),
                                .residual = po_json_read_number(object, "residual"),
                                .rounding = po_json_read_number(object, "rounding")};
}

static void read_reverse_trace(const json_t *object, po_reverse_trace *w) {
  w->excess = NAN;
  w->made = json_is_object(object);
  if (!w->made)
    return;
  const char *reason = json_string_value(json_object_get(object, "reason"));
  if (!po_status_find(json_string_value(json_object_get(object, "status")), &w->status))
    w->made = false;
  po_quote_text(reason ? reason : "", w->reason, sizeof w->reason);
  w->points = (size_t)po_json_count_of(object, "points");
  w->folds = (size_t)po_json_count_of(object, "folds");
  w->extrema = (size_t)po_json_count_of(object, "extrema");
  w->same = json_is_true(json_object_get(object, "same"));
  w->fold_approach = po_json_read_number(object, "fold_approach_change");
  w->fold_load = po_json_read_number(object, "fold_load_change");
  w->extremum_approach = po_json_read_number(object, "extremum_approach_change");
  w->extremum_load = po_json_read_number(object, "extremum_load_change");
  w->excess = po_json_read_number(object, "excess");
}

po_status po_json_read_diagnostics(const json_t *object, po_result *result) {
  po_diagnostics *d = &result->diagnostics;
  const json_t *states = json_object_get(object, "states");
  const json_t *moved = json_object_get(object, "moved");
  const size_t count = json_array_size(states);
  d->residual = po_json_read_number(object, "residual");
  d->rounding = po_json_read_number(object, "rounding");
  d->undiagnosed = (size_t)po_json_count_of(object, "undiagnosed");
  d->energy_defect = po_json_read_number(object, "energy_defect");
  d->energy_defect_at = po_json_read_number(object, "energy_defect_at");
  d->seconds = po_json_read_number(object, "seconds");
  d->moved = (po_moved){.solves = (size_t)po_json_count_of(moved, "solves"),
                        .failed = (size_t)po_json_count_of(moved, "failed"),
                        .change = po_json_read_number(moved, "force_change"),
                        .excess = po_json_read_number(moved, "force_excess"),
                        .predicted = po_json_read_number(moved, "force_change_predicted"),
                        .folds = po_json_read_number(moved, "fold_change")};
  read_reverse_trace(json_object_get(object, "reverse_trace"), &d->reverse_trace);
  read_sensitivity(json_object_get(object, "sensitivity"), d);
  if (!object)
    return PO_OK;
  d->states = po_allocate(count, sizeof *d->states);
  if (!d->states)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < count; ++k)
    read_state(json_array_get(states, k), &d->states[k]);
  d->state_count = count;
  return PO_OK;
}
