#include "po_explain.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_elementary.h"
#include "po_text.h"

/* Returned: special point number `index` in the list of all folds followed by all extrema. */
static const po_special_point *special(const po_result *result, size_t index) {
  return index < result->fold_count ? &result->folds[index]
                                    : &result->extrema[index - result->fold_count];
}

static void name_special(const po_result *result, size_t index, char words[32]) {
  const size_t number = index < result->fold_count ? index : index - result->fold_count;
  snprintf(words, 32, "%s-%zu", PO_SPECIAL_KINDS[special(result, index)->kind], number + 1);
}

/* Returned: the arclength of the nearest point of the curve; NAN without a curve. */
static double position_of(const po_result *result, double approach, double load) {
  double nearest = (double)INFINITY, position = (double)NAN;
  for (size_t i = 0; i < result->curve_count; ++i) {
    const po_curve_point *p = &result->curve[i];
    const double distance = po_hypot(p->approach - approach, p->load - load);
    if (distance < nearest) {
      nearest = distance;
      position = p->position;
    }
  }
  return position;
}

void po_place_describe(const po_result *result, double approach, double load,
                       char words[PO_PLACE_LENGTH]) {
  const size_t count = result->fold_count + result->extremum_count, none = count;
  const double position = position_of(result, approach, load);
  size_t before = none, after = none;
  words[0] = '\0';
  for (size_t i = 0; i < count; ++i) {
    const po_special_point *mark = special(result, i);
    if (mark->approach == approach && mark->load == load) {
      char at[32];
      name_special(result, i, at);
      snprintf(words, PO_PLACE_LENGTH, "at %s", at);
      return;
    }
    if (mark->position <= position &&
        (before == none || mark->position > special(result, before)->position))
      before = i;
    if (mark->position > position &&
        (after == none || mark->position < special(result, after)->position))
      after = i;
  }
  char first[32] = "", second[32] = "";
  if (before < none)
    name_special(result, before, first);
  if (after < none)
    name_special(result, after, second);
  if (*first && *second)
    snprintf(words, PO_PLACE_LENGTH, "between %s and %s", first, second);
  else if (*first || *second)
    snprintf(words, PO_PLACE_LENGTH, "%s %s", *first ? "after" : "before", *first ? first : second);
}

/* Reports whether the first `length` characters of `word` are a word of a label. */
static bool has_word(const char *label, const char *word, size_t length) {
  while (*label) {
    label += strspn(label, " ");
    const size_t other = strcspn(label, " ");
    if (other == length && strncmp(label, word, length) == 0)
      return true;
    label += other;
  }
  return false;
}

bool po_explain_means(const po_point *point, const char *text) {
  if (strcmp(point->id, text) == 0)
    return true;
  size_t words = 0;
  for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
    const size_t length = strcspn(text, " ");
    if (!has_word(point->label, text, length))
      return false;
    words += 1;
    text += length;
  }
  return words > 0;
}

static bool is_chosen(const po_explain_choice *choice, size_t point) {
  return !choice->points || choice->points[point];
}

bool po_explain_concerns(const po_case_run *run, const po_explain_choice *choice,
                         const po_finding *finding) {
  if (finding->label)
    return is_chosen(choice, finding->point);
  for (size_t i = 0; i < run->plan->kase->point_count; ++i)
    if (!is_chosen(choice, i))
      return false;
  return true;
}

static bool is_explained(const po_case_run *run, const po_explain_choice *choice,
                         const po_finding *finding) {
  return po_explain_concerns(run, choice, finding) && (choice->all || !finding->plain);
}

/* Adds the solve of a point by this program, with its time limit; for a curve, with the option that
 * writes it. */
static void add_solve(const po_case_run *run, const po_finding *finding, po_text *text) {
  const po_request request = po_plan_request(run->plan, finding->point);
  const bool curve = finding->item && finding->item->check->quantity == PO_CURVE;
  po_input_add_command(&request, text);
  po_text_add(text, "%s", curve ? " --curve curve.csv" : "");
}

