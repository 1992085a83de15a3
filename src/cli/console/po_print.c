#include "po_print.h"

#include <math.h>
#include <stdio.h>

#include "po_input.h"
#include "po_json.h"
#include "po_profile_table.h"
#include "po_result_rows.h"
#include "po_text.h"

void po_print_solver(const po_solver *solver, FILE *stream) {
  po_text command = {0};
  for (unsigned i = 0; i < solver->file->command_count; ++i) {
    po_text_add(&command, "%s", i ? " " : "");
    po_text_add_word(&command, solver->command[i]);
  }
  fprintf(stream, "solver   %s (%s)", solver->name, solver->path.text);
  if (solver->knob)
    fprintf(stream, ", %s %s", solver->file->knob->name, solver->knob);
  fprintf(stream, "\ncommand  %s\n", po_text_string(&command));
  po_text_clear(&command);
}

po_status po_print_document(json_t *document) {
  po_text text = {0};
  po_json_print(document, &text);
  json_decref(document);
  return po_text_print(&text);
}

po_status po_print_digest(json_t *document) {
  if (!document)
    return PO_NO_MEMORY;
  printf("digest   %s\n", json_string_value(json_object_get(document, "digest")));
  json_decref(document);
  return PO_OK;
}

po_status po_print_json(const po_request *request, const po_texts *given, const po_result *result) {
  json_t *document = po_json_document(request, result);
  if (request->in_si)
    po_json_set(&document, "physical", po_json_physical(given, request, result));
  return po_print_document(document);
}

static void print_special_points(const po_special_point *list, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    char of_approach[16], of_load[16];
    printf("%-9s %16.10f %8s %16.10f %8s %14.8g %14d", PO_SPECIAL_KINDS[list[i].kind],
           list[i].approach, po_print_error(list[i].approach_error, of_approach), list[i].load,
           po_print_error(list[i].load_error, of_load), list[i].contact_radius,
           list[i].unstable_modes);
    if (list[i].has_base)
      printf(" %8d", list[i].base_modes);
    printf("\n");
  }
}

/* Where and why the trace ended. */
static void print_ended(const po_result *o) {
  static const char *const WHY[] = {
      [PO_END_COMPRESSED] = "the smooth profile is stable under compression; no harder preload "
                            "changes the pull-off",
      [PO_END_PRELOAD] = "loading reached the preload",
      [PO_END_COMPLETE] = "no later minimum of the load can be deeper",
      [PO_END_SEARCHED] = "the search beyond the preload stopped without certainty",
      [PO_END_ASKED] = "the trace reached approach_end"};
  if (o->ended.cause == PO_END_NONE)
    return;
  printf("ended    at approach %.6g, load %.6g: %s\n", o->ended.approach, o->ended.load,
         WHY[o->ended.cause]);
}

static void print_pull_off(const po_request *request, const po_result *o) {
  if (!o->has_pull_off)
    return;
  printf("pull-off force %.10g at approach %.10g, contact radius %.8g", o->pull_off.force,
         o->pull_off.approach, o->pull_off.contact_radius);
  if (!isnan(o->pull_off.contact_radius_other))
    printf(" or %.8g (the error does not decide whether a crest is in contact)",
           o->pull_off.contact_radius_other);
  printf("\n");
  if (isfinite(o->pull_off.force_error))
    printf("errors   force %.1e, approach %.1e, contact radius %.1e\n", o->pull_off.force_error,
           o->pull_off.approach_error, o->pull_off.contact_radius_error);
  else if (request->mesh.scheme != PO_PANEL)
    printf("errors   not estimated with the scheme %s; expected panel\n",
           PO_SCHEMES[request->mesh.scheme]);
  if (o->pull_off.excess > 1.0)
    printf("warning  the error of the force is %.2g times the tolerance: expected a larger "
           "tolerance%s\n",
           o->pull_off.excess,
           o->pull_off.far_force_error > 0.5 * o->pull_off.force_error ? " or an outer radius"
                                                                       : "");
}

