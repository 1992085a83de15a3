#include "po_texts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_profile_table.h"
#include "po_quote.h"
#include "po_si.h"
#include "po_suggest.h"
#include "po_texts_internal.h"

static bool are_options(const po_texts *given) {
  return *given->prefix == '-';
}

void po_texts_write_name(const po_texts *given, int key, char name[PO_KEY_NAME_LENGTH]) {
  char flag[PO_FLAG_LENGTH];
  po_key_flag(key, flag);
  snprintf(name, PO_KEY_NAME_LENGTH, "%s%s", given->prefix,
           are_options(given) ? flag : PO_KEYS[key].name);
}

void po_texts_name(const po_texts *given, po_key key, char name[PO_KEY_NAME_LENGTH]) {
  const int si = po_key_in_si(key);
  po_texts_write_name(given, given->si && si >= 0 ? si : key, name);
}

static const char UNCERTAIN[] =
    "; an uncertain number is written 0.05+-0.01, and only solve and cases take it; in "
    "place of follow, a case with a sweep does";

po_status po_texts_refuse(po_texts *given, int key, const char *format, ...) {
  char name[PO_KEY_NAME_LENGTH], shown[PO_QUOTE_LENGTH], expected[300];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(expected, sizeof expected, format, arguments);
  va_end(arguments);
  given->wrong = key;
  po_texts_write_name(given, key, name);
  if (!given->text[key])
    return po_fail(PO_BAD_INPUT, "%s is missing: expected %s", name, expected);
  const char *text = given->text[key];
  const bool uncertain = strstr(text, "+-") || strstr(text, "+/-") || strstr(text, "\u00B1");
  return po_suggest(po_fail(PO_BAD_INPUT, "%s is %s: expected %s%s", name, po_quote(text, shown),
                            expected, uncertain ? UNCERTAIN : ""),
                    text, expected);
}

po_status po_texts_set_key(po_texts *given, int key, po_request *request) {
  const char *text = given->text[key];
  if (!text)
    return PO_OK;
  if (key == PO_KEY_VISCOELASTIC) {
    const po_status read = po_creep_read(text, &request->creep);
    given->wrong = key;
    return read == PO_BAD_INPUT ? po_texts_refuse(given, key, "%s", PO_KEYS[key].expected) : read;
  }
  if (key != PO_KEY_PROFILE_FILE)
    return po_key_set(request, key, text)
               ? PO_OK
               : po_texts_refuse(given, key, "%s", PO_KEYS[key].expected);
  given->wrong = key; /* the message states what is wrong with the file */
  const po_status status = po_profile_use_file(&request->scene.profile, text);
  if (!status && !request->radius_given)
    request->scene.radius = po_profile_default_radius(&request->scene.profile);
  return status;
}

bool po_texts_has(const po_texts *given, po_key key) {
  const int si = po_key_in_si(key);
  return given->text[key] || (si >= 0 && given->text[si]);
}

double po_texts_without_unit(int key, double value, const po_units *units) {
  return value / po_si_unit_of(units, PO_KEYS[key].dimension).factor;
}

double po_texts_number(const po_texts *given, po_key key, const po_units *units) {
  const int si = po_key_in_si(key);
  double value = (double)NAN;
  if (given->text[key] && po_key_parse(key, given->text[key], &value))
    return value;
  return si >= 0 && given->text[si] && po_key_parse(si, given->text[si], &value)
             ? po_texts_without_unit(si, value, units)
             : (double)NAN;
}

/* Refuses two keys that set the same. */
static po_status check_pairs(po_texts *given) {
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key target = po_key_target(key);
    const bool further = are_options(given) && key == PO_KEY_WAVES;
    if (!given->text[key] || target == key || further || !po_texts_has(given, target) ||
        (PO_KEYS[key].owner == PO_OWNER_SI && !given->text[target]))
      continue;
    char name[PO_KEY_NAME_LENGTH], other[PO_KEY_NAME_LENGTH];
    po_texts_write_name(given, key, name);
    po_texts_write_name(given, given->text[target] ? target : po_key_in_si(target), other);
    return po_texts_refuse(given, key, "only one of %s and %s", other, name);
  }
  return PO_OK;
}

/* Refuses keys in the units of the other kind of scene. */
static po_status check_units(po_texts *given) {
  for (int key = 0; key < PO_KEY_ALL; ++key) {
    const po_key_row *row = &PO_KEYS[key];
    const int si = po_key_in_si(key);
    const bool of_scene = row->owner == PO_OWNER_SCENE && key != PO_KEY_AMPLITUDE_RATIO;
    if (!given->text[key])
      continue;
    if (row->owner == PO_OWNER_SI && !given->si)
      return po_texts_refuse(given, key, "it with --from-physical, as it is in SI units");
    if (!given->si || (si < 0 ? !of_scene : !of_scene && given->mixed))
      continue;
    if (si < 0)
      return po_texts_refuse(given, key,
                             "it to be left out, as it follows from the values in SI units");
    char name[PO_KEY_NAME_LENGTH];
    po_texts_write_name(given, si, name);
    return po_texts_refuse(given, key, "%s, as the scene is in SI units", name);
  }
  return PO_OK;
}

