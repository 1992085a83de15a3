/* The digest of results, a few hexadecimal digits that two people can compare (doc/json.md#digest),
 * and the checksum of a document, by which an altered file is noticed (doc/json.md#checksums). */
#ifndef PO_JSON_DIGEST_H
#define PO_JSON_DIGEST_H

#include "po_digest.h"
#include "po_json_value.h"

enum { PO_RESULT_DIGEST_LENGTH = 17 }; /* 16 hexadecimal digits and the NUL */

/* The digest of a document, or of a part of one: the first 16 digits of the SHA-256 of the lines
 * `PATH=VALUE` of all its results, in the order of the sorted keys. Numbers are written as the bits
 * of a double. What does not belong to the results has no line: what was asked, counters of work,
 * times, messages, values in SI units, and condition numbers, which depend on the library for
 * linear algebra. Status: PO_NO_MEMORY, also for a document that is NULL. */
po_status po_json_digest(const json_t *document, char digest[PO_RESULT_DIGEST_LENGTH]);

/* Adds the member "digest". If memory runs out, the document is released and *document is NULL. */
void po_json_seal(json_t **document);

/* As po_json_print, or as po_json_print_line, for an object with members, with "checksum" as the
 * first member: the SHA-256 of all lines but its own; of one line, of all but this member.
 * Returned: digest, this checksum. Status: PO_NO_MEMORY, also for a document that is NULL. */
po_status po_json_print_checked(const json_t *document, bool line, po_text *text,
                                char digest[PO_DIGEST_LENGTH]);

/* As po_json_parse. Returned: *intact, whether the document has its checksum. */
po_status po_json_parse_checked(const char *bytes, size_t size, json_t **document, bool *intact);

#endif