/* With which ranges of the attraction the pull-off was found, if not with the true one. */
static void print_range(const po_result *o) {
  if (o->range.is_reduced)
    printf("range    %.4g to %.4g times as great; the limit at the true one, %+.1e from the "
           "least, is stated with its error\n",
           o->range.least, o->range.greatest, o->range.change);
}

/* A line if the contact at pull-off is too wide for a parabola in place of a sphere. */
static void print_parabola(const po_request *request, const po_result *o) {
  const po_scene *scene = &request->scene;
  const double ratio = po_request_wide_contact(request, o);
  if (!request->theories || !(ratio > 0.0))
    return;
  printf("sphere   the contact radius is %.3g R, where the parabola r^2/(2R) is no sphere", ratio);
  const double excess = request->theories->parabola_excess(scene);
  if (isfinite(excess))
    printf(": by JKR theory the force of the parabola is that of the sphere %+.0f %%",
           100.0 * excess);
  printf("; --profile exact_sphere:%.6g is the sphere\n",
         scene->radius * (request->in_si ? request->units.length : 1.0));
}

/* The derivatives of the pull-off force by the inputs, as changes in percent. A profile without a
 * radius has the coupling C as input; with tabor = (C^2 R)^(1/3). */
static void print_sensitivity(const po_request *request, const po_result *o) {
  if (!o->has_pull_off || !o->pull_off.has_sensitivity)
    return;
  const po_sensitivity *s = &o->pull_off.sensitivity;
  const bool sphere = po_profile_is_sphere(&request->scene.profile);
  const bool one_wave = po_scene_waves(&request->scene) == 1;
  printf("inputs   1 %% more %s changes the force by %.4g %%", sphere ? "tabor" : "coupling",
         po_print_percent(sphere ? s->tabor : 2.0 / 3.0 * s->tabor));
  if (one_wave)
    printf(", amplitude %.4g %%, wavelength %.4g %%", po_print_percent(s->amplitude),
           po_print_percent(s->wavelength));
  if (sphere)
    printf(", radius %.4g %%", po_print_percent(s->radius));
  printf("\n");
}

/* Whether a preload is known whose pull-off force is greater than that of the declared preload, by
 * more than the errors of both. */
static bool gives_more(const po_result *o) {
  return o->pull_off_any.is_known &&
         o->pull_off_any.force - o->pull_off.force >
             fmax(o->pull_off.force_error, 0.0) + fmax(o->pull_off_any.force_error, 0.0);
}

/* What is known about preloads that are harder than the declared one. */
static void print_harder(const po_result *o) {
  const po_preload *until = &o->pull_off.until;
  const bool reversal = !gives_more(o) && !isnan(until->approach);
  if (!o->pull_off_any.is_known && !reversal)
    return;
  printf("harder   ");
  if (gives_more(o))
    printf("loading beyond approach %.6g (load %.6g) gives the pull-off force %.7g",
           o->pull_off_any.pressed.approach, o->pull_off_any.pressed.load, o->pull_off_any.force);
  else if (reversal)
    printf("beyond approach %.4g the tension is greatest where loading is reversed",
           until->approach);
  if (o->pull_off_any.is_known) {
    printf("%s", gives_more(o) || reversal ? "; " : "");
    if (o->pull_off_any.complete)
      printf("no harder preload gives a greater pull-off force");
    else
      printf("preloads beyond approach %.6g (load %.6g) were not examined",
             o->pull_off_any.searched.approach, o->pull_off_any.searched.load);
  }
  printf("\n");
}

/* Which preloads give the pull-off, and what harder preloads give. */
static void print_preload(const po_result *o) {
  if (!o->has_pull_off || o->status)
    return;
  const po_preload *from = &o->pull_off.pressed, *until = &o->pull_off.until;
  if (isnan(from->approach) && o->range.is_reduced) {
    print_harder(o);
    return;
  }
  printf("preload  ");
  if (isnan(from->approach))
    printf("no test at given approach measures this minimum of the load\n");
  else if (isnan(until->approach))
    printf("loading beyond approach %.6g gives this pull-off\n", from->approach);
  else
    printf("loading to an approach between %.6g and %.4g gives this pull-off\n", from->approach,
           until->approach);
  print_harder(o);
}