po_status po_texts_add_waves(po_texts *given, double distance, po_scene *scene) {
  po_scene waves = po_scene_default();
  if (!given->text[PO_KEY_WAVES])
    return PO_OK;
  if (!po_scene_set_waves(&waves, given->text[PO_KEY_WAVES]))
    return po_texts_refuse(given, PO_KEY_WAVES, "%s", PO_KEYS[PO_KEY_WAVES].expected);
  for (size_t k = 0; k < po_scene_waves(&waves); ++k) {
    const po_wave wave = po_scene_wave(&waves, k);
    if (!po_scene_add_wave(scene, (po_wave){wave.amplitude / distance, wave.length / distance}))
      return po_texts_refuse(given, PO_KEY_WAVES, "at most %d waves, with that of the amplitude",
                             PO_MOST_WAVES);
  }
  return PO_OK;
}

/* Refuses keys that the mesh, the law or the profile of a request does not have. */
static po_status check_idle(po_texts *given, const po_request *request) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!given->text[key])
      continue;
    if (po_key_is_of_other_scheme(request, key))
      return po_texts_refuse(given, key, "it with the scheme %s, not %s",
                             key == PO_KEY_TOLERANCE ? "panel" : "ring or triangle",
                             PO_SCHEMES[request->mesh.scheme]);
    if (!isnan(po_key_number(request, key)))
      continue;
    if (PO_KEYS[key].owner == PO_OWNER_TRACE) /* a value that is no number is the default */
      continue;
    if (key == PO_KEY_TABLE_SCALE || key == PO_KEY_SMOOTH)
      return po_texts_refuse(given, key, "it beside the file of a profile");
    const bool law = PO_KEYS[key].owner == PO_OWNER_LAW;
    const char *name = PO_KEYS[key].name; /* begins with that of its law or profile */
    return po_texts_refuse(
        given, key, "it with the %s %.*s, not %s", law ? "law" : "profile", (int)strcspn(name, "_"),
        name, law ? po_law_name(&request->scene.law) : po_profile_name(&request->scene.profile));
  }
  return PO_OK;
}

po_status po_texts_read(po_texts *given, po_request *request) {
  po_status status = check_pairs(given);
  if (!status)
    status = check_units(given);
  if (!status && given->si)
    status = po_texts_set_physical(given, request);
  const bool further = are_options(given) && given->text[PO_KEY_AMPLITUDE];
  for (int key = 0; key < PO_KEY_END && !status; ++key) {
    const po_key_owner owner = PO_KEYS[key].owner;
    if (given->si ? owner == PO_OWNER_SCENE || owner == PO_OWNER_PROFILE
                  : further && key == PO_KEY_WAVES)
      continue;
    status = po_texts_set_key(given, key, request);
  }
  if (!status && !given->si && further)
    status = po_texts_add_waves(given, 1.0, &request->scene);
  if (!status)
    status = po_texts_set_in_si(given, request);
  if (!status && request->in_si)
    po_texts_set_usual_units(request);
  if (!status)
    status = po_texts_check_material(given, request);
  return status ? status : check_idle(given, request);
}

/* Whether a key is given as a number other than 0, in its own unit or in SI units. */
static bool is_not_zero(const po_texts *given, po_key key) {
  const int si = po_key_in_si(key);
  const char *text = given->text[key] || si < 0 ? given->text[key] : given->text[si];
  double value = 0;
  return text && po_number_parse(text, &value) && value != 0;
}

po_status po_texts_check_waves(po_texts *given) {
  const bool amplitude =
      po_texts_has(given, PO_KEY_AMPLITUDE) || given->text[PO_KEY_AMPLITUDE_RATIO];
  const bool smooth =
      !is_not_zero(given, PO_KEY_AMPLITUDE) && !is_not_zero(given, PO_KEY_AMPLITUDE_RATIO);
  if (amplitude ? smooth || given->text[PO_KEY_ALPHA] || is_not_zero(given, PO_KEY_WAVELENGTH)
                : !po_texts_has(given, PO_KEY_WAVELENGTH) && !given->text[PO_KEY_ALPHA])
    return PO_OK;
  const po_key key = amplitude ? PO_KEY_WAVELENGTH : PO_KEY_AMPLITUDE;
  char name[PO_KEY_NAME_LENGTH];
  po_texts_name(given, amplitude ? PO_KEY_AMPLITUDE : PO_KEY_WAVELENGTH, name);
  return po_texts_refuse(given, given->si ? po_key_in_si(key) : key, "%s beside %s",
                         given->text[key] ? PO_KEYS[key].expected : "it", name);
}

