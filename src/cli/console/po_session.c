#include "po_session.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_live.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_print.h"
#include "po_quote.h"
#include "po_record.h"
#include "po_text.h"
#include "po_verdicts.h"

static const size_t MOST_JOBS = 4096;
static const char OUTPUT[] = "build/run";

/* The value of --knob that means each value of the manifest. */
static const char ALL[] = "all";

po_session po_session_default(void) {
  return (po_session){.time_limit = NAN, .options = {.output = OUTPUT}};
}

const char *po_session_output(const po_session *session) {
  return strcmp(session->options.output, OUTPUT) == 0 ? NULL : session->options.output;
}

/* Reads "17" or "0-499". Returned: false if it is neither. */
static bool read_range(const char *text, size_t length, po_point_range *range) {
  char first[64];
  if (length >= sizeof first)
    return false;
  snprintf(first, sizeof first, "%.*s", (int)length, text);
  char *dash = strchr(first, '-');
  if (dash)
    *dash = '\0';
  return po_number_parse_count(first, &range->first) &&
         po_number_parse_count(dash ? dash + 1 : first, &range->last) &&
         range->last >= range->first;
}

/* "17", "0-499" or "0-3,17". */
po_status po_session_take_points(const char *name, void *to) {
  po_session *session = to;
  size_t count = 0;
  bool good = true, more = true;
  for (const char *at = optarg; good && more; ++count) {
    const size_t length = strcspn(at, ",");
    good = count < PO_MOST_RANGES && read_range(at, length, &session->ranges[count]);
    more = at[length] == ',';
    at += length + 1;
  }
  session->range_count = count;
  char expected[64] = "A-B or one number, counted from 0, or several with commas";
  if (count > PO_MOST_RANGES)
    snprintf(expected, sizeof expected, "at most %d of A-B or one number", PO_MOST_RANGES);
  return good ? PO_OK : po_options_refuse(name, optarg, expected);
}

/* "2/5". */
po_status po_session_take_shard(const char *name, void *to) {
  po_shard *shard = to;
  char number[32];
  const size_t length = strcspn(optarg, "/");
  snprintf(number, sizeof number, "%.*s", (int)(length < 31 ? length : 31), optarg);
  if (!optarg[length] || !po_number_parse_count(number, &shard->number) ||
      !po_number_parse_count(optarg + length + 1, &shard->count) || shard->number < 1 ||
      shard->number > shard->count)
    return po_options_refuse(name, optarg, "K/N, the K-th of N shards, such as 1/4");
  return PO_OK;
}

po_status po_session_take_jobs(const char *name, void *to) {
  size_t jobs = 0;
  if (!po_number_parse_count(optarg, &jobs) || jobs > MOST_JOBS)
    return po_options_refuse(name, optarg, "a whole number, 0 for all cores");
  *(int *)to = (int)jobs;
  return PO_OK;
}

po_status po_session_take_solver(const char *name, void *to) {
  po_session *session = to;
  if (session->manifest_count == PO_MOST_MANIFESTS)
    return po_options_refuse(name, optarg, "at most 16 solvers");
  return po_options_take_text(name, "the path of a manifest, or pulloff",
                              &session->manifests[session->manifest_count++]);
}

/* Adds a solver (NULL: this program). Two solvers must not write to the same folder. */
static po_status add_solver(po_session *session, po_solver *solver) {
  for (size_t k = 0; k < session->solver_count; ++k) {
    const po_solver *other = session->solvers[k];
    if ((!solver && !other) || (solver && other && strcmp(solver->name, other->name) == 0)) {
      const po_status status =
          po_fail(PO_BAD_INPUT, "--solver names %s twice: expected each solver once",
                  solver ? solver->name : "pulloff");
      po_solver_destroy(solver);
      return status;
    }
  }
  if (session->solver_count == PO_MOST_SOLVERS) {
    po_solver_destroy(solver);
    return po_fail(PO_BAD_INPUT, "there are more than %d solvers with all values of their knobs",
                   PO_MOST_SOLVERS);
  }
  session->solvers[session->solver_count++] = solver;
  return PO_OK;
}