/* Returned: the command that repeats a result or a failed solve; of a result of all points together
 * it repeats the first failed solve, or the case if none failed. In *compare the solve of the point
 * alone by this program, if that is another one; else it stays empty. */
static po_text command_of(const po_case_run *run, const po_finding *finding, const char *output,
                          po_text *compare) {
  po_text text = {0};
  if (finding->item && finding->item->whole && !run->points[finding->point].result.status) {
    po_text_add(&text, "pulloff verify %s", po_case_word(run->plan->kase));
    po_plan_add_options(run->plan, &text);
    po_text_add(&text, " --fresh");
  } else if (po_case_run_needs_rerun(run, finding->point)) {
    add_solve(run, finding, compare);
    po_plan_add_rerun(run->plan, finding->point, &text);
  } else {
    add_solve(run, finding, &text);
    return text;
  }
  if (output) {
    po_text_add(&text, " --output ");
    po_text_add_word(&text, output);
  }
  return text;
}

static void add_commands(const po_case_run *run, const po_finding *finding, const char *output,
                         po_text *text) {
  po_text compare = {0}, command = command_of(run, finding, output, &compare);
  po_text_add(text, "  rerun      %s\n", po_text_string(&command));
  if (compare.length)
    po_text_add(text, "  compare    %s\n", po_text_string(&compare));
  po_text_add(text, "\n");
  text->failed = text->failed || command.failed || compare.failed;
  po_text_clear(&command);
  po_text_clear(&compare);
}

static void set_commands(const po_case_run *run, const po_finding *finding, const char *output,
                         json_t **object) {
  po_text compare = {0}, command = command_of(run, finding, output, &compare);
  po_json_set(object, "command", po_json_take_text(po_text_take(&command)));
  po_json_set(object, "compare",
              compare.length || compare.failed ? po_json_take_text(po_text_take(&compare))
                                               : json_null());
}

static void explain_numbers(const po_check_result *item, po_text *text) {
  const po_check *check = item->check;
  if (isfinite(item->obtained))
    po_text_add(text, "  obtained   %.12g\n", item->obtained);
  if (isfinite(item->expected))
    po_text_add(text, "  expected   %.12g\n", item->expected);
  po_text_add(text, "  ledger     %s: %s", PO_LEDGERS[item->ledger], item->reference->name);
  if (isfinite(item->uncertainty) && item->uncertainty > 0)
    po_text_add(text, ", with an uncertainty of %.2g", item->uncertainty);
  po_text_add(text, "\n");
  if (!isfinite(item->error))
    return;
  po_text_add(text, "  %s %+.3g, ", check->quantity == PO_CURVE ? "distance  " : "difference",
              item->error);
  po_text_add(text, "%.4g times the tolerance of %s %s\n", item->ratio, check->tolerance_text,
              check->kind_text);
}

static void explain_item(const po_case_run *run, const po_finding *finding, const char *output,
                         po_text *text) {
  const po_check_result *item = finding->item;
  char place[PO_PLACE_LENGTH] = "";
  po_blame blame;
  po_blame_find(run, item, &blame);
  po_text_add(text, "%s %s %s: %s\n", run->plan->name, item->subject,
              finding->label ? finding->label : "-", PO_VERDICTS[item->verdict]);
  explain_numbers(item, text);
  if (isfinite(item->approach)) {
    po_place_describe(&run->points[item->point].result, item->approach, item->load, place);
    po_text_add(text, "  where      approach %.6g, load %.6g%s%s\n", item->approach, item->load,
                *place ? ", " : "", place);
  }
  if (item->note[0])
    po_text_add(text, "  note       %s\n", item->note);
  if (blame.why[0])
    po_text_add(text, "  fault      %s: %s\n", blame.side, blame.why);
  po_text_add(text, "  tolerance  because %s\n", item->check->because);
  add_commands(run, finding, output, text);
}

