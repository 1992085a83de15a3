"""Does a piece of work in a second process, beside this one."""

import concurrent.futures
import multiprocessing

_work = None


def start(work):
    """Calls a function without arguments in a copy of this process; result() of what is returned waits for its value."""
    # A function with data cannot be sent to another process, but a copy of this process has it.
    pool = concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("fork"), _keep, (work,))
    value = pool.submit(_call)
    pool.shutdown(wait=False)
    return value


def _keep(work):
    global _work
    _work = work


def _call():
    return _work()
