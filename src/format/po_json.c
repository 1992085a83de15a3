#include "po_json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_input.h"
#include "po_json_digest.h"
#include "po_json_rows.h"
#include "po_profile_table.h"
#include "po_result_rows.h"

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
  json_t *object = PO_JSON_OBJECT({"rows", po_json_count(po_profile_table_points(table))},
                                  {"end_radius", po_json_number(po_profile_end(profile))},
                                  {"exponent", po_json_number(table->growth)},
                                  {"uncertainty", po_json_number(table->uncertainty)},
                                  {"sha256", po_json_text(table->digest)});
  const po_smoothing *s = &table->smoothing;
  const double unit = 1.0 / table->scale;
  if (s->knots)
    po_json_set(&object, "smoothing",
                PO_JSON_OBJECT({"deviation", po_json_number(s->deviation * unit)},
                               {"residual", po_json_number(s->residual * unit)},
                               {"removed_rms", po_json_number(s->rms * unit)},
                               {"removed_greatest", po_json_number(s->greatest * unit)},
                               {"parameters", po_json_number(s->parameters)},
                               {"knots", po_json_count(s->knots)}));
  return object;
}

json_t *po_json_result(const po_request *request, const po_result *result) {
  json_t *object = PO_JSON_OBJECT({"input", po_json_input(request)});
  po_json_set_all(&object, po_json_of(&PO_RESULT_ROWS, result));
  if (po_profile_is_table(&request->scene.profile))
    po_json_set(&object, "profile_table", table_of(&request->scene.profile));
  po_json_set_all(&object, po_json_of(&PO_WANTED_ROWS, result));
  return object;
}

po_status po_json_read_result(const json_t *object, po_result *result) {
  *result = (po_result){0};
  po_status status = po_json_into(object, &PO_RESULT_ROWS, result);
  if (!status)
    status = po_json_into(object, &PO_WANTED_ROWS, result);
  if (!status)
    status = po_json_into(json_object_get(object, "contact"), &PO_CONTACT_ROWS, result);
  if (status)
    po_result_clear(result);
  return status;
}

json_t *po_json_document(const po_request *request, const po_result *result) {
  json_t *document = PO_JSON_OBJECT({"schema", po_json_text("pulloff/1")});
  po_json_set_all(&document, po_json_result(request, result));
  if (request->want & PO_WANT_CURVE)
    po_json_set(&document, "curve",
                po_json_list_of(&PO_CURVE_ROWS, result->curve, result->curve_count));
  if (request->want & PO_WANT_PROFILE) {
    po_json_set(&document, "profile_approach", po_json_number(result->profile_approach));
    po_json_set(&document, "profile",
                po_json_list_of(&PO_PROFILE_ROWS, result->profile, result->profile_count));
    po_json_set(&document, "contact", po_json_of(&PO_CONTACT_ROWS, result));
  }
  po_json_seal(&document);
  return document;
}

json_t *po_json_units(const po_units *units) {
  return PO_JSON_OBJECT({"length_m", po_json_number(units->length)},
                        {"force_n", po_json_number(units->force)},
                        {"traction_pa", po_json_number(units->traction)});
}

json_t *po_json_units_pull_off(const po_units *u, const po_result *result) {
  static const char *const KEYS[] = {"force",
                                     "approach",
                                     "contact_radius",
                                     "error_estimate",
                                     "approach_error_estimate",
                                     "contact_radius_error_estimate",
                                     "contact_radius_other",
                                     NULL};
  return result->has_pull_off ? po_json_si(&PO_PULL_OFF_ROWS, result, u, KEYS) : json_null();
}
