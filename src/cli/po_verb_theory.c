#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_forms.h"
#include "po_json.h"
#include "po_json_form.h"
#include "po_options.h"
#include "po_print.h"
#include "po_si.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff theory NAME [OPTION]...\n"
    "Evaluates a closed form. NAME is one of\n"
    "  bradley             pull-off of a rigid smooth sphere (Eq 23)\n"
    "  rigid               pull-off of a rigid wavy sphere (Eqs 21, 22), or of any rigid\n"
    "                      profile, waves and law\n"
    "  jkr                 JKR theory of a smooth sphere (Eqs 7, 8), or of any profile and waves\n"
    "  dmt                 DMT theory of a smooth sphere\n"
    "  maugis              Maugis-Dugdale theory of any profile and waves\n"
    "  guduru              JKR theory of a wavy sphere (Eq 5)\n"
    "  kesari-lew          envelope of Eq 5 (Eq 24)\n"
    "  persson-tosatti     effective work of adhesion of a rough surface (Eqs 25-30)\n"
    "  persson-brener      pull-off of a viscoelastic body at a speed: JKR theory with the work "
    "of\n"
    "                      adhesion of an edge that moves, and its slow and fast limits\n"
    "  rumpf-rabinowicz    rigid crest on a sphere (Eq 20)\n"
    "  compactness         whether the gap is monotonic (Eqs 3, 4)\n"
    "  crest               rigid central crest (Eqs 18, 19)\n"
    "  lennard-jones       traction-separation law (Eq 9)\n"
    "It prints the equation and the preload that the results assume, then the results. An option "
    "on\n"
    "which the closed form does not depend is refused. Lengths are in units of the\n"
    "equilibrium distance epsilon, loads in pi w R (w: work of adhesion), or in pi w epsilon\n"
    "for a profile without a radius. The approach is positive when the bodies are pressed\n"
    "together, the load when it is compressive.\n"
    "\n"
    "Scene:\n"
    "@scene\n"
    "  --tension Q             tension of Maugis-Dugdale, in w/epsilon (maugis; default: the\n"
    "                          greatest tension of the law)\n"
    "  --alpha ALPHA           A R/L^2, instead of the wavelength (rigid) or of amplitude,\n"
    "                          wavelength and radius (rumpf-rabinowicz)\n"
    "\n"
    "Additional results:\n"
    "@trace\n"
    "  --gap H                 the traction at this gap, H = h/epsilon - 1 > -1 (lennard-jones)\n"
    "  --curve FILE            write approach, load and contact radius along the curve to FILE, "
    "as\n"
    "                          CSV, up to the preload, or to twice the contact radius at pull-off\n"
    "                          (jkr, dmt, maugis, guduru); - is standard output; the JSON\n"
    "                          document has it, too\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n" PO_SCENE_OPTIONS_HELP "\n"
    "Example: pulloff theory guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100 --json\n"
    "Example: pulloff theory guduru --tabor 5 --amplitude 2 --wavelength 20 --preload-load 1\n"
    "Example: pulloff theory jkr --tabor 3 --load 0\n"
    "Example: pulloff theory persson-brener --tabor 3 --viscoelastic sls:0.1 --unload-speed 1 \\\n"
    "             --preload 5\n"
    "Example: pulloff theory jkr --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7\n";

/* The options of one command line. A number that is not given is NAN. */
typedef struct {
  po_scene_options options;
  po_request request;
  double alpha; /* A R/lambda^2, given or of the scene */
  double gap, tension, load, approach, contact_radius;
  const char *curve; /* the file */
  bool json;
} po_theory_line;

/* Beside the options of keys. */
static const po_option OPTIONS[] = {
    PO_NUMBER("alpha", po_theory_line, alpha, 0.0, "a finite number > 0"),
    PO_NUMBER("gap", po_theory_line, gap, -1.0, "a finite number > -1"),
    PO_NUMBER("tension", po_theory_line, tension, 0.0, "a finite number > 0"),
    PO_TEXT("curve", po_theory_line, curve, "the name of a file"),
    PO_FLAG("json", po_theory_line, json),
    {0}};

