#include "po_conform.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_deadline.h"
#include "po_input.h"
#include "po_known_scenes.h"
#include "po_process.h"
#include "po_recognise.h"
#include "po_text.h"

/* Relative tolerance on the numbers of these scenes. It is wide, because only wrong signs, factors
 * and units are looked for; the cases measure the accuracy. The smallest distance of two factors
 * that are recognised, 4/3 and 3/2, is 12 %. */
static const double CLOSE = 0.05;

/* The numbers of a scene that are compared, and what is expected of them. */
enum {
  FORCE = PO_KNOWN_FORCE,
  APPROACH = PO_KNOWN_APPROACH,
  CONTACT_RADIUS = PO_KNOWN_CONTACT_RADIUS,
  NUMBERS = PO_KNOWN_NUMBERS
};
static const struct {
  const char *what, *unit;
  double small; /* eps; less is not compared, because a coarse mesh has a larger error */
} COMPARED[NUMBERS] = {{"force at pull-off", "the magnitude, > 0, in pi w R", 0},
                       {"approach at pull-off",
                        "in epsilon, > 0 when pressed together, 0 at the gap of equilibrium", 0.2},
                       {"contact radius at pull-off", "in epsilon", 10}};

typedef struct {
  po_question question;
  po_answer answer; /* the first one, or the last without an answer */
  unsigned answers; /* with status ok */
  bool final;
} conform_scene;

typedef struct {
  const po_solver *solver;
  const char *folder;
  const volatile sig_atomic_t *stop;
  size_t *wrong; /* number of findings */
  po_known_scenes known;
  conform_scene scenes[PO_MOST_KNOWN];
  size_t count;
  po_ask_log log;               /* of the present test */
  volatile sig_atomic_t enough; /* ends a process after its first answer */
  size_t taken;                 /* answers of that process */
  double at;                    /* time of the first of them */
} conforming;

static void __attribute__((format(printf, 3, 4)))
tell(conforming *c, const char *verdict, const char *format, ...) {
  *c->wrong += strcmp(verdict, "wrong") == 0;
  printf("%-8s ", verdict);
  va_list arguments;
  va_start(arguments, format);
  vprintf(format, arguments);
  va_end(arguments);
  putchar('\n');
  fflush(stdout);
}

/* The theory near which a smooth sphere is. */
static const char *limit_of(double tabor) {
  return tabor < 0.5 ? "Bradley" : tabor > 1.2 ? "JKR" : "between";
}

static void ask_known_scenes(conforming *c) {
  for (size_t i = 0; i < c->known.count; ++i) {
    po_question *question = &c->scenes[i].question;
    question->request = c->known.scenes[i].request;
    snprintf(question->id, sizeof question->id, "%zu", i);
    question->want = c->solver->quantities;
    question->repeats = 1;
    question->limit = c->solver->time_limit;
  }
}

/* Takes a point as the pull-off if none has a greater tension. */
static void take_deepest(double approach, double load, double obtained[NUMBERS]) {
  if (!isnan(obtained[FORCE]) && -load <= obtained[FORCE])
    return;
  obtained[FORCE] = -load;
  obtained[APPROACH] = approach;
}

/* The pull-off of the stable path and of the whole branch are the same for a smooth sphere.
 * Returned: the numbers of an answer, from whichever part it has; NAN: none. */
static void pull_off_of(const po_result *o, double obtained[NUMBERS]) {
  obtained[FORCE] = obtained[APPROACH] = obtained[CONTACT_RADIUS] = (double)NAN;
  if (o->has_pull_off) {
    obtained[FORCE] = o->pull_off.force;
    obtained[APPROACH] = o->pull_off.approach;
    obtained[CONTACT_RADIUS] = o->pull_off.contact_radius;
  }
  const po_path_state *stable = &o->hysteresis.of[PO_AT_APPROACH].pull_off;
  if (o->has_hysteresis && isnan(obtained[FORCE]))
    take_deepest(stable->approach, stable->load, obtained);
  if (o->has_pull_off || o->has_hysteresis)
    return;
  for (size_t i = 0; i < o->extremum_count; ++i)
    take_deepest(o->extrema[i].approach, o->extrema[i].load, obtained);
  for (size_t i = 0; i < o->curve_count; ++i)
    take_deepest(o->curve[i].approach, o->curve[i].load, obtained);
}

