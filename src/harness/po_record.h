/* The record of a case: <output>/<case>/record.json, beside it the curves and profiles. */
#ifndef PO_RECORD_H
#define PO_RECORD_H

#include "po_run.h"

/* Writes the tables, then the record. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_record_write(const po_case_run *run, const char *output, int jobs);

/* Reads the outcomes of an earlier run of the same solves back. Status: PO_NOT_FOUND when there is
 * none, or it is of other scenes, another program, or damaged: then it has to be solved again. */
po_status po_record_read(po_case_run *run, const char *output);

#endif