/* Adds the solver of a manifest, with --knob all once for each value of its knob. */
static po_status add_manifest(po_session *session, const char *path) {
  const bool all = session->knob && strcmp(session->knob, ALL) == 0;
  po_solver *solver = NULL;
  po_status status = po_solver_read(path, all ? NULL : session->knob, &solver);
  if (status)
    return status;
  const po_solver_knob *knob = solver->file->knob;
  for (unsigned v = 0; !status && all && knob && v + 1 < knob->values_count; ++v) {
    po_solver *coarser = NULL;
    status = po_solver_read(path, knob->values[v], &coarser);
    if (!status)
      status = add_solver(session, coarser);
  }
  if (!status)
    return add_solver(session, solver);
  po_solver_destroy(solver);
  return status;
}

/* Returned: where "@VALUE" begins in the argument of --solver; NULL if it is a manifest alone. */
static const char *value_in(const char *text) {
  return po_path_exists(text) ? NULL : strrchr(text, '@');
}

/* Adds the solver of "MANIFEST@VALUE", or of "MANIFEST" with --knob. */
static po_status add_named(po_session *session, const char *text) {
  const char *at = value_in(text);
  if (!at)
    return add_manifest(session, text);
  po_solver *solver = NULL;
  po_file_path path;
  snprintf(path.text, sizeof path.text, "%.*s", (int)(at - text), text);
  const po_status status = po_solver_read(path.text, at + 1, &solver);
  return status ? status : add_solver(session, solver);
}

static po_status read_solvers(po_session *session) {
  po_status status = PO_OK;
  bool is_taken = !session->knob;
  for (size_t m = 0; m < session->manifest_count; ++m)
    is_taken = is_taken ||
               (strcmp(session->manifests[m], "pulloff") != 0 && !value_in(session->manifests[m]));
  if (!is_taken)
    return po_fail(PO_BAD_INPUT,
                   "--knob is %s: expected it with --solver MANIFEST, whose knob it is",
                   session->knob);
  for (size_t m = 0; !status && m < session->manifest_count; ++m)
    status = strcmp(session->manifests[m], "pulloff") == 0
                 ? add_solver(session, NULL)
                 : add_named(session, session->manifests[m]);
  for (size_t s = 0; !status && s < session->solver_count; ++s)
    if (session->solvers[s])
      po_print_solver(session->solvers[s], stderr);
  if (!session->solver_count)
    session->solver_count = 1;
  return status;
}

static po_status plan_one(po_case *kase, const po_solver *solver, po_case_run *run) {
  po_plan *plan = NULL;
  const po_status status = po_plan_create(kase, po_environment_data(), solver, &plan);
  return status ? status : po_case_run_create(plan, run);
}

static po_status plan_all(po_session *session) {
  const size_t count = session->catalog.count;
  po_status status = read_solvers(session);
  session->run_count = session->solver_count * count;
  session->runs = status ? NULL : po_allocate(session->run_count, sizeof *session->runs);
  if (!status && !session->runs)
    status = PO_NO_MEMORY;
  for (size_t i = 0; !status && i < count; ++i) {
    po_case *kase = session->catalog.cases[i];
    kase->time_limit = session->time_limit;
    for (size_t k = 0; !isnan(session->time_limit) && k < kase->point_count; ++k)
      kase->points[k].request.time_limit = session->time_limit;
  }
  for (size_t r = 0; !status && r < session->run_count; ++r)
    status =
        plan_one(session->catalog.cases[r % count], session->solvers[r / count], &session->runs[r]);
  return status;
}

static po_status check_points(const po_session *session) {
  for (size_t i = 0; i < session->catalog.count; ++i) {
    const po_case *kase = session->catalog.cases[i];
    for (size_t k = 0; k < session->range_count; ++k)
      if (session->ranges[k].first >= kase->point_count)
        return po_fail(PO_BAD_INPUT,
                       "--points begins at %zu: expected less than %zu, the number of points of %s",
                       session->ranges[k].first, kase->point_count, kase->file->name);
  }
  return PO_OK;
}