/* Keeps an answer. */
static po_status take_answer(void *context, size_t question, po_answer *answer, bool final) {
  conforming *c = context;
  conform_scene *scene = &c->scenes[question];
  scene->answers += answer->result.status == PO_OK;
  scene->final = final;
  if (scene->answers <= 1 || answer->result.status) {
    po_result_clear(&scene->answer.result);
    scene->answer = *answer;
    answer->result = po_result_none();
  }
  return PO_OK;
}

static void forget_answers(conforming *c) {
  po_ask_log_clear(&c->log);
  for (size_t i = 0; i < c->count; ++i) {
    po_result_clear(&c->scenes[i].answer.result);
    c->scenes[i].answer = (po_answer){.result = po_result_none()};
    c->scenes[i].answers = 0;
    c->scenes[i].final = false;
  }
}

static po_status ask_scenes(conforming *c, size_t count, unsigned repeats,
                            const volatile sig_atomic_t *stop, po_answer_taker *taker) {
  po_question questions[PO_MOST_KNOWN];
  forget_answers(c);
  for (size_t i = 0; i < count; ++i) {
    questions[i] = c->scenes[i].question;
    questions[i].repeats = repeats;
  }
  return po_ask(c->solver, questions, count, c->folder, NULL, stop, taker, c, &c->log);
}

static po_status test_empty(conforming *c) {
  const po_status status = ask_scenes(c, 0, 1, c->stop, take_answer);
  if (!status) {
    const po_ask_process *p = &c->log.processes[0];
    const bool ok = !*c->log.folder.text;
    tell(c, ok ? "ok" : "wrong", "empty request: %s %.2f s, %.2f s of processor time%s",
         ok ? "ended after" : "expected the end with exit status 0; after", p->wall, p->processor,
         p->left ? "; processes that it left behind were killed" : "");
  }
  return status;
}

/* Reports whether a constant, 1 or -1, turns all expected numbers into the obtained ones: the
 * distance between the gap 0 and the gap of equilibrium. */
static bool recognise_offset(const po_pair *pairs, size_t count, int *offset) {
  *offset = pairs[0].obtained > pairs[0].expected ? 1 : -1;
  for (size_t i = 0; i < count; ++i)
    if (!(fabs(pairs[i].obtained - pairs[i].expected - *offset) <= CLOSE))
      return false;
  return true;
}

/* Compares one number of some scenes, at least one. */
static void test_number(conforming *c, int number, const po_pair *pairs, size_t count) {
  const char *what = COMPARED[number].what, *unit = COMPARED[number].unit;
  char name[PO_FACTOR_LENGTH];
  int offset = 0;
  const bool same = po_recognise_factor(pairs, count, CLOSE, name);
  if (same && strcmp(name, "1") == 0)
    tell(c, "ok", "%s: within %.0f %% of the expected value in %zu %s", what, 100 * CLOSE, count,
         po_one_or_more(count, "scene", "scenes"));
  else if (same)
    tell(c, "wrong", "%s: the expected value times %s in %zu %s; expected: %s", what, name, count,
         po_one_or_more(count, "scene", "scenes"), unit);
  else if (number == APPROACH && recognise_offset(pairs, count, &offset))
    tell(c, "wrong", "%s: the expected value %+d eps in %zu %s; expected: %s", what, offset, count,
         po_one_or_more(count, "scene", "scenes"), unit);
  else {
    size_t worst = 0;
    for (size_t i = 1; i < count; ++i)
      if (fabs(pairs[i].obtained / pairs[i].expected - 1) >
          fabs(pairs[worst].obtained / pairs[worst].expected - 1))
        worst = i;
    tell(c, "wrong",
         "%s: no common factor; worst for tabor %g, radius %g: %.6g, expected %.6g (%s)", what,
         pairs[worst].scene->tabor, pairs[worst].scene->radius, pairs[worst].obtained,
         pairs[worst].expected, unit);
  }
}

