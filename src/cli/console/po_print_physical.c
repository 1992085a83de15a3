#include "po_print.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_json.h"
#include "po_result_rows.h"
#include "po_si.h"

/* The text of a key as it was given; NULL: it is not printed. A profile has its parameters, and
 * a ratio of amplitude and wavelength is an amplitude. */
static const char *shown(const po_texts *given, int key, char text[PO_KEY_TEXT_LENGTH]) {
  const bool one = key == PO_KEY_PROFILE || key == PO_KEY_TABLE_SCALE || key == PO_KEY_SMOOTH ||
                   key == PO_KEY_PROFILE_FILE || key == PO_KEY_WAVES;
  if (!one && PO_KEYS[key].owner != PO_OWNER_SI)
    return NULL;
  const char *ratio = given->text[PO_KEY_AMPLITUDE_RATIO],
             *wavelength = given->text[PO_KEY_WAVELENGTH_M];
  double a = 0, b = 0;
  if (key == PO_KEY_AMPLITUDE_M && ratio && wavelength && po_number_parse(ratio, &a) &&
      po_number_parse(wavelength, &b)) {
    po_number_print(a * b, text);
    return text;
  }
  if (key != PO_KEY_PROFILE || !given->text[key] || strchr(given->text[key], ':'))
    return given->text[key];
  int length = snprintf(text, PO_KEY_TEXT_LENGTH, "%s", given->text[key]);
  const int name = length;
  for (int other = 0; other < PO_KEY_COUNT && length < PO_KEY_TEXT_LENGTH; ++other)
    if (po_key_is_parameter(other, PO_OWNER_PROFILE) && given->text[other])
      length += snprintf(text + length, PO_KEY_TEXT_LENGTH - (size_t)length, "%c%s",
                         length == name ? ':' : ',', given->text[other]);
  return text;
}

/* The keys of a scene in SI units in the order in which they are printed: those in SI units first.
 */
static int key_at(int index) {
  return (index + PO_KEY_END) % PO_KEY_ALL;
}

json_t *po_json_physical_input(const po_texts *given, const po_units *units) {
  json_t *input = po_json_empty_object();
  for (int i = 0; i < PO_KEY_ALL; ++i) {
    double value = 0;
    char buffer[PO_KEY_TEXT_LENGTH];
    const char *text = shown(given, key_at(i), buffer);
    if (text)
      po_json_set(&input, PO_KEYS[key_at(i)].name,
                  po_number_parse(text, &value) ? po_json_number(value) : po_json_text(text));
  }
  json_t *object = PO_JSON_OBJECT({"input", input}, {"units", po_json_units(units)});
  double modulus, radius, work;
  if (po_texts_bodies(given, &modulus, &radius, &work)) {
    json_t *bodies = PO_JSON_OBJECT({"modulus_pa", po_json_number(modulus)},
                                    {"radius_m", po_json_number(radius)});
    if (!isnan(work))
      po_json_set(&bodies, "work_j_per_m2", po_json_number(work));
    po_json_set(&object, "bodies", bodies);
  }
  return object;
}

json_t *po_json_physical(const po_texts *given, const po_request *request,
                         const po_result *result) {
  json_t *object = po_json_physical_input(given, &request->units);
  po_json_set_all(&object, po_json_document_in_si(request, result));
  return object;
}

/* The contact modulus, the radius and the work of adhesion that follow from two bodies. */
static void print_bodies(const po_texts *given) {
  double value[3];
  static const struct {
    const char *name, *unit;
  } OF[] = {{"contact modulus E*", "Pa"}, {"radius R", "m"}, {"work of adhesion w", "J/m^2"}};
  if (!po_texts_bodies(given, &value[0], &value[1], &value[2]))
    return;
  const char *before = "bodies   ";
  for (int k = 0; k < 3; ++k)
    if (!isnan(value[k])) {
      printf("%s%s %.10g %s", before, OF[k].name, value[k], OF[k].unit);
      before = ", ";
    }
  printf("\n");
}

void po_print_physical_input(const po_texts *given) {
  printf("physical");
  for (int i = 0; i < PO_KEY_ALL; ++i) {
    char buffer[PO_KEY_TEXT_LENGTH];
    const char *text = shown(given, key_at(i), buffer);
    if (text)
      printf(" %s %s", PO_KEYS[key_at(i)].name, text);
  }
  printf("\n");
  print_bodies(given);
}

/* The greatest numbers of the special points, or of a pull-off, and their units. */
typedef struct {
  double approach, load, radius;
} greatest;
typedef struct {
  po_si_unit approach, load, radius;
} units_of_point;

static void take_greatest(greatest *g, double approach, double load, double radius) {
  po_si_take(&g->approach, approach);
  po_si_take(&g->load, load);
  po_si_take(&g->radius, radius);
}

static units_of_point units_for(const po_units *units, const greatest *g) {
  return (units_of_point){.approach = po_si_readable_approach(units, g->approach),
                          .load = po_si_readable(units, PO_DIMENSION_LOAD, g->load),
                          .radius = po_si_readable(units, PO_DIMENSION_LENGTH, g->radius)};
}

static void print_special_points(const units_of_point *u, const po_special_point *list,
                                 size_t count) {
  for (size_t i = 0; i < count; ++i)
    printf("%-9s %16.10g %16.10g %17.6g\n", PO_SPECIAL_KINDS[list[i].kind],
           list[i].approach * u->approach.factor, list[i].load * u->load.factor,
           list[i].contact_radius * u->radius.factor);
}

