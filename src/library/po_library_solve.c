/* What the library computes: single scenes, series of scenes, closed forms. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_forms.h"
#include "po_json_form.h"
#include "po_library.h"
#include "po_memory.h"
#include "po_quote.h"
#include "po_series.h"
#include "po_solve.h"
#include "po_uncertain.h"

/* Whether a solve gave a result, complete or not. */
static bool has_result(po_status status) {
  return status >= 0;
}

/* As po_library_request. An amplitude without a wavelength, and the reverse, are refused, which a
 * scene may have until the other one is set. */
static po_status request_of(const pulloff_scene *scene, int key, const char *value,
                            po_request *request) {
  po_texts given = po_library_given(scene, key, value);
  const po_status status = po_library_request(scene, key, value, request);
  return status ? status : po_texts_check_waves(&given);
}

static po_status solve_request(const po_request *request, pulloff_result **result) {
  po_result solved = {0};
  const po_status status = po_solve(request, &solved);
  if (status && !solved.reason[0])
    snprintf(solved.reason, sizeof solved.reason, "%.250s", po_message());
  if (!has_result(status)) {
    po_result_clear(&solved);
    return status;
  }
  *result = po_library_result(request, &solved);
  if (!*result)
    return PO_NO_MEMORY;
  return status ? po_fail(status, "the solve failed: %s", (*result)->result.reason) : PO_OK;
}

static po_status solve(const pulloff_scene *scene, pulloff_result **result) {
  po_request request;
  po_uncertain_inputs uncertain;
  po_texts given = po_library_given(scene, -1, NULL);
  po_status status = po_uncertain_read(&given, &uncertain);
  if (!status)
    status = po_library_make(&given, scene, &request);
  if (!status)
    status = po_texts_check_waves(&given);
  if (!status)
    status = po_uncertain_vary(&uncertain, &given, po_library_make, scene, &request);
  if (!status)
    status = solve_request(&request, result);
  if (*result) /* what the uncertainties were made of ends here */
    (*result)->request.variation = NULL, (*result)->request.variations = 0;
  po_uncertain_clear(&uncertain);
  return status;
}

pulloff_status pulloff_solve(const pulloff_scene *scene, pulloff_result **result,
                             pulloff_message *message) {
  *result = NULL;
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : solve(scene, result), message);
}

static po_status make_requests(const pulloff_scene *scene, const char *name, const double *values,
                               size_t count, po_request *requests) {
  char shown[PO_QUOTE_LENGTH];
  const int key = po_texts_key(name);
  if (key < 0 || !po_key_is_number(key)) {
    po_fail(PO_BAD_INPUT, "the key of a series is %s: expected a number of the scene",
            po_quote(name, shown));
    return po_library_suggest(name);
  }
  po_status status = PO_OK;
  for (size_t k = 0; k < count && !status; ++k) {
    char text[PO_NUMBER_LENGTH];
    po_number_print(values[k], text);
    status = request_of(scene, key, text, &requests[k]);
    requests[k].search = PO_SEARCH_NONE;
    if (!status && !isnan(requests[k].stiffness))
      status =
          po_fail(PO_BAD_INPUT, "stiffness is %g: expected none, as it has no effect on a series",
                  requests[k].stiffness);
  }
  return status;
}

static void show_seen(void *user, size_t seen) {
  const pulloff_scene *const *scene = user;
  if ((*scene)->seen)
    *(*scene)->seen = (sig_atomic_t)seen;
}

static po_status follow(const pulloff_scene *scene, const char *key, const double *values,
                        size_t count, pulloff_result **results) {
  if (!count)
    return po_fail(PO_BAD_INPUT, "a series has 0 values: expected at least 1");
  po_request *requests = po_allocate(count, sizeof *requests);
  po_result *solved = po_allocate(count, sizeof *solved);
  po_series_progress progress = {show_seen, &scene, 0};
  po_status status =
      requests && solved ? make_requests(scene, key, values, count, requests) : PO_NO_MEMORY;
  void *marks = status ? NULL : po_series_watch(requests, count, &progress);
  if (!status && !marks)
    status = PO_NO_MEMORY;
  if (!status)
    status = po_series_pull_offs(requests, count, PO_CHECKPOINT_EVERY, solved);
  status = po_no_memory_or(status);
  for (size_t k = 0; k < count && !status; ++k) {
    results[k] = po_library_result(&requests[k], &solved[k]);
    status = results[k] ? PO_OK : PO_NO_MEMORY;
  }
  for (size_t k = 0; k < count && status; ++k) {
    pulloff_result_destroy(results[k]);
    results[k] = NULL;
    if (solved)
      po_result_clear(&solved[k]);
  }
  free(marks);
  free(requests);
  free(solved);
  return status;
}

