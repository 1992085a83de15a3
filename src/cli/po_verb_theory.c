#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_forms.h"
#include "po_json.h"
#include "po_json_digest.h"
#include "po_print.h"
#include "po_print_physical.h"
#include "po_scene_flags.h"
#include "po_use.h"
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
    "  rumpf-rabinowicz    rigid crest on a sphere (Eq 20)\n"
    "  compactness         whether the gap is monotonic (Eqs 3, 4)\n"
    "  crest               rigid central crest (Eqs 18, 19)\n"
    "  lennard-jones       traction-separation law (Eq 9)\n"
    "An option on which the closed form does not depend is refused. Lengths are in units of the\n"
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
    "  --approach D            the load at this approach, in epsilon, < 1 (bradley, rigid)\n"
    "  --contact-radius A      load and approach at this contact radius, in epsilon (jkr, maugis,\n"
    "                          guduru, kesari-lew)\n"
    "  --gap H                 the traction at this gap, H = h/epsilon - 1 > -1 (lennard-jones)\n"
    "  --json                  print one JSON document and nothing else\n"
    "  -h, --help              print this text\n"
    "\n";

static const char MORE_HELP[] = PO_SCENE_FLAGS_HELP
    "\n"
    "Example: pulloff theory guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100 --json\n"
    "Example: pulloff theory jkr --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 \\\n"
    "             --distance-m 3e-10 --radius-m 1e-7\n";

enum { ALPHA = PO_FLAG_NEXT, GAP, TENSION, JSON, LAW = PO_OPTION_KEYS + PO_KEY_LAW };

/* The options of one command line. */
typedef struct {
  po_scene_flags flags;
  po_scene scene;
  double alpha;   /* A R/lambda^2, given or of the scene; NAN: neither */
  double gap;     /* NAN: not given */
  double tension; /* NAN: not given */
  po_law law;
  bool has_law;
  bool json;
} po_theory_line;

/* Beside the options of keys. */
static const struct option OPTIONS[] = {
    {"alpha", required_argument, NULL, ALPHA},
    PO_LENGTH_OPTIONS("approach", PO_LENGTH_APPROACH),
    PO_LENGTH_OPTIONS("contact-radius", PO_LENGTH_CONTACT_RADIUS),
    {"gap", required_argument, NULL, GAP},
    {"tension", required_argument, NULL, TENSION},
    {"json", no_argument, NULL, JSON},
    {"help", no_argument, NULL, PO_OPTION_HELP},
    {NULL, 0, NULL, 0}};

static po_status take_option(void *to, int option) {
  po_theory_line *l = to;
  if (option < PO_FLAG_NEXT)
    return po_scene_flags_take(&l->flags, option);
  if (option == JSON) {
    l->json = true;
    return PO_OK;
  }
  if (option == GAP)
    return po_number_parse(optarg, &l->gap) && l->gap > -1.0
               ? PO_OK
               : po_options_refuse("gap", optarg, "a finite number > -1");
  if (option == LAW) {
    l->has_law = true;
    return po_law_set(&l->law, optarg) ? PO_OK : po_options_refuse("law", optarg, PO_LAW_EXPECTED);
  }
  if (option == TENSION)
    return po_number_parse(optarg, &l->tension) && l->tension > 0.0
               ? PO_OK
               : po_options_refuse("tension", optarg, "a finite number > 0");
  if (!po_number_parse(optarg, &l->alpha) || !(l->alpha > 0.0))
    return po_options_refuse("alpha", optarg, "a finite number > 0");
  return PO_OK;
}

static po_use use_of(const po_theory_line *l, po_length length, bool taken) {
  po_use use = {.given = !isnan(l->flags.length[length]), .taken = taken};
  po_scene_flags_name(&l->flags, length, use.name);
  return use;
}

