#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_bradley.h"
#include "po_estimates.h"
#include "po_guduru.h"
#include "po_json.h"
#include "po_number.h"
#include "po_options.h"
#include "po_verbs.h"
#include "po_wavy_rigid.h"

static const char HELP[] =
    "Usage: pulloff theory NAME [OPTION]...\n"
    "Prints a closed form of the paper. NAME is one of bradley, rigid, jkr, guduru, kesari-lew,\n"
    "persson-tosatti, rumpf-rabinowicz, compactness, crest, lennard-jones.\n"
    "Lengths in units of the equilibrium distance epsilon; load in pi w R, compressive > 0.\n\n"
    "  --tabor MU           Tabor parameter (1)\n"
    "  --amplitude A        of the waviness\n"
    "  --wavelength L       of the waviness\n"
    "  --radius R           of the sphere (100)\n"
    "  --alpha ALPHA        A R/L^2, in place of the wavelength (rigid, rumpf-rabinowicz)\n"
    "  --approach D         the load there, too (bradley, rigid)\n"
    "  --contact-radius A   load and approach there, too (jkr, guduru, kesari-lew)\n"
    "  --json               one JSON document on standard output, nothing else\n"
    "  --help               this text\n\n"
    "Example: pulloff theory guduru --tabor 5 --amplitude 10 --wavelength 20 --radius 100 --json\n";

enum { TABOR = 1, AMPLITUDE, WAVELENGTH, RADIUS, ALPHA, APPROACH, CONTACT, FLAGS, JSON };

static const struct option OPTIONS[] = {{"tabor", required_argument, NULL, TABOR},
                                        {"amplitude", required_argument, NULL, AMPLITUDE},
                                        {"wavelength", required_argument, NULL, WAVELENGTH},
                                        {"radius", required_argument, NULL, RADIUS},
                                        {"alpha", required_argument, NULL, ALPHA},
                                        {"approach", required_argument, NULL, APPROACH},
                                        {"contact-radius", required_argument, NULL, CONTACT},
                                        {"json", no_argument, NULL, JSON},
                                        {"help", no_argument, NULL, PO_OPTION_HELP},
                                        {NULL, 0, NULL, 0}};

typedef struct {
  double value[FLAGS]; /* NaN: not given */
  po_scene scene;
  double alpha;
  json_t *out;
} theory_line;

static void put(theory_line *l, const char *key, double value) {
  json_object_set_new(l->out, key, po_json_number(value));
}

static void put_contact(theory_line *l, const char *prefix, po_contact c) {
  char key[64];
  snprintf(key, sizeof key, "%sload", prefix);
  put(l, key, c.load);
  snprintf(key, sizeof key, "%sapproach", prefix);
  put(l, key, c.approach);
  snprintf(key, sizeof key, "%scontact_radius", prefix);
  put(l, key, c.contact_radius);
}

static void put_pull_off(theory_line *l, double force, double approach) {
  put(l, "pull_off_force", force);
  put(l, "pull_off_approach", approach);
}

static void bradley(theory_line *l) {
  put_pull_off(l, 2.0, 0.0);
  if (!isnan(l->value[APPROACH]))
    put(l, "load", po_bradley_load(l->value[APPROACH]));
}

static void rigid(theory_line *l) {
  const po_rigid_pull_off p = po_wavy_rigid_pull_off(l->scene.amplitude, l->alpha);
  put_pull_off(l, p.force, p.approach);
  if (!isnan(l->value[APPROACH]))
    put(l, "load", po_wavy_rigid_load(l->scene.amplitude, l->alpha, l->value[APPROACH]));
}

static void jkr(theory_line *l) {
  const po_contact p = po_jkr_pull_off(&l->scene);
  put_pull_off(l, -p.load, p.approach);
  put(l, "pull_off_contact_radius", p.contact_radius);
  put_contact(l, "last_", po_jkr_last(&l->scene));
  if (!isnan(l->value[CONTACT]))
    put_contact(l, "", po_jkr_at(&l->scene, l->value[CONTACT]));
}

