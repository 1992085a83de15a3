#include "po_print_physical.h"

#include <math.h>
#include <stdio.h>

#include "po_json.h"
#include "po_json_rows.h"
#include "po_print_uncertain.h"
#include "po_result_rows.h"

static void set(json_t **object, const char *key, double value) {
  po_json_set(object, key, isinf(value) ? po_json_text("inf") : po_json_number(value));
}

/* The waves in metres, as the key `waves` has them in epsilon. */
static json_t *waves_of(const po_scene_flags *flags) {
  po_text text = {0};
  for (size_t k = 0; k < flags->waves; ++k) {
    char amplitude[PO_NUMBER_LENGTH], length[PO_NUMBER_LENGTH];
    po_number_print(flags->wave[k].amplitude, amplitude);
    po_number_print(flags->wave[k].length, length);
    po_text_add(&text, "%s%s@%s", k ? ";" : "", amplitude, length);
  }
  if (text.failed)
    po_text_clear(&text);
  return po_json_take_text(text.data);
}

json_t *po_json_physical_input(const po_scene_flags *flags) {
  json_t *input = po_json_empty_object();
  if (!isnan(flags->modulus))
    set(&input, "modulus_pa", flags->modulus);
  set(&input, "work_j_per_m2", flags->work);
  set(&input, "distance_m", flags->distance);
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    if (!isnan(flags->metres[i])) {
      char key[32]; /* the name of the option with underscores */
      po_scene_flags_name(flags, (po_length)i, key);
      for (char *c = key; *c; ++c)
        *c = *c == '-' ? '_' : *c;
      set(&input, key, flags->metres[i]);
    }
  if (flags->profile)
    po_json_set(&input, "profile", po_json_text(flags->shown));
  if (flags->profile_file)
    po_json_set(&input, "profile_file", po_json_text(flags->profile_file));
  if (flags->waves)
    po_json_set(&input, "waves", waves_of(flags));
  return PO_JSON_OBJECT({"input", input}, {"units", po_json_units(&flags->units)});
}

/* The members in SI units. */
static const char *const SPECIAL[] = {
    "approach", "load", "contact_radius", "kind", "error_estimate", "load_error_estimate", NULL};
static const char *const CURVE[] = {"approach", "load", "contact_radius", NULL};
static const char *const PROFILE[] = {"radius", "gap", "traction", NULL};
static const char *const UNCERTAIN[] = {"source", "value", "deviation", "below",
                                        "above",  "force", NULL};
static const char *const THEORY[] = {"theory", "force", NULL};

json_t *po_json_physical(const po_scene_flags *flags, const po_request *request,
                         const po_result *o) {
  const po_units *u = &flags->units;
  json_t *object = po_json_physical_input(flags);
  po_json_set(&object, "pull_off", po_json_units_pull_off(u, o));
  if (o->uncertain_count)
    po_json_set(&object, "uncertainty",
                PO_JSON_OBJECT({"force_n", po_json_number(o->uncertainty * u->force)},
                               {"sources", po_json_si_list(&PO_UNCERTAIN_ROWS, o->uncertain,
                                                           o->uncertain_count, u, UNCERTAIN)}));
  po_json_set(&object, "folds",
              po_json_si_list(&PO_SPECIAL_POINT_ROWS, o->folds, o->fold_count, u, SPECIAL));
  po_json_set(&object, "extrema",
              po_json_si_list(&PO_SPECIAL_POINT_ROWS, o->extrema, o->extremum_count, u, SPECIAL));
  if (request->want & PO_WANT_CURVE)
    po_json_set(&object, "curve",
                po_json_si_list(&PO_CURVE_ROWS, o->curve, o->curve_count, u, CURVE));
  if (request->want & PO_WANT_PROFILE) {
    po_json_set(&object, "profile_approach_m", po_json_number(o->profile_approach * u->length));
    po_json_set(&object, "profile",
                po_json_si_list(&PO_PROFILE_ROWS, o->profile, o->profile_count, u, PROFILE));
  }
  if (request->want & PO_WANT_THEORIES)
    po_json_set(&object, "theories",
                po_json_si_list(&PO_THEORIES_ROWS, o->theories, o->theory_count, u, THEORY));
  return object;
}

