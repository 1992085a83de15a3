/* Scenes of the library: the texts of their keys, which become a request when they are solved, so
 * that groups such as amplitude_ratio do not depend on the order in which keys are set. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_library.h"
#include "po_memory.h"
#include "po_quote.h"
#include "po_suggest.h"
#include "po_text.h"
#include "po_uncertain.h"

/* The key that is not in the table of src/text/keys. */
enum { WANT = PO_KEY_VARIABLES, KEY_COUNT };

const char *pulloff_version(void) {
  return PULLOFF_VERSION;
}

const char *pulloff_status_text(pulloff_status status) {
  return po_status_text((po_status)status);
}

pulloff_status pulloff_scene_create(pulloff_scene **scene, pulloff_message *message) {
  po_message_clear();
  *scene = po_allocate(1, sizeof **scene);
  return po_library_end(*scene ? PO_OK : PO_NO_MEMORY, message);
}

void pulloff_scene_destroy(pulloff_scene *scene) {
  for (int key = 0; scene && key < PO_KEY_ALL; ++key)
    free(scene->text[key]);
  free(scene);
}

pulloff_status pulloff_scene_copy(const pulloff_scene *scene, pulloff_scene **copy,
                                  pulloff_message *message) {
  const pulloff_status status = pulloff_scene_create(copy, message);
  if (status)
    return status;
  **copy = *scene;
  (*copy)->stop = NULL;
  (*copy)->seen = NULL;
  bool whole = true;
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    (*copy)->text[key] = scene->text[key] ? po_copy_text(scene->text[key]) : NULL;
    whole = whole && !(*copy)->text[key] == !scene->text[key];
  }
  if (whole)
    return po_library_end(PO_OK, message);
  pulloff_scene_destroy(*copy);
  *copy = NULL;
  return po_library_end(PO_NO_MEMORY, message);
}

size_t pulloff_key_count(void) {
  return KEY_COUNT;
}

const char *pulloff_key_name(size_t number) {
  return number < WANT ? PO_KEYS[number].name : number == WANT ? "want" : NULL;
}

const char *pulloff_key_expected(size_t number) {
  return number < WANT ? PO_KEYS[number].expected : number == WANT ? PO_WANT_EXPECTED : NULL;
}

const char *pulloff_key_help(size_t number) {
  if (number >= WANT)
    return number == WANT ? "results beside the pull-off" : NULL;
  while (!*PO_KEYS[number].help) /* that of several keys is in the row of the last */
    ++number;
  return PO_KEYS[number].help;
}

po_status po_library_suggest(const char *key) {
  po_text known = {0};
  for (size_t k = 0; k < KEY_COUNT; ++k)
    po_text_add(&known, "%s ", pulloff_key_name(k));
  po_suggest(PO_BAD_INPUT, key, po_text_string(&known));
  po_text_clear(&known);
  return PO_BAD_INPUT;
}

/* The number of a key, or -1 with a message. */
static int find_key(const char *name) {
  char shown[PO_QUOTE_LENGTH];
  for (size_t k = 0; k < KEY_COUNT; ++k)
    if (strcmp(pulloff_key_name(k), name) == 0)
      return (int)k;
  po_fail(PO_BAD_INPUT, "unknown key %s of a scene: expected one that pulloff_key_name names",
          po_quote(name, shown));
  po_library_suggest(name);
  return -1;
}

/* Refuses a value. A file that cannot be used has its own message. */
static po_status refuse(int key, const char *value) {
  char shown[PO_QUOTE_LENGTH];
  if (*po_message())
    return key == PO_KEY_PROFILE_FILE || key == PO_KEY_VISCOELASTIC ? PO_CANNOT_READ : PO_BAD_INPUT;
  const char *expected = pulloff_key_expected((size_t)key);
  return po_suggest(po_fail(PO_BAD_INPUT, "%s is %s: expected %s", pulloff_key_name((size_t)key),
                            po_quote(value, shown), expected),
                    value, expected);
}

static po_status set(pulloff_scene *scene, int key, const char *value) {
  if (key < 0)
    return PO_BAD_INPUT;
  unsigned want = 0;
  if (key == WANT) {
    if (value && *value && !po_want_read(value, &want))
      return refuse(key, value);
    scene->want = want;
    return PO_OK;
  }
  po_request scratch = po_input_default();
  po_texts one = {.prefix = ""};
  po_uncertain_inputs uncertain;
  one.text[key] = value;
  po_status status = po_uncertain_read(&one, &uncertain);
  if (!status && value && !po_key_set(&scratch, key, one.text[key]))
    status = po_no_memory_or(refuse(key, value));
  po_uncertain_clear(&uncertain);
  if (status)
    return status;
  char *copy = value ? po_copy_text(value) : NULL;
  if (value && !copy)
    return PO_NO_MEMORY;
  free(scene->text[key]);
  scene->text[key] = copy;
  return PO_OK;
}

pulloff_status pulloff_scene_set(pulloff_scene *scene, const char *key, const char *value,
                                 pulloff_message *message) {
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : set(scene, find_key(key), value), message);
}

/* Prints a number so that it is read back to the same bits. */
static void print_number(double value, char text[PO_NUMBER_LENGTH]) {
  if (isinf(value))
    snprintf(text, PO_NUMBER_LENGTH, value > 0 ? "inf" : "-inf");
  else
    po_number_print(value, text);
}

static po_status set_number(pulloff_scene *scene, int key, double value) {
  char text[PO_NUMBER_LENGTH];
  print_number(value, text);
  return set(scene, key, text);
}

pulloff_status pulloff_scene_set_number(pulloff_scene *scene, const char *key, double value,
                                        pulloff_message *message) {
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : set_number(scene, find_key(key), value),
                          message);
}

