#include "po_plan.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_quote.h"
#include "po_solve.h"
#include "po_text.h"

/* Adds a line to the description. */
static void __attribute__((format(printf, 2, 3))) say(json_t **lines, const char *format, ...) {
  char *printed = NULL, *line = NULL;
  va_list arguments;
  va_start(arguments, format);
  const int length = vasprintf(&printed, format, arguments);
  va_end(arguments);
  /* A reason may have several lines, and may have been truncated inside a character. */
  const size_t room = 4 * (size_t)length + 1;
  if (length < 0)
    po_fail(PO_NO_MEMORY, "no memory for the description of a plan");
  else if ((line = po_resize(NULL, room, 1)) != NULL)
    po_quote_text(printed, line, room);
  po_json_append(lines, po_json_take_text(line));
  if (length >= 0)
    free(printed);
}

static const char *scenes(size_t count) {
  return po_one_or_more(count, "scene", "scenes");
}

/* The numbers of points with certain properties. */
typedef struct {
  size_t points, rigid, smooth;
  size_t bounded; /* outer_radius is finite */
  size_t to_end;  /* approach_end is given */
  size_t creep;   /* viscoelastic */
  size_t loaded;  /* of these, loaded at a speed */
  size_t limits;  /* of these, at the speeds 0 and inf */
} point_counts;

static point_counts count_properties(const po_case *kase) {
  point_counts count = {.points = kase->point_count};
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_request *request = &kase->points[i].request;
    count.rigid += po_request_size(request).nodes ? 0 : 1;
    count.smooth += po_scene_is_wavy(&request->scene) ? 0 : 1;
    count.bounded += isfinite(request->scene.outer_radius) ? 1 : 0;
    const bool creeps = request->creep.kind != PO_CREEP_NONE;
    count.to_end += isnan(request->approach_end) || creeps ? 0 : 1;
    count.creep += creeps;
    const bool loaded = creeps && request->load_speed > 0.0;
    count.loaded += loaded;
    count.limits +=
        creeps && !loaded && (request->unload_speed == 0.0 || isinf(request->unload_speed));
  }
  return count;
}

static void tell_sample(const po_plan *plan, json_t **lines) {
  const po_sample_words *sample = plan->kase->file->sample;
  if (!sample)
    return;
  say(lines,
      "draw %zu scenes; each value depends on seed %s, the number of the scene and the name of "
      "its key:",
      sample->count, sample->seed_text);
  for (unsigned i = 0; i < sample->keys_count; ++i) {
    const po_draw *draw = &sample->keys[i];
    say(lines, "  %s from %s to %s%s%s, %s", draw->key, draw->from_text, draw->to_text,
        draw->times ? " times " : "",
        !draw->times    ? ""
        : draw->by_root ? "the square root of the radius"
                        : draw->times,
        draw->log ? "uniform in the logarithm" : "uniform");
  }
}

static void tell_marches(const point_counts *n, json_t **lines) {
  if (n->creep)
    say(lines,
        "solve %zu viscoelastic %s: each loaded slowly to the preload, and unloaded by three "
        "marches in time, whose differences bound the errors: one with half as long steps, and one "
        "on coarser panels",
        n->creep, scenes(n->creep));
  if (n->loaded)
    say(lines, "load %zu of these at a speed, too, in the same marches", n->loaded);
  if (n->limits)
    say(lines, "no steps in time for %zu of these: at the speeds 0 and inf the body is elastic",
        n->limits);
}