void po_print_physical_input(const po_scene_flags *flags) {
  printf("physical");
  if (!isnan(flags->modulus))
    printf(" modulus %g Pa", flags->modulus);
  printf(" work %g J/m^2 distance %g m", flags->work, flags->distance);
  for (int i = 0; i < PO_LENGTH_COUNT; ++i)
    if (!isnan(flags->metres[i])) {
      char name[32];
      po_scene_flags_name(flags, (po_length)i, name);
      printf(" %.*s %g m", (int)(snprintf(NULL, 0, "%s", name) - 2), name, flags->metres[i]);
    }
  if (flags->profile)
    printf(" profile %s, lengths in m", flags->shown);
  if (flags->profile_file)
    printf(" profile of %s, lengths in m", flags->profile_file);
  for (size_t k = 0; k < flags->waves; ++k)
    printf(" wave %g,%g m", flags->wave[k].amplitude, flags->wave[k].length);
  printf("\n");
}

static void print_special_points(const po_units *u, const po_special_point *list, size_t count) {
  for (size_t i = 0; i < count; ++i)
    printf("%-9s %16.9e %16.9e %16.6g\n", po_special_kind_name(list[i].kind),
           list[i].approach * u->length, list[i].load * u->force,
           list[i].contact_radius * u->length);
}

double po_print_percent(double change) {
  return round(change * 1e4) / 1e4 + 0.0; /* + 0.0: not -0 */
}

/* The derivatives of the pull-off force in N, pi w R f(tabor, ...), by the inputs in SI units, as
 * changes in percent; tabor = (R w^2/(E*^2 eps^3))^(1/3). */
static void print_sensitivity(const po_request *request, const po_result *o) {
  const po_sensitivity *s = &o->pull_off.sensitivity;
  if (!o->has_pull_off || !o->pull_off.has_sensitivity)
    return;
  printf("inputs   1 %% more modulus changes the force by %.4g %%, work %.4g %%",
         po_print_percent(-2.0 / 3.0 * s->tabor), po_print_percent(1.0 + 2.0 / 3.0 * s->tabor));
  if (po_scene_waves(&request->scene) == 1)
    printf(", amplitude %.4g %%, wavelength %.4g %%", po_print_percent(s->amplitude),
           po_print_percent(s->wavelength));
  if (po_profile_is_sphere(&request->scene.profile))
    printf(", radius %.4g %%", po_print_percent(1.0 + s->tabor / 3.0 + s->radius));
  printf("\n");
}

/* Which preloads give the pull-off, with the loads of a test at these approaches. */
static void print_preload(const po_units *u, const po_result *o) {
  const po_pressed *from = &o->pull_off.pressed, *until = &o->pull_off.until;
  if (!o->has_pull_off || o->status || isnan(from->approach))
    return;
  printf("preload  loading to approach %.6g m, load %.6g N,", from->approach * u->length,
         from->load * u->force);
  if (isnan(until->approach))
    printf(" or more gives this pull-off\n");
  else
    printf(" to approach %.4g m, load %.4g N, gives this pull-off\n", until->approach * u->length,
           until->load * u->force);
}

void po_print_physical(const po_scene_flags *flags, const po_request *request,
                       const po_result *result) {
  const po_units *u = &flags->units;
  po_print_physical_input(flags);
  if (result->has_pull_off)
    printf("pull-off force %.10g N at approach %.10g m, contact radius %.8g m\n",
           result->pull_off.force * u->force, result->pull_off.approach * u->length,
           result->pull_off.contact_radius * u->length);
  if (result->has_pull_off && isfinite(result->pull_off.force_error))
    printf("errors   force %.1e N, approach %.1e m, contact radius %.1e m\n",
           result->pull_off.force_error * u->force, result->pull_off.approach_error * u->length,
           result->pull_off.contact_radius_error * u->length);
  po_print_uncertain(result, u->force, "N");
  print_sensitivity(request, result);
  print_preload(u, result);
  if (result->fold_count + result->extremum_count) {
    printf("%-9s %16s %16s %16s\n", "point", "approach/m", "load/N", "contact radius/m");
    print_special_points(u, result->folds, result->fold_count);
    print_special_points(u, result->extrema, result->extremum_count);
  }
}
