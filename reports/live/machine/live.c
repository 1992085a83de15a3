/* The door of the module: a request in, a document out, both JSON. */
#include <stdlib.h>
#include <string.h>

#include "po_json_value.h"
#include "po_library.h"
#include "po_observe.h"

/* Functions of the page. Progress: a point of the trace. Profile: gap and traction at the point of
 * the curve with this number, in rows of radius, gap and traction. */
__attribute__((import_module("page"), import_name("progress"))) void page_progress(double approach,
                                                                                   double load);
__attribute__((import_module("page"), import_name("profile"))) void
page_profile(int number, const po_profile_point *profile, int count);

static void tell_progress(void *page, double approach, double load) {
  (void)page;
  page_progress(approach, load);
}

static void tell_profile(void *page, size_t number, const po_profile_point *profile, size_t count) {
  (void)page;
  page_profile((int)number, profile, (int)count);
}

/* As pulloff_solve, with progress and profiles for the page. */
static pulloff_status solve(const pulloff_scene *scene, pulloff_result **result,
                            pulloff_message *message) {
  po_process_state state;
  po_status status = po_process_enter(&state);
  if (status)
    return po_library_end(status, message);
  po_request request;
  po_result solved = {0};
  status = po_library_request(scene, -1, NULL, &request);
  if (!status) {
    request.watch = tell_progress;
    request.show = tell_profile;
    status = po_observe(&request, &solved);
    if (status && !solved.reason[0])
      snprintf(solved.reason, sizeof solved.reason, "%.250s", po_message());
  }
  if (status >= 0) {
    *result = po_library_result(&request, &solved);
    status = *result ? PO_OK : PO_NO_MEMORY;
  } else {
    po_result_clear(&solved);
  }
  po_process_leave(&state);
  return po_library_end(status, message);
}

static double number_of(const json_t *object, const char *name, double absent) {
  const json_t *value = json_object_get(object, name);
  return json_is_number(value) ? json_number_value(value) : absent;
}

/* Sets the keys of a scene: a text each. */
static pulloff_status set_keys(pulloff_scene *scene, json_t *keys, pulloff_message *message) {
  const char *name;
  json_t *value;
  pulloff_status status = PULLOFF_OK;
  json_object_foreach(keys, name, value) {
    if (!status)
      status = pulloff_scene_set(scene, name, json_string_value(value), message);
  }
  return status;
}

/* Sets a scene in SI units. Returned: the units of its results, for the answer. */
static pulloff_status set_physical(pulloff_scene *scene, const json_t *si, json_t **answer,
                                   pulloff_message *message) {
  const pulloff_physical physical = {.modulus = number_of(si, "modulus", INFINITY),
                                     .work = number_of(si, "work", NAN),
                                     .distance = number_of(si, "distance", NAN),
                                     .radius = number_of(si, "radius", NAN),
                                     .amplitude = number_of(si, "amplitude", 0.0),
                                     .wavelength = number_of(si, "wavelength", NAN),
                                     .outer_radius = number_of(si, "outer_radius", INFINITY)};
  pulloff_units units;
  const pulloff_status status = pulloff_scene_set_physical(scene, &physical, &units, message);
  if (!status)
    po_json_set(answer, "units",
                PO_JSON_OBJECT({"length", po_json_number(units.length)},
                               {"force", po_json_number(units.force)},
                               {"work", po_json_number(units.work)},
                               {"traction", po_json_number(units.traction)}));
  return status;
}

/* Answers a request {"keys": {NAME: TEXT}, "physical": {NAME: NUMBER}, "theory": NAME, "alpha":
 * NUMBER, "at": NUMBER}, all optional: without `theory`, the scene is solved. */
static pulloff_status answer_to(json_t *request, pulloff_scene *scene, json_t **answer,
                                pulloff_message *message) {
  const char *theory = json_string_value(json_object_get(request, "theory"));
  const json_t *physical = json_object_get(request, "physical");
  pulloff_result *result = NULL;
  pulloff_status status = set_keys(scene, json_object_get(request, "keys"), message);
  if (!status && physical)
    status = set_physical(scene, physical, answer, message);
  if (!status && theory)
    status = pulloff_theory(theory, scene, number_of(request, "alpha", NAN),
                            number_of(request, "at", NAN), &result, message);
  else if (!status)
    status = solve(scene, &result, message);
  if (!status)
    po_json_set(answer, "document", json_incref(result->document));
  pulloff_result_destroy(result);
  return status;
}

/* Given: a request, as text. Returned: {"document": ...}, with "units" for a scene in SI units; or
 * {"error": MESSAGE}; to be freed. NULL if memory runs out. */
__attribute__((export_name("po_live"))) char *po_live(const char *text) {
  pulloff_message message = {""};
  pulloff_scene *scene = NULL;
  json_t *answer = po_json_empty_object(), *request = NULL;
  pulloff_status status = pulloff_scene_create(&scene, &message);
  if (!status)
    status = (pulloff_status)po_json_parse(text, strlen(text), &request);
  if (status)
    po_library_end((po_status)status, &message);
  else
    status = answer_to(request, scene, &answer, &message);
  if (status) {
    json_decref(answer);
    answer = PO_JSON_OBJECT({"error", po_json_text(message.text)});
  }
  po_text printed = {0};
  po_json_print_line(answer, &printed);
  json_decref(answer);
  json_decref(request);
  pulloff_scene_destroy(scene);
  return printed.data;
}