po_texts po_library_given(const pulloff_scene *scene, int key, const char *value) {
  po_texts given = {.prefix = ""};
  for (int k = 0; k < PO_KEY_ALL; ++k) {
    given.text[k] = k == key ? value : scene->text[k];
    given.si = given.si || (given.text[k] && PO_KEYS[k].owner == PO_OWNER_SI);
  }
  return given;
}

po_status po_library_request(const pulloff_scene *scene, int key, const char *value,
                             po_request *request) {
  const po_texts given = po_library_given(scene, key, value);
  return po_library_make(&given, scene, request);
}

po_status po_library_make(const po_texts *texts, const void *scene, po_request *request) {
  po_texts given = *texts;
  *request = po_input_default();
  const po_status status = po_texts_read(&given, request);
  if (status)
    return status;
  request->want = ((const pulloff_scene *)scene)->want;
  request->stop = ((const pulloff_scene *)scene)->stop;
  return po_request_complete(request);
}

/* The request without the uncertainties of its numbers. */
static po_status certain_request(const pulloff_scene *scene, po_request *request) {
  po_texts given = po_library_given(scene, -1, NULL);
  po_uncertain_inputs uncertain;
  po_status status = po_uncertain_read(&given, &uncertain);
  if (!status)
    status = po_library_make(&given, scene, request);
  po_uncertain_clear(&uncertain);
  return status;
}

static po_status get(const pulloff_scene *scene, int key, char *text, size_t size) {
  po_request request;
  const po_status status = key < 0 ? PO_BAD_INPUT : certain_request(scene, &request);
  if (status)
    return status;
  char value[PO_KEY_TEXT_LENGTH] = "auto";
  if (key < WANT && scene->text[key] && strstr(scene->text[key], "+-"))
    snprintf(value, sizeof value, "%s", scene->text[key]);
  else if (key < PO_KEY_COUNT)
    po_key_print(&request, key, value);
  else if (key < PO_KEY_END)
    print_number(po_key_number(&request, key), value);
  else if (key < WANT && scene->text[key])
    snprintf(value, sizeof value, "%s", scene->text[key]);
  if (key != WANT) {
    snprintf(text, size, "%s", value);
    return PO_OK;
  }
  size_t length = 0;
  if (size)
    *text = '\0';
  for (int k = 0; k < PO_WANT_COUNT; ++k)
    if (request.want & (1u << k) && length < size)
      length +=
          (size_t)snprintf(text + length, size - length, "%s%s", length ? "," : "", PO_WANTS[k]);
  return PO_OK;
}

pulloff_status pulloff_scene_get(const pulloff_scene *scene, const char *key, char *text,
                                 size_t size, pulloff_message *message) {
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : get(scene, find_key(key), text, size), message);
}

pulloff_units po_library_units(const po_request *request) {
  const po_units *u = &request->units;
  return (pulloff_units){u->length, u->force, u->work, u->traction};
}

static po_status set_physical(pulloff_scene *scene, const pulloff_physical *given,
                              pulloff_units *units) {
  const struct {
    po_key key;
    double value, idle; /* the latter is the default */
  } values[] = {{PO_KEY_MODULUS_PA, given->modulus, NAN},
                {PO_KEY_WORK_J_PER_M2, given->work, NAN},
                {PO_KEY_DISTANCE_M, given->distance, NAN},
                {PO_KEY_RADIUS_M, given->radius, NAN},
                {PO_KEY_AMPLITUDE_M, given->amplitude, 0.0},
                {PO_KEY_WAVELENGTH_M, given->amplitude > 0.0 ? given->wavelength : 0.0, 0.0},
                {PO_KEY_OUTER_RADIUS_M, given->outer_radius, INFINITY}};
  po_request request;
  pulloff_scene *changed = NULL;
  po_status status = (po_status)pulloff_scene_copy(scene, &changed, NULL);
  for (size_t i = 0; i < sizeof values / sizeof *values && !status; ++i) {
    char text[PO_NUMBER_LENGTH];
    print_number(values[i].value, text);
    set(changed,
        po_key_target(values[i].key) == values[i].key ? PO_KEY_TABOR : po_key_target(values[i].key),
        NULL);
    status = set(changed, values[i].key, values[i].value == values[i].idle ? NULL : text);
  }
  if (!status)
    status = certain_request(changed, &request);
  if (!status) {
    const pulloff_scene before = *scene;
    *scene = *changed;
    scene->stop = before.stop;
    scene->seen = before.seen;
    *changed = before;
    if (units)
      *units = po_library_units(&request);
  }
  pulloff_scene_destroy(changed);
  return status;
}

pulloff_status pulloff_scene_set_physical(pulloff_scene *scene, const pulloff_physical *physical,
                                          pulloff_units *units, pulloff_message *message) {
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : set_physical(scene, physical, units), message);
}

static po_status get_units(const pulloff_scene *scene, pulloff_units *units) {
  po_request request;
  const po_status status = certain_request(scene, &request);
  if (status)
    return status;
  if (!request.in_si)
    return po_fail(PO_BAD_INPUT, "the scene is not in SI units: expected modulus_pa, "
                                 "work_j_per_m2, distance_m and radius_m");
  *units = po_library_units(&request);
  return PO_OK;
}

pulloff_status pulloff_scene_units(const pulloff_scene *scene, pulloff_units *units,
                                   pulloff_message *message) {
  po_library_call call;
  const po_status status = po_library_enter(&call);
  return po_library_leave(&call, status ? status : get_units(scene, units), message);
}

void pulloff_scene_set_stop(pulloff_scene *scene, const volatile sig_atomic_t *stop) {
  scene->stop = stop;
}

void pulloff_scene_set_seen(pulloff_scene *scene, volatile sig_atomic_t *seen) {
  scene->seen = seen;
}
