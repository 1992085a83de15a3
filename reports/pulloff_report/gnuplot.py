"""Runs gnuplot with the script of a figure and its data."""

import math
import os
import re
import shutil
import subprocess
import tempfile

from .errors import ReportError
from .words import printable

FIGURES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "figures")
NAME = "gnuplot"


def require():
    """The path of gnuplot, or a ReportError."""
    path = shutil.which(NAME)
    if path is None:
        raise ReportError("gnuplot is not on the PATH: install the package gnuplot-nox")
    return path


class Enhanced(str):
    """A text in the markup of gnuplot, such as "r^{3}"; any other text is drawn as it is."""


def literal(text):
    """A text in one line, with its characters that have a meaning in the markup of gnuplot escaped."""
    return re.sub(r"([\\{}^_@&~])", r"\\\1", printable(text).replace("\n", " "))


def quoted(value):
    """A value in the syntax of gnuplot. It looks for macros and quotes also within quotes, and reads more than three octal digits:
    characters that could mean something are strings of their own, joined with the others."""
    if isinstance(value, str):
        text = value if isinstance(value, Enhanced) else literal(value)
        return "'" + re.sub(r"""[\0-\x1f'"\\@`$]""", lambda found: f"""'."\\{ord(found[0]):03o}".'""", text) + "'"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(quoted(item) for item in value) + "]"
    return repr(float(value)) if isinstance(value, float) else str(value)


def assignment(name, value):
    if isinstance(value, (list, tuple)):
        # gnuplot has no empty array.
        return f"array {name}[{max(len(value), 1)}]" + (f" = {quoted(value)}" if value else "")
    return f"{name} = {quoted(value)}"


def text_of(blocks):
    """Blocks of rows, separated by two blank lines; gnuplot's `index` counts them from 0."""
    lines = []
    for block in blocks:
        rows = [" ".join("NaN" if cell != cell else f"{cell:.17g}" for cell in row) for row in block
                if not any(isinstance(cell, float) and math.isinf(cell) for cell in row)]
        lines += (rows or ["NaN NaN NaN NaN"]) + ["", ""]
    return "".join(line + "\n" for line in lines)


def draw(script, parameters, data):
    """The SVG drawn by figures/<script>.gp.

    parameters: name -> number, string or list, set as gnuplot variables before the script runs;
    data: name -> list of blocks, written to <name>.dat beside it.
    """
    files = {name + ".dat": text_of(blocks) for name, blocks in data.items()}
    files["parameters.gp"] = "".join(assignment(name, value) + "\n" for name, value in parameters.items())
    with tempfile.TemporaryDirectory(prefix="pulloff-figure-") as place:
        for name, text in files.items():
            with open(os.path.join(place, name), "w", encoding="utf-8") as stream:
                stream.write(text)
        scripts = ["parameters.gp", os.path.join(FIGURES, "style.gp"),
                   os.path.join(FIGURES, script + ".gp")]
        done = subprocess.run([require()] + scripts, cwd=place, capture_output=True, text=True,
                              env=dict(os.environ, LC_ALL="C.UTF-8"), check=False)
        output = os.path.join(place, "figure.svg")
        if done.returncode != 0 or not os.path.isfile(output):
            reason = [line for line in done.stderr.splitlines() if line.strip()]
            raise ReportError(f"{scripts[-1]}: gnuplot failed: {reason[-1] if reason else 'no output'}")
        with open(output, encoding="utf-8") as stream:
            return stream.read()