static void guduru(theory_line *l) {
  const po_contact p = po_guduru_pull_off(&l->scene);
  put_pull_off(l, -p.load, p.approach);
  put(l, "pull_off_contact_radius", p.contact_radius);
  if (!isnan(l->value[CONTACT]))
    put_contact(l, "", po_guduru_at(&l->scene, l->value[CONTACT]));
}

static void kesari_lew(theory_line *l) {
  put(l, "johnson_parameter", po_johnson_parameter(&l->scene));
  put(l, "effective_work", po_kesari_lew_work(&l->scene));
  put(l, "pull_off_force", 1.5 * po_kesari_lew_work(&l->scene));
  if (isnan(l->value[CONTACT]))
    return;
  put_contact(l, "lower_", po_kesari_lew_edge(&l->scene, l->value[CONTACT], -1));
  put_contact(l, "upper_", po_kesari_lew_edge(&l->scene, l->value[CONTACT], 1));
}

static void persson_tosatti(theory_line *l) {
  put(l, "johnson_parameter", po_johnson_parameter(&l->scene));
  put(l, "area_ratio", po_persson_tosatti_area(&l->scene));
  put(l, "area_ratio_printed", po_persson_tosatti_area_printed(&l->scene));
  put(l, "effective_work", po_persson_tosatti_work(&l->scene));
  put(l, "effective_work_with_area", po_persson_tosatti_work_with_area(&l->scene));
}

static void rumpf_rabinowicz(theory_line *l) {
  put(l, "part_of_bradley", po_rumpf_rabinowicz_ratio(l->alpha, l->scene.radius));
  put(l, "pull_off_force", po_rumpf_rabinowicz_force(l->alpha, l->scene.radius));
}

static void compactness(theory_line *l) {
  put(l, "bound", po_compactness_bound());
  put(l, "wavelength2_over_amplitude_radius", 1.0 / l->alpha);
  put(l, "critical_radius", po_compactness_radius(&l->scene));
}

static void crest(theory_line *l) {
  put(l, "crest_radius", po_crest_radius(&l->scene));
  put(l, "composite_radius", po_crest_composite_radius(&l->scene));
  put(l, "pull_off_force", po_crest_force(l->alpha));
}

static void lennard_jones(theory_line *l) {
  put(l, "peak_tension", po_lennard_jones_peak_tension());
  put(l, "peak_distance", po_lennard_jones_peak_distance());
}

enum { NEEDS_WAVES = 1, NEEDS_ALPHA = 2, NEEDS_AMPLITUDE = 4 };

static const struct {
  const char *name;
  void (*print)(theory_line *line);
  unsigned needs;
} NAMES[] = {{"bradley", bradley, 0},
             {"rigid", rigid, NEEDS_ALPHA | NEEDS_AMPLITUDE},
             {"jkr", jkr, 0},
             {"guduru", guduru, NEEDS_WAVES},
             {"kesari-lew", kesari_lew, NEEDS_WAVES},
             {"persson-tosatti", persson_tosatti, NEEDS_WAVES},
             {"rumpf-rabinowicz", rumpf_rabinowicz, NEEDS_ALPHA},
             {"compactness", compactness, NEEDS_WAVES},
             {"crest", crest, NEEDS_WAVES},
             {"lennard-jones", lennard_jones, 0}};
enum { NAME_COUNT = sizeof NAMES / sizeof *NAMES };

static po_status take(theory_line *l, int option) {
  double *value = &l->value[option];
  const char *name = OPTIONS[option - 1].name;
  if (!po_number_parse(optarg, value))
    return po_options_refuse(name, optarg, "a finite number");
  if (option == APPROACH)
    return *value < 1.0 ? PO_OK : po_options_refuse(name, optarg, "a finite number < 1");
  if (option == CONTACT)
    return *value >= 0.0 ? PO_OK : po_options_refuse(name, optarg, "a finite number >= 0");
  return *value > 0.0 ? PO_OK : po_options_refuse(name, optarg, "a finite number > 0");
}