/* Refuses options that have no effect on the form. */
static po_status check_use(const po_theory_line *l, const po_form *form) {
  const unsigned takes = po_form_takes(form, !isnan(l->alpha));
  char what[80];
  snprintf(what, sizeof what, "theory %s%s", form->name,
           takes != form->takes ? " with --alpha" : "");
  const po_use flags[] = {
      {"tabor", !isnan(l->flags.tabor), takes & PO_TAKES_TABOR && !l->flags.from_physical},
      {"coupling", !isnan(l->flags.coupling), takes & PO_TAKES_TABOR && !l->flags.from_physical},
      use_of(l, PO_LENGTH_AMPLITUDE, takes & PO_TAKES_AMPLITUDE),
      use_of(l, PO_LENGTH_WAVELENGTH, takes & PO_TAKES_WAVELENGTH),
      /* in SI units, the unit of force contains the radius */
      use_of(l, PO_LENGTH_RADIUS, takes & PO_TAKES_RADIUS || l->flags.from_physical),
      {"alpha", !isnan(l->alpha), takes & PO_TAKES_ALPHA},
      use_of(l, PO_LENGTH_APPROACH, form->variable == PO_FORM_AT_APPROACH),
      use_of(l, PO_LENGTH_CONTACT_RADIUS, form->variable == PO_FORM_AT_CONTACT_RADIUS),
      {"gap", !isnan(l->gap), form->variable == PO_FORM_AT_GAP},
      {"law", l->has_law, takes & PO_TAKES_LAW},
      {"tension", !isnan(l->tension), takes & PO_TAKES_TENSION},
      {"profile", l->flags.profile != NULL, takes & PO_TAKES_PROFILE},
      {"profile-file", l->flags.profile_file != NULL, takes & PO_TAKES_PROFILE},
      {"wave", l->flags.waves > 0, takes & PO_TAKES_PROFILE}};
  return po_use_check("--", what, flags, sizeof flags / sizeof *flags);
}

/* Whether profile, waves or law are given: the forms of any profile apply. */
static bool is_general(const po_theory_line *l, const po_form *form) {
  return l->flags.profile || l->flags.profile_file || l->flags.waves > 0 || l->has_law ||
         po_form_is_general(form, &l->scene);
}

static po_status check_elastic(const po_theory_line *l, const po_form *form) {
  if (!(form->needs & PO_NEEDS_ELASTIC) || l->scene.tabor > 0.0)
    return PO_OK;
  return l->flags.from_physical
             ? po_fail(PO_BAD_INPUT, "--modulus-pa is inf: expected a finite number > 0")
             : po_fail(PO_BAD_INPUT, "--%s is 0: expected a finite number > 0",
                       isnan(l->flags.coupling) ? "tabor" : "coupling");
}

/* Refuses values outside the domain of the form. */
static po_status check_values(const po_theory_line *l, const po_form *form) {
  const double approach = l->flags.length[PO_LENGTH_APPROACH];
  const po_status status = check_elastic(l, form);
  if (status)
    return status;
  if (approach >= 1.0 && l->flags.from_physical)
    return po_fail(PO_BAD_INPUT, "--approach-m is %g: expected less than --distance-m, %g",
                   l->flags.metres[PO_LENGTH_APPROACH], l->flags.distance);
  if (approach >= 1.0)
    return po_fail(PO_BAD_INPUT, "--approach is %g: expected a finite number < 1", approach);
  return PO_OK;
}

/* Computes the scene and alpha from the options, and refuses options that are missing. */
static po_status complete(po_theory_line *l, const po_form *form) {
  const bool given = !isnan(l->alpha);
  l->scene = po_scene_default();
  const po_status status =
      po_scene_flags_end(&l->flags, (form->needs & PO_NEEDS_ELASTIC) != 0, &l->scene);
  if (status)
    return status;
  const po_status idle = check_use(l, form);
  if (idle)
    return idle;
  l->scene.law = l->law;
  if (is_general(l, form)) {
    const po_status wrong = po_scene_check(&l->scene);
    return wrong ? wrong : check_elastic(l, form);
  }
  const double *length = l->flags.length;
  const bool smooth = length[PO_LENGTH_AMPLITUDE] == 0.0;
  const bool waves =
      smooth || (!isnan(length[PO_LENGTH_AMPLITUDE]) && !isnan(length[PO_LENGTH_WAVELENGTH]));
  char amplitude[32], wavelength[32];
  po_scene_flags_name(&l->flags, PO_LENGTH_AMPLITUDE, amplitude);
  po_scene_flags_name(&l->flags, PO_LENGTH_WAVELENGTH, wavelength);
  if (form->needs & PO_NEEDS_WAVES && !waves)
    return po_fail(PO_BAD_INPUT, "theory %s needs --%s and --%s", form->name, amplitude,
                   wavelength);
  if (form->needs & PO_NEEDS_AMPLITUDE && isnan(length[PO_LENGTH_AMPLITUDE]))
    return po_fail(PO_BAD_INPUT, "theory %s needs --%s", form->name, amplitude);
  if (form->needs & PO_NEEDS_ALPHA && !given && !waves)
    return po_fail(PO_BAD_INPUT, "theory %s needs --alpha, or --%s and --%s", form->name, amplitude,
                   wavelength);
  if (!given && waves)
    l->alpha = po_scene_alpha(&l->scene);
  return check_values(l, form);
}

