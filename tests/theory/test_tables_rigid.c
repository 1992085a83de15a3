/* The pull-off of Eq 22 against every row of its reference table. It takes seconds, so it is a
 * program of its own. */
#include "../unit/run.h"
#include "po_wavy_rigid.h"
#include "table.h"

/* The tolerance that the header states. */
static const double RIGID_ACCURACY = 1e-10;

ROWS_TEST(rigid_pull_off_agrees_with_the_table, "rigid_pull_off.csv", "pull-off of Eq 22", 153, 2) {
  const po_rigid_pull_off got =
      po_wavy_rigid_pull_off(table_number(t, row, "amplitude"), table_number(t, row, "alpha"));
  table_compare(t, row, "force", got.force, RIGID_ACCURACY * table_number(t, row, "force"));
  table_compare(t, row, "approach", got.approach, RIGID_ACCURACY);
}
