"""The program, the libraries and the machine that the run was computed with."""

import platform
import subprocess

from . import Section
from .. import words
from ..gnuplot import require

LABELS = {"pulloff": "pulloff", "compiler": "Compiler", "gsl": "GSL", "openblas": "OpenBLAS",
          "lapacke": "LAPACKE", "jansson": "Jansson", "libyaml": "libyaml", "nettle": "Nettle",
          "system": "System", "machine": "Machine", "processor": "Processor", "cores": "Cores",
          "jobs": "Parallel jobs", "date": "Date"}


def span(dates):
    """The range from the first date to the last, in words."""
    first, last = words.date(min(dates)), words.date(max(dates))
    return first if first == last else f"{first} to {last}"


def merged(cases, part):
    """Rows (label, [(value, names of the cases with this value)]); no names where all cases agree."""
    keys = list(dict.fromkeys(key for case in cases for key in case.record[part]))
    rows = []
    for key in keys:
        values = {}
        for case in cases:
            values.setdefault(str(case.record[part].get(key, "not recorded")), []).append(case.name)
        if key == "date":
            values = {span(values): []}
        named = len(values) > 1
        rows.append((LABELS.get(key, key.replace("_", " ").capitalize()),
                     [(value, ", ".join(names) if named else "") for value, names in values.items()]))
    return rows


def tool_versions():
    """Versions of the programs that drew this report."""
    import jinja2
    import matplotlib
    import numpy
    import scipy
    import weasyprint
    said = subprocess.run([require(), "--version"], capture_output=True, text=True, check=False)
    return [("gnuplot", said.stdout.replace("gnuplot", "").replace(" patchlevel ", ".").strip()),
            ("Python", platform.python_version()), ("NumPy", numpy.__version__),
            ("SciPy", scipy.__version__), ("Matplotlib", matplotlib.__version__),
            ("Jinja", jinja2.__version__), ("WeasyPrint", weasyprint.__version__)]


def build(source):
    cases = source.run.cases
    return Section("environment", "Environment", "environment.html",
                   {"program": merged(cases, "versions"), "machine": merged(cases, "environment"),
                    "tools": tool_versions()})
