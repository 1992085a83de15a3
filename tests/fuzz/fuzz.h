/* What the fuzz targets share: properties that are required, parts of an input, a scratch folder.
 *
 * Each target defines LLVMFuzzerTestOneInput, which libFuzzer calls with inputs of its own making
 * and replay.c with those of the corpus. */
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

/* Requires of a refusal that its message is there and made of such words, on one line; forgets the
 * message. Nothing is required of PO_OK, and of PO_NOT_FOUND only the words: it is an answer. */
void fuzz_require_message(po_status status);

/* Requires that each key of a request can be printed and read back equal. */
void fuzz_require_request(const po_request *request);

/* A file in a scratch folder of this process, which is removed at its end; `name` may hold one
 * folder. The path stays valid until the end. */
const char *fuzz_path(const char *name);

/* Writes a file of the scratch folder, making its folder. */
void fuzz_write(const char *path, const char *bytes, size_t size);

/* Removes the files of a folder, not the folders in it. */
void fuzz_empty(const char *folder);

/* A copy of the input, ended by a NUL, cut at lines that are `%%`: the parts of *count, at most
 * `most`. The text of the last part is the rest. Free the first part to free all. */
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

/* The checksum of a table, as its record names it; "" when it is none. */
void fuzz_table_digest(const char *path, char digest[PO_DIGEST_LENGTH]);

/* Writes the second and third part of an input as the curve and the profile of point 0 into a
 * folder of the scratch folder, and their checksums. */
typedef char fuzz_digests[2][PO_DIGEST_LENGTH];
void fuzz_write_tables(const char *folder, const fuzz_part *parts, size_t count,
                       fuzz_digests digests);

/* A case of tests/fuzz/data/cases, planned. It lives until the end of the process. */
po_case_run *fuzz_run(const char *name);

/* Forgets the results of a run, so that it can be read once more. */
void fuzz_run_reset(po_case_run *run);

/* Requires that two runs have the same result of a point, as their records say it. */
void fuzz_require_same_point(const po_case_run *a, const po_case_run *b, size_t point);

#endif
