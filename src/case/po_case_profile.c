/* Keys of the scene that name the same thing in two ways, and the files of profiles. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_parts.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_schema.h"

/* The length of the folder of the case file in its path, with the slash. */
static size_t folder_length(const po_case *kase) {
  const char *slash = strrchr(kase->path, '/');
  return slash ? (size_t)(slash - kase->path) + 1 : 0;
}

const char *po_case_profile_shown(const po_case *kase, const char *path) {
  const size_t length = folder_length(kase);
  return strncmp(path, kase->path, length) == 0 ? path + length : path;
}

po_status po_case_profile_path(const po_case *kase, char **word) {
  po_text path = {0};
  if ((*word)[0] == '/')
    return PO_OK;
  po_text_add(&path, "%.*s%s", (int)folder_length(kase), kase->path, *word);
  if (path.failed)
    return PO_NO_MEMORY;
  free(*word);
  *word = path.data;
  return PO_OK;
}

/* Replaces the name of a table, relative to the case file, by its path, and reads it. */
static po_status resolve(const po_case *kase, const po_yaml *yaml, char **word, const char *format,
                         ...) __attribute__((format(printf, 4, 5)));

static po_status resolve(const po_case *kase, const po_yaml *yaml, char **word, const char *format,
                         ...) {
  char where[2 * PO_CASE_WHERE_LENGTH];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(where, sizeof where, format, arguments);
  va_end(arguments);
  po_profile scratch = po_profile_sphere();
  po_status status = po_case_profile_path(kase, word);
  if (!status)
    status = po_profile_set_file(&scratch, *word);
  return status ? po_case_refuse_for(yaml, where, status) : PO_OK;
}

static po_status resolve_axes(const po_case *kase, const po_yaml *yaml, po_axis *axes,
                              unsigned count, const char *list) {
  po_status status = PO_OK;
  for (unsigned i = 0; i < count; ++i)
    if (axes[i].key && po_key_of_name(axes[i].key) == PO_KEY_PROFILE_FILE)
      for (unsigned k = 0; k < axes[i].values_count && !status; ++k)
        status = resolve(kase, yaml, &axes[i].values[k], "%s[%u].values[%u]", list, i + 1, k + 1);
  return status;
}

static po_status resolve_checks(const po_case *kase, const po_yaml *yaml, po_check *checks,
                                unsigned count, const char *list) {
  po_status status = PO_OK;
  for (unsigned i = 0; i < count && !status; ++i) {
    char when[PO_CASE_WHERE_LENGTH], as_if[PO_CASE_WHERE_LENGTH];
    snprintf(when, sizeof when, "%s[%u].when", list, i + 1);
    snprintf(as_if, sizeof as_if, "%s[%u].as_if", list, i + 1);
    status = resolve_axes(kase, yaml, checks[i].when, checks[i].when_count, when);
    if (!status)
      status = resolve_axes(kase, yaml, checks[i].as_if, checks[i].as_if_count, as_if);
  }
  return status;
}

static po_status resolve_sweep(const po_case *kase, const po_yaml *yaml) {
  po_case_file *file = kase->file;
  po_status status = PO_OK;
  for (unsigned i = 0; i < file->sweep_count && !status; ++i) {
    po_sweep *sweep = &file->sweep[i];
    if (sweep->axis.key && po_key_of_name(sweep->axis.key) == PO_KEY_PROFILE_FILE)
      for (unsigned k = 0; k < sweep->axis.values_count && !status; ++k)
        status = resolve(kase, yaml, &sweep->axis.values[k], "sweep[%u].values[%u]", i + 1, k + 1);
    for (unsigned k = 0; k < sweep->together_count && !status; ++k)
      if (sweep->together[k].values[PO_KEY_PROFILE_FILE])
        status = resolve(kase, yaml, &sweep->together[k].values[PO_KEY_PROFILE_FILE],
                         "sweep[%u].together[%u].profile_file", i + 1, k + 1);
  }
  return status;
}

po_status po_case_refuse_for(const po_yaml *yaml, const char *where, po_status status) {
  if (status == PO_NO_MEMORY)
    return status;
  char *why = po_copy_text(po_message());
  const po_status failed = po_fail(status, "%s:%zu: %s: %s", po_yaml_name(yaml),
                                   po_yaml_line(yaml, where), where, why ? why : "refused");
  free(why);
  return failed;
}

po_status po_case_profile_resolve(po_case *kase, const po_yaml *yaml) {
  po_case_file *file = kase->file;
  po_status status = PO_OK;
  if (file->scene.values[PO_KEY_PROFILE_FILE])
    status = resolve(kase, yaml, &file->scene.values[PO_KEY_PROFILE_FILE], "scene.profile_file");
  if (!status)
    status = resolve_sweep(kase, yaml);
  if (!status)
    status = resolve_checks(kase, yaml, file->checks, file->checks_count, "checks");
  if (!status)
    status = resolve_checks(kase, yaml, file->measure, file->measure_count, "measure");
  for (unsigned i = 0; i < file->leave_out_count && !status; ++i) {
    char list[PO_CASE_WHERE_LENGTH];
    snprintf(list, sizeof list, "leave_out[%u].when", i + 1);
    status = resolve_axes(kase, yaml, file->leave_out[i].when, file->leave_out[i].when_count, list);
  }
  return status;
}

/* Keys that set the same. */
static const struct {
  po_key key, other;
  const char *expected;
} PAIRS[] = {
    {PO_KEY_PROFILE, PO_KEY_PROFILE_FILE, "only one of profile and profile_file"},
    {PO_KEY_AMPLITUDE, PO_KEY_WAVES, "only waves, or amplitude and wavelength"},
    {PO_KEY_WAVELENGTH, PO_KEY_WAVES, "only waves, or amplitude and wavelength"},
    {PO_KEY_TABOR, PO_KEY_COUPLING, "only one of tabor and coupling"},
};

po_status po_case_profile_check(const po_case_file *file, const po_yaml *yaml) {
  const char *const *scene = (const char *const *)file->scene.values;
  for (size_t i = 0; i < sizeof PAIRS / sizeof *PAIRS; ++i) {
    const po_key key = PAIRS[i].key, other = PAIRS[i].other;
    if (scene[other] && (scene[key] || po_case_varies(file, key)))
      return po_schema_refuse(yaml, PAIRS[i].expected, "scene.%s", po_key_name(other));
    if (scene[key] && po_case_varies(file, other))
      return po_schema_refuse(yaml, PAIRS[i].expected, "scene.%s", po_key_name(key));
    for (unsigned k = 0; k < file->sweep_count; ++k)
      for (unsigned n = 0; n < file->sweep[k].together_count; ++n)
        if (file->sweep[k].together[n].values[key] && file->sweep[k].together[n].values[other])
          return po_schema_refuse(yaml, PAIRS[i].expected, "sweep[%u].together[%u].%s", k + 1,
                                  n + 1, po_key_name(other));
  }
  return PO_OK;
}
