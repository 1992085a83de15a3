/* Prints what a test along the branch gives: loops, staircases, and the profile. */
#ifndef PO_PRINT_TEST_H
#define PO_PRINT_TEST_H

#include "po_request.h"
#include "po_result.h"
#include "po_si.h"

/* Prints the loops and the staircases of the result, of the JKR theory, too, and the sizes of the
 * results that are too long for the terminal: in SI units if the scene is. */
void po_print_test(const po_request *request, const po_result *result);

/* An error with two digits; empty if none was estimated. */
const char *po_print_error(double error, char text[16]);

#endif