static void compare_scenes(conforming *c) {
  size_t answered = 0, compared = 0;
  for (size_t i = 0; i < c->count; ++i)
    answered += !c->scenes[i].answer.result.status;
  for (int n = 0; n < NUMBERS; ++n) {
    po_pair pairs[PO_MOST_KNOWN];
    size_t count = 0;
    for (size_t i = 0; i < c->count; ++i) {
      const conform_scene *s = &c->scenes[i];
      double obtained[NUMBERS];
      pull_off_of(&s->answer.result, obtained);
      if (!s->answer.result.status && s->final && isfinite(obtained[n]) &&
          fabs(c->known.scenes[i].expected[n]) > COMPARED[n].small)
        pairs[count++] =
            (po_pair){obtained[n], c->known.scenes[i].expected[n], &s->question.request.scene};
    }
    compared += count;
    if (count)
      test_number(c, n, pairs, count);
  }
  if (answered && !compared)
    tell(c, "wrong",
         "no answer has a number that can be compared: expected one of force, approach (beyond %g) "
         "and contact radius (beyond %g) at pull-off",
         COMPARED[APPROACH].small, COMPARED[CONTACT_RADIUS].small);
}

static po_status test_scenes(conforming *c) {
  const po_status status = ask_scenes(c, c->count, 1, c->stop, take_answer);
  bool left = false;
  for (size_t i = 0; i < c->log.count; ++i)
    left = left || c->log.processes[i].left;
  for (size_t i = 0; !status && i < c->count; ++i) {
    const conform_scene *s = &c->scenes[i];
    const po_result *o = &s->answer.result;
    const po_scene *scene = &s->question.request.scene;
    double obtained[NUMBERS];
    pull_off_of(o, obtained);
    if (o->status)
      tell(c, "wrong", "%s, tabor %g, radius %g: %s: %s", limit_of(scene->tabor), scene->tabor,
           scene->radius, po_status_name(o->status), o->reason);
    else
      tell(c, "ok", "%s, tabor %g, radius %g: answered; force %.6g, expected %.6g",
           limit_of(scene->tabor), scene->tabor, scene->radius, obtained[FORCE],
           c->known.scenes[i].expected[FORCE]);
  }
  if (!status)
    compare_scenes(c);
  if (!status && left)
    tell(c, "note", "processes that the solver left behind were killed");
  if (!status && *c->log.folder.text)
    tell(c, "note", "request and response are in %s", c->log.folder.text);
  return status;
}

static po_status test_repeats(conforming *c) {
  const po_status status = ask_scenes(c, 1, 2, c->stop, take_answer);
  const conform_scene *s = &c->scenes[0];
  if (!status)
    tell(c, s->answers == 2 ? "ok" : "wrong", "repeats: %u answers to a request of 2 repeats%s%s",
         s->answers, s->answer.result.reason[0] ? ": " : "", s->answer.result.reason);
  return status;
}

/* Finds a scene that the solver does not accept. */
static bool find_beyond(const conforming *c, po_request *request, char why[PO_SOLVER_WHY]) {
  *request = c->scenes[0].question.request;
  po_request changed[4] = {*request, *request, *request, *request};
  po_key_set(&changed[0], PO_KEY_LAW, "morse:2");
  po_key_set(&changed[1], PO_KEY_AMPLITUDE, "1");
  po_key_set(&changed[1], PO_KEY_WAVELENGTH, "20");
  po_key_set(&changed[2], PO_KEY_TABOR, "1000");
  po_key_set(&changed[3], PO_KEY_OUTER_RADIUS, "7");
  for (size_t i = 0; i < 4; ++i)
    if (!po_solver_accepts(c->solver, &changed[i], why)) {
      *request = changed[i];
      return true;
    }
  return false;
}