static void tell_scenes(const po_plan *plan, json_t **lines) {
  const po_case *kase = plan->kase;
  const po_traced_words *traced = kase->file->traced;
  const point_counts n = count_properties(kase);
  const size_t elastic = n.points - n.rigid, unbounded = n.points - n.bounded;
  const size_t traced_whole = n.points - n.creep;
  const bool series = kase->series_length > 1 && traced_whole;
  if (traced_whole)
    say(lines, "solve %zu %s: each traced as one branch from large separation%s", traced_whole,
        scenes(traced_whole), series ? ", or computed by parameter continuation" : "");
  tell_marches(&n, lines);
  if (series)
    say(lines,
        "continue the pull-off in %s along %zu series of %zu scenes; every %zu scenes one is "
        "traced as a checkpoint, and further scenes where checkpoints contradict the continuation "
        "between them",
        kase->file->follow, n.points / kase->series_length, kase->series_length, kase->checkpoints);
  if (traced)
    say(lines,
        "trace %s scenes between checkpoints in addition, drawn with seed %s, and compare them "
        "with the continuation",
        traced->count_text, traced->seed_text);
  if (n.rigid)
    say(lines,
        "no influence matrix for %zu rigid %s: elasticity would change the load by less than 1e-8",
        n.rigid, scenes(n.rigid));
  if (elastic)
    say(lines, "one influence matrix for each of %zu %s %s", elastic,
        n.creep ? "deformable" : "elastic", scenes(elastic));
  if (n.smooth)
    say(lines, "no waviness for %zu smooth %s: amplitude is 0", n.smooth, scenes(n.smooth));
  if (unbounded)
    say(lines, "add the load beyond the mesh for %zu %s: outer_radius is inf", unbounded,
        scenes(unbounded));
  if (n.to_end < traced_whole)
    say(lines, plan->want & PO_WANT_PRELOAD
                   ? "end each branch where no harder preload gives a greater pull-off force"
                   : "end each branch at the preload: the case does not want other preloads");
  if (n.to_end)
    say(lines, "trace %zu %s up to approach_end", n.to_end,
        po_one_or_more(n.to_end, "branch", "branches"));
}

static void tell_left_out(const po_plan *plan, json_t **lines) {
  for (unsigned i = 0; i < plan->kase->file->leave_out_count; ++i) {
    const po_leave_out *rule = &plan->kase->file->leave_out[i];
    say(lines, "leave out %zu %s: %.250s", rule->points, scenes(rule->points), rule->because);
  }
}

static void tell_wants(const po_plan *plan, json_t **lines) {
  const po_case *kase = plan->kase;
  const po_case_file *file = kase->file;
  const point_counts n = count_properties(kase);
  if (n.creep)
    say(lines,
        "find of each viscoelastic scene: pull-off, energies and losses; no folds or extrema");
  if (n.creep < n.points)
    say(lines, kase->series_length > 1
                   ? "no folds or extrema: parameter continuation delivers only the pull-off"
                   : "find on each branch: pull-off, folds, extrema of the load");
  if (plan->want & PO_WANT_CURVE)
    say(lines, "keep the points of the branch: %s",
        kase->want & PO_WANT_CURVE ? "the case wants the curve" : "the curve is compared");
  else
    say(lines, "no curves: neither the case nor a check needs them");
  say(lines, plan->want & PO_WANT_PROFILE
                 ? "keep gap and traction at pull-off: the case wants the profile"
                 : "no profiles: the case does not want them");
  if (plan->want & PO_WANT_HYSTERESIS)
    say(lines,
        "simulate loading and unloading, at given approach and at given load: the case wants "
        "the hysteresis");
  if (plan->want & PO_WANT_LOOP)
    say(lines, "keep the states of loading and unloading: the case wants the loop");
  if (plan->want & PO_WANT_PRELOAD)
    say(lines, "find the pull-off for every preload: the case wants the staircase");
  if (plan->want & PO_WANT_THEORIES)
    say(lines, "evaluate the theories: the case wants them");
  say(lines, plan->want & PO_WANT_DIAGNOSTICS
                 ? "diagnose each scene, and solve it again with the last bit of each input "
                   "increased and decreased"
                 : "no diagnostics: neither the case nor a check needs them");
  if (kase->repeats > 1)
    say(lines,
        "repeat each solve %u times, one solve at a time, in rounds over all points: the case "
        "measures times",
        kase->repeats);
  for (unsigned i = 0; i < file->lines_count; ++i)
    say(lines, "evaluate the closed form %.40s along a sweep, for line %.60s",
        file->lines[i].theory, file->lines[i].name);
  if (file->figure_script)
    say(lines, "figure by script %s", file->figure_script);
  else
    say(lines, "no figure: the case names no script");
}

