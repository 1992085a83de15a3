"""Figure 4: pull-off force and approach at pull-off of a smooth sphere against the Tabor parameter."""

import math

from markupsafe import Markup

from .. import gnuplot, live, svg
from ..words import MINUS, listing, plain, scientific, value_of
from . import twice
from .figure import Figure, checks_of, failures, log_range, tolerance_of

NUMBER = "4"
TITLE = "Pull-off of a smooth sphere against the Tabor parameter"
PANELS = (("pull_off_force", "force", 1.0, "force"),
          ("pull_off_approach", "approach", -1.0, "approach"))
PULL_OFF = "feng_pull_off.csv"
PUBLISHED = "published/feng_fig4.csv"   # Feng's own points, if a digitised file is available


def rows_of(references, name, field, sign):
    """Rows (μ, value) of a table of pull-offs, in order; empty if the file is not available."""
    table = references.table(name)
    return [] if table is None else sorted(
        zip(table.numbers("tabor").tolist(), (sign * table.numbers(field)).tolist()))


def by_tabor(case):
    """Pairs (μ, point) of a case, in order; empty without a case."""
    found = [(value_of(point, "tabor"), point) for point in case.points] if case else []
    return sorted((pair for pair in found if pair[0] is not None), key=lambda pair: pair[0])


def residuals(case, quantity):
    """Rows (μ, |difference|) and (μ, tolerance) of the first check of each point on one quantity."""
    found, tolerances = [], []
    for tabor, point in by_tabor(case):
        for check in checks_of(case, point, quantity)[:1] if point.get("pull_off") else []:
            if check["error"] is not None:
                found.append((tabor, max(abs(check["error"]), 1e-16)))
            tolerances.append((tabor, tolerance_of(check)))
    return found, tolerance_rows(tolerances)


def tolerance_rows(tolerances):
    return [(tabor, value) for tabor, value in tolerances if value]


def folds(case):
    """Rows (μ, number of folds)."""
    return [(tabor, len(point["folds"])) for tabor, point in by_tabor(case) if point.get("folds") is not None]


def make(case, references):
    data, parameters, said, links = {}, {}, [], live.Links(3)
    for panel, (quantity, field, sign, name) in enumerate(PANELS):
        solved = [(tabor, sign * point["pull_off"][field], point) for tabor, point in by_tabor(case) if point.get("pull_off")]
        computed = [row[:2] for row in solved]
        for *place, point in solved:
            links.add(panel, [place], point)
        reference, crosses = (rows_of(references, table, field, sign) for table in (PULL_OFF, PUBLISHED))
        found, limit = residuals(case, quantity)
        paper = residuals(case.companion, quantity)[0]
        data[name] = [computed, reference, found, limit, crosses, paper]
        low, high = log_range([row[1] for row in found + limit + paper])
        parameters.update({f"{name}_low": low, f"{name}_high": high,
                           f"{name}_reference": len(reference), f"{name}_limits": len(limit),
                           f"{name}_crosses": len(crosses),
                           f"{name}_tolerance": limit[0][1] if limit else 0.0})
        if found:
            said.append((name, max(found, key=lambda row: row[1]), max(paper, key=lambda row: row[1], default=None)))
    data["folds"] = [folds(case), folds(case.companion)]
    for tabor, point in by_tabor(case):
        if point.get("folds") is not None:
            links.add(2, [(tabor, len(point["folds"]))], point)
    data["links"] = links.blocks
    parameters.update({"cut": twice.CUT, "paper": 1 if case.companion else 0, "fold_points": len(data["folds"][0]),
                       "figure_height": 600 if data["folds"][0] else 480})
    drawn = gnuplot.draw("fig04", parameters, data)
    label = "Pull-off force and minus the approach at pull-off against the Tabor parameter"
    return Figure("fig04", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig04", label, links)),
                  caption(case, data, said), remarks(case, references), case.record["command"])


def caption(case, data, said):
    text = Markup("(a) Pull-off force |W̄| and (b) approach {}Δ† at pull-off against the Tabor "
                  "parameter μ. Blue squares: computed with {}.").format(MINUS, twice.how(case))
    if data["force"][1]:
        text += Markup(" Black asterisks: Feng’s problem, solved independently (see the note on "
                       "Feng’s points).")
    if data["force"][4]:
        text += Markup(" Crosses: Feng’s own points, read off a figure.")
    if said:
        text += Markup(" (c), (d) Absolute difference from it; blue: panels, at most {}").format(greatest(said, 1))
        if said[0][2]:
            text += Markup(". Orange: with the paper’s discretisation ({1}); at most {0}; in (c) {2}").format(
                greatest(said, 2), twice.PAPER, twice.CUT_WORDS)
        text += "."
    if data["folds"][0]:
        text += " (e) Number of folds of the branch"
        if data["folds"][1]:
            count, tabor, true = most_folds(data["folds"])
            text += Markup(
                "; with the paper’s discretisation {} at μ = {} instead of {}. The others are spurious: the contact edge "
                "advances by one element at a time, see Figure 3. The approaches of two of them differ by only {} ε. "
                "A trace may step over such a pair, so the trace of Figure 3, which has other steps, may "
                "have a few more or fewer folds").format(count, plain(tabor), true, scientific(least_apart(case.companion, tabor), 1))
        text += "."
    return text


def least_apart(case, tabor):
    """The smallest distance in approach of two successive folds at this Tabor parameter."""
    places = [[fold["approach"] for fold in point["folds"]] for found, point in by_tabor(case) if found == tabor]
    return min((abs(a - b) for row in places for a, b in zip(row, row[1:])), default=math.inf)


def greatest(said, which):
    return listing(Markup("{} for the {} (μ = {})").format(scientific(item[which][1]), item[0], plain(item[which][0]))
                   for item in said)


def most_folds(both):
    """The largest number of folds with the paper's discretisation, its Tabor parameter, and the number with panels there."""
    tabor, count = max(both[1], key=lambda row: row[1])
    return count, tabor, dict(both[0]).get(tabor, "—")


def remarks(case, references):
    made = twice.remarks(case, failures)
    if not references.has(PULL_OFF):
        made.append(f"The reference values ({PULL_OFF}) are not available, so no asterisks are drawn.")
    return made
