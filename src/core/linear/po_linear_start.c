/* Part of the program, not of a library: it decides for the whole process that OpenBLAS starts no
 * threads.
 *
 * OpenBLAS calls a function of this name when it is loaded, to obtain the number of threads to
 * start; the dynamic linker finds this definition before that of OpenBLAS. A thread of OpenBLAS
 * polls for work, which doubles the processor time of a short solve, and maps a work area before
 * main begins. Condition numbers, for which alone it is called (po_linear.c), need no threads. */
int openblas_num_threads_env(void);
int openblas_num_threads_env(void) {
  return 1;
}
