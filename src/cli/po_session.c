#include "po_session.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_interrupt.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"
#include "po_record.h"
#include "po_summary.h"

static const size_t MOST_JOBS = 4096;

static const char OUTPUT[] = "build/run";

po_session po_session_default(void) {
  return (po_session){.time_limit = NAN, .last = SIZE_MAX, .options = {.output = OUTPUT}};
}

const char *po_session_output(const po_session *session) {
  return strcmp(session->options.output, OUTPUT) == 0 ? NULL : session->options.output;
}

/* "17" or "0-499". */
static po_status take_points(const char *text, po_session *session) {
  char first[32];
  const size_t length = strcspn(text, "-");
  snprintf(first, sizeof first, "%.*s", (int)(length < 31 ? length : 31), text);
  const char *last = text[length] ? text + length + 1 : first;
  if (!po_number_parse_count(first, &session->first) ||
      !po_number_parse_count(last, &session->last) || session->last < session->first)
    return po_options_refuse("points", text, "A-B or one number, counted from 0");
  return PO_OK;
}

/* "2/5". */
static po_status take_shard(const char *text, po_shard *shard) {
  char number[32];
  const size_t length = strcspn(text, "/");
  snprintf(number, sizeof number, "%.*s", (int)(length < 31 ? length : 31), text);
  if (!text[length] || !po_number_parse_count(number, &shard->number) ||
      !po_number_parse_count(text + length + 1, &shard->count) || shard->number < 1 ||
      shard->number > shard->count || shard->count > PO_MOST_SHARDS)
    return po_options_refuse("shard", text, "K/N, the K-th of N shards, such as 1/4");
  return PO_OK;
}

po_status po_session_option(void *to, int option) {
  po_session *session = to;
  size_t jobs = 0;
  switch (option) {
  case PO_SESSION_SUITE:
    return po_options_take_text("suite", "names of suites", &session->suites);
  case PO_SESSION_OUTPUT:
    return po_options_take_text("output", "the name of a folder", &session->options.output);
  case PO_SESSION_JOBS:
    if (!po_number_parse_count(optarg, &jobs) || jobs > MOST_JOBS)
      return po_options_refuse("jobs", optarg, "a whole number, 0 for all cores");
    session->options.jobs = (int)jobs;
    return PO_OK;
  case PO_SESSION_POINTS:
    return take_points(optarg, session);
  case PO_SESSION_SHARD:
    return take_shard(optarg, &session->shard);
  case PO_SESSION_TIME_LIMIT:
    return po_number_parse(optarg, &session->time_limit) && session->time_limit > 0
               ? PO_OK
               : po_options_refuse("time-limit", optarg, "a finite number > 0");
  default:
    session->options.fresh = true;
    return PO_OK;
  }
}

static po_status plan_all(po_session *session) {
  const size_t count = session->catalog.count;
  session->runs = po_allocate(count, sizeof *session->runs);
  po_status status = session->runs ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < count; ++i) {
    po_plan *plan = NULL;
    po_case *kase = session->catalog.cases[i];
    for (size_t k = 0; !isnan(session->time_limit) && k < kase->point_count; ++k)
      kase->points[k].request.time_limit = session->time_limit;
    status = session->arithmetic
                 ? po_plan_create_for(kase, po_environment_data(), session->arithmetic, &plan)
                 : po_plan_create(kase, po_environment_data(), &plan);
    if (!status)
      status = po_case_run_create(plan, &session->runs[i]);
  }
  return status;
}

static po_status check_points(const po_session *session) {
  for (size_t i = 0; i < session->catalog.count; ++i) {
    const po_case *kase = session->catalog.cases[i];
    if (session->first >= kase->point_count)
      return po_fail(PO_BAD_INPUT,
                     "--points begins at %zu: expected less than %zu, the number of points of %s",
                     session->first, kase->point_count, kase->file->name);
  }
  return PO_OK;
}

/* Marks the points that --points or --shard selects. */
static po_status ask(po_session *session) {
  for (size_t i = 0; i < session->catalog.count; ++i)
    po_case_run_ask(&session->runs[i], session->first, session->last);
  return session->shard.count ? po_shard_deal(session->runs, session->catalog.count, session->shard)
                              : PO_OK;
}

po_status po_session_open(po_session *session, char *const *names, size_t count) {
  if (count && session->suites)
    return po_fail(PO_BAD_INPUT, "cases and --suite are given: expected one of them");
  if (session->shard.count && session->last < SIZE_MAX)
    return po_fail(PO_BAD_INPUT, "--points and --shard are given: expected one of them");
  const po_suites suites = {.names = session->suites, .only_named = true};
  po_status status =
      po_catalog_open(po_environment_data(), names, count, suites, &session->catalog);
  if (!status && session->catalog.count == 0)
    status = po_fail(PO_BAD_INPUT, "there is no such case in %s/cases", po_environment_data());
  if (!status)
    status = check_points(session);
  if (!status)
    status = plan_all(session);
  if (!status)
    status = ask(session);
  return status;
}

po_status po_session_solve(po_session *session) {
  session->options.stop = po_interrupt_listen();
  if (session->options.jobs == 0)
    session->options.jobs = po_environment_cores();
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < session->catalog.count; ++i)
    status = po_record_check_owner(&session->runs[i], session->options.output);
  if (!status && session->shard.count)
    status = po_shard_write(session->runs, session->catalog.count, session->shard,
                            session->time_limit, session->options.jobs, session->options.output);
  return status ? status : po_run(session->runs, session->catalog.count, &session->options);
}

po_status po_session_run(po_session *session, char *const *names, size_t count) {
  const po_status status = po_session_open(session, names, count);
  return status ? status : po_session_solve(session);
}

po_status po_session_open_one(po_session *session, const po_options *options) {
  if (options->argc - optind != 1)
    return po_fail(PO_BAD_INPUT, "%s needs the name of one case (see pulloff %s --help)",
                   options->verb, options->verb);
  return po_session_open(session, options->argv + optind, 1);
}

size_t po_session_failures(const po_session *session) {
  size_t total = 0;
  for (size_t i = 0; i < session->catalog.count; ++i)
    total += po_case_run_failures(&session->runs[i]);
  return total;
}

size_t po_session_outside(const po_session *session) {
  size_t total = 0;
  for (size_t i = 0; i < session->catalog.count; ++i)
    total += po_case_run_outside(&session->runs[i]);
  return total;
}

po_status po_session_summarise(const po_session *session) {
  po_text text = {0};
  for (size_t i = 0; i < session->catalog.count; ++i)
    if (session->catalog.cases[i]->file->sample)
      po_summary_add(&session->runs[i], &text);
  fputs(po_text_string(&text), stdout);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

int po_session_end(po_session *session, po_status status) {
  if (!status)
    status = po_session_summarise(session);
  const size_t failures = status ? 0 : po_session_failures(session);
  int code = po_options_end(status);
  if (failures) {
    char shown[PO_QUOTE_LENGTH];
    fprintf(stderr, "pulloff: %zu solves failed; the records in %s state the reasons\n", failures,
            po_quote(session->options.output, shown));
    code = PO_EXIT_SOLVE;
  }
  po_session_clear(session);
  return code;
}

void po_session_clear(po_session *session) {
  for (size_t i = 0; session->runs && i < session->catalog.count; ++i)
    po_case_run_clear(&session->runs[i]);
  free(session->runs);
  po_catalog_close(&session->catalog);
  *session = (po_session){0};
}