/* The scene and alpha from what was given, and whether that is enough for `needs`. */
static po_status complete(theory_line *l, const char *name, unsigned needs) {
  const double *v = l->value;
  const bool waves = !isnan(v[AMPLITUDE]) && !isnan(v[WAVELENGTH]);
  l->scene = po_scene_default();
  l->scene.tabor = isnan(v[TABOR]) ? l->scene.tabor : v[TABOR];
  l->scene.radius = isnan(v[RADIUS]) ? l->scene.radius : v[RADIUS];
  l->scene.amplitude = isnan(v[AMPLITUDE]) ? 0.0 : v[AMPLITUDE];
  l->scene.wavelength = isnan(v[WAVELENGTH]) ? 0.0 : v[WAVELENGTH];
  l->alpha = isnan(v[ALPHA]) && waves ? po_scene_alpha(&l->scene) : v[ALPHA];
  if (needs & NEEDS_WAVES && !waves)
    return po_fail(PO_BAD_INPUT, "theory %s needs --amplitude and --wavelength", name);
  if (needs & NEEDS_AMPLITUDE && isnan(v[AMPLITUDE]))
    return po_fail(PO_BAD_INPUT, "theory %s needs --amplitude", name);
  if (needs & NEEDS_ALPHA && isnan(l->alpha))
    return po_fail(PO_BAD_INPUT, "theory %s needs --alpha, or --amplitude and --wavelength", name);
  if (!isnan(v[ALPHA]) && (!(needs & NEEDS_ALPHA) || !isnan(v[WAVELENGTH])))
    return po_fail(PO_BAD_INPUT, "--alpha is given to theory %s: expected --wavelength alone",
                   name);
  return PO_OK;
}

static po_status print(theory_line *l, int index, bool as_json) {
  l->out = json_object();
  if (as_json) {
    json_object_set_new(l->out, "schema", json_string("pulloff/1"));
    json_object_set_new(l->out, "theory", json_string(NAMES[index].name));
  }
  NAMES[index].print(l);
  po_text text = {0};
  po_status status = PO_OK;
  if (as_json) {
    status = po_json_print(l->out, &text);
  } else {
    const char *key;
    json_t *value;
    json_object_foreach(l->out, key, value) po_text_add(
        &text, "%-34s %.12g\n", key, json_is_null(value) ? NAN : json_number_value(value));
  }
  if (!status)
    fputs(po_text_string(&text), stdout);
  po_text_clear(&text);
  json_decref(l->out);
  return status;
}

int po_verb_theory(int argc, char **argv) {
  const po_options options = {"theory", HELP, OPTIONS, argc, argv};
  theory_line line = {.alpha = NAN};
  for (int i = 0; i < FLAGS; ++i)
    line.value[i] = NAN;
  bool as_json = false;
  po_status status = PO_OK;
  int option = 0;
  while (!status && (option = po_options_next(&options)) > 0) {
    if (option == PO_OPTION_HELP)
      return PO_EXIT_OK;
    if (option == JSON)
      as_json = true;
    else
      status = take(&line, option);
  }
  if (status || option == PO_OPTION_BAD)
    return po_options_end(PO_BAD_INPUT);
  const char *name = optind < argc ? argv[optind++] : "";
  int index = 0;
  while (index < NAME_COUNT && strcmp(name, NAMES[index].name) != 0)
    ++index;
  if (index == NAME_COUNT)
    return po_options_end(po_fail(PO_BAD_INPUT,
                                  "theory %.80s is unknown: expected bradley, rigid, jkr, guduru, "
                                  "kesari-lew, persson-tosatti, rumpf-rabinowicz, compactness, "
                                  "crest or lennard-jones",
                                  *name ? name : "without a name"));
  status = po_options_no_operands(&options);
  if (!status)
    status = complete(&line, name, NAMES[index].needs);
  if (!status)
    status = print(&line, index, as_json);
  return po_options_end(status);
}
