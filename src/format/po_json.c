#include "po_json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_json_digest.h"
#include "po_json_parts.h"
#include "po_profile_table.h"

json_t *po_json_input(const po_request *request) {
  json_t *object = po_json_empty_object();
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    const double value = po_key_number(request, (po_key)key);
    char text[PO_KEY_TEXT_LENGTH];
    po_key_print(request, (po_key)key, text);
    json_t *item = NULL;
    if (!po_key_is_number((po_key)key) || isinf(value))
      item = strcmp(text, "-") == 0 ? json_null() : po_json_text(text);
    else if (key == PO_KEY_NODES)
      item = po_json_count(request->mesh.nodes);
    else
      item = po_json_number(value);
    po_json_set(&object, po_key_name((po_key)key), item);
  }
  po_json_set(&object, "load_unit", po_json_text(po_input_load_unit(request)));
  return object;
}

/* The table of the profile of a scene, which must have one. */
static json_t *table_of(const po_profile *profile) {
  const po_profile_table *table = profile->table;
  return PO_JSON_OBJECT(
      {"rows", po_json_count(table->rows)}, {"end_radius", po_json_number(po_profile_end(profile))},
      {"exponent", po_json_number(table->growth)},
      {"uncertainty", po_json_number(table->uncertainty)}, {"sha256", po_json_text(table->digest)});
}

static json_t *special_points(const po_special_point *list, size_t count) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < count; ++i)
    po_json_append(&array, po_json_special_point(&list[i]));
  return array;
}

/* The reason and the place at which the trace ended; null for a followed pull-off, for which no
 * trace exists. */
static json_t *ended_of(const po_result *o) {
  if (o->followed)
    return json_null();
  const char *why =
      o->ended.cause == PO_END_NONE ? po_status_name(o->status) : po_end_cause_name(o->ended.cause);
  return PO_JSON_OBJECT({"why", po_json_text(why)}, {"approach", po_json_number(o->ended.approach)},
                        {"load", po_json_number(o->ended.load)});
}

/* For a followed pull-off the special points are unknown (null), which differs from an empty list.
 * Followed folds are listed. */
static json_t *special_points_of(const po_result *result, const po_special_point *list,
                                 size_t count) {
  return result->followed && count == 0 ? json_null() : special_points(list, count);
}

json_t *po_json_result(const po_request *request, const po_result *result) {
  json_t *object = PO_JSON_OBJECT(
      {"input", po_json_input(request)}, {"status", po_json_text(po_status_name(result->status))},
      {"reason", po_json_text(result->reason)}, {"rigid", po_json_flag(result->rigid)},
      {"followed", po_json_flag(result->followed)}, {"start", po_json_number(result->start)},
      {"end", po_json_number(result->ended.approach)}, {"ended", ended_of(result)},
      {"pull_off", po_json_pull_off(result)}, {"pull_off_any", po_json_pull_off_any(result)},
      {"folds", special_points_of(result, result->folds, result->fold_count)},
      {"extrema", special_points_of(result, result->extrema, result->extremum_count)},
      {"work", po_json_work(&result->work)});
  if (po_profile_is_table(&request->scene.profile))
    po_json_set(&object, "profile_table", table_of(&request->scene.profile));
  if (result->has_hysteresis)
    po_json_set(&object, "hysteresis", po_json_hysteresis(result));
  if (result->has_staircases)
    po_json_set(&object, "staircase", po_json_staircases(result));
  if (result->diagnostics.states || result->diagnostics.moved.solves)
    po_json_set(&object, "diagnostics", po_json_diagnostics(result));
  return object;
}

json_t *po_json_document(const po_request *request, const po_result *result) {
  json_t *document = PO_JSON_OBJECT({"schema", po_json_text("pulloff/1")});
  po_json_set_all(&document, po_json_result(request, result));
  if (request->want & PO_WANT_CURVE)
    po_json_set(&document, "curve", po_json_curve(result));
  if (request->want & PO_WANT_PROFILE) {
    po_json_set(&document, "profile_approach", po_json_number(result->profile_approach));
    po_json_set(&document, "profile", po_json_profile(result));
    po_json_set(&document, "contact", po_json_contact(result));
  }
  po_json_seal(&document);
  return document;
}

json_t *po_json_curve(const po_result *result) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < result->curve_count; ++i) {
    const po_curve_point *p = &result->curve[i];
    po_json_append(&array,
                   PO_JSON_OBJECT({"position", po_json_number(p->position)},
                                  {"approach", po_json_number(p->approach)},
                                  {"load", po_json_number(p->load)},
                                  {"energy", po_json_number(p->energy)},
                                  {"energy_error_estimate", po_json_number(p->energy_error)},
                                  {"contact_radius", po_json_number(p->contact_radius)},
                                  {"approach_rate", po_json_number(p->approach_rate)},
                                  {"load_rate", po_json_number(p->load_rate)},
                                  {"unstable_modes", po_json_integer(p->unstable_modes)}));
  }
  return array;
}

json_t *po_json_profile(const po_result *result) {
  json_t *array = po_json_empty_array();
  for (size_t i = 0; i < result->profile_count; ++i) {
    const po_profile_point *p = &result->profile[i];
    po_json_append(&array, PO_JSON_OBJECT({"radius", po_json_number(p->radius)},
                                          {"gap", po_json_number(p->gap)},
                                          {"traction", po_json_number(p->traction)}));
  }
  return array;
}

static json_t *annuli_of(const po_contact_annulus *list, size_t count) {
  json_t *array = po_json_empty_array();
  for (size_t k = 0; k < count; ++k)
    po_json_append(&array, PO_JSON_OBJECT({"inner", po_json_number(list[k].inner)},
                                          {"outer", po_json_number(list[k].outer)}));
  return array;
}

json_t *po_json_contact(const po_result *result) {
  const po_contact_annuli *a = &result->annuli;
  return PO_JSON_OBJECT({"approach", po_json_number(result->profile_approach)},
                        {"compressed", annuli_of(a->compressed, a->compressed_count)},
                        {"held", annuli_of(a->held, a->held_count)},
                        {"grooves", po_json_count(a->held_count > 0 ? a->held_count - 1 : 0)});
}
