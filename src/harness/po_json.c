#include "po_json.h"

#include <math.h>
#include <stdlib.h>

#include "po_contact.h"
#include "po_input.h"
#include "po_json_parts.h"
#include "po_law.h"
#include "po_memory.h"

json_t *po_json_number(double value) {
  return isfinite(value) ? json_real(value) : json_null();
}

json_t *po_json_input(const po_request *request) {
  json_t *object = json_object();
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    const double value = po_key_number(request, (po_key)key);
    char text[PO_NUMBER_LENGTH];
    po_key_print(request, (po_key)key, text);
    json_t *item = NULL;
    if (!po_key_is_number((po_key)key) || isinf(value))
      item = json_string(text);
    else if (key == PO_KEY_NODES)
      item = json_integer((json_int_t)request->mesh.nodes);
    else
      item = po_json_number(value);
    json_object_set_new(object, po_key_name((po_key)key), item);
  }
  return object;
}

static json_t *landmarks(const po_landmark *list, size_t count) {
  json_t *array = json_array();
  for (size_t i = 0; i < count; ++i)
    json_array_append_new(array, po_json_landmark(&list[i]));
  return array;
}

/* Of a pull-off that was followed nothing else is known, which is not the same as none; folds that
 * were followed are. */
static json_t *landmarks_of(const po_outcome *outcome, const po_landmark *list, size_t count) {
  return outcome->followed && count == 0 ? json_null() : landmarks(list, count);
}

json_t *po_json_outcome(const po_request *request, const po_outcome *outcome) {
  json_t *object =
      json_pack("{s:o, s:s, s:s, s:b, s:b, s:o, s:o, s:o, s:o, s:o, s:o}", "input",
                po_json_input(request), "status", po_status_name(outcome->status), "reason",
                outcome->reason, "rigid", (int)outcome->rigid, "followed", (int)outcome->followed,
                "start", po_json_number(outcome->start), "end", po_json_number(outcome->end),
                "pull_off", po_json_pull_off(outcome), "folds",
                landmarks_of(outcome, outcome->folds, outcome->fold_count), "extrema",
                landmarks_of(outcome, outcome->extrema, outcome->extremum_count), "work",
                po_json_work(&outcome->work));
  if (object && outcome->has_hysteresis)
    json_object_set_new(object, "hysteresis", po_json_hysteresis(request, outcome));
  if (object && (outcome->diagnostics.states || outcome->diagnostics.moved.solves))
    json_object_set_new(object, "diagnostics", po_json_diagnostics(outcome));
  return object;
}

json_t *po_json_curve(const po_outcome *outcome) {
  json_t *array = json_array();
  for (size_t i = 0; i < outcome->curve_count; ++i) {
    const po_curve_point *p = &outcome->curve[i];
    json_array_append_new(
        array, json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i}", "position",
                         po_json_number(p->position), "approach", po_json_number(p->approach),
                         "load", po_json_number(p->load), "energy", po_json_number(p->energy),
                         "contact_radius", po_json_number(p->contact_radius), "approach_rate",
                         po_json_number(p->approach_rate), "load_rate",
                         po_json_number(p->load_rate), "unstable_modes", p->unstable_modes));
  }
  return array;
}

json_t *po_json_profile(const po_outcome *outcome) {
  json_t *array = json_array();
  for (size_t i = 0; i < outcome->profile_count; ++i) {
    const po_profile_point *p = &outcome->profile[i];
    json_array_append_new(array, json_pack("{s:o, s:o, s:o}", "radius", po_json_number(p->radius),
                                           "gap", po_json_number(p->gap), "traction",
                                           po_json_number(p->traction)));
  }
  return array;
}

static json_t *rings_of(const po_contact_ring *ring, size_t count) {
  json_t *array = json_array();
  for (size_t k = 0; k < count; ++k)
    json_array_append_new(array,
                          json_pack("{s:f, s:f}", "inner", ring[k].inner, "outer", ring[k].outer));
  return array;
}

json_t *po_json_contact(const po_outcome *outcome) {
  const size_t n = outcome->profile_count;
  double *node = po_allocate(n, sizeof *node), *gap = po_allocate(n, sizeof *gap);
  po_contact_ring *ring = po_allocate(n / 2 + 1, sizeof *ring);
  json_t *object = NULL;
  if (node && gap && ring) {
    for (size_t j = 0; j < n; ++j) {
      node[j] = outcome->profile[j].radius;
      gap[j] = outcome->profile[j].gap;
    }
    json_t *pressed = rings_of(ring, po_contact_rings(n, node, gap, 0.0, ring));
    const size_t held = po_contact_rings(n, node, gap, PO_LAW_PEAK_GAP, ring);
    object = json_pack("{s:o, s:o, s:o, s:I}", "approach",
                       po_json_number(outcome->profile_approach), "compressed", pressed, "held",
                       rings_of(ring, held), "grooves", (json_int_t)(held ? held - 1 : 0));
  }
  free(node);
  free(gap);
  free(ring);
  return object;
}

po_status po_json_print(const json_t *document, po_text *text) {
  char *dump = document ? json_dumps(document, JSON_INDENT(2) | JSON_REAL_PRECISION(17)) : NULL;
  if (!dump)
    return po_fail(PO_NO_MEMORY, "no memory for a JSON document");
  po_text_add(text, "%s\n", dump);
  free(dump);
  return text->failed ? PO_NO_MEMORY : PO_OK;
}