/* Refuses options that have no effect on the form. */
static po_status check_use(const po_theory_line *l, const po_form *form) {
  const unsigned takes = po_form_takes(form, !isnan(l->alpha));
  const bool state = takes & PO_TAKES_STATE;
  po_use others[] = {{"--load", po_texts_has(&l->options.given, PO_KEY_LOAD), state},
                     {"--approach", po_texts_has(&l->options.given, PO_KEY_APPROACH),
                      state || form->variable == PO_FORM_AT_APPROACH},
                     {"--contact-radius", po_texts_has(&l->options.given, PO_KEY_CONTACT_RADIUS),
                      form->variable == PO_FORM_AT_CONTACT_RADIUS},
                     {"--alpha", !isnan(l->alpha), takes & PO_TAKES_ALPHA},
                     {"--gap", !isnan(l->gap), form->variable == PO_FORM_AT_GAP},
                     {"--curve", l->curve, takes & PO_TAKES_CURVE},
                     {"--tension", !isnan(l->tension), takes & PO_TAKES_TENSION}};
  for (size_t i = 0; i < 3 && l->request.in_si; ++i)
    strcat(others[i].name, i ? "-m" : "-n");
  return po_texts_check_form(&l->options.given, form, !isnan(l->alpha), others,
                             sizeof others / sizeof *others);
}

static po_status check_elastic(const po_theory_line *l, const po_form *form) {
  if (!(form->needs & PO_NEEDS_ELASTIC) || l->request.scene.tabor > 0.0)
    return PO_OK;
  return l->request.in_si
             ? po_fail(PO_BAD_INPUT, "--modulus-pa is inf: expected a finite number > 0")
             : po_fail(PO_BAD_INPUT, "--%s is 0: expected a finite number > 0",
                       l->options.given.text[PO_KEY_COUPLING] ? "coupling" : "tabor");
}

/* Refuses values outside the domain of the form. */
static po_status check_values(const po_theory_line *l, const po_form *form) {
  const po_status status = check_elastic(l, form);
  if (status || !(l->approach >= 1.0) || form->variable != PO_FORM_AT_APPROACH)
    return status;
  return l->request.in_si
             ? po_fail(PO_BAD_INPUT, "--approach-m is %s: expected less than --distance-m, %s",
                       l->options.given.text[PO_KEY_APPROACH_M],
                       l->options.given.text[PO_KEY_DISTANCE_M])
             : po_fail(PO_BAD_INPUT, "--approach is %g: expected a finite number < 1", l->approach);
}

/* Computes the scene and alpha from the options, and refuses options that are missing. */
static po_status complete_line(po_theory_line *l, const po_form *form) {
  po_texts *given = &l->options.given;
  const po_scene *scene = &l->request.scene;
  const bool has_alpha = !isnan(l->alpha);
  given->any_modulus = !(form->needs & PO_NEEDS_ELASTIC);
  given->any_radius = form->variable == PO_FORM_AT_GAP;
  po_status status = po_texts_read(given, &l->request);
  if (!status)
    status = check_use(l, form);
  if (status)
    return status;
  l->load = po_texts_number(given, PO_KEY_LOAD, &l->request.units);
  l->approach = po_texts_number(given, PO_KEY_APPROACH, &l->request.units);
  l->contact_radius = po_texts_number(given, PO_KEY_CONTACT_RADIUS, &l->request.units);
  if (!isnan(l->load) + !isnan(l->approach) + !isnan(l->contact_radius) > 1)
    return po_fail(PO_BAD_INPUT, "more than one of load, approach and contact radius is given: "
                                 "expected one of them");
  if (l->curve && l->json && strcmp(l->curve, "-") == 0)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  po_scene_options_warn(given);
  if (po_texts_is_general(given, form, scene)) {
    const po_status wrong = po_scene_check(scene);
    return wrong ? wrong : check_elastic(l, form);
  }
  const bool has_amplitude = po_texts_has(given, PO_KEY_AMPLITUDE);
  const bool waves =
      has_amplitude && (scene->amplitude == 0.0 || po_texts_has(given, PO_KEY_WAVELENGTH));
  char amplitude[PO_KEY_NAME_LENGTH], wavelength[PO_KEY_NAME_LENGTH];
  po_texts_name(given, PO_KEY_AMPLITUDE, amplitude);
  po_texts_name(given, PO_KEY_WAVELENGTH, wavelength);
  if (form->needs & PO_NEEDS_WAVES && !waves)
    return po_fail(PO_BAD_INPUT, "theory %s needs %s and %s", form->name, amplitude, wavelength);
  if (form->needs & PO_NEEDS_AMPLITUDE && !has_amplitude)
    return po_fail(PO_BAD_INPUT, "theory %s needs %s", form->name, amplitude);
  if (form->needs & PO_NEEDS_ALPHA && !has_alpha && !waves)
    return po_fail(PO_BAD_INPUT, "theory %s needs --alpha, or %s and %s", form->name, amplitude,
                   wavelength);
  if (!has_alpha && waves)
    l->alpha = po_scene_alpha(scene);
  return check_values(l, form);
}

