/* SHA-256 checksums, which identify the content of files and of solves. */
#ifndef PO_DIGEST_H
#define PO_DIGEST_H

#include <stdbool.h>
#include <stddef.h>

enum { PO_DIGEST_LENGTH = 65 }; /* 64 hexadecimal digits and the NUL */

/* The SHA-256 (FIPS 180-4) of `size` bytes, in lower-case hexadecimal. */
void po_digest_bytes(const void *bytes, size_t size, char digest[PO_DIGEST_LENGTH]);

/* The SHA-256 of two byte sequences, one appended to the other. */
void po_digest_two(const void *first, size_t first_size, const void *second, size_t second_size,
                   char digest[PO_DIGEST_LENGTH]);

/* Whether a stated checksum is the computed one. The checksums of records are compared by this
 * function alone, so that a fuzz target can make every input fit. */
bool po_digest_agrees(const char *stated, const char *computed);

#endif
