/* Whether a request has the value that a table or a case file gives. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "po_input.h"

static bool is_near(double a, double b, int ulps) {
  return a == b || (isfinite(b) && fabs(a - b) <= ulps * DBL_EPSILON * fabs(b));
}

static bool is_close(double a, double b) {
  return is_near(a, b, 4);
}

/* The coupling is computed from the Tabor parameter, and tables give it with 15 digits: half a unit
 * of the last is up to 23 ulp. */
enum { ULPS_OF_COUPLING = 32 };

/* The scale of a table is not compared: the content of the table is. */
static bool parameters_match(const po_request *a, const po_request *b, po_key_owner owner) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    if (!po_key_is_parameter(key, owner) || !po_key_is_continuous(key))
      continue;
    const double x = po_key_number(a, (po_key)key), y = po_key_number(b, (po_key)key);
    if (!isnan(y) && !is_close(x, y))
      return false;
  }
  return true;
}

static bool waves_match(const po_scene *a, const po_scene *b) {
  bool match = po_scene_waves(a) == po_scene_waves(b);
  for (size_t k = 0; match && k < po_scene_waves(a); ++k) {
    const po_wave x = po_scene_wave(a, k), y = po_scene_wave(b, k);
    match = is_close(x.amplitude, y.amplitude) && is_close(x.length, y.length);
  }
  return match;
}

/* The Lennard-Jones law of the paper is the Mie law (3, 9): one name for both. */
static po_request with_one_name(po_request request) {
  if (po_law_index(&request.scene.law) == 0)
    po_law_set(&request.scene.law, "mie:3,9");
  return request;
}

bool po_key_matches(const po_request *request, po_key key, const char *text) {
  po_request wanted = *request;
  const po_scene *scene = &request->scene;
  if (key == PO_KEY_PROFILE_FILE && strcmp(text, po_profile_digest(&scene->profile)) == 0)
    return true;
  if (!po_key_set(&wanted, key, text))
    return false;
  switch (key) {
  case PO_KEY_LAW: {
    const po_request own = with_one_name(*request);
    wanted = with_one_name(wanted);
    return po_law_index(&wanted.scene.law) == po_law_index(&own.scene.law) &&
           parameters_match(&own, &wanted, PO_OWNER_LAW);
  }
  case PO_KEY_PROFILE:
    return po_profile_index(&wanted.scene.profile) == po_profile_index(&scene->profile) &&
           parameters_match(request, &wanted, PO_OWNER_PROFILE);
  case PO_KEY_PROFILE_FILE:
    return strcmp(po_profile_digest(&wanted.scene.profile), po_profile_digest(&scene->profile)) ==
           0;
  case PO_KEY_WAVES:
    return waves_match(scene, &wanted.scene);
  case PO_KEY_COUPLING:
    return is_near(po_key_number(request, key), po_key_number(&wanted, key), ULPS_OF_COUPLING);
  default:
    return is_close(po_key_number(request, key), po_key_number(&wanted, key));
  }
}