/* The value of a result in SI units: its number, key and unit. Returned: false if it has none. */
static bool in_si(const po_theory_line *l, const po_form_value *item, double *value, char key[80],
                  const char **unit) {
  static const struct {
    const char *suffix, *text;
  } UNITS[] = {{"", ""}, {"m", "m"}, {"n", "N"}, {"j_per_m2", "J/m^2"}, {"pa", "Pa"}};
  const po_units *u = &l->request.units;
  const double size[] = {1, u->length, u->force, u->work, u->tension};
  snprintf(key, 80, "%s_%s", item->name, UNITS[item->unit].suffix);
  *unit = UNITS[item->unit].text;
  *value = item->value * size[item->unit];
  return l->request.in_si && item->unit != PO_FORM_PURE;
}

/* An infinite value, such as the crest radius of a smooth sphere, is null in JSON and - here. */
static void print_number(const char *key, double value, const char *unit) {
  if (isfinite(value))
    printf("%-34s %.12g%s%s\n", key, value, *unit ? " " : "", unit);
  else
    printf("%-34s -\n", key);
}

/* A value in SI units, with a prefix; J/m^2 has none. */
static void print_readable(const po_form_value *item, double value, const char *unit) {
  static const po_dimension DIMENSIONS[] = {[PO_FORM_LENGTH] = PO_DIMENSION_LENGTH,
                                            [PO_FORM_FORCE] = PO_DIMENSION_LOAD,
                                            [PO_FORM_TENSION] = PO_DIMENSION_TRACTION};
  static const po_units SI = {.length = 1, .force = 1, .tension = 1, .traction = 1};
  if (item->unit == PO_FORM_WORK) {
    print_number(item->name, value, unit);
    return;
  }
  const po_si_unit readable = po_si_readable(&SI, DIMENSIONS[item->unit], value);
  print_number(item->name, value * readable.factor, readable.text);
}

/* What the results assume. */
static void print_assumed(const char *key, const char *text) {
  if (text)
    printf("%-8s %s\n", key, text);
}

static po_status print_text(const po_theory_line *l, const po_form *form,
                            const po_form_input *input, const po_form_values *values) {
  double value;
  char key[80];
  const char *unit;
  if (l->request.in_si)
    po_print_physical_input(&l->options.given);
  print_assumed("theory", form->source);
  print_assumed("preload", po_form_preload(form, input));
  print_assumed("branch", po_form_branch(input));
  for (size_t i = 0; i < values->count; ++i)
    print_number(values->items[i].name, values->items[i].value, "");
  for (size_t i = 0; i < values->count; ++i)
    if (in_si(l, &values->items[i], &value, key, &unit))
      print_readable(&values->items[i], value, unit);
  return po_print_digest(po_json_form(form, input, values, NULL, 0));
}

/* The curve of --curve. */
typedef struct {
  po_form_point *points;
  size_t count;
} form_curve;

static po_status print_json(const po_theory_line *l, const po_form *form,
                            const po_form_input *input, const po_form_values *values,
                            const form_curve *curve) {
  double value;
  char key[80];
  const char *unit;
  json_t *document = po_json_form(form, input, values, curve->points, curve->count);
  if (l->request.in_si) {
    json_t *physical = po_json_physical_input(&l->options.given, &l->request.units);
    for (size_t i = 0; i < values->count; ++i)
      if (in_si(l, &values->items[i], &value, key, &unit))
        po_json_set(&physical, key, po_json_number(value));
    po_json_set(&document, "physical", physical);
  }
  return po_print_document(document);
}

