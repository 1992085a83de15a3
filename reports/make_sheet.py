#!/usr/bin/env python3
"""Prints the adhesion sheet: definitions, problems and certified values on a few pages.

    make_sheet.py [--sheet FOLDER] [--output FOLDER]     adhesion-sheet-1.pdf and .html

FOLDER has problems.json, values.csv and score.py (default: reference/sheet of this tree); the output is build/report
unless another folder is given. The number of digits that is printed is that of the certified digits.
"""

import argparse
import html
import importlib.util
import logging
import os
import re
import sys
from collections import Counter
from itertools import groupby
from pathlib import Path
from string import ascii_uppercase

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from pulloff_report import sheet_curves

HERE = Path(__file__).resolve().parent
WORDS = {"pi": "π", "mu": "μ", "epsilon": "ε", "lambda": "λ", "alpha": "α", "beta": "β", "phi": "φ", "kappa": "κ",
         "tau_0": "τ<sub>0</sub>", "gamma": "γ", "gamma1": "γ<sub>1</sub>", "gamma2": "γ<sub>2</sub>",
         "gamma12": "γ<sub>12</sub>", "nu": "ν", "nu1": "ν<sub>1</sub>", "nu2": "ν<sub>2</sub>", "um": "µm", "uN": "µN",
         "int": "∫", "inf": "∞"}
SHARED, LONG = 3, 35        # statements of a sentence that is printed once; its letters
LEVELS = ["easy", "average", "hard", "extreme"]


def mathematics(text):
    """A text with formulas in plain letters as HTML: Greek letters, exponents, integrals, minus signs."""
    text = html.escape(text, quote=False)
    text = re.sub(r"\bint_(\w)\^(r_max|inf|\w)", r"∫<sub>\1</sub><sup>\2</sup>", text)
    text = re.sub(r"\b[A-Za-z]+(?:_0|\d+)?\b", lambda word: WORDS.get(word[0], word[0]), text)
    text = re.sub(r"\bsqrt(?=[(])", "√", text)
    text = re.sub(r"\^\(((?:[^()]|\([^()]*\))*)\)", r"<sup>\1</sup>", text)
    text = re.sub(r"\^(-?\d+(?:\.\d+)?|[a-z])", lambda found: f"<sup>{found[1].replace('-', '−')}</sup>", text)
    text = re.sub(r"\b([RDEALracd])(\d|_\d|_max|_t)\b", lambda found: f"{found[1]}<sub>{found[2].strip('_')}</sub>", text)
    text = re.sub(r"(?<![\w>)])-(?=[\d(√A-Za-zπα-ω])", "−", text)
    text = re.sub(r"(?<= )-(?= )", "−", text)
    text = re.sub(r"`(\w+)`", r"<code>\1</code>", text)
    text = re.sub(r"(\d(?:\.\d+)?)e-?(\d+)", lambda found: number(found[0]), text)
    return Markup(text.replace("E*", "E<sup>*</sup>"))


def number(text):
    """A decimal number with its power of ten, and a minus sign."""
    mantissa, _, power = text.partition("e")
    shown = mantissa if not power else f"{mantissa}·10<sup>{int(power)}</sup>"
    return Markup(shown.replace("-", "−"))


def rounded(row):
    """A value with its certified digits."""
    return number(f"{float(row['value']):#.{int(row['digits'])}g}".removesuffix("."))


def name(text):
    """The name of a quantity, with places where a line may end."""
    return Markup("_<wbr>".join(text.split("_")))


def parameters(problem):
    """The parameters with their units, in one line."""
    units = {key: "" if unit == "1" else Markup("\u202f") + mathematics(unit) for key, unit in problem["parameter_units"].items()}
    return Markup(", ").join(Markup("{} = {}{}").format(mathematics(key) if key in WORDS or len(key) < 4 else key,
                                                       number(f"{value:g}"), units[key])
                             for key, value in problem["parameters"].items())


def sentences(text):
    return re.split(r"(?<=\.) (?=[A-Z])", text)


def groups(sheet):
    """[(group, shared, problems)]. Sentences that at least SHARED statements of a group have are printed once, with a letter:
    `shared` is [(letter, sentence)]. Problems are pairs of a problem and the parts of its statement, letters or sentences."""
    found = []
    for group in dict.fromkeys(problem["group"] for problem in sheet["problems"]):
        problems = [problem for problem in sheet["problems"] if problem["group"] == group]
        counts = Counter(sentence for problem in problems for sentence in sentences(problem["statement"]))
        often = [sentence for sentence, count in counts.items() if count >= SHARED and len(sentence) >= LONG]
        letters = dict(zip(often, ascii_uppercase))
        found.append((group, [(letters[sentence], sentence) for sentence in letters],
                      [(problem, parts(problem["statement"], letters)) for problem in problems]))
    return found


def parts(statement, letters):
    """[(letters, sentences)]: what a statement says in this order, neighbours of the same kind together."""
    pieces = [(letters.get(sentence), sentence) for sentence in sentences(statement)]
    return [("" .join(letter for letter, _ in run) if shared else "", " ".join(text for _, text in run))
            for shared, run in ((shared, list(run)) for shared, run in groupby(pieces, lambda piece: piece[0] is not None))]


def read_score(folder):
    """The module score.py of a sheet, which reads and checks its files."""
    specification = importlib.util.spec_from_file_location("score", folder / "score.py")
    score = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(score)
    return score


def page(folder):
    score = read_score(folder)
    sheet = score.read_problems(folder)
    values, checksum = score.read_values(folder)
    templates = Environment(loader=FileSystemLoader(HERE / "templates"), undefined=StrictUndefined, autoescape=True,
                            trim_blocks=True, lstrip_blocks=True)
    templates.filters.update(mathematics=mathematics, rounded=rounded, name=name, parameters=parameters)
    counts = {level: sum(problem["level"] == level for problem in sheet["problems"]) for level in LEVELS}
    return sheet["name"], templates.get_template("sheet.html").render(
        sheet=sheet, values=values, checksum=checksum, groups=groups(sheet), counts=counts,
        curves=Markup(sheet_curves.draw(sheet, values)), style=Markup((HERE / "templates" / "sheet.css").read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sheet", metavar="FOLDER", type=Path, default=HERE.parent / "reference" / "sheet")
    parser.add_argument("--output", metavar="FOLDER", type=Path, default=HERE.parent / "build" / "report")
    given = parser.parse_args()
    os.environ.setdefault("SOURCE_DATE_EPOCH", "0")
    logging.getLogger("weasyprint").setLevel(logging.ERROR)
    try:
        import weasyprint
        title, text = page(given.sheet)
        given.output.mkdir(parents=True, exist_ok=True)
        (given.output / f"{title}.html").write_text(text, encoding="utf-8")
        weasyprint.HTML(string=text).write_pdf(given.output / f"{title}.pdf")
    except (OSError, ValueError, ImportError) as problem:
        print(f"make_sheet.py: {problem}", file=sys.stderr)
        return 1
    print(f"{given.output / title}.pdf")
    return 0


if __name__ == "__main__":
    sys.exit(main())
