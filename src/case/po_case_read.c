#include "po_case_read.h"

#include <stdlib.h>

#include "po_case_parse.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_schema.h"

po_status po_case_read(const char *path, const char *shown, po_case **result) {
  *result = NULL;
  po_yaml *yaml = NULL;
  po_case *kase = po_allocate(1, sizeof *kase);
  po_status status = kase ? PO_OK : PO_NO_MEMORY;
  if (!status && (!(kase->path = po_copy_text(path)) || !(kase->shown = po_copy_text(shown))))
    status = PO_NO_MEMORY;
  if (!status)
    status = po_file_read(path, &kase->source, &kase->source_size);
  if (!status)
    status = po_yaml_create(shown, kase->source, kase->source_size, &yaml);
  if (!status)
    status = po_schema_load(yaml, &kase->file);
  if (!status)
    status = po_case_parse(kase, yaml);
  po_yaml_destroy(yaml);
  if (status)
    po_case_destroy(kase);
  else
    *result = kase;
  return status;
}

void po_case_destroy(po_case *kase) {
  if (!kase)
    return;
  for (size_t i = 0; kase->points && i < kase->point_count; ++i)
    free(kase->points[i].label);
  free(kase->points);
  po_case_axes_clear(kase->file);
  po_schema_free(kase->file);
  free(kase->source);
  free(kase->word);
  free(kase->shown);
  free(kase->path);
  free(kase);
}