static void print_diagnostics(const po_result *o) {
  const po_diagnostics *d = &o->diagnostics;
  if (!d->states && !d->moved.solves)
    return;
  char text[16];
  printf("checks   ");
  if (isfinite(d->residual))
    printf("residual of the discrete equations %s; ", po_print_error(d->residual, text));
  printf("defect of the energy balance %s", po_print_error(d->energy_defect, text));
  if (isfinite(d->moved.change))
    printf("; relative change of the force by the last bit of an input %s",
           po_print_error(d->moved.change, text));
  printf("\n");
  if (d->reverse_trace.made)
    printf("reverse  status %s: the reverse trace found %s special points\n",
           po_status_name(d->reverse_trace.status),
           d->reverse_trace.same ? "the same" : "different");
}

/* Whether the line of the scene has a key. The smooth sphere has an amplitude, 0, there. */
static bool is_printed(const po_request *request, po_key key) {
  switch (key) {
  case PO_KEY_AMPLITUDE:
    return po_scene_waves(&request->scene) < 2;
  case PO_KEY_RANGE:
    return request->range != PO_RANGE_AUTO;
  case PO_KEY_RADIUS: /* of reference, epsilon, of a profile that is not a sphere */
    return !po_input_has_coupling(request);
  case PO_KEY_WAVELENGTH:
  case PO_KEY_WAVES:
  case PO_KEY_PROFILE:
  case PO_KEY_PROFILE_FILE:
  case PO_KEY_TABLE_SCALE:
  case PO_KEY_SMOOTH:
    return !po_key_is_idle(request, key);
  default:
    return !isnan(po_key_number(request, key)) && !po_key_is_of_other_scheme(request, key);
  }
}

/* Uncertainty of a table, eps, from which on it may move a force by a percent. */
static const double NOISY = 0.02;

/* A line for the noise of a smoothed table, or one that recommends to smooth it; nothing if the
 * rows determine the table well. */
static void print_smoothing(const po_profile *profile) {
  const po_smoothing *s = &profile->table->smoothing;
  if (!s->knots && profile->table->uncertainty > NOISY)
    printf("         rows with noise are smoothed with its standard deviation, --smooth SIGMA or "
           "auto\n");
  if (!s->knots)
    return;
  const double unit = profile->table->scale;
  printf("smoothed noise %.4g of the rows %s, residuals %.4g; removed: rms %.4g, greatest %.4g, in "
         "%s; %.1f of %zu parameters are left\n",
         s->deviation / unit, isinf(profile->table->smooth) ? "estimated" : "stated",
         s->residual / unit, s->rms / unit, s->greatest / unit,
         profile->table->in_metres ? "m" : "the unit of the file", s->parameters, s->points);
}

static void print_table(const po_profile *profile) {
  const po_profile_table *table = profile->table;
  printf(
      "table    %zu rows to radius %.6g, beyond which the gap is continued as r^%.4g; its spline "
      "is uncertain by %.1e epsilon\n",
      po_profile_table_points(table), po_profile_shape(profile).end,
      po_profile_shape(profile).growth, table->uncertainty);
  print_smoothing(profile);
}

/* Prints the value of a key. Numbers of a scene in SI units have a rounding error: one that is the
 * number that its first 15 digits state, but for that error, is shown by these, and the same number
 * in the JSON document is exact. */
static void print_key(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]) {
  char rounded[PO_NUMBER_LENGTH];
  po_key_print(request, key, text);
  if (!request->in_si || !po_key_is_number(key))
    return;
  snprintf(rounded, sizeof rounded, "%.15g", po_key_number(request, key));
  if (po_key_matches(request, key, rounded))
    snprintf(text, PO_KEY_TEXT_LENGTH, "%s", rounded);
}

