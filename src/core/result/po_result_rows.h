/* The rows of a result: the only list of its numbers. */
#ifndef PO_RESULT_ROWS_H
#define PO_RESULT_ROWS_H

#include "po_rows.h"

/* Blocks of po_result: all its rows; of these, the keys that every result has, those that it has if
 * they are wanted, the curve, the profile with the contact, and the contact annuli there. */
extern const po_block PO_ALL_ROWS, PO_RESULT_ROWS, PO_WANTED_ROWS, PO_BRANCH_ROWS, PO_SURFACE_ROWS,
    PO_CONTACT_ROWS;

/* Of the items of its lists; of the pull-off, a block of po_result; of a step of a staircase; of
 * the states of a loop; of a theory; and of one that holds for the parabola alone. */
extern const po_block PO_CURVE_ROWS, PO_PROFILE_ROWS, PO_SPECIAL_POINT_ROWS, PO_PULL_OFF_ROWS,
    PO_STEP_ROWS, PO_LOOP_ROW_ROWS, PO_THEORIES_ROWS, PO_PARABOLA_THEORY_ROWS, PO_UNCERTAIN_ROWS;

/* The label of a jump, or of one of its ends. Labels are numbered from 1: "1", "2", ... in loading;
 * "a", "b", ... "z", "aa", ... in unloading. */
void po_jump_label(bool loading, size_t number, po_label label);

/* Private to the module: the parts of a result that have files of their own. */
extern const po_block PO_HYSTERESIS_ROWS, PO_STAIRCASE_ROWS, PO_DIAGNOSTICS_ROWS;

#endif
