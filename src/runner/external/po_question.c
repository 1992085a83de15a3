#include "po_question.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_input.h"
#include "po_json.h"
#include "po_load_unit.h"

/* A number of the protocol: "inf" stands for an infinite one, null for NaN. */
static json_t *number_json(double value) {
  return isinf(value) ? po_json_text(value > 0 ? "inf" : "-inf") : po_json_number(value);
}

static bool is_asked(const po_request *request, int key) {
  return po_key_is_of_scene(key) && !po_key_is_idle(request, key);
}

/* Prints the value of a key. The solver runs in another folder: it gets the absolute path of a
 * table. */
static void print_value(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]) {
  po_key_print(request, key, text);
  const char *file = key == PO_KEY_PROFILE_FILE   ? text
                     : key == PO_KEY_VISCOELASTIC ? po_creep_file(&request->creep)
                                                  : NULL;
  char *real = file ? realpath(file, NULL) : NULL;
  if (real)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%s%s", key == PO_KEY_VISCOELASTIC ? "prony:" : "", real);
  free(real);
}

/* Returned: the keys that describe the scene, as po_json_input writes them. */
static json_t *scene_json(const po_request *request) {
  json_t *object = po_json_empty_object(), *input = po_json_input(request);
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (is_asked(request, key)) {
      const char *name = PO_KEYS[key].name;
      char path[PO_KEY_TEXT_LENGTH];
      print_value(request, key, path);
      po_json_set(&object, name,
                  key == PO_KEY_PROFILE_FILE || key == PO_KEY_VISCOELASTIC
                      ? po_json_text(path)
                      : json_incref(json_object_get(input, name)));
    }
  json_decref(input);
  return object;
}

static json_t *want_json(unsigned want) {
  json_t *array = po_json_empty_array();
  for (int quantity = 0; quantity < PO_QUANTITY_COUNT; ++quantity)
    if (want & (1U << quantity))
      po_json_append(&array, po_json_text(PO_QUANTITIES[quantity].name));
  return array;
}

/* Returned: the knob, as a number if its value is one. */
static json_t *knob_json(const po_solver *solver) {
  json_t *object = po_json_empty_object();
  double value = 0;
  size_t count = 0;
  if (solver->knob)
    po_json_set(&object, solver->file->knob->name,
                po_number_parse_count(solver->knob, &count) ? po_json_count(count)
                : po_number_parse(solver->knob, &value)     ? po_json_number(value)
                                                            : po_json_text(solver->knob));
  return object;
}

static json_t *question_json(const po_solver *solver, const po_question *q) {
  const po_preload preload = po_load_unit_preload(&q->request);
  return PO_JSON_OBJECT({"id", po_json_text(q->id)}, {"scene", scene_json(&q->request)},
                        {"load_unit", po_json_text(po_input_load_unit(&q->request))},
                        {"preload", PO_JSON_OBJECT({"approach", number_json(preload.approach)},
                                                   {"load", number_json(preload.load)})},
                        {"approach_start", po_json_number(q->request.approach_start)},
                        {"approach_end", po_json_number(q->request.approach_end)},
                        {"knob", knob_json(solver)}, {"want", want_json(q->want)},
                        {"limit_s", po_json_number(q->limit)});
}

static po_status print_json(const po_solver *solver, const po_question *questions, const bool *open,
                            size_t count, po_text *text) {
  json_t *points = po_json_empty_array();
  for (size_t i = 0; i < count; ++i)
    if (open[i])
      po_json_append(&points, question_json(solver, &questions[i]));
  json_t *document = PO_JSON_OBJECT({"schema", po_json_text(PO_SOLVER_PROTOCOL)},
                                    {"repeats", po_json_count(count ? questions[0].repeats : 1)},
                                    {"points", points});
  const po_status status = po_json_print(document, text);
  json_decref(document);
  return status;
}

static void add_number(po_text *text, double value) {
  char number[PO_NUMBER_LENGTH];
  po_number_print(value, number);
  po_text_add(text, ",%s", isnan(value) ? "-" : number);
}

po_status po_questions_print(const po_solver *solver, const po_question *questions,
                             const bool *open, size_t count, po_text *json, po_text *text) {
  bool used[PO_KEY_COUNT] = {false};
  for (size_t i = 0; i < count; ++i)
    for (int key = 0; open[i] && key < PO_KEY_COUNT; ++key)
      used[key] = used[key] || is_asked(&questions[i].request, key);
  po_text_add(
      text,
      "id,limit_s,repeats,load_unit,preload_approach,preload_load,approach_start,approach_end");
  if (solver->knob)
    po_text_add(text, ",%s", solver->file->knob->name);
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (used[key])
      po_text_add(text, ",%s", PO_KEYS[key].name);
  po_text_add(text, "\n");
  for (size_t i = 0; i < count; ++i) {
    const po_question *q = &questions[i];
    if (!open[i])
      continue;
    const po_preload preload = po_load_unit_preload(&q->request);
    po_text_add(text, "%s", q->id);
    add_number(text, q->limit);
    po_text_add(text, ",%u,%s", q->repeats, po_input_load_unit(&q->request));
    add_number(text, preload.approach);
    add_number(text, preload.load);
    add_number(text, q->request.approach_start);
    add_number(text, q->request.approach_end);
    if (solver->knob)
      po_text_add(text, ",%s", solver->knob);
    for (int key = 0; key < PO_KEY_COUNT; ++key) {
      char value[PO_KEY_TEXT_LENGTH] = "-";
      if (used[key] && is_asked(&q->request, key))
        print_value(&q->request, key, value);
      if (used[key])
        po_text_add(text, ",%s", value);
    }
    po_text_add(text, "\n");
  }
  return text->failed ? PO_NO_MEMORY : print_json(solver, questions, open, count, json);
}
