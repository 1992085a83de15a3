#include "po_solve_line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_live.h"
#include "po_solve.h"

po_solve_line po_solve_line_begin(void) {
  return (po_solve_line){.request = po_input_default(), .scene = po_scene_options_begin()};
}

/* --profile gives the profile of the scene; as in earlier versions, it also gives the file for gap
 * and traction if its value is a path with a period or a slash. */
static bool names_file(const char *text) {
  return !*text || strcspn(text, "./") < strcspn(text, ":");
}

po_status po_solve_line_take_key(void *to, int option) {
  po_solve_line *line = to;
  if (option == PO_OPTION_KEYS + PO_KEY_PROFILE && names_file(optarg))
    return po_options_take_text("profile", "the name of a file", &line->profile);
  return po_scene_options_take(&line->scene, option);
}

po_status po_solve_line_take_want(const char *name, void *want) {
  return po_want_read(optarg, want) ? PO_OK : po_options_refuse(name, optarg, PO_WANT_EXPECTED);
}

void po_solve_line_add_wants(po_solve_line *line) {
  line->request.want |= (line->curve ? PO_WANT_CURVE : 0) | (line->profile ? PO_WANT_PROFILE : 0) |
                        (line->staircase ? PO_WANT_PRELOAD : 0) | (line->loop ? PO_WANT_LOOP : 0) |
                        (line->history ? PO_WANT_HISTORY : 0);
}

static bool is_output(const char *file) {
  return file && strcmp(file, "-") == 0;
}

po_status po_solve_line_end(po_solve_line *line) {
  po_request *request = &line->request;
  po_texts *given = &line->scene.given;
  po_solve_line_add_wants(line);
  po_status status = po_texts_read(given, request);
  if (!status)
    status = po_texts_check_waves(given);
  if (status)
    return status;
  if (!line->warned)
    po_scene_options_warn(given);
  line->tables = is_output(line->curve) + is_output(line->profile) + is_output(line->staircase) +
                 is_output(line->loop) + is_output(line->smoothed) + is_output(line->history);
  if (line->tables + line->json > 1)
    return po_fail(PO_BAD_INPUT, "standard output is asked for twice: expected only one of --json "
                                 "and the file -");
  if (line->smoothed && isnan(request->scene.profile.parameter[PO_TABLE_SMOOTH]))
    return po_fail(PO_BAD_INPUT, "--smoothed is given without --smooth: expected both");
  return po_request_complete(request);
}

typedef struct {
  po_live live;
  size_t points;
} solve_progress;

static void show_point(void *watcher, double approach, double load) {
  solve_progress *progress = watcher;
  ++progress->points;
  po_live_show(&progress->live, "%zu points, approach %.4g, load %.4g", progress->points, approach,
               load);
}

po_status po_solve_line_solve(po_solve_line *line, po_result *result) {
  solve_progress progress = {.live = po_live_begin(false)};
  line->request.stop = po_interrupt_listen();
  line->request.watch = show_point;
  line->request.watcher = &progress;
  const po_status status = po_solve(&line->request, result);
  po_live_end(&progress.live);
  if (status && !result->reason[0])
    snprintf(result->reason, sizeof result->reason, "%.250s", po_message());
  return status;
}
