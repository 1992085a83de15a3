/* What the ledgers say together.
 *
 * An oracle says whether a number is right, a pin whether it is what it was. Together:
 *
 *   pin    oracle                        verdict of the pin   of the oracle
 *   holds  within                        within               within
 *   holds  outside                       within               wrong_and_frozen
 *   moved  within, error fell            improved             within
 *   moved  error rose                    regressed            within or outside
 *   moved  outside, though error fell    moved                outside
 *   moved  silent, or no oracle          moved
 *
 * An oracle is silent when both errors lie below its own uncertainty: it cannot tell them apart.
 * With several oracles an error that rose against one of them rose. Published values judge by
 * themselves: their uncertainty is of the size of the errors, and no pin is moved for their sake.
 *
 * Counters of work have no oracle: more is regressed, less is improved.
 *
 * A tolerance against an oracle or a published value is slack when it is more than a thousand times
 * the largest error it met, at any point of the case: one tolerance serves all points of a check,
 * so the worst of them is what it must be measured by. An error counts as no less than the
 * uncertainty of its reference and than rounding. Numbers of folds and shares of solves are counted
 * and no tolerance of theirs is slack; nor is that of a pin, which a program that did not change
 * meets to the bit. */
#ifndef PO_JUDGE_H
#define PO_JUDGE_H

#include "po_check_result.h"

/* Turns the verdicts of the checks of one case, each judged by itself, into the common ones. */
void po_judge(po_check_results *check_results);

#endif
