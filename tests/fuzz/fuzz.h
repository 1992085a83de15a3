/* Functions of all fuzz targets: required properties, parts of an input, a scratch folder.
 *
 * Each target defines LLVMFuzzerTestOneInput. libFuzzer calls it with generated inputs, replay.c
 * with those of the corpus. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_run.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the process with a message (printf style) unless `holds`: a property was violated. */
void fuzz_require(bool holds, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Requires that a text is valid UTF-8 without control characters; `what` names it. A line feed is
 * allowed in a text of several lines. */
void fuzz_require_words(const char *what, const char *text, bool lines);

/* Requires that a status other than PO_OK has a message of one line of such text, and clears the
 * message. PO_NOT_FOUND is an answer and may have no message. */
void fuzz_require_message(po_status status);

/* Requires that each key of a request can be printed and read back equal. */
void fuzz_require_request(const po_request *request);

/* The path of a file in the scratch folder of this process, which is removed when the process ends.
 * `name` may contain one folder. The path stays valid until the end. */
const char *fuzz_path(const char *name);

/* Writes a file of the scratch folder and creates its folder. */
void fuzz_write(const char *path, const char *bytes, size_t size);

/* Removes the files of a folder, not the folders in it. */
void fuzz_empty(const char *folder);

/* A copy of the input, ended by a NUL, divided at lines `%%` into *count parts, at most `most`. The
 * last part contains the rest. Freeing the first part frees all. */
typedef struct {
  char *bytes;
  size_t size;
} fuzz_part;
size_t fuzz_split(const uint8_t *data, size_t size, fuzz_part *parts, size_t most);

/* A copy of a part in which each of `count` tokens is replaced by its value. Free it. */
typedef struct {
  const char *token, *value;
} fuzz_token;
fuzz_part fuzz_fill(const fuzz_part *part, const fuzz_token *tokens, size_t count);

/* The plan of a case of tests/fuzz/data/cases. It exists until the end of the process. */
po_case_run *fuzz_run(const char *name);

/* Clears the results of a run, so that it can be read again. */
void fuzz_run_reset(po_case_run *run);

/* Requires that the records of two runs state the same result of a point. */
void fuzz_require_same_point(const po_case_run *a, const po_case_run *b, size_t point);

#endif