/* The scene, defaults included, and the units of all numbers below. */
static void print_input(const po_request *request) {
  printf("scene   ");
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char text[PO_KEY_TEXT_LENGTH];
    if (!is_printed(request, key))
      continue;
    const bool coupling = key == PO_KEY_TABOR && po_input_has_coupling(request);
    const po_key shown = coupling ? PO_KEY_COUPLING : key;
    if (coupling)
      snprintf(text, sizeof text, "%.15g", po_key_number(request, shown));
    else
      print_key(request, shown, text);
    printf(" %s %s", PO_KEYS[shown].name, text);
  }
  printf("\nunits    lengths in epsilon, load and force in %s; the load is > 0 in compression\n",
         po_input_load_unit(request));
  if (po_profile_is_table(&request->scene.profile))
    print_table(&request->scene.profile);
}

/* The theories of the line, at most so many, the nearest one first. Of two with the same force the
 * first one is named, which is the simpler one: in the limit of large Tabor parameters JKR, not
 * Maugis-Dugdale. */
static const po_theory KNOWN[] = {PO_THEORY_JKR, PO_THEORY_MAUGIS, PO_THEORY_GUDURU, PO_THEORY_DMT,
                                  PO_THEORY_RIGID};
enum { KNOWN_COUNT = sizeof KNOWN / sizeof *KNOWN, MOST_NAMED = 3 };
static const double SAME = 1e-6;

/* Inserts a row by its deviation, unless one with the same force is there. */
static void insert_theory(const po_theory_row *row, const po_theory_row *sorted[], size_t *count) {
  size_t at = *count;
  for (size_t k = 0; k < *count; ++k)
    if (fabs(sorted[k]->force - row->force) <= SAME * row->force)
      return;
  for (; at > 0 && fabs(sorted[at - 1]->deviation) > fabs(row->deviation); --at)
    sorted[at] = sorted[at - 1];
  sorted[at] = row;
  ++*count;
}

/* One line with the deviations of the best known theories; nothing without any. */
static void print_theories(const po_result *result) {
  const po_theory_row *sorted[KNOWN_COUNT];
  size_t count = 0;
  for (size_t k = 0; k < KNOWN_COUNT && result->theory_count == PO_THEORY_OF_RATE; ++k)
    if (isfinite(result->theories[KNOWN[k]].deviation))
      insert_theory(&result->theories[KNOWN[k]], sorted, &count);
  for (size_t k = 0; k < count && k < MOST_NAMED; ++k)
    printf("%s%s %+.1f %%", k ? ", " : "theories ", PO_THEORIES[sorted[k]->theory].words,
           100.0 * sorted[k]->deviation);
  if (count)
    printf("; pulloff compare says more\n");
}

/* The lines of a viscoelastic body that is loaded at a speed. */
static void print_loading(const po_request *request, const po_rate_loading *l) {
  if (!l->is_known)
    return;
  const po_rate_energy *start = &l->start.energy, *error = &l->error;
  /* slow unloading starts at the relaxed contact, whatever the dwell */
  const double held = request->unload_speed > 0.0 ? request->dwell : (double)INFINITY;
  char dwell[PO_NUMBER_LENGTH];
  printf("loaded   at speed %g epsilon/tau_0 from approach %.8g, with %zu %s of the contact; then "
         "held for %s tau_0\n",
         request->load_speed, l->start.approach, l->jumps,
         po_one_or_more(l->jumps, "jump", "jumps"),
         po_number_or("%.8g", held, "infinitely many", dwell));
  printf("         work %.8g +- %.1e, dissipated %.8g +- %.1e, in jumps %.8g +- %.1e, in %s "
         "epsilon\n",
         0.0 - start->work, error->work, 0.0 - start->dissipated, error->dissipated,
         0.0 - start->jumps, error->jumps, po_input_load_unit(request));
}

