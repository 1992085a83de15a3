#include "po_json_units.h"

#include "po_json.h"

json_t *po_json_units(const po_units *units) {
  return PO_JSON_OBJECT({"length_m", po_json_number(units->length)},
                        {"force_n", po_json_number(units->force)},
                        {"traction_pa", po_json_number(units->traction)});
}

json_t *po_json_units_pull_off(const po_units *u, const po_result *result) {
  if (!result->has_pull_off)
    return json_null();
  return PO_JSON_OBJECT(
      {"force_n", po_json_number(result->pull_off.force * u->force)},
      {"approach_m", po_json_number(result->pull_off.approach * u->length)},
      {"contact_radius_m", po_json_number(result->pull_off.contact_radius * u->length)},
      {"error_estimate_n", po_json_number(result->pull_off.force_error * u->force)},
      {"approach_error_estimate_m", po_json_number(result->pull_off.approach_error * u->length)},
      {"contact_radius_error_estimate_m",
       po_json_number(result->pull_off.contact_radius_error * u->length)},
      {"contact_radius_other_m",
       po_json_number(result->pull_off.contact_radius_other * u->length)});
}
