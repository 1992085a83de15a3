"""Error against run time: what a digit costs with each discretisation of the surface."""

import io
import math

import matplotlib

matplotlib.use("svg")
from matplotlib import font_manager, pyplot, ticker  # noqa: E402
from markupsafe import Markup  # noqa: E402

from .. import fonts, svg  # noqa: E402
from ..words import listing, plain, value_of  # noqa: E402
from .figure import BLUE, GREEN, GREY, VERMILLION, Figure, checks_of, failures  # noqa: E402

SCRIPT = "error_time"
TITLE = "Error against run time"
FIELDS = (("pull_off_force", "force", "error of the pull-off force"),
          ("pull_off_approach", "approach", "error of the approach at pull-off"))
COLOURS = {"ring": VERMILLION, "triangle": BLUE, "panel": GREEN}
MARKERS = {"ring": "o", "triangle": "^", "panel": "s"}
PULL_OFF = "feng_pull_off.csv"
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class Sample:
    """One timed solve: its scene, its cost, and its errors by field (None when it failed)."""

    def __init__(self, case, references, point):
        self.scheme = value_of(point, "scheme") or "?"
        self.tabor = value_of(point, "tabor")
        self.nodes = value_of(point, "nodes") or point["work"].get("nodes")
        self.seconds = point["work"].get("seconds")
        self.failed = point["status"] != "ok" or not point.get("pull_off")
        self.label = point["label"]
        self.errors, self.floors, self.orders = {}, {}, {}
        for quantity, field, _ in FIELDS:
            expected, floor = expectation(case, references, point, quantity, field, self.tabor)
            self.floors[field] = floor
            if not self.failed and expected is not None:
                self.errors[field] = abs(point["pull_off"][field] - expected)


def expectation(case, references, point, quantity, field, tabor):
    """(expected value, its uncertainty) from the check of the point, else from the reference file."""
    for check in checks_of(case, point, quantity):
        if check["ledger"] != "pin" and check["expected"] is not None:
            return check["expected"], check.get("reference_uncertainty")
    table = references.table(PULL_OFF)
    if table is not None and tabor is not None:
        for row, value in enumerate(table.numbers("tabor")):
            if math.isclose(value, tabor, rel_tol=1e-9):
                name = field + "_uncertainty"
                floor = table.numbers(name)[row] if name in table.columns else None
                return table.numbers(field)[row], floor
    return None, None


def samples(case, references):
    return [Sample(case, references, point) for point in case.points]


def decade(value, _=None):
    """10⁻⁵ without mark-up, so that it stays text."""
    return "10" + str(round(math.log10(value))).translate(SUPERSCRIPTS)


def look():
    """Matplotlib dressed as the gnuplot figures are."""
    for style in ("normal", "italic"):
        font_manager.fontManager.addfont(fonts.path_of("Inter", style))
    family = font_manager.FontProperties(fname=fonts.path_of("Inter")).get_name()
    return {"font.family": family, "font.size": 8.2, "svg.fonttype": "none",
            "svg.hashsalt": "pulloff", "axes.linewidth": 0.6, "axes.edgecolor": "#303030",
            "axes.labelsize": 8.2, "xtick.labelsize": 8.0, "ytick.labelsize": 8.0,
            "axes.grid": True, "grid.color": "#E6E6E6", "grid.linewidth": 0.4,
            "xtick.direction": "in", "ytick.direction": "in", "axes.axisbelow": True,
            "legend.frameon": False, "legend.fontsize": 8.2}


def is_upper(sample, chosen, field):
    """Whether no other scheme has a greater error with as many nodes: its label goes above."""
    return all(other.errors[field] <= sample.errors[field] for other in chosen
               if other.nodes == sample.nodes and field in other.errors)


# Places for a label around its marker: (right, up) of its middle, in points, the wanted one first.
PLACES = ((0, 8), (0, -8), (12, 0), (-12, 0), (11, 8), (-11, 8), (11, -8), (-11, -8),
          (0, 16), (0, -16), (21, 8), (-21, -8))


def overlap(one, other):
    return (abs(one[0] - other[0]) < one[2] + other[2]
            and abs(one[1] - other[1]) < one[3] + other[3])