/* Writes the curve to the file of --curve. The command in it repeats the options of the scene. */
static po_status write_curve(const po_theory_line *l, const po_form *form,
                             const po_form_input *input, const form_curve *curve) {
  po_text command = {0};
  po_text_add(&command, "pulloff theory %s%s", form->name,
              l->request.in_si ? " --from-physical" : "");
  for (int key = 0; key < PO_KEY_ALL; ++key)
    if (l->options.given.text[key] && key != PO_KEY_WAVES) {
      char flag[PO_FLAG_LENGTH];
      po_key_flag(key, flag);
      po_text_add(&command, " --%s %s", flag, l->options.given.text[key]);
    }
  if (l->options.given.text[PO_KEY_WAVES])
    po_input_add_waves(&command, l->options.given.text[PO_KEY_WAVES]);
  if (!isnan(l->tension))
    po_text_add(&command, " --tension %.17g", l->tension);
  po_text_add(&command, " --curve %s", l->curve);
  const po_status status = po_tables_write_form(
      l->curve, form, input, l->request.in_si ? &l->request.units : NULL,
      po_input_load_unit(&l->request), po_text_string(&command), curve->points, curve->count);
  po_text_clear(&command);
  return status;
}

static po_form_input input_of(const po_theory_line *l, const po_form *form) {
  const double variables[] = {(double)NAN, l->approach, l->contact_radius, l->gap};
  const po_preload preload = l->request.preload;
  const bool states = form->takes & PO_TAKES_STATE;
  const po_form_held held = states && !isnan(l->load)       ? PO_FORM_HOLDS_LOAD
                            : states && !isnan(l->approach) ? PO_FORM_HOLDS_APPROACH
                                                            : PO_FORM_HOLDS_NOTHING;
  return (po_form_input){.scene = l->request.scene,
                         .alpha = l->alpha,
                         .at = variables[form->variable],
                         .tension = l->tension,
                         .general = po_texts_is_general(&l->options.given, form, &l->request.scene),
                         .held = held,
                         .value = held == PO_FORM_HOLDS_LOAD ? l->load : l->approach,
                         .has_preload = isfinite(preload.approach) || !isnan(preload.load),
                         .preload = preload,
                         .creep = l->request.creep,
                         .unload_speed = l->request.unload_speed};
}

static po_status print_form(const po_theory_line *l, const po_form *form) {
  const po_form_input input = input_of(l, form);
  po_form_values values = {.count = 0};
  form_curve curve = {NULL, 0};
  po_status status = po_texts_check_rate(&l->options.given, form, &input);
  if (!status)
    status = po_form_evaluate(form, &input, &values);
  if (!status && l->curve)
    status = po_form_curve(form, &input, &curve.points, &curve.count);
  if (!status && !(l->curve && strcmp(l->curve, "-") == 0))
    status = l->json ? print_json(l, form, &input, &values, &curve)
                     : print_text(l, form, &input, &values);
  if (!status && l->curve)
    status = write_curve(l, form, &input, &curve);
  free(curve.points);
  return status;
}

int po_verb_theory(int argc, char **argv) {
  const po_options options = {
      "theory", HELP, OPTIONS, argc, argv, 1, NULL, PO_FOR_THEORY, po_scene_options_take};
  po_theory_line line = {.options = po_scene_options_begin(),
                         .request = po_input_default(),
                         .alpha = NAN,
                         .gap = NAN,
                         .tension = NAN,
                         .load = NAN,
                         .approach = NAN,
                         .contact_radius = NAN};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  const char *name = optind < argc ? argv[optind++] : "";
  const po_form *form = po_form_find(name);
  if (!form && !*name)
    return po_options_end(po_fail(
        PO_BAD_INPUT, "theory needs the name of a closed form: expected %s", PO_FORM_NAMES));
  if (!form)
    return po_options_end(po_form_refuse(name));
  status = complete_line(&line, form);
  if (!status)
    status = print_form(&line, form);
  return po_options_end(status);
}
