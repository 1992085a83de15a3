/* The verbs of the program. Each function reads the command line of its verb (argv[0] is the verb)
 * and returns the exit code. */
#ifndef PO_VERBS_H
#define PO_VERBS_H

/* Reads the command line of the program (argv[1] is the verb) and runs the verb. */
int po_verbs_run(int argc, char **argv);

/* One row a verb: its name, in which _ stands for -, and what it does. */
// clang-format off
#define PO_VERBS(X) \
  X(solve, "solve one scene") \
  X(compare, "compare the pull-off force of one scene with every theory") \
  X(follow, "compute the pull-off of a series of scenes in which one parameter varies") \
  X(theory, "evaluate a closed form, of the paper or of any profile") \
  X(contact_law, "write the law of contact of two particles for other programs") \
  X(profile, "make the profile of a body of a line scan across its apex") \
  X(fit, "fit work of adhesion, range and modulus to a measured force curve") \
  X(plot, "plot one scene or the pull-off forces of a case") \
  X(list, "list the cases or the reference tables") \
  X(plan, "print what would be computed for a case, and why") \
  X(run, "solve the points of cases and write their records") \
  X(merge, "combine the shards of a run") \
  X(verify, "compare the results of cases with references and print the verdicts") \
  X(explain, "explain the checks that are not within their tolerance") \
  X(bless, "accept the results of a case as its pins") \
  X(conform, "test whether an external solver follows the protocol") \
  X(seal, "make reference tables of CSV files") \
  X(report, "write the report of a run")
// clang-format on
#define PO_VERB_FUNCTION(name, summary) int po_verb_##name(int argc, char **argv);
PO_VERBS(PO_VERB_FUNCTION)

#endif
