/* The values of a request as text, and the command that repeats its solve. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_load_unit.h"
#include "po_number.h"
#include "po_text.h"

static void print_waves(const po_scene *scene, char text[PO_KEY_TEXT_LENGTH]) {
  size_t length = 0;
  snprintf(text, PO_KEY_TEXT_LENGTH, "-");
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    const po_wave wave = po_scene_wave(scene, k);
    char amplitude[PO_NUMBER_LENGTH], wavelength[PO_NUMBER_LENGTH];
    po_number_print(wave.amplitude, amplitude);
    po_number_print(wave.length, wavelength);
    length += (size_t)snprintf(text + length, PO_KEY_TEXT_LENGTH - length, "%s%s@%s", k ? ";" : "",
                               amplitude, wavelength);
  }
}

void po_key_print(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]) {
  const po_scene *scene = &request->scene;
  const char *name = NULL;
  if (key == PO_KEY_LAW)
    name = po_law_name(&scene->law);
  else if (key == PO_KEY_PROFILE)
    name = po_profile_name(&scene->profile);
  else if (key == PO_KEY_PROFILE_FILE)
    name = po_profile_shown(&scene->profile);
  else if (key == PO_KEY_SCHEME)
    name = PO_SCHEMES[request->mesh.scheme];
  else if (key == PO_KEY_GRADING)
    name = PO_GRADINGS[request->mesh.grading];
  else if (key == PO_KEY_RANGE)
    name = PO_RANGES[request->range];
  if (name)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%s", name);
  else if (key == PO_KEY_WAVES)
    print_waves(scene, text);
  else if (key == PO_KEY_VISCOELASTIC && request->creep.kind != PO_CREEP_NONE)
    po_creep_write(&request->creep, text);
  else if (key == PO_KEY_NODES)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%zu", request->mesh.nodes);
  else if (isnan(po_key_number(request, key)))
    snprintf(text, PO_KEY_TEXT_LENGTH,
             key == PO_KEY_TIME_LIMIT || po_key_is_of_time(key) ? "none" : "auto");
  else if (key == PO_KEY_SMOOTH && isinf(po_key_number(request, key)))
    snprintf(text, PO_KEY_TEXT_LENGTH, "auto");
  else
    po_number_print(po_key_number(request, key), text);
}

bool po_key_is_idle(const po_request *request, po_key key) {
  const po_scene *scene = &request->scene;
  const bool sphere = po_profile_is_sphere(&scene->profile);
  switch (key) {
  case PO_KEY_AMPLITUDE:
  case PO_KEY_WAVELENGTH:
    return po_scene_waves(scene) != 1;
  case PO_KEY_WAVES:
    return po_scene_waves(scene) < 2;
  case PO_KEY_LAW:
    return po_law_index(&scene->law) == 0;
  case PO_KEY_PROFILE:
    return sphere || po_profile_is_table(&scene->profile);
  case PO_KEY_PROFILE_FILE:
    return !po_profile_is_table(&scene->profile);
  case PO_KEY_RANGE:
    return request->range == PO_RANGE_AUTO;
  case PO_KEY_TABLE_SCALE:
    return !po_profile_is_table(&scene->profile) || po_key_number(request, key) == 1.0;
  default:
    return isnan(po_key_number(request, key)) || po_key_is_of_other_scheme(request, key);
  }
}

/* Returned: whether the command must state the default preload. */
static bool adds_preload(const po_request *request) {
  return !po_scene_is_simple(&request->scene) && !(request->want & ~(unsigned)PO_WANT_THEORIES) &&
         isnan(request->preload.approach) && isnan(request->preload.load) &&
         isnan(request->approach_end);
}

void po_input_add_waves(po_text *command, const char *waves) {
  for (const char *wave = waves; *wave;) {
    const int amplitude = (int)strcspn(wave, "@");
    const int length = (int)strcspn(wave + amplitude + 1, ";");
    po_text_add(command, " --wave %.*s,%.*s", amplitude, wave, length, wave + amplitude + 1);
    wave += amplitude + 1 + length;
    wave += *wave == ';';
  }
}

