/* The verbs of the program. Each function reads the command line of its verb (argv[0] is the verb)
 * and returns the exit code. */
#ifndef PO_VERBS_H
#define PO_VERBS_H

/* Reads the command line of the program (argv[1] is the verb) and runs the verb. */
int po_verbs_run(int argc, char **argv);

int po_verb_solve(int argc, char **argv);
int po_verb_compare(int argc, char **argv);
int po_verb_follow(int argc, char **argv);
int po_verb_theory(int argc, char **argv);
int po_verb_plot(int argc, char **argv);
int po_verb_list(int argc, char **argv);
int po_verb_plan(int argc, char **argv);
int po_verb_run(int argc, char **argv);
int po_verb_merge(int argc, char **argv);
int po_verb_verify(int argc, char **argv);
int po_verb_conform(int argc, char **argv);
int po_verb_seal(int argc, char **argv);
int po_verb_report(int argc, char **argv);
int po_verb_explain(int argc, char **argv);
int po_verb_bless(int argc, char **argv);

#endif
