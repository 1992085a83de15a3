/* The rows of the theories beside a solve. */
#include "po_theories.h"

#include "po_result_rows.h"
#include "po_row_cells.h"

#define NAME(key, name, ...) [PO_THEORY_##key] = name,
#define DESCRIBED(key, name, words, source) [PO_THEORY_##key] = {name, words, source},
#define LISTED(key, name, ...) ", " name
static const char *const NAMES[] = {PO_THEORY_ROWS(NAME) NULL};

const char *const PO_THEORY_NAMES = &(PO_THEORY_ROWS(LISTED))[2];

const po_theory_text PO_THEORIES[] = {PO_THEORY_ROWS(DESCRIBED)};

#define KEY(key, name, ...) [PO_ASSUMES_##key] = name,
#define MEANING(key, name, words) [PO_ASSUMES_##key] = words,
static const char *const NUMBERS[] = {PO_ASSUMPTION_ROWS(KEY) NULL};

const char *const PO_ASSUMPTIONS[] = {PO_ASSUMPTION_ROWS(MEANING)};

static const char *const HOLDS[] = {"unknown", "no", "yes", NULL};
static const char *const SIDES[] = {"at_most", "at_least", NULL};

// clang-format off
#define UNEVALUATED "if the theory cannot be evaluated"
#define S po_theory_row
static const po_row ROWS[] = {
  WORD("theory", theory, NAMES, "name of the theory"),
  TEXT("source", source, "authors, year and equation of the paper"),
  NUMBER("force", force, LOAD, "", UNEVALUATED, "pull-off force of the theory"),
  NUMBER("deviation", deviation, NONE, "deviation_error_estimate", "if the theory or the solve has no pull-off force",
         "force of the theory divided by the computed one, less 1"),
  NUMBER("deviation_error_estimate", deviation_error, NONE, "", "if there is no estimate",
         "bound of the error of `deviation` by that of the computed force"),
  WORD("assumptions", holds, HOLDS, "whether the assumptions of the theory hold"),
  WORD("decided_by", decided_by, NUMBERS, "the first assumption that does not hold, otherwise the first one"),
  NUMBER("number", number, NONE, "", "if not known, and " UNEVALUATED, "the number of `decided_by`"),
  WORD("side", at_least, SIDES, "whether the limit is the greatest or the least number with which the assumption holds"),
  NUMBER("limit", limit, NONE, "", UNEVALUATED, "limit of `number`"),
  TEXT("reason", reason, "why the theory cannot be evaluated; otherwise empty"),
};
const po_block PO_THEORIES_ROWS = BLOCK("theory_row", ROWS, NULL);
#undef S

#define S po_parabola_theory
static const po_row OF_PARABOLA[] = {
  WORD("theory", theory, NAMES, "name of a theory whose assumptions hold"),
};
const po_block PO_PARABOLA_THEORY_ROWS = BLOCK("parabola_theory", OF_PARABOLA, NULL);
#undef S
