"""Calls of the library that take long."""

from __future__ import annotations

import contextlib
import ctypes
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any, TypeVar

from ._library import C, Message
from ._result import Result, SolveError, check, result_of
from ._values import Error, encoded, known_key

_T = TypeVar("_T")


@contextlib.contextmanager
def in_library(given: dict[str, str]) -> Iterator[ctypes.c_void_p]:
    """The scene of the library with these texts. It exists during one call, and belongs to it alone: whatever becomes of
    a Scene meanwhile, in other threads, too, the library does not see."""
    message, handle = Message(), ctypes.c_void_p()
    check(C.pulloff_scene_create(handle, message), message)
    try:
        for key, text in given.copy().items():
            value = encoded(known_key(key), text, "a text")
            check(C.pulloff_scene_set(handle, key.encode(), value, message), message)
        yield handle
    finally:
        C.pulloff_scene_destroy(handle)


def interruptible(call: Callable[[ctypes.c_int], _T], watch: Callable[[], None] | None = None) -> _T:
    """Runs a call of the library, which is given the flag that ends it. In the main thread, the call runs in another one,
    so that a KeyboardInterrupt can set the flag; so it does if `watch` shall be called meanwhile. Whatever the library
    uses belongs to the call, which ends by itself if this function is left."""
    stop = ctypes.c_int(0)
    if watch is None and threading.current_thread() is not threading.main_thread():
        return call(stop)
    outcome: list[Any] = []

    def work() -> None:
        try:
            outcome.extend((call(stop), None))
        except BaseException as error:
            outcome.extend((None, error))

    worker = threading.Thread(target=work, name="pulloff")
    try:
        try:
            worker.start()
        except RuntimeError:  # there are no more threads, for example at the end of the interpreter
            return call(stop)
        while worker.is_alive():
            worker.join(0.1 if watch else None)
            if watch:
                watch()
    except BaseException:
        stop.value = 1
        while worker.is_alive():
            with contextlib.suppress(BaseException):  # of a second Ctrl-C
                worker.join()
        raise
    error = outcome.pop()
    if error is None:
        return outcome.pop()  # type: ignore[no-any-return]
    try:
        raise error
    finally:
        del error


def solve_given(given: dict[str, str], stop: ctypes.c_int) -> Result:
    message, handle = Message(), ctypes.c_void_p()
    with in_library(given) as scene:
        C.pulloff_scene_set_stop(scene, stop)
        status = check(C.pulloff_solve(scene, handle, message), message)
    try:
        result = result_of(handle)
    finally:
        C.pulloff_result_destroy(handle)
    if status:
        raise SolveError(message.text.decode(errors="replace"), status, result)
    return result


class Progress:
    """What a series has to show."""

    def __init__(self, count: int, show: Callable[[int, int], object]) -> None:
        self.seen, self.count, self.shown, self.show = ctypes.c_int(0), count, 0, show

    def __call__(self, last: bool = False) -> None:
        seen = self.count if last else min(self.seen.value, self.count - 1)
        if seen > self.shown:
            self.shown = seen
            self.show(seen, self.count)


def print_progress(seen: int, count: int) -> None:
    print(f"\r{seen}/{count} scenes", end="\n" if seen == count else "", file=sys.stderr, flush=True)


def follow_given(given: dict[str, str], key: bytes, values: list[float], stop: ctypes.c_int,
                 show: Progress | None) -> list[Result]:
    numbers, handles, message = (ctypes.c_double * len(values))(*values), (ctypes.c_void_p * len(values))(), Message()
    with in_library(given) as scene:
        C.pulloff_scene_set_stop(scene, stop)
        if show:
            C.pulloff_scene_set_seen(scene, show.seen)
        status = check(C.pulloff_follow(scene, key, numbers, len(values), handles, message), message)
    if status:  # interrupted: there are no results
        raise Error(message.text.decode(errors="replace"), status)
    try:
        return [result_of(ctypes.c_void_p(handle)) for handle in handles]
    finally:
        for handle in handles:
            C.pulloff_result_destroy(handle)
