#include "po_json_form.h"

#include "po_csv.h"
#include "po_json_digest.h"
#include "po_si.h"
#include "po_tables.h"

static json_t *text_or_null(const char *text) {
  return text ? po_json_text(text) : json_null();
}

static json_t *curve_of(const po_form_point *points, size_t count) {
  json_t *curve = po_json_empty_array();
  for (size_t i = 0; i < count; ++i)
    po_json_append(
        &curve, PO_JSON_OBJECT({"approach", po_json_number(points[i].approach)},
                               {"load", po_json_number(points[i].load)},
                               {"contact_radius", po_json_number(points[i].contact_radius)},
                               {"stable_at_approach", json_boolean(points[i].stable_at_approach)},
                               {"stable_at_load", json_boolean(points[i].stable_at_load)}));
  return curve;
}

json_t *po_json_form(const po_form *form, const po_form_input *input, const po_form_values *values,
                     const po_form_point *points, size_t count) {
  json_t *document = PO_JSON_OBJECT(
      {"schema", po_json_text("pulloff/1")}, {"theory", po_json_text(form->name)},
      {"assumes", PO_JSON_OBJECT({"source", po_json_text(form->source)},
                                 {"preload", text_or_null(po_form_preload(form, input))},
                                 {"branch", text_or_null(po_form_branch(input))})});
  for (size_t i = 0; i < values->count; ++i)
    po_json_set(&document, values->items[i].name, po_json_number(values->items[i].value));
  if (count)
    po_json_set(&document, "curve", curve_of(points, count));
  po_json_seal(&document);
  return document;
}

po_status po_tables_write_form(const char *path, const po_form *form, const po_form_input *input,
                               const po_units *units, const char *load_unit, const char *command,
                               const po_form_point *points, size_t count) {
  const po_si_unit none = {.factor = 1};
  const po_si_unit length = units ? po_si_prefixed(units, PO_DIMENSION_LENGTH) : none,
                   load = units ? po_si_prefixed(units, PO_DIMENSION_LOAD) : none;
  const char *before = units ? "_" : "", *of_length = units ? length.name : "",
             *of_load = units ? load.name : "";
  const char *preload = po_form_preload(form, input);
  po_text rows = {0}, what = {0}, in = {0}, header = {0};
  po_text_add(&what, "closed form %s: %s; preload: %s", form->name, form->source,
              preload ? preload : "none");
  po_text_add(&in, "%s%s%s",
              units ? "SI, at the end of the name of each column"
                    : "approach and contact_radius in epsilon; load in ",
              units ? "" : load_unit,
              "; load compressive > 0; 1: the states from here to the next row are stable");
  po_text_add(&rows, "approach%s%s,load%s%s,contact_radius%s%s,stable_at_approach,stable_at_load\n",
              before, of_length, before, of_load, before, of_length);
  for (size_t i = 0; i < count; ++i) {
    const double row[] = {po_si_value(&length, points[i].approach),
                          po_si_value(&load, points[i].load),
                          po_si_value(&length, points[i].contact_radius),
                          points[i].stable_at_approach, points[i].stable_at_load};
    po_csv_add_row(&rows, row, sizeof row / sizeof *row);
  }
  po_text_add(&header, "# what: %s\n# units: %s\n# command: %s\n", po_text_string(&what),
              po_text_string(&in), command);
  const po_status status = po_tables_write_rows(path, &header, &rows);
  po_text_clear(&rows);
  po_text_clear(&what);
  po_text_clear(&in);
  po_text_clear(&header);
  return status;
}