pulloff_status pulloff_follow(const pulloff_scene *scene, const char *key, const double *values,
                              size_t count, pulloff_result **results, pulloff_message *message) {
  for (size_t k = 0; k < count; ++k)
    results[k] = NULL;
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : follow(scene, key, values, count, results),
                          message);
}

/* Refuses an input outside the domain of a form. */
static po_status check_form(const po_form *form, const po_texts *given,
                            const po_form_input *input) {
  const bool waves = po_texts_has(given, PO_KEY_AMPLITUDE) || po_scene_is_wavy(&input->scene);
  const bool general = input->general || !po_scene_is_of_paper(&input->scene);
  if ((form->needs & (PO_NEEDS_WAVES | PO_NEEDS_AMPLITUDE)) && !waves && !general)
    return po_fail(PO_BAD_INPUT, "theory %s needs the key amplitude", form->name);
  if ((form->needs & PO_NEEDS_ALPHA) && isnan(input->alpha) && !general)
    return po_fail(PO_BAD_INPUT, "theory %s needs alpha, or the keys amplitude and wavelength",
                   form->name);
  if (!general && !isnan(input->alpha) && !(input->alpha >= 0 && isfinite(input->alpha)))
    return po_fail(PO_BAD_INPUT, "alpha is %g: expected a finite number > 0", input->alpha);
  if ((form->needs & PO_NEEDS_ELASTIC) && !(input->scene.tabor > 0))
    return po_fail(PO_BAD_INPUT, "tabor is 0: expected a finite number > 0");
  const po_status status = po_texts_check_rate(given, form, input);
  if (status || isnan(input->at))
    return status;
  const double at = input->at;
  const struct {
    bool is_inside;
    const char *expected;
  } domain[] = {[PO_FORM_AT_NOTHING] = {false, "none"},
                [PO_FORM_AT_APPROACH] = {at < 1, "a finite number < 1"},
                [PO_FORM_AT_CONTACT_RADIUS] = {at >= 0, "a finite number >= 0"},
                [PO_FORM_AT_GAP] = {at > -1, "a finite number > -1"}};
  const char *variable = PO_FORM_VARIABLES[form->variable];
  return domain[form->variable].is_inside && isfinite(at)
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "%s of theory %s is %g: expected %s",
                       *variable ? variable : "the variable", form->name, at,
                       domain[form->variable].expected);
}

/* Sets the state of an input from the number of a variable. */
static void set_state(po_form_input *input, const po_form *form, po_key key, double value) {
  const po_form_variable own[] = {PO_FORM_AT_APPROACH, PO_FORM_AT_CONTACT_RADIUS};
  const bool is_load = key == PO_KEY_LOAD;
  if (!is_load && form->variable == own[key == PO_KEY_CONTACT_RADIUS])
    input->at = value;
  else
    input->held = is_load ? PO_FORM_HOLDS_LOAD : PO_FORM_HOLDS_APPROACH;
  input->value = value;
}

/* Evaluates the form. Given: `key`, a variable, in its unit or in SI units, and its value; -1: the
 * value is that of the variable of the form. */