void po_explain_text(const po_case_run *run, const po_explain_choice *choice, po_text *text) {
  size_t explained = 0, considered = 0;
  for (po_finding f = {0}; po_finding_next(run, &f);) {
    considered += f.item && po_explain_concerns(run, choice, &f);
    if (!is_explained(run, choice, &f))
      continue;
    explained += f.item != NULL;
    if (f.item)
      explain_item(run, &f, choice->output, text);
    else {
      po_text_add(text, "%s solve %s: failed\n  reason     %s\n", run->plan->name, f.label,
                  run->points[f.point].result.reason);
      add_commands(run, &f, choice->output, text);
    }
  }
  po_text_add(text, "%s: %zu of %zu %s explained%s\n", run->plan->name, explained, considered,
              po_one_or_more(considered, "check", "checks"),
              explained < considered ? ", the others are within" : "");
}

static json_t *item_json(const po_case_run *run, const po_finding *finding, const char *output) {
  const po_check_result *item = finding->item;
  const po_check *check = item->check;
  char place[PO_PLACE_LENGTH] = "";
  po_blame blame;
  po_blame_find(run, item, &blame);
  json_t *where = json_null();
  if (isfinite(item->approach)) {
    po_place_describe(&run->points[item->point].result, item->approach, item->load, place);
    where = PO_JSON_OBJECT({"approach", po_json_number(item->approach)},
                           {"load", po_json_number(item->load)},
                           {"special_points", po_json_text(place)});
  }
  json_t *object = PO_JSON_OBJECT(
      {"id", po_json_text(item->id)},
      {"point", po_json_text(item->whole ? NULL : run->plan->kase->points[item->point].id)},
      {"label", po_json_text(finding->label)}, {"quantity", po_json_text(item->quantity)},
      {"ledger", po_json_text(PO_LEDGERS[item->ledger])},
      {"verdict", po_json_text(PO_VERDICTS[item->verdict])},
      {"passes", json_boolean(po_verdict_passes(item->verdict))},
      {"obtained", po_json_number(item->obtained)}, {"expected", po_json_number(item->expected)},
      {"error", po_json_number(item->error)}, {"ratio", po_json_number(item->ratio)},
      {"tolerance", po_json_number(check->tolerance)}, {"kind", po_json_text(check->kind_text)},
      {"reference_uncertainty", po_json_number(item->uncertainty)},
      {"reference", po_json_text(item->reference->name)}, {"where", where},
      {"fault", po_json_text(blame.side)}, {"why", po_json_text(blame.why)},
      {"because", po_json_text(check->because)}, {"note", po_json_text(item->note)});
  set_commands(run, finding, output, &object);
  return object;
}

static json_t *failure_json(const po_case_run *run, const po_finding *finding, const char *output) {
  json_t *object =
      PO_JSON_OBJECT({"point", po_json_text(run->plan->kase->points[finding->point].id)},
                     {"label", po_json_text(finding->label)},
                     {"reason", po_json_text(run->points[finding->point].result.reason)});
  set_commands(run, finding, output, &object);
  return object;
}

json_t *po_explain_json(const po_case_run *run, const po_explain_choice *choice) {
  json_t *checks = po_json_empty_array(), *failed = po_json_empty_array();
  for (po_finding f = {0}; po_finding_next(run, &f);)
    if (is_explained(run, choice, &f))
      po_json_append(f.item ? &checks : &failed, f.item ? item_json(run, &f, choice->output)
                                                        : failure_json(run, &f, choice->output));
  return PO_JSON_OBJECT({"schema", po_json_text("pulloff-explain/1")},
                        {"case", po_json_text(run->plan->kase->file->name)},
                        {"verdict", po_json_text(po_case_run_verdict(run))}, {"checks", checks},
                        {"failed", failed});
}