bool po_texts_is_general(const po_texts *given, const po_form *form, const po_scene *scene) {
  /* a wave makes the form that of any profile, unless the paper has a formula with the wave */
  const bool by_wave = form->takes & PO_TAKES_PROFILE && !(form->needs & PO_NEEDS_AMPLITUDE);
  return given->text[PO_KEY_LAW] || given->text[PO_KEY_PROFILE] ||
         given->text[PO_KEY_PROFILE_FILE] || given->text[PO_KEY_WAVES] ||
         (by_wave && po_scene_is_wavy(scene));
}

po_status po_use_check(const char *what, const po_use *uses, size_t count) {
  const po_use *idle = NULL;
  size_t taken = 0, named = 0;
  for (size_t i = 0; i < count; ++i) {
    if (uses[i].given && !uses[i].taken && !idle)
      idle = &uses[i];
    taken += uses[i].taken;
  }
  char names[1000] = "";
  for (size_t i = 0; idle && i < count; ++i)
    if (uses[i].taken) {
      const char *before = named == 0 ? "only " : named + 1 < taken ? ", " : " or ";
      snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", before, uses[i].name);
      ++named;
    }
  return idle ? po_fail(PO_BAD_INPUT, "%s has no effect on %s: expected %s", idle->name, what,
                        *names ? names : "it to be left out")
              : PO_OK;
}

/* The part of a scene to which a key belongs, as in po_form.takes; 0: no form depends on it. */
static unsigned part_of(po_key key) {
  const po_key_owner owner = PO_KEYS[key].owner;
  if (owner == PO_OWNER_LAW || owner == PO_OWNER_PROFILE)
    return owner == PO_OWNER_LAW ? PO_TAKES_LAW : PO_TAKES_PROFILE;
  switch (po_key_target(key)) {
  case PO_KEY_TABOR:
    return PO_TAKES_TABOR;
  case PO_KEY_AMPLITUDE:
    return PO_TAKES_AMPLITUDE;
  case PO_KEY_WAVELENGTH:
    return PO_TAKES_WAVELENGTH;
  case PO_KEY_RADIUS:
    return PO_TAKES_RADIUS;
  case PO_KEY_PRELOAD:
  case PO_KEY_PRELOAD_LOAD:
    return PO_TAKES_PRELOAD | PO_TAKES_RATE;
  case PO_KEY_VISCOELASTIC:
  case PO_KEY_UNLOAD_SPEED:
    return PO_TAKES_RATE;
  default:
    return 0;
  }
}

po_status po_texts_check_rate(const po_texts *given, const po_form *form,
                              const po_form_input *input) {
  char name[3][PO_KEY_NAME_LENGTH];
  const po_key keys[] = {PO_KEY_VISCOELASTIC, PO_KEY_UNLOAD_SPEED, PO_KEY_PRELOAD};
  for (int k = 0; k < 3; ++k)
    po_texts_name(given, keys[k], name[k]);
  if (po_form_lacks_rate(form, input))
    return po_fail(PO_BAD_INPUT, "theory %s needs %s and %s", form->name, name[0], name[1]);
  if (form->needs & PO_NEEDS_RATE && isinf(input->preload.approach))
    return po_fail(PO_BAD_INPUT, "%s is %g: expected a finite number", name[2],
                   input->preload.approach);
  return PO_OK;
}

po_status po_texts_check_form(const po_texts *given, const po_form *form, bool alpha,
                              const po_use *others, size_t count) {
  enum { MOST_OTHERS = 8 };
  const unsigned takes = po_form_takes(form, alpha);
  po_use uses[PO_KEY_END + MOST_OTHERS];
  size_t used = 0;
  char what[80];
  snprintf(what, sizeof what, "theory %s%s%s", form->name,
           takes == form->takes ? ""
           : are_options(given) ? " with --"
                                : " with ",
           takes == form->takes ? "" : "alpha");
  for (int other = 0; other < 2; ++other) /* tabor and coupling first */
    for (int k = 0; k < PO_KEY_END; ++k) {
      const po_key key = k;
      if ((po_key_target(key) != PO_KEY_TABOR) != (other != 0))
        continue;
      const bool named = !po_key_is_number(key) || key == PO_KEY_COUPLING ||
                         part_of(key) & PO_TAKES_RATE ||
                         (po_key_is_of_scene(key) && PO_KEYS[k].owner == PO_OWNER_SCENE);
      po_use *use = &uses[used++];
      po_texts_name(given, key, use->name);
      use->given = po_texts_has(given, key);
      use->taken = takes & part_of(key) && (named || use->given);
      if (given->si && !other) /* follows from the units */
        use->taken = false;
      if (given->si && key == PO_KEY_RADIUS) /* the unit of force contains it */
        use->taken = true;
    }
  memcpy(uses + used, others, count * sizeof *others);
  return po_use_check(what, uses, used + count);
}
