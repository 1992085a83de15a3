"""The approach of the pull-off force of the smooth sphere to its limits, with the observed rates."""

import io
import math

from matplotlib import pyplot, ticker
from markupsafe import Markup

from .. import svg
from ..words import listing, value_of
from .precision import decade, look
from .figure import BLUE, GREY, VERMILLION, Figure, checks_of

CASE = "extreme_tabor"
TITLE = "Approach to the limits"
# Reference of the limit -> name, scenes whose rates are tabulated, row of the outermost rate, colour, marker.
LIMITS = {"bradley": ("Bradley, 2, as μ → 0", lambda tabor: tabor <= 0.1, 1, BLUE, "o"),
          "reference/guduru_limit.csv": ("JKR, 3/2, as μ → ∞", lambda tabor: tabor >= 5, -1, VERMILLION, "s")}


def limit_of(case, reference):
    """The limit of the force by this reference, which is the same for all smooth spheres."""
    for point in case.points:
        for check in checks_of(case, point, "pull_off_force"):
            if check.get("reference") == reference and check["expected"] is not None:
                return check["expected"]
    return None


def distances(case, limit):
    """(μ, force, difference from the limit) of every elastic scene, in order."""
    found = []
    for point in case.points:
        if point["status"] == "ok" and point.get("pull_off") and not point.get("rigid"):
            force = point["pull_off"]["force"]
            found.append((value_of(point, "tabor"), force, abs(force - limit)))
    return sorted(row for row in found if row[2] > 0)


def rates_of(name, limit, rows):
    """The rate between each row and the previous one: log(ratio of differences) / log(ratio of μ)."""
    made = []
    for place, (tabor, force, difference) in enumerate(rows):
        rate = None
        if place:
            before = rows[place - 1]
            rate = math.log(difference / before[2]) / math.log(tabor / before[0])
        made.append({"first": place == 0, "name": name, "tabor": tabor, "force": force, "limit": limit,
                     "difference": difference, "rate": rate})
    return made


def draw(curves):
    with pyplot.rc_context(look()):
        figure, panels = pyplot.subplots(1, 2, figsize=(6.4, 2.8))
        figure.subplots_adjust(left=0.1, right=0.99, top=0.91, bottom=0.16, wspace=0.3)
        for axes, (name, rows, near, end, colour, marker) in zip(panels, curves):
            axes.loglog([row[0] for row in rows], [row[2] for row in rows], color=GREY, linewidth=0.8)
            chosen = [row for row in rows if near(row[0])]
            axes.loglog([row[0] for row in chosen], [row[2] for row in chosen], marker, color=colour,
                        markersize=4)
            axes.loglog([row[0] for row in rows if not near(row[0])],
                        [row[2] for row in rows if not near(row[0])], marker, color=colour,
                        markerfacecolor="white", markersize=4)
            axes.set_title(f"{name}: rate {end:.2f}".replace("-", "−"), fontsize=8.2)
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_locator(ticker.LogLocator(base=10, numticks=9))
                axis.set_minor_locator(ticker.NullLocator())
                axis.set_major_formatter(ticker.FuncFormatter(decade))
            axes.set_xlabel("μ")
            axes.set_ylabel("difference of the pull-off force")
        out = io.StringIO()
        figure.savefig(out, format="svg", metadata={"Date": None})
        pyplot.close(figure)
    return out.getvalue()


def make(cases):
    """The figure and the table of rates; None and nothing without the case."""
    case = next((case for case in cases if case.name == CASE), None)
    curves, rows_of_table = [], []
    for reference, (name, near, outer, colour, marker) in LIMITS.items():
        limit = limit_of(case, reference) if case else None
        rows = distances(case, limit) if limit is not None else []
        rates = rates_of(name, limit, [row for row in rows if near(row[0])])
        if len(rates) > 1:
            curves.append((name, rows, near, rates[outer]["rate"], colour, marker))
            rows_of_table += rates
    if len(curves) < len(LIMITS):
        return None, rows_of_table
    caption = Markup("Difference between the pull-off force of the smooth sphere and its limits: {}. Filled markers: the "
                     "scenes of the table of rates. The rate above each panel is that between the two "
                     "outermost scenes.").format(listing(curve[0] for curve in curves))
    drawn = Markup(svg.embeddable(draw(curves), "extreme-limits", TITLE))
    return Figure("extreme-limits", "", TITLE, drawn, caption, command=case.record["command"]), rows_of_table