/* Marks the points that --points or --shard selects. Each solver has the same shards. */
static po_status ask_runs(po_session *session) {
  const size_t count = session->catalog.count;
  po_status status = PO_OK;
  for (size_t r = 0; session->range_count && r < session->run_count; ++r)
    po_case_run_ask(&session->runs[r], session->ranges, session->range_count);
  for (size_t s = 0; !status && session->shard.count && s < session->solver_count; ++s)
    status = po_shard_deal(session->runs + s * count, count, session->shard);
  return status;
}

po_status po_session_open(po_session *session, char *const *names, size_t count) {
  if (count && session->suites)
    return po_fail(PO_BAD_INPUT, "cases and --suite are given: expected one of them");
  if (session->shard.count && session->range_count)
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
    status = ask_runs(session);
  return status;
}

/* Finds the folder of the records of a solver, and writes the shard. */
static po_status prepare_solver(po_session *session, size_t s) {
  const size_t count = session->catalog.count;
  const po_run_options *options = &session->options;
  po_case_run *runs = session->runs + s * count;
  const po_file_path folder = session->solvers[s]
                                  ? po_solver_folder(session->solvers[s], options->output)
                                  : po_path_join("", options->output);
  po_status status = PO_OK;
  for (size_t i = 0; !status && i < count; ++i) {
    po_case_run_place(&runs[i], folder.text);
    status = po_record_check_owner(&runs[i]);
  }
  if (!status && session->shard.count)
    status = po_shard_write(runs, count, session->shard, session->time_limit, options->jobs,
                            folder.text);
  return status;
}

po_status po_session_solve(po_session *session) {
  session->options.stop = po_interrupt_listen();
  if (session->options.jobs == 0)
    session->options.jobs = po_environment_cores();
  po_status status = PO_OK;
  for (size_t s = 0; !status && s < session->solver_count; ++s)
    status = prepare_solver(session, s);
  return status ? status : po_run(session->runs, session->run_count, &session->options);
}

po_status po_session_run(po_session *session, char *const *names, size_t count) {
  const po_status status = po_session_open(session, names, count);
  return status ? status : po_session_solve(session);
}

po_status po_session_check_one(const po_session *session, const po_options *options) {
  if (session->manifest_count > 1)
    return po_fail(PO_BAD_INPUT, "%s takes one solver: expected --solver once", options->verb);
  if (session->knob && strcmp(session->knob, ALL) == 0)
    return po_fail(PO_BAD_INPUT, "%s takes one value of the knob: expected --knob VALUE",
                   options->verb);
  return PO_OK;
}

po_status po_session_open_one(po_session *session, const po_options *options) {
  if (options->argc - optind != 1)
    return po_fail(PO_BAD_INPUT, "%s needs the name of one case (see pulloff %s --help)",
                   options->verb, options->verb);
  const po_status status = po_session_check_one(session, options);
  return status ? status : po_session_open(session, options->argv + optind, 1);
}

size_t po_session_failures(const po_session *session) {
  size_t total = 0;
  for (size_t i = 0; i < session->run_count; ++i)
    total += po_case_run_failures(&session->runs[i]);
  return total;
}

po_status po_session_summarise(const po_session *session) {
  po_text text = {0};
  for (size_t i = 0; i < session->run_count; ++i)
    if (session->runs[i].plan->kase->file->sample)
      po_summary_add(&session->runs[i], &text);
  return po_text_print(&text);
}

int po_session_end(po_session *session, po_status status) {
  if (!status)
    status = po_session_summarise(session);
  const size_t failures = status ? 0 : po_session_failures(session);
  int code = po_options_end(status);
  if (failures) {
    char shown[PO_QUOTE_LENGTH];
    fprintf(stderr, "pulloff: %zu %s failed; the records in %s state the reasons\n", failures,
            po_one_or_more(failures, "solve", "solves"), po_quote(session->options.output, shown));
    code = PO_EXIT_SOLVE;
  }
  po_session_clear(session);
  return code;
}

void po_session_clear(po_session *session) {
  for (size_t i = 0; session->runs && i < session->run_count; ++i)
    if (session->runs[i].plan)
      po_case_run_clear(&session->runs[i]);
  free(session->runs);
  for (size_t s = 0; s < session->solver_count; ++s)
    po_solver_destroy(session->solvers[s]);
  po_catalog_close(&session->catalog);
  *session = (po_session){0};
}
