/* Verdicts that combine the checks of the same number against different references.
 *
 * An oracle shows whether a number is correct, a pin shows whether it changed. The combination:
 *
 *   value         error against the oracle       verdict of the pin   of the oracle
 *   as pinned     within                         within               within
 *   as pinned     outside                        within               wrong_and_frozen
 *   changed       decreased, within              improved             within
 *   changed       increased                      regressed            within or outside
 *   changed       decreased, but outside         moved                outside
 *   changed       undecided, or no oracle        moved
 *
 * An oracle is undecided if the errors of both values are below its uncertainty. With several
 * oracles, an increase against one of them counts as an increase. Published values have no
 * influence on the verdict of a pin: their uncertainty is as large as the errors.
 *
 * Counters of work have no oracle: an increase is regressed, a decrease is improved.
 *
 * The tolerance of a check against an oracle or a published value is slack if it is more than a
 * thousand times the largest error of all points of the case, because the same tolerance applies to
 * all of them. Errors below the uncertainty of the reference, or below rounding, are replaced by
 * these. Two kinds of tolerance are never slack: those of integers (numbers of folds, shares of
 * solved points), and those of pins, which an unchanged program reproduces to the last bit. */
#ifndef PO_JUDGE_H
#define PO_JUDGE_H

#include "po_check_result.h"

/* Replaces the verdicts of the individual checks of a case by the combined verdicts. */
void po_judge(po_check_results *check_results);

#endif
