#include "po_environment.h"
#include "po_file.h"
#include "po_options.h"
#include "po_python.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff report [OPTION]...\n"
    "Writes report.html and report.pdf from the records of a run. Solves nothing.\n"
    "\n"
    "  --run DIR       folder of the records (default build/run)\n"
    "  --output DIR    folder to which the report is written (default build/report)\n"
    "  --fresh         draw all figures again, even if their data have not changed\n"
    "  -h, --help      print this text\n"
    "\n"
    "Example: pulloff report --run build/run --output build/report\n";

typedef struct {
  const char *run, *output;
  bool fresh;
} report_line;

static const po_option OPTIONS[] = {PO_TEXT("run", report_line, run, "the name of a folder"),
                                    PO_OUTPUT(report_line, output, "the name of a folder"),
                                    PO_FLAG("fresh", report_line, fresh),
                                    {0}};

static po_status check_means(const char *script, const char *run) {
  if (!po_path_exists(script))
    return po_fail(PO_CANNOT_READ,
                   "%s does not exist: expected it in the data folder (PULLOFF_DATA)", script);
  if (!po_path_exists(run))
    return po_fail(PO_CANNOT_READ,
                   "%s does not exist: expected the records of a run (see pulloff run --help)",
                   run);
  if (!*po_program_find(po_python()).text)
    return po_fail(PO_MISSING_TOOL, "%s was not found: expected Python, which writes the report",
                   po_python());
  if (!*po_program_find("gnuplot").text)
    return po_fail(PO_MISSING_TOOL,
                   "gnuplot was not found: expected it in PATH, to draw the figures");
  return PO_OK;
}

/* Runs the script. Returned: its exit code. */
static int run_script(const char *script, const report_line *line) {
  char *const argv[] = {(char *)po_python(),
                        (char *)script,
                        "--run",
                        (char *)line->run,
                        "--output",
                        (char *)line->output,
                        line->fresh ? "--fresh" : NULL,
                        NULL};
  return po_python_run(argv);
}

int po_verb_report(int argc, char **argv) {
  const po_options options = {"report", HELP, OPTIONS, argc, argv};
  report_line line = {.run = "build/run", .output = "build/report"};
  po_status status = PO_OK;
  if (!po_options_read(&options, &line, &status))
    return po_options_end(status);
  const po_file_path script = po_path_join(po_environment_data(), "reports/make_report.py");
  status = check_means(script.text, line.run);
  if (!status)
    status = po_folder_make(line.output);
  return status ? po_options_end(status) : run_script(script.text, &line);
}
