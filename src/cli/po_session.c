#include "po_session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_interrupt.h"
#include "po_memory.h"
#include "po_number.h"

static const size_t MOST_JOBS = 4096;

po_session po_session_default(void) {
  return (po_session){.options = {.output = "build/run"}};
}

po_status po_session_suites(const char *list, unsigned *suites) {
  while (*list) {
    char name[32];
    const size_t length = strcspn(list, ",");
    snprintf(name, sizeof name, "%.*s", (int)(length < 31 ? length : 31), list);
    const unsigned suite = po_suite_of_name(name);
    if (!suite)
      return po_options_refuse("suite", name, PO_SUITE_NAMES);
    *suites |= suite;
    list += length + (list[length] == ',');
  }
  return *suites ? PO_OK : po_options_refuse("suite", list, PO_SUITE_NAMES);
}

po_status po_session_option(po_session *session, int option) {
  size_t jobs = 0;
  switch (option) {
  case PO_SESSION_SUITE:
    return po_session_suites(optarg, &session->suites);
  case PO_SESSION_OUTPUT:
    session->options.output = optarg;
    return *optarg ? PO_OK : po_options_refuse("output", optarg, "the name of a folder");
  case PO_SESSION_JOBS:
    if (!po_number_parse_count(optarg, &jobs) || jobs < 1 || jobs > MOST_JOBS)
      return po_options_refuse("jobs", optarg, "a whole number > 0");
    session->options.jobs = (int)jobs;
    return PO_OK;
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
    status = po_plan_create(session->catalog.cases[i], po_environment_data(), &plan);
    if (!status)
      status = po_case_run_create(plan, &session->runs[i]);
  }
  return status;
}

static po_status open_cases(po_session *session, char *const *names, size_t count) {
  if (count && session->suites)
    return po_fail(PO_BAD_INPUT, "cases and --suite are given: expected one of them");
  po_status status =
      po_catalog_open(po_environment_data(), names, count, session->suites, &session->catalog);
  if (!status && session->catalog.count == 0)
    status = po_fail(PO_BAD_INPUT, "there is no such case in %s/cases", po_environment_data());
  if (!status)
    status = plan_all(session);
  return status;
}

po_status po_session_solve(po_session *session) {
  session->options.stop = po_interrupt_listen();
  return po_run(session->runs, session->catalog.count, &session->options);
}

po_status po_session_run(po_session *session, char *const *names, size_t count) {
  const po_status status = open_cases(session, names, count);
  return status ? status : po_session_solve(session);
}

po_status po_session_open_one(po_session *session, const po_options *options) {
  if (options->argc - optind != 1)
    return po_fail(PO_BAD_INPUT, "%s needs the name of one case (see pulloff %s --help)",
                   options->verb, options->verb);
  return open_cases(session, options->argv + optind, 1);
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

void po_session_clear(po_session *session) {
  for (size_t i = 0; session->runs && i < session->catalog.count; ++i)
    po_case_run_clear(&session->runs[i]);
  free(session->runs);
  po_catalog_close(&session->catalog);
  *session = (po_session){0};
}