/* Prints the coupling to the 15 digits with which it is given. Returned: whether the scene is
 * stated by its coupling, and this text gives exactly its Tabor parameter. */
static bool print_coupling(const po_request *request, char text[PO_KEY_TEXT_LENGTH]) {
  double coupling = 0;
  snprintf(text, PO_KEY_TEXT_LENGTH, "%.15g", po_key_number(request, PO_KEY_COUPLING));
  return po_input_has_coupling(request) && po_number_parse(text, &coupling) &&
         po_scene_tabor_of_coupling(coupling, request->scene.radius) == request->scene.tabor;
}

void po_key_flag(po_key key, char flag[PO_FLAG_LENGTH]) {
  snprintf(flag, PO_FLAG_LENGTH, "%s", key == PO_KEY_WAVES ? "wave" : PO_KEYS[key].name);
  for (char *c = flag; *c; ++c)
    if (*c == '_')
      *c = '-';
}

static void add_option(po_text *command, const po_request *request, po_key key, bool identity) {
  char value[PO_KEY_TEXT_LENGTH], flag[PO_FLAG_LENGTH];
  if (key == PO_KEY_TABOR && !identity && print_coupling(request, value))
    key = PO_KEY_COUPLING;
  else
    po_key_print(request, key, value);
  if (key == PO_KEY_WAVES) {
    po_input_add_waves(command, value);
    return;
  }
  po_key_flag(key, flag);
  po_text_add(command, " --%s ", flag);
  if (key == PO_KEY_PROFILE_FILE)
    po_text_add_word(command, identity ? po_profile_digest(&request->scene.profile) : value);
  else if (key == PO_KEY_VISCOELASTIC) {
    if (identity)
      po_creep_write_identity(&request->creep, value);
    po_text_add_word(command, value);
  } else
    po_text_add(command, "%s", value);
}

static void describe_request(const po_request *request, bool identity, po_text *command) {
  po_text_add(command, "pulloff solve");
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (!po_key_is_idle(request, key) &&
        (identity || key != PO_KEY_RADIUS || !po_input_has_coupling(request)))
      add_option(command, request, key, identity);
  if (!isnan(request->profile_approach))
    add_option(command, request, PO_KEY_PROFILE_APPROACH, identity);
  if (!isnan(request->profile_load))
    add_option(command, request, PO_KEY_PROFILE_LOAD, identity);
  /* without the preload, a single solve would search beyond the default one */
  if (adds_preload(request)) {
    char load[PO_NUMBER_LENGTH];
    po_number_print(po_load_unit_preload(request).load, load);
    po_text_add(command, " --preload-load %s", load);
  }
  const char *before = " --want ";
  for (int k = 0; k < PO_WANT_COUNT; ++k)
    if (request->want & (1u << k)) {
      po_text_add(command, "%s%s", before, PO_WANTS[k]);
      before = ",";
    }
}

void po_input_add_command(const po_request *request, po_text *text) {
  describe_request(request, false, text);
}

void po_input_add_identity(const po_request *request, po_text *text) {
  describe_request(request, true, text);
  for (size_t k = 0; k < request->variations; ++k) {
    const po_variation *v = &request->variation[k];
    char value[2][PO_NUMBER_LENGTH];
    po_number_print(v->value, value[0]);
    po_number_print(v->deviation, value[1]);
    po_text_add(text, " %s=%s+-%s", v->source, value[0], value[1]);
    for (int more = 0; more < 2; ++more) {
      po_number_print(v->unit[more], value[0]);
      po_text_add(text, " (%s: ", value[0]);
      describe_request(v->moved[more], true, text);
      po_text_add(text, ")");
    }
  }
}