/* Reports whether the reference has a value of the quantity of a check for a scene. */
static bool is_covered(const po_reference *reference, const po_check *check,
                       const po_request *solved) {
  const po_request asked = po_check_request(check, solved), *request = &asked;
  po_reference_number number;
  po_special_point *points = NULL;
  size_t count = 0, row = 0;
  if (check->quantity == PO_SOLVED_SHARE || reference->type == PO_REFERENCE_TRACED)
    return true;
  if (po_quantity_is_steps(check->quantity))
    return po_reference_next_row(reference, request, &row);
  if (check->quantity <= PO_FOLD_COUNT)
    return po_reference_find(reference, check->quantity, request, &number) == PO_OK;
  const po_status status =
      po_reference_points(reference, check->quantity, request, NULL, &points, &count);
  free(points);
  return status == PO_OK;
}

/* Counts the points to which a check applies, and those of them for which the reference has a
 * value. */
static void count_points(const po_case *kase, const po_check *check, const po_reference *reference,
                         size_t *concerned, size_t *covered) {
  for (size_t k = 0; k < kase->point_count; ++k)
    if (po_check_concerns(check, &kase->points[k].request) &&
        (kase->points[k].traced || reference->type != PO_REFERENCE_TRACED)) {
      *concerned += 1;
      *covered += is_covered(reference, check, &kase->points[k].request);
    }
}

static void tell_measures(const po_plan *plan, json_t **lines) {
  const po_case *kase = plan->kase;
  for (unsigned i = 0; i < kase->file->measure_count; ++i) {
    const po_check *measure = &kase->file->measure[i];
    size_t concerned = 0, covered = 0;
    count_points(kase, measure, &plan->references[kase->file->checks_count + i], &concerned,
                 &covered);
    say(lines, "measure the error of %s against %s at %zu of %zu %s, without a verdict",
        measure->quantity_text, measure->reference, concerned, kase->point_count,
        po_one_or_more(kase->point_count, "point", "points"));
    if (covered < concerned)
      say(lines, "  but %s has no value for %zu of these", measure->reference, concerned - covered);
  }
}

static void tell_checks(const po_plan *plan, json_t **lines) {
  const po_case *kase = plan->kase;
  if (!kase->file->checks_count && !kase->file->measure_count)
    say(lines, "nothing is compared: the case has no checks");
  for (unsigned i = 0; i < kase->file->checks_count; ++i) {
    const po_check *check = &kase->file->checks[i];
    const po_reference *reference = &plan->references[i];
    if (reference->type == PO_REFERENCE_ABSENT) {
      say(lines, "leave out %s against %s: the file does not exist; its stand-in is %s",
          check->quantity_text, check->reference, check->stand_in);
      continue;
    }
    size_t concerned = 0, covered = 0;
    count_points(kase, check, reference, &concerned, &covered);
    say(lines, "compare %s with %s at %zu of %zu %s, tolerance %s %s", check->quantity_text,
        reference->name, concerned, kase->point_count,
        po_one_or_more(kase->point_count, "point", "points"), check->tolerance_text,
        check->kind_text);
    if (covered < concerned)
      say(lines, "  but %s has no value for %zu of these", reference->name, concerned - covered);
  }
}

/* Marks the rows of the table of a check that belong to its points. */
static void mark_rows(const po_case *kase, const po_check *check, const po_reference *reference,
                      bool *used) {
  for (size_t k = 0; k < kase->point_count; ++k) {
    if (!po_check_concerns(check, &kase->points[k].request))
      continue;
    const po_request asked = po_check_request(check, &kase->points[k].request);
    for (size_t row = 0; po_reference_next_row(reference, &asked, &row); ++row)
      used[row] = true;
  }
}