static const char *unit_of(const char *key) {
  static const char *const UNITS[][2] = {
      {"_m", "m"}, {"_n", "N"}, {"_j_per_m2", "J/m^2"}, {"_pa", "Pa"}};
  const size_t length = strlen(key);
  for (size_t i = 0; i < sizeof UNITS / sizeof *UNITS; ++i) {
    const size_t suffix = strlen(UNITS[i][0]);
    if (length > suffix && strcmp(key + length - suffix, UNITS[i][0]) == 0)
      return UNITS[i][1];
  }
  return "";
}

/* An infinite value, such as the crest radius of a smooth sphere, is null in JSON and - here. */
static void print_number(const char *key, const json_t *value, const char *unit) {
  if (json_is_null(value))
    printf("%-34s -\n", key);
  else
    printf("%-34s %.12g%s%s\n", key, json_number_value(value), *unit ? " " : "", unit);
}

/* The document of the results, without those in SI units. Returned: NULL if memory runs out. */
static json_t *document_of(const char *name, json_t *out) {
  json_t *document =
      PO_JSON_OBJECT({"schema", po_json_text("pulloff/1")}, {"theory", po_json_text(name)});
  po_json_set_all(&document, json_incref(out));
  po_json_seal(&document);
  return document;
}

static po_status print_text(const po_theory_line *l, const char *name, json_t *out, json_t *si) {
  const char *key;
  json_t *value;
  if (si)
    po_print_physical_input(&l->flags);
  json_object_foreach(out, key, value) {
    print_number(key, value, "");
  }
  json_object_foreach(si, key, value) {
    print_number(key, value, unit_of(key));
  }
  return po_print_digest(document_of(name, out));
}

static po_status print_json(const po_theory_line *l, const char *name, json_t *out, json_t *si) {
  json_t *document = document_of(name, out);
  if (l->flags.from_physical) {
    json_t *physical = po_json_physical_input(&l->flags);
    po_json_set_all(&physical, json_incref(si));
    po_json_set(&document, "physical", physical);
  }
  return po_print_document(document);
}

/* The results by name, and those that have a unit also in SI units. */
static void fill(const po_theory_line *l, const po_form_values *values, json_t **out, json_t **si) {
  static const char *const SUFFIXES[] = {"", "m", "n", "j_per_m2", "pa"};
  const po_units *u = &l->flags.units;
  const double size[] = {1, u->length, u->force, u->work, u->tension};
  for (size_t i = 0; i < values->count; ++i) {
    const po_form_value *item = &values->items[i];
    po_json_set(out, item->name, po_json_number(item->value));
    if (!l->flags.from_physical || item->unit == PO_FORM_PURE)
      continue;
    char name[80];
    snprintf(name, sizeof name, "%s_%s", item->name, SUFFIXES[item->unit]);
    po_json_set(si, name, po_json_number(item->value * size[item->unit]));
  }
}

static po_status print(const po_theory_line *l, const po_form *form) {
  const double variables[] = {(double)NAN, l->flags.length[PO_LENGTH_APPROACH],
                              l->flags.length[PO_LENGTH_CONTACT_RADIUS], l->gap};
  const po_form_input input = {l->scene, l->alpha, variables[form->variable], l->tension,
                               is_general(l, form)};
  po_form_values values = {.count = 0};
  const po_status status = po_form_evaluate(form, &input, &values);
  if (status)
    return status;
  json_t *out = po_json_empty_object();
  json_t *si = l->flags.from_physical ? po_json_empty_object() : NULL;
  fill(l, &values, &out, &si);
  po_status printed = PO_NO_MEMORY;
  if (out && (si || !l->flags.from_physical))
    printed = l->json ? print_json(l, form->name, out, si) : print_text(l, form->name, out, si);
  json_decref(out);
  json_decref(si);
  return printed;
}

int po_verb_theory(int argc, char **argv) {
  const po_options options = {"theory", HELP, OPTIONS, argc, argv, MORE_HELP, PO_FOR_THEORY};
  po_theory_line line = {.flags = po_scene_flags_default(),
                         .alpha = NAN,
                         .gap = NAN,
                         .tension = NAN,
                         .law = po_law_lennard_jones()};
  po_status status = PO_OK;
  if (!po_options_read(&options, take_option, &line, &status))
    return po_options_end(status);
  const char *name = optind < argc ? argv[optind++] : "";
  const po_form *form = po_form_find(name);
  if (!form && !*name)
    return po_options_end(po_fail(
        PO_BAD_INPUT, "theory needs the name of a closed form: expected %s", PO_FORM_NAMES));
  if (!form)
    return po_options_end(po_form_refuse(name));
  status = po_options_no_operands(&options);
  if (!status)
    status = complete(&line, form);
  if (!status)
    status = print(&line, form);
  return po_options_end(status);
}