static void print_table(const po_units *units, const po_result *o) {
  greatest g = {0};
  for (size_t i = 0; i < o->fold_count + o->extremum_count; ++i) {
    const po_special_point *p = i < o->fold_count ? &o->folds[i] : &o->extrema[i - o->fold_count];
    take_greatest(&g, p->approach, p->load, p->contact_radius);
  }
  const units_of_point u = units_for(units, &g);
  printf("%-9s %13s/%s %13s/%s %14s/%s\n", "point", "approach", u.approach.text, "load",
         u.load.text, "contact radius", u.radius.text);
  print_special_points(&u, o->folds, o->fold_count);
  print_special_points(&u, o->extrema, o->extremum_count);
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
static void print_preload(const po_units *units, const po_result *o) {
  const po_preload *from = &o->pull_off.pressed, *until = &o->pull_off.until;
  if (!o->has_pull_off || o->status || isnan(from->approach))
    return;
  greatest g = {0};
  take_greatest(&g, from->approach, from->load, 0);
  take_greatest(&g, until->approach, until->load, 0);
  const units_of_point u = units_for(units, &g);
  const po_si_unit *length = &u.approach, *force = &u.load;
  printf("preload  loading to approach %.6g %s, load %.6g %s,", from->approach * length->factor,
         length->text, from->load * force->factor, force->text);
  if (isnan(until->approach))
    printf(" or more gives this pull-off\n");
  else
    printf(" to approach %.4g %s, load %.4g %s, gives this pull-off\n",
           until->approach * length->factor, length->text, until->load * force->factor,
           force->text);
}

/* A number with two significant digits, "1500". */
static double rounded(double value) {
  char text[32];
  snprintf(text, sizeof text, "%.2g", value);
  return strtod(text, NULL);
}

static void print_source(const po_uncertain *u, double unit, const char *name) {
  if (strcmp(u->source, "noise") == 0)
    printf("uncertain noise of the profile: ");
  else
    printf("uncertain %s %.6g+-%.6g: ", u->source, u->value, u->deviation);
  if (!isnan(u->force))
    printf("force +-%g %s\n", rounded(u->force * unit), name);
  else if (isnan(u->below) || isnan(u->above))
    printf("unknown, because the solve with the input %s by twice its uncertainty failed\n",
           isnan(u->below) ? "less" : "more");
  else
    printf("no number, because the force is not linear there: it changes by %g %s with the input "
           "less by twice its uncertainty, by %g with the input more\n",
           rounded(u->below * unit), name, rounded(u->above * unit));
}

/* The first intervals of the rows, in which a contact is known by few rows. */
enum { FIRST_INTERVALS = 4 };

/* What the interpolation of a table does to the force. */
static void print_interpolation(const po_result *o, double unit, const char *name) {
  if (!o->interpolation.is_known)
    return;
  printf("uncertain interpolation of the rows: ");
  if (isnan(o->interpolation.force))
    printf("unknown, because a solve with another spline failed\n");
  else
    printf(
        "force +-%g %s, without every other row %+g or %+g, with a round apex %+g\n",
        rounded(o->interpolation.force * unit), name, rounded(o->interpolation.without_odd * unit),
        rounded(o->interpolation.without_even * unit), rounded(o->interpolation.round_apex * unit));
  if (o->interpolation.interval <= FIRST_INTERVALS)
    printf("warning  the contact at pull-off ends in interval %d of the rows: there the force is "
           "that of the interpolation; expected rows nearer to each other about the axis\n",
           o->interpolation.interval);
}

void po_print_uncertain(const po_result *result, double unit, const char *name) {
  print_interpolation(result, unit, name);
  for (size_t k = 0; k < result->uncertain_count; ++k)
    print_source(&result->uncertain[k], unit, name);
  if (result->uncertain_count > 1 && !isnan(result->uncertainty))
    printf("uncertain all together: force +-%g %s, the root of the sum of squares\n",
           rounded(result->uncertainty * unit), name);
}

static units_of_point units_of_pull_off(const po_units *units, const po_result *o) {
  greatest g = {0};
  take_greatest(&g, o->pull_off.approach, o->pull_off.force, o->pull_off.contact_radius);
  return units_for(units, &g);
}

void po_print_physical_pull_off(const po_units *units, const po_result *o) {
  const units_of_point u = units_of_pull_off(units, o);
  if (o->has_pull_off)
    printf("pull-off force %.10g %s at approach %.10g %s, contact radius %.8g %s\n",
           o->pull_off.force * u.load.factor, u.load.text, o->pull_off.approach * u.approach.factor,
           u.approach.text, o->pull_off.contact_radius * u.radius.factor, u.radius.text);
  if (o->has_pull_off && isfinite(o->pull_off.force_error))
    printf("errors   force %.1e %s, approach %.1e %s, contact radius %.1e %s\n",
           o->pull_off.force_error * u.load.factor, u.load.text,
           o->pull_off.approach_error * u.approach.factor, u.approach.text,
           o->pull_off.contact_radius_error * u.radius.factor, u.radius.text);
}

void po_print_physical(const po_texts *given, const po_request *request, const po_result *o) {
  const units_of_point u = units_of_pull_off(&request->units, o);
  po_print_physical_input(given);
  po_print_physical_pull_off(&request->units, o);
  po_print_uncertain(o, u.load.factor, u.load.text);
  print_sensitivity(request, o);
  print_preload(&request->units, o);
  if (o->fold_count + o->extremum_count)
    print_table(&request->units, o);
}
