#!/usr/bin/python3
"""Makes a notebook of a script that consists of cells.

    notebook.py SCRIPT.py            writes SCRIPT.ipynb beside it, without output

A cell begins with a line `# %% heading`; the lines of a cell `# %% [markdown]` are text behind "# "."""

import json
import pathlib
import re
import sys


def notebook_of(script):
    cells = []
    for number, part in enumerate(re.split(r"^# %% ", script, flags=re.M)[1:]):
        heading, _, body = part.partition("\n")
        text = heading == "[markdown]"
        lines = re.sub(r"^# ?", "", body, flags=re.M) if text else f"# {heading}\n{body}"
        cells.append({"cell_type": "markdown" if text else "code", "id": f"cell-{number}", "metadata": {},
                      "source": lines.strip().splitlines(keepends=True),
                      **({} if text else {"execution_count": None, "outputs": []})})
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return json.dumps({"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5},
                      ensure_ascii=False, indent=1) + "\n"


def main():
    script = pathlib.Path(sys.argv[1])
    script.with_suffix(".ipynb").write_text(notebook_of(script.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
