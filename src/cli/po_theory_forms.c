#include "po_theory_forms.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_bradley.h"
#include "po_estimates.h"
#include "po_guduru.h"
#include "po_json.h"
#include "po_wavy_rigid.h"

/* What a number is in units of; NONE: it has none. */
typedef enum { NONE, LENGTH, FORCE, WORK, TENSION } unit;

static void put(po_theory_line *l, unit of, const char *key, double value) {
  static const char *const SUFFIXES[] = {"", "m", "n", "j_per_m2", "pa"};
  json_object_set_new(l->out, key, po_json_number(value));
  if (!l->si || of == NONE)
    return;
  const po_units *u = &l->flags.units;
  const double size[] = {1, u->length, u->force, u->work, u->tension};
  char name[80];
  snprintf(name, sizeof name, "%s_%s", key, SUFFIXES[of]);
  json_object_set_new(l->si, name, po_json_number(value * size[of]));
}

static void put_contact(po_theory_line *l, const char *prefix, po_contact c) {
  char key[64];
  snprintf(key, sizeof key, "%sload", prefix);
  put(l, FORCE, key, c.load);
  snprintf(key, sizeof key, "%sapproach", prefix);
  put(l, LENGTH, key, c.approach);
  snprintf(key, sizeof key, "%scontact_radius", prefix);
  put(l, LENGTH, key, c.contact_radius);
}

static void put_pull_off(po_theory_line *l, double force, double approach) {
  put(l, FORCE, "pull_off_force", force);
  put(l, LENGTH, "pull_off_approach", approach);
}

static void bradley(po_theory_line *l) {
  put_pull_off(l, 2.0, 0.0);
  if (!isnan(l->flags.length[PO_LENGTH_APPROACH]))
    put(l, FORCE, "load", po_bradley_load(l->flags.length[PO_LENGTH_APPROACH]));
}

static void rigid(po_theory_line *l) {
  const po_rigid_pull_off p = po_wavy_rigid_pull_off(l->scene.amplitude, l->alpha);
  put_pull_off(l, p.force, p.approach);
  if (!isnan(l->flags.length[PO_LENGTH_APPROACH]))
    put(l, FORCE, "load",
        po_wavy_rigid_load(l->scene.amplitude, l->alpha, l->flags.length[PO_LENGTH_APPROACH]));
}

static void jkr(po_theory_line *l) {
  const po_contact p = po_jkr_pull_off(&l->scene);
  put_pull_off(l, -p.load, p.approach);
  put(l, LENGTH, "pull_off_contact_radius", p.contact_radius);
  put_contact(l, "last_", po_jkr_last(&l->scene));
  if (!isnan(l->flags.length[PO_LENGTH_CONTACT_RADIUS]))
    put_contact(l, "", po_jkr_at(&l->scene, l->flags.length[PO_LENGTH_CONTACT_RADIUS]));
}

static void guduru(po_theory_line *l) {
  const po_contact p = po_guduru_pull_off(&l->scene);
  put_pull_off(l, -p.load, p.approach);
  put(l, LENGTH, "pull_off_contact_radius", p.contact_radius);
  if (!isnan(l->flags.length[PO_LENGTH_CONTACT_RADIUS]))
    put_contact(l, "", po_guduru_at(&l->scene, l->flags.length[PO_LENGTH_CONTACT_RADIUS]));
}

static void kesari_lew(po_theory_line *l) {
  put(l, NONE, "johnson_parameter", po_johnson_parameter(&l->scene));
  put(l, WORK, "effective_work", po_kesari_lew_work(&l->scene));
  put(l, FORCE, "pull_off_force", 1.5 * po_kesari_lew_work(&l->scene));
  if (isnan(l->flags.length[PO_LENGTH_CONTACT_RADIUS]))
    return;
  put_contact(l, "lower_",
              po_kesari_lew_edge(&l->scene, l->flags.length[PO_LENGTH_CONTACT_RADIUS], -1));
  put_contact(l, "upper_",
              po_kesari_lew_edge(&l->scene, l->flags.length[PO_LENGTH_CONTACT_RADIUS], 1));
}

static void persson_tosatti(po_theory_line *l) {
  put(l, NONE, "johnson_parameter", po_johnson_parameter(&l->scene));
  put(l, NONE, "area_ratio", po_persson_tosatti_area(&l->scene));
  put(l, NONE, "area_ratio_printed", po_persson_tosatti_area_printed(&l->scene));
  put(l, WORK, "effective_work", po_persson_tosatti_work(&l->scene));
  put(l, WORK, "effective_work_with_area", po_persson_tosatti_work_with_area(&l->scene));
}

static void rumpf_rabinowicz(po_theory_line *l) {
  put(l, NONE, "part_of_bradley", po_rumpf_rabinowicz_ratio(l->alpha, l->scene.radius));
  put(l, FORCE, "pull_off_force", po_rumpf_rabinowicz_force(l->alpha, l->scene.radius));
}

static void compactness(po_theory_line *l) {
  put(l, NONE, "bound", po_compactness_bound());
  put(l, NONE, "wavelength2_over_amplitude_radius", 1.0 / l->alpha);
  put(l, LENGTH, "critical_radius", po_compactness_radius(&l->scene));
}

static void crest(po_theory_line *l) {
  put(l, LENGTH, "crest_radius", po_crest_radius(&l->scene));
  put(l, LENGTH, "composite_radius", po_crest_composite_radius(&l->scene));
  put(l, FORCE, "pull_off_force", po_crest_force(l->alpha));
}

static void lennard_jones(po_theory_line *l) {
  put(l, TENSION, "peak_tension", po_lennard_jones_peak_tension());
  put(l, LENGTH, "peak_distance", po_lennard_jones_peak_distance());
}

static const po_theory_form FORMS[] = {
    {"bradley", bradley, 0},
    {"rigid", rigid, PO_NEEDS_ALPHA | PO_NEEDS_AMPLITUDE},
    {"jkr", jkr, PO_NEEDS_ELASTIC},
    {"guduru", guduru, PO_NEEDS_WAVES | PO_NEEDS_ELASTIC},
    {"kesari-lew", kesari_lew, PO_NEEDS_WAVES | PO_NEEDS_ELASTIC},
    {"persson-tosatti", persson_tosatti, PO_NEEDS_WAVES | PO_NEEDS_ELASTIC},
    {"rumpf-rabinowicz", rumpf_rabinowicz, PO_NEEDS_ALPHA},
    {"compactness", compactness, PO_NEEDS_WAVES},
    {"crest", crest, PO_NEEDS_WAVES},
    {"lennard-jones", lennard_jones, 0}};

const po_theory_form *po_theory_find(const char *name) {
  for (size_t i = 0; i < sizeof FORMS / sizeof *FORMS; ++i)
    if (strcmp(name, FORMS[i].name) == 0)
      return &FORMS[i];
  return NULL;
}