def strokes(good, at):
    """Small boxes along the lines between markers, so that labels keep off them."""
    boxes = []
    for scheme in {row.scheme for row in good}:
        line = [at[id(row)] for row in sorted(good, key=lambda row: row.nodes)
                if row.scheme == scheme]
        for (x, y), (to_x, to_y) in zip(line, line[1:]):
            boxes += [(x + part * (to_x - x) / 16, y + part * (to_y - y) / 16, 0.5, 0.5)
                      for part in range(1, 16)]
    return boxes


def place_labels(axes, field, chosen):
    """Writes N at every marker where it covers no marker and no other label."""
    good = [row for row in chosen if field in row.errors and row.seconds]
    scale = 72 / axes.figure.dpi
    at = {id(row): axes.transData.transform((row.seconds, max(row.errors[field], 1e-16))) * scale
          for row in good}
    taken = [(x, y, 3.0, 3.0) for x, y in at.values()] + strokes(good, at)
    for row in sorted(good, key=lambda item: (item.nodes, item.scheme)):
        text = plain(row.nodes)
        half = 2.3 * len(text)
        x, y = at[id(row)]
        flip = 1 if is_upper(row, chosen, field) else -1
        boxes = [(x + right, y + flip * up, half, 3.8) for right, up in PLACES]
        free = [box for box in boxes if not any(overlap(box, other) for other in taken)]
        box = (free or boxes)[0]
        taken.append(box)
        axes.annotate(text, (row.seconds, max(row.errors[field], 1e-16)),
                      xytext=(box[0] - x, box[1] - y - 2.6), textcoords="offset points",
                      ha="center", fontsize=7, color=COLOURS.get(row.scheme, GREY))


def draw_panel(axes, field, chosen):
    """One pair of axes; returns the failures it shows."""
    failed = []
    for scheme in sorted({sample.scheme for sample in chosen}):
        rows = sorted((sample for sample in chosen if sample.scheme == scheme),
                      key=lambda sample: sample.nodes)
        good = [row for row in rows if field in row.errors and row.seconds]
        failed += [row for row in rows if row.failed and row.seconds]
        colour = COLOURS.get(scheme, GREY)
        axes.plot([row.seconds for row in good],
                  [max(row.errors[field], 1e-16) for row in good], "-", lw=0.9, color=colour,
                  marker=MARKERS.get(scheme, "D"), ms=4.2, mfc="white", mew=1.1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    return failed


def draw_failures(axes, failed):
    """Failed solves stand on the upper edge, where an error without bound would."""
    for row in failed:
        axes.plot([row.seconds], [0.965], marker="X", ms=5.5, color="black", mec="white", mew=0.5,
                  transform=axes.get_xaxis_transform(), clip_on=False)
        axes.annotate(f"{row.scheme} {plain(row.nodes)} failed", (row.seconds, 0.965),
                      xycoords=axes.get_xaxis_transform(), xytext=(5, -2.5),
                      textcoords="offset points", fontsize=7, color="black")


def frame(axes, chosen, field, tabor, failed):
    """Ranges of whole decades, labels, and the floor below which the reference says nothing."""
    errors = [max(row.errors[field], 1e-16) for row in chosen if field in row.errors]
    floors = [row.floors[field] for row in chosen if row.floors[field]]
    if errors:
        low, high = min(errors + floors), max(errors)
        axes.set_ylim(10 ** (math.floor(math.log10(low)) - 0.4),
                      10 ** (math.ceil(math.log10(high)) + (1.4 if failed else 0.6)))
    if floors:
        axes.axhline(max(floors), ls=(0, (4, 3)), lw=0.8, color=GREY)
        axes.annotate("uncertainty of the reference", (0.985, max(floors)), ha="right",
                      xycoords=("axes fraction", "data"), xytext=(0, 3),
                      textcoords="offset points", fontsize=7, color=GREY)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(base=10, numticks=9))
        axis.set_major_formatter(ticker.FuncFormatter(decade))
        axis.set_minor_formatter(ticker.NullFormatter())
    axes.set_title(f"μ = {plain(tabor)}", fontsize=8.2, loc="left", pad=4)