/* The lines of a viscoelastic body. */
static void print_unloading(const po_request *request, const po_result *o) {
  const po_rate *r = &o->rate;
  if (!r->is_known)
    return;
  const po_rate_energy *end = &r->end.energy, *begin = &r->begin.energy, *error = &r->end_error;
  char time[PO_NUMBER_LENGTH];
  print_loading(request, &r->loading);
  printf(
      "unloaded at speed %g epsilon/tau_0 from approach %.8g, load %.8g; pull-off after %s tau_0, "
      "with %zu %s of the contact in all\n",
      r->speed, r->begin.approach, r->begin.load,
      po_number_or("%.8g", r->time, isinf(r->speed) ? "0" : "infinitely many", time), r->jumps,
      po_one_or_more(r->jumps, "jump", "jumps"));
  if (request->creep.kind == PO_CREEP_SLS)
    printf(
        "material deforms in tau_0 under a held load; a held deformation relaxes in %.6g tau_0\n",
        request->creep.ratio);
  printf("base     does the work %.8g +- %.1e until approach %.6g, in %s epsilon\n", end->work,
         error->work, r->end.approach, po_input_load_unit(request));
  printf("losses   dissipated %.8g +- %.1e, in jumps %.8g +- %.1e\n", end->dissipated,
         error->dissipated, end->jumps, error->jumps);
  printf("energies stored from %.8g to %.8g +- %.1e, adhesive from %.8g to %.8g +- %.1e",
         begin->stored, end->stored, error->stored, begin->adhesive, end->adhesive,
         error->adhesive);
  if (!isnan(request->stiffness))
    printf(", spring from %.8g to %.8g", begin->spring, end->spring);
  printf(
      "\ntime     %zu steps, %zu %s; error of the force by steps %.1e, by panels %.1e; imbalance "
      "%.1e\n",
      r->steps, r->terms, po_one_or_more(r->terms, "retardation time", "retardation times"),
      r->time_part, r->mesh_part, r->imbalance);
}

void po_print_summary(const po_request *request, const po_result *result) {
  print_input(request);
  printf("status   %s%s%s\n", po_status_name(result->status),
         result->rigid ? ", solved as rigid" : "",
         result->has_pull_off ? "" : ", no pull-off found");
  print_pull_off(request, result);
  print_range(result);
  print_parabola(request, result);
}

/* Time beside the trace that is said, s. */
static const double LONG_BESIDE = 5.0;

po_status po_print_text(const po_request *request, const po_texts *given, const po_result *result) {
  po_print_summary(request, result);
  po_print_uncertain(result, 1.0, po_input_load_unit(request));
  print_sensitivity(request, result);
  if (!result->rate.is_known) {
    print_preload(result);
    print_ended(result);
  }
  print_unloading(request, result);
  if (!result->rate.is_known) /* they are elastic */
    print_theories(result);
  if (result->fold_count + result->extremum_count) {
    printf("%-9s %16s %8s %16s %8s %14s %14s%s\n", "point", "approach", "error", "load", "error",
           "contact radius", "unstable modes", isnan(request->stiffness) ? "" : "  at base");
    print_special_points(result->folds, result->fold_count);
    print_special_points(result->extrema, result->extremum_count);
  }
  if (!request->in_si)
    po_print_loading(request, result);
  print_diagnostics(result);
  if (request->in_si) {
    po_print_physical(given, request, result);
    po_print_loading(request, result);
  }
  const size_t points = (size_t)result->work.points,
               iterations = (size_t)result->work.newton_iterations,
               factorizations = (size_t)result->work.factorizations,
               nodes = (size_t)result->work.factorized_nodes;
  printf("work     %zu %s, %zu Newton %s, %zu %s of at most %zu %s, %.3g s", points,
         po_one_or_more(points, "point", "points"), iterations,
         po_one_or_more(iterations, "iteration", "iterations"), factorizations,
         po_one_or_more(factorizations, "factorisation", "factorisations"), nodes,
         po_one_or_more(nodes, "node", "nodes"), result->work.seconds);
  if (result->seconds_beside > LONG_BESIDE)
    printf(", of which %.3g s for the theories and solves beside it", result->seconds_beside);
  printf("\n");
  po_result wanted = *result;
  if (!(request->want & PO_WANT_THEORIES)) /* those of the line are no result */
    wanted.theory_count = 0;
  return po_print_digest(po_json_document(request, &wanted));
}
