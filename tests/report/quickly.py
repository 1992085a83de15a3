"""The report in this process, without what takes long and is tested elsewhere: interpreters, typefaces, drawings made twice."""

import contextlib
import functools
import gc
import io
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "reports"))

import make_report  # noqa: E402
from markupsafe import Markup  # noqa: E402
from pulloff_report import fonts, gnuplot, page, svg  # noqa: E402
from pulloff_report.plots import precision, solvers, speed  # noqa: E402
from pulloff_report.sections import environment  # noqa: E402


class Now:
    """The work of beside.start, done at once."""

    def __init__(self, work):
        self.value = work()

    def result(self):
        return self.value


def remembered(function):
    """A function that draws; it draws the same once."""
    kept = {}

    def called(*given, **named):
        key = repr((given, named))
        if key not in kept:
            kept[key] = function(*given, **named)
        return kept[key]
    return called


def drawn_nothing(draw, *given, name, label):
    """In place of matplotlib, which takes seconds: an empty drawing. The texts of its drawings are names of solvers and numbers."""
    return Markup(svg.embeddable('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"></svg>', name, label))


def replace(owner, module, name, replacement):
    """A function of a module for a test, or for the tests of a class."""
    clean = owner.addClassCleanup if isinstance(owner, type) else owner.addCleanup
    clean(setattr, module, name, getattr(module, name))
    setattr(module, name, replacement)


def prepare(owner):
    """For a test, or the tests of a class: no second process, no typefaces, no drawing twice, versions of the tools asked once."""
    for module, name, replacement in ((page.beside, "start", Now), (fonts, "font_faces", lambda text: ""),
                                      (gnuplot, "draw", remembered(gnuplot.draw)), (svg, "embeddable", remembered(svg.embeddable)),
                                      (page, "environment", functools.lru_cache(page.environment)),
                                      (environment, "tool_versions", remembered(environment.tool_versions))):
        replace(owner, module, name, replacement)


def draw_no_times(owner):
    for module in (precision, solvers, speed):
        replace(owner, module, "rendered", drawn_nothing)


def html_only(test, *words):
    """Exit code and standard error of make_report.py, which writes no pages for paper."""
    replace(test, page, "pdf", lambda content: b"")
    code, _, said = main(words)
    return code, said


def main(words):
    """Exit code, standard output and standard error of make_report.py."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = make_report.main(words)
        except SystemExit as ended:  # by argparse
            code = ended.code
    gc.enable()
    return code, out.getvalue(), err.getvalue()