static po_status test_unsupported(conforming *c) {
  char why[PO_SOLVER_WHY];
  conform_scene kept = c->scenes[0];
  if (!find_beyond(c, &c->scenes[0].question.request, why))
    return PO_OK;
  const po_status status = ask_scenes(c, 1, 1, c->stop, take_answer);
  const po_result *o = &c->scenes[0].answer.result;
  if (!status && o->status == PO_UNSUPPORTED)
    tell(c, "ok", "a scene outside the manifest (%s): unsupported: %s", why, o->reason);
  else if (!status && o->status)
    tell(c, "wrong", "a scene outside the manifest (%s): %s: %s; expected the status unsupported",
         why, po_status_name(o->status), o->reason);
  else if (!status)
    tell(c, "note", "a scene outside the manifest (%s) is solved; it will never be asked", why);
  c->scenes[0].question = kept.question;
  return status;
}

/* Notes the first answer, and asks for the end of the process. */
static po_status take_and_stop(void *context, size_t question, po_answer *answer, bool final) {
  conforming *c = context;
  (void)question, (void)answer, (void) final;
  if (!c->taken++)
    c->at = po_clock_wall();
  c->enough = 1;
  return PO_OK;
}

/* Asks all questions and ends the process after the first answer. If the solver writes each answer
 * at once, fewer answers than questions have arrived then. */
static po_status test_stop(conforming *c) {
  if (c->count == 1)
    return PO_OK;
  c->enough = 0;
  c->taken = 0;
  po_status status = ask_scenes(c, c->count, 1, &c->enough, take_and_stop);
  const double seconds = po_clock_wall() - c->at;
  if (status == PO_INTERRUPTED && !(c->stop && *c->stop))
    status = PO_OK;
  if (!status && c->taken >= c->count)
    tell(c, "note",
         "all answers arrived together: either the scenes take no time, or the lines are "
         "not flushed");
  else if (!status && c->taken) /* other tests report a solver that gives no answer */
    tell(c, "ok", "stopped after %zu of %zu answers: these were written at once", c->taken,
         c->count);
  if (!status && c->taken && seconds > 2 && c->taken < c->count)
    tell(c, "note", "the signal TERM does not end the solver; KILL does");
  return status;
}

po_status po_conform(const po_solver *solver, const char *data_folder, const char *folder,
                     const volatile sig_atomic_t *stop, size_t *wrong) {
  conforming c = {.solver = solver, .folder = folder, .stop = stop, .wrong = wrong};
  *wrong = 0;
  po_status status = po_known_scenes_choose(solver, data_folder, &c.known);
  if (status)
    return status;
  c.count = c.known.count;
  ask_known_scenes(&c);
  forget_answers(&c);
  tell(&c, "ok", "manifest: %u %s, %s", solver->file->can.quantities_count,
       po_one_or_more(solver->file->can.quantities_count, "quantity", "quantities"),
       solver->unstable ? "finds unstable equilibria" : "follows stable equilibria");
  status = test_empty(&c);
  if (!status && c.count == 0)
    tell(&c, "wrong",
         "no scene was asked, so that no number is tested: expected a manifest that accepts a "
         "smooth sphere under the law lennard-jones, with a tabor of at most 10 and an outer "
         "radius that is inf or not below the radius%s%s%s",
         *c.known.why ? " (" : "", c.known.why, *c.known.why ? ")" : "");
  po_status (*const tests[])(conforming *) = {test_scenes, test_repeats, test_unsupported,
                                              test_stop};
  for (size_t i = 0; i < sizeof tests / sizeof *tests && c.count && !status; ++i)
    status = tests[i](&c);
  forget_answers(&c);
  return status;
}
