/* The shards of a run, as merge reads them. Each part of the input is the file of one shard.
 * Tokens:
 * @PROGRAM@ for the program, @PLAIN@ and @FOLLOWED@ for the keys of the two cases. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_shard.h"

enum { MOST_SHARDS = 4, CASES = 2 };

static po_case_run *runs[CASES];

static void require_one_run(const po_merge *merge) {
  for (size_t i = 0; i < merge->count; ++i)
    fuzz_require(po_json_count_of(merge->parts[i].root, "of") == merge->of,
                 "a shard of another run is accepted");
}

/* The runs of the named cases, if all of these are known. */
static size_t find_runs(char *const *names, size_t count, po_case_run *chosen) {
  for (size_t i = 0; i < count; ++i) {
    int c = 0;
    while (c < CASES && strcmp(names[i], runs[c]->plan->kase->file->name) != 0)
      ++c;
    if (c == CASES || i == CASES || (i > 0 && chosen[0].plan == runs[c]->plan))
      return 0;
    chosen[i] = *runs[c];
  }
  return count;
}

static void fill(const po_merge *merge, char *const *names, size_t count) {
  po_case_run chosen[CASES];
  const size_t found = find_runs(names, count, chosen);
  if (!found)
    return;
  for (size_t i = 0; i < found; ++i)
    fuzz_run_reset(&chosen[i]);
  fuzz_require_message(po_merge_fill(merge, chosen, found));
  for (size_t i = 0; i < found; ++i) {
    fuzz_run_reset(&chosen[i]);
    for (int c = 0; c < CASES; ++c)
      if (chosen[i].plan == runs[c]->plan)
        *runs[c] = chosen[i];
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part parts[MOST_SHARDS];
  const size_t count = fuzz_split(data, size, parts, MOST_SHARDS);
  if (!runs[0]) {
    runs[0] = fuzz_run("plain");
    runs[1] = fuzz_run("followed");
  }
  const fuzz_token tokens[] = {{"@PROGRAM@", runs[0]->plan->program},
                               {"@PLAIN@", runs[0]->plan->solve_key},
                               {"@FOLLOWED@", runs[1]->plan->solve_key}};
  char *folder = (char *)fuzz_path("shards");
  po_folder_make(folder);
  fuzz_empty(folder);
  for (size_t i = 0; i < count; ++i) {
    char name[64];
    fuzz_part shard = fuzz_fill(&parts[i], tokens, sizeof tokens / sizeof *tokens);
    snprintf(name, sizeof name, "shards/shard-%zu-of-%zu.json", i + 1, count);
    fuzz_write(fuzz_path(name), shard.bytes, shard.size);
    free(shard.bytes);
  }
  po_merge merge;
  po_status status = po_merge_open(&folder, 1, &merge);
  fuzz_require_message(status);
  if (!status) {
    require_one_run(&merge);
    fuzz_require(!(merge.time_limit <= 0), "a time limit of %g is accepted", merge.time_limit);
    fill(&merge, merge.cases, merge.case_count);
  }
  po_merge_close(&merge);
  free(parts[0].bytes);
  return 0;
}