def make(case, references):
    """(Figure, samples), or (None, []) when the case holds nothing to draw."""
    found = samples(case, references)
    drawn = [sample for sample in found if sample.errors and sample.seconds]
    if not drawn:
        return None, found
    tabors = sorted({sample.tabor for sample in found})
    with matplotlib.rc_context(look()):
        picture, grid = pyplot.subplots(len(tabors), len(FIELDS), squeeze=False, sharex=True,
                                        figsize=(680 / 96, (60 + 205 * len(tabors)) / 96))
        for line, tabor in zip(grid, tabors):
            chosen = [sample for sample in found if sample.tabor == tabor]
            for axes, (_, field, label) in zip(line, FIELDS):
                failed = draw_panel(axes, field, chosen)
                frame(axes, chosen, field, tabor, failed)
                draw_failures(axes, failed)
                axes.set_ylabel(label)
        times = [sample.seconds for sample in found if sample.seconds]
        grid[0][0].set_xlim(min(times) / 1.9, max(times) * 1.9)
        for axes in grid[-1]:
            axes.set_xlabel("run time in seconds")
        add_legend(picture, found)
        for line, tabor in zip(grid, tabors):
            for axes, (_, field, _) in zip(line, FIELDS):
                place_labels(axes, field, [row for row in found if row.tabor == tabor])
        text = io.StringIO()
        picture.savefig(text, format="svg", metadata={"Date": None})
        pyplot.close(picture)
    label = "Error of pull-off force and approach against run time, by scheme and number of nodes"
    figure = Figure(SCRIPT, "", TITLE, Markup(svg.embeddable(text.getvalue(), SCRIPT, label)),
                    caption(found), failures(case), case.record["command"])
    return figure, found


def add_legend(picture, found):
    schemes = sorted({sample.scheme for sample in found})
    handles = [pyplot.Line2D([], [], color=COLOURS.get(name, GREY), marker=MARKERS.get(name, "D"),
                             mfc="white", mew=1.1, ms=4.2, lw=0.9) for name in schemes]
    height = picture.get_figheight()
    picture.legend(handles, schemes, loc="upper center", ncol=len(schemes),
                   bbox_to_anchor=(0.5, 1.0))
    picture.subplots_adjust(left=0.088, right=0.985, top=1 - 0.42 / height, bottom=0.45 / height,
                            wspace=0.24, hspace=0.2)


def caption(found):
    schemes = listing(sorted({sample.scheme for sample in found}))
    return Markup("Magnitude of the error of one solve against its run time on one core, for {}; "
                  "numbers at the markers are the nodes N. Time is the median of the repeats. "
                  "Below the dashed line the reference itself is not known better. A failed solve "
                  "stands as a cross on the upper edge at the time it took.").format(schemes)


def orders(found):
    """A row a (μ, N), with every scheme's sample of it; the orders are left in sample.orders."""
    for scheme in {sample.scheme for sample in found}:
        for tabor in {sample.tabor for sample in found}:
            chosen = sorted((sample for sample in found if sample.tabor == tabor
                             and sample.scheme == scheme), key=lambda sample: sample.nodes)
            for before, sample in zip([None] + chosen, chosen):
                sample.orders = {field: slope(before, sample, field) for _, field, _ in FIELDS}
    rows = []
    for tabor, nodes in sorted({(sample.tabor, sample.nodes) for sample in found}):
        cells = {sample.scheme: sample for sample in found
                 if (sample.tabor, sample.nodes) == (tabor, nodes)}
        rows.append({"tabor": tabor, "nodes": nodes, "cells": cells,
                     "first": bool(rows) and rows[-1]["tabor"] != tabor})
    return rows


def slope(coarse, fine, field):
    """The order between two solves; None when one of them has no error or sits on the floor."""
    if coarse is None or field not in coarse.errors or field not in fine.errors:
        return None
    floor = fine.floors[field] or 0.0
    if min(coarse.errors[field], fine.errors[field]) <= floor:
        return None
    return (math.log(coarse.errors[field] / fine.errors[field])
            / math.log(fine.nodes / coarse.nodes))
