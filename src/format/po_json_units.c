#include "po_json_units.h"

#include "po_json.h"
#include "po_json_rows.h"
#include "po_result_rows.h"

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
