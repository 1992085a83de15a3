#include "po_digest.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <nettle/sha2.h>

void po_digest_two(const void *first, size_t first_size, const void *second, size_t second_size,
                   char digest[PO_DIGEST_LENGTH]) {
  struct sha256_ctx context;
  uint8_t raw[SHA256_DIGEST_SIZE];
  sha256_init(&context);
  sha256_update(&context, first_size, first);
  sha256_update(&context, second_size, second);
  sha256_digest(&context, sizeof raw, raw);
  for (size_t i = 0; i < sizeof raw; ++i)
    snprintf(digest + 2 * i, 3, "%02x", raw[i]);
}

void po_digest_bytes(const void *bytes, size_t size, char digest[PO_DIGEST_LENGTH]) {
  po_digest_two(bytes, size, "", 0, digest);
}

bool po_digest_agrees(const char *stated, const char *computed) {
  return strcmp(stated, computed) == 0;
}
