#include "po_environment.h"

#include <limits.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <gsl/gsl_version.h>
#include <yaml.h>

#include "po_file.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_text.h"

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

json_t *po_environment_versions(void) {
  return PO_JSON_OBJECT({"pulloff", po_json_text(PULLOFF_VERSION)},
                        {"compiler", po_json_text(COMPILER)}, {"gsl", po_json_text(gsl_version)},
                        {"openblas", po_json_text(po_linear_library())},
                        {"lapacke", po_json_text(PULLOFF_LAPACKE_VERSION)},
                        {"jansson", po_json_text(jansson_version_str())},
                        {"libyaml", po_json_text(yaml_get_version_string())});
}

static const char EXECUTABLE[] = "/proc/self/exe";

/* Returned: in `text`, the value in the first line of a file that begins with `start`, without
 * separator, blanks and quotes; "unknown" if there is no such line. */
static void find_line(const char *path, const char *start, char *text, size_t size) {
  snprintf(text, size, "unknown");
  po_memory_watch();
  FILE *file = fopen(path, "r");
  char line[512];
  while (file && fgets(line, sizeof line, file)) {
    if (strncmp(line, start, strlen(start)) != 0)
      continue;
    const char *value = line + strlen(start);
    value += strspn(value, " \t:=\"");
    snprintf(text, size, "%.*s", (int)strcspn(value, "\"\n"), value);
    break;
  }
  if (po_memory_ran_out())
    po_fail(PO_NO_MEMORY, "no memory to read %s", path);
  if (file)
    fclose(file);
}

int po_environment_cores(void) {
  return omp_get_num_procs();
}

json_t *po_environment_describe(int jobs) {
  char system[256], processor[256], date[32];
  struct utsname name;
  find_line("/etc/os-release", "PRETTY_NAME", system, sizeof system);
  find_line("/proc/cpuinfo", "model name", processor, sizeof processor);
  if (uname(&name) != 0)
    snprintf(name.machine, sizeof name.machine, "unknown");
  const time_t now = time(NULL);
  struct tm utc;
  gmtime_r(&now, &utc);
  strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return PO_JSON_OBJECT({"system", po_json_text(system)}, {"machine", po_json_text(name.machine)},
                        {"processor", po_json_text(processor)},
                        {"cores", po_json_count((uint64_t)po_environment_cores())},
                        {"jobs", po_json_count((uint64_t)jobs)}, {"date", po_json_text(date)});
}

po_status po_environment_program(char digest[PO_DIGEST_LENGTH]) {
  char *program = NULL;
  size_t size = 0;
  po_text text = {0};
  po_status status = po_path_exists(EXECUTABLE) ? po_file_read(EXECUTABLE, &program, &size) : PO_OK;
  po_text_add(&text, "%s|%s|", PULLOFF_VERSION, COMPILER);
  if (program) {
    po_digest_bytes(program, size, digest);
    po_text_add(&text, "%s", digest);
  }
  free(program);
  if (!status && text.failed)
    status = PO_NO_MEMORY;
  po_digest_bytes(po_text_string(&text), text.length, digest);
  po_text_clear(&text);
  return status;
}

/* Finds a file or folder whose path is relative to that of the executable. Returned: its path
 * without symbolic links; false if there is none. */
static bool find_beside_program(const char *relative, char folder[PATH_MAX]) {
  char path[2 * PATH_MAX];
  const ssize_t length = readlink(EXECUTABLE, path, PATH_MAX - 1);
  if (length <= 0)
    return false;
  path[length] = '\0';
  char *name = strrchr(path, '/') + 1;
  snprintf(name, sizeof path - (size_t)(name - path), "%s", relative);
  return realpath(path, folder) != NULL;
}

/* Finds the folder that a file beside the executable names, by a path relative to its own. */
static bool find_named_beside_program(const char *name, char folder[PATH_MAX]) {
  char path[PATH_MAX], *line = NULL;
  size_t size = 0;
  if (!find_beside_program(name, path) || po_file_read(path, &line, &size))
    return false;
  line[strcspn(line, "\n")] = '\0';
  const bool found = find_beside_program(line, folder);
  free(line);
  return found;
}

const char *po_environment_data(void) {
  static char found[PATH_MAX];
  const char *chosen = getenv("PULLOFF_DATA");
  if (chosen && *chosen)
    return chosen;
  if (!*found && !find_named_beside_program("data-folder.txt", found) &&
      !find_beside_program(PULLOFF_DATA_FROM_PROGRAM, found))
    snprintf(found, sizeof found, "%s", PULLOFF_DATA_INSTALLED);
  return found;
}