/* Adds the lines of the unused rows as ranges, a few of them: "7-9, 12, ...". */
static void add_ranges(const po_csv *table, const bool *used, po_text *text) {
  enum { MOST_RANGES = 8 };
  int ranges = 0;
  for (size_t row = 0, end = 0; row < table->row_count; row = end + 1) {
    for (end = row; end < table->row_count && !used[end]; ++end)
      continue;
    if (end == row)
      continue;
    if (ranges++ == MOST_RANGES) {
      po_text_add(text, ", ...");
      return;
    }
    po_text_add(text, "%s%zu", ranges > 1 ? ", " : "", table->lines[row]);
    if (end > row + 1)
      po_text_add(text, "-%zu", table->lines[end - 1]);
  }
}

/* Says which rows of a table no check and no measurement of the case uses, once for each table. */
static void tell_unused_rows(const po_plan *plan, unsigned number, json_t **lines) {
  const po_case *kase = plan->kase;
  const po_reference *reference = &plan->references[number];
  const po_check *other = NULL;
  if (reference->type != PO_REFERENCE_TABLE || reference->row)
    return;
  for (unsigned i = 0; i < number; ++i)
    if (strcmp(plan->references[i].name, reference->name) == 0)
      return;
  bool *used = po_allocate(reference->table.row_count, sizeof *used);
  if (!used)
    return;
  for (unsigned i = number; (other = po_case_check(kase->file, i)) != NULL; ++i)
    if (strcmp(plan->references[i].name, reference->name) == 0)
      mark_rows(kase, other, &plan->references[i], used);
  size_t unused = 0;
  for (size_t row = 0; row < reference->table.row_count; ++row)
    unused += !used[row];
  po_text ranges = {0};
  add_ranges(&reference->table, used, &ranges);
  if (unused)
    say(lines, "no scene of the case is that of %zu of %zu %s of %s: %s %s", unused,
        reference->table.row_count, po_one_or_more(reference->table.row_count, "row", "rows"),
        reference->name, po_one_or_more(unused, "line", "lines"), po_text_string(&ranges));
  po_text_clear(&ranges);
  free(used);
}

/* The plan of an external solver: what it is asked, and what it is not. */
static void describe_solver(const po_plan *plan, json_t **lines) {
  const po_case *kase = plan->kase;
  size_t asked = 0, made = 0;
  char why[PO_SOLVER_WHY] = "";
  for (size_t i = 0; i < kase->point_count; ++i)
    asked += po_solver_accepts(plan->solver, &kase->points[i].request, why);
  for (unsigned c = 0; c < kase->file->checks_count; ++c)
    made += po_plan_covers(plan, &kase->file->checks[c]);
  say(lines, "ask the solver %s for %zu of %zu %s", plan->solver->name, asked, kase->point_count,
      po_one_or_more(kase->point_count, "point", "points"));
  if (asked < kase->point_count)
    say(lines, "leave out the others, for example because %s", why);
  say(lines, "make %zu of %u %s", made, kase->file->checks_count,
      po_one_or_more(kase->file->checks_count, "check", "checks"));
}

json_t *po_plan_describe(const po_plan *plan) {
  json_t *lines = po_json_empty_array();
  if (plan->solver)
    describe_solver(plan, &lines);
  else {
    tell_sample(plan, &lines);
    tell_scenes(plan, &lines);
    tell_left_out(plan, &lines);
    tell_wants(plan, &lines);
    tell_checks(plan, &lines);
    tell_measures(plan, &lines);
    for (unsigned i = 0; po_case_check(plan->kase->file, i); ++i)
      tell_unused_rows(plan, i, &lines);
  }
  return lines;
}