static po_status evaluate(const char *name, const pulloff_scene *scene, double alpha, int key,
                          double at, pulloff_result **result) {
  const po_form *form = po_form_find(name);
  if (!form)
    return po_form_refuse(name);
  char value[PO_NUMBER_LENGTH] = "";
  po_number_print(at, value);
  const char *text = key < 0 ? NULL : value;
  const po_texts given = po_library_given(scene, key, text);
  po_request request;
  po_status status = po_library_request(scene, key, text, &request);
  if (status)
    return status;
  const bool takes_state = form->takes & PO_TAKES_STATE;
  const unsigned curve = form->takes & PO_TAKES_CURVE ? PO_WANT_CURVE : 0;
  po_form_input input = {request.scene, alpha, key < 0 ? at : (double)NAN};
  input.has_preload = isfinite(request.preload.approach) || !isnan(request.preload.load);
  input.preload = request.preload;
  input.creep = request.creep;
  input.unload_speed = request.unload_speed;
  po_use others[] = {{"alpha", !isnan(alpha), form->takes & PO_TAKES_ALPHA},
                     {"", po_texts_has(&given, PO_KEY_PROFILE_APPROACH), false},
                     {"", po_texts_has(&given, PO_KEY_PROFILE_LOAD), false},
                     {"want", (request.want & ~curve) != 0, false},
                     {"", po_texts_has(&given, PO_KEY_LOAD), takes_state},
                     {"", po_texts_has(&given, PO_KEY_APPROACH),
                      takes_state || form->variable == PO_FORM_AT_APPROACH},
                     {"", po_texts_has(&given, PO_KEY_CONTACT_RADIUS),
                      form->variable == PO_FORM_AT_CONTACT_RADIUS}};
  po_texts_name(&given, PO_KEY_PROFILE_APPROACH, others[1].name);
  po_texts_name(&given, PO_KEY_PROFILE_LOAD, others[2].name);
  for (int k = 0; k < 3; ++k)
    po_texts_name(&given, PO_KEY_LOAD + k, others[4 + k].name);
  if (key >= 0)
    set_state(&input, form, po_key_target(key),
              po_texts_number(&given, po_key_target(key), &request.units));
  input.general = po_texts_is_general(&given, form, &request.scene);
  if (isnan(alpha) && (po_texts_has(&given, PO_KEY_AMPLITUDE) || po_scene_is_wavy(&request.scene)))
    input.alpha = po_scene_alpha(&request.scene);
  status = po_texts_check_form(&given, form, !isnan(alpha), others, sizeof others / sizeof *others);
  if (!status)
    status = check_form(form, &given, &input);
  po_form_values values = {.count = 0};
  po_form_point *points = NULL;
  size_t count = 0;
  if (!status)
    status = po_form_evaluate(form, &input, &values);
  if (!status && request.want & PO_WANT_CURVE)
    status = po_form_curve(form, &input, &points, &count);
  if (status)
    return status;
  po_result none = po_result_none();
  *result = po_library_result(&request, &none);
  if (*result) {
    json_decref((*result)->document);
    (*result)->document = po_json_form(form, &input, &values, points, count);
  }
  free(points);
  if (!*result)
    return PO_NO_MEMORY;
  if ((*result)->document)
    return PO_OK;
  pulloff_result_destroy(*result);
  *result = NULL;
  return po_fail(PO_NO_MEMORY, "out of memory for the numbers of a closed form");
}

pulloff_status pulloff_theory(const char *form, const pulloff_scene *scene, double alpha, double at,
                              pulloff_result **result, pulloff_message *message) {
  *result = NULL;
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : evaluate(form, scene, alpha, -1, at, result),
                          message);
}

static po_status evaluate_at(const char *form, const pulloff_scene *scene, double alpha,
                             const char *variable, double at, pulloff_result **result) {
  const int key = po_texts_key(variable);
  char shown[PO_QUOTE_LENGTH];
  if (key < PO_KEY_VARIABLES)
    return po_fail(PO_BAD_INPUT,
                   "the variable of a closed form is %s: expected load, approach or "
                   "contact_radius, or one of them in SI units: load_n, approach_m or "
                   "contact_radius_m",
                   po_quote(variable, shown));
  if (!isfinite(at))
    return po_fail(PO_BAD_INPUT, "%s is %g: expected a finite number", variable, at);
  return evaluate(form, scene, alpha, key, at, result);
}

pulloff_status pulloff_theory_at(const char *form, const pulloff_scene *scene, double alpha,
                                 const char *variable, double at, pulloff_result **result,
                                 pulloff_message *message) {
  *result = NULL;
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(
      &call, status ? status : evaluate_at(form, scene, alpha, variable, at, result), message);
}
