"""Error against run time for each discretisation of the half-space."""

import io
import math

import matplotlib

matplotlib.use("svg")
from matplotlib import font_manager, pyplot, ticker  # noqa: E402
from markupsafe import Markup  # noqa: E402

from .. import fonts, samples, svg  # noqa: E402
from ..words import count  # noqa: E402
from .figure import BLUE, GREEN, GREY, VERMILLION, Figure  # noqa: E402

SCRIPT = "precision"
COLOURS = {"ring": VERMILLION, "triangle": BLUE, "panel": GREEN}
MARKERS = {"ring": "o", "triangle": "^", "panel": "s"}
LABELS = {"force": "force", "approach": "approach", "folds": "folds", "curve": "curve"}
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
# Two figures, because one with seven rows would not fit on a page.
PARTS = (("wavy", "Error against run time, wavy spheres", True),
         ("smooth", "Error against run time, smooth spheres", False))
FAILED_AT = 0.945        # height of the markers of failed solves, relative to the panel


def decade(value, _=None):
    """A power of ten as plain text: 10⁻⁵."""
    return "10" + str(round(math.log10(value))).translate(SUPERSCRIPTS)


def look():
    """Matplotlib settings that match the gnuplot figures."""
    for style in ("normal", "italic"):
        font_manager.fontManager.addfont(fonts.path_of("Inter", style))
    family = font_manager.FontProperties(fname=fonts.path_of("Inter")).get_name()
    return {"font.family": family, "font.size": 8.3, "svg.fonttype": "none",
            "svg.hashsalt": "pulloff", "axes.linewidth": 0.6, "axes.edgecolor": "#303030",
            "axes.labelsize": 8.3, "xtick.labelsize": 8.3, "ytick.labelsize": 8.3,
            "axes.grid": True, "grid.color": "#E6E6E6", "grid.linewidth": 0.4,
            "xtick.direction": "in", "ytick.direction": "in", "axes.axisbelow": True,
            "legend.frameon": False, "legend.fontsize": 8.3, "text.parse_math": False}


def rendered(draw, *given, name, label):
    """What matplotlib draws, as SVG for embedding."""
    with matplotlib.rc_context(look()):
        picture = draw(*given)
        text = io.StringIO()
        picture.savefig(text, format="svg", metadata={"Date": None})
        pyplot.close(picture)
    return Markup(svg.embeddable(text.getvalue(), name, label))


def style(series):
    scheme = series.split()[0]
    dashed = series.endswith("graded")
    return {"color": COLOURS.get(scheme, GREY), "marker": MARKERS.get(scheme, "D"),
            "ls": (0, (3, 2)) if dashed else "-", "lw": 0.9, "ms": 3.4, "mew": 0.8}


def draw_series(axes, field, rows):
    """Draws one scheme: a line, a bar from the smallest to the largest time, and open markers for unmatched folds."""
    look_of = style(rows[0].series)
    good = [row for row in rows if row.seconds and not row.failed and field in row.errors
            and not (field == "folds" and row.misfit)]
    height = [max(row.errors[field], 1e-16) for row in good]
    axes.plot([row.seconds for row in good], height, **{**look_of, "marker": ""})
    for row, y in zip(good, height):
        axes.plot([min(row.times), max(row.times)], [y, y], "-", lw=0.7, color=look_of["color"])
        axes.plot([row.seconds], [y], mfc="white" if row.misfit else look_of["color"],
                  **{**look_of, "ls": ""})


def draw_failures(axes, field, rows):
    """Draws failed solves and unmatched folds at the upper edge."""
    for row in rows:
        if row.seconds and (row.failed or (field == "folds" and row.misfit)):
            axes.plot([row.seconds], [FAILED_AT], marker="X" if row.failed else "x", ls="",
                      ms=4.4, mew=0.5 if row.failed else 1.0, mec="white" if row.failed else None,
                      color="black" if row.failed else style(row.series)["color"],
                      transform=axes.get_xaxis_transform(), clip_on=False)


def frame(axes, field, rows):
    """Sets up a panel; errors below the uncertainty of the reference are shaded."""
    floors = [row.floors[field] for row in rows if field in row.floors]
    if floors:
        axes.axhspan(1e-30, max(floors), color="#E3E3E3", lw=0, zorder=0)
    if not any(field in row.errors for row in rows):
        axes.text(0.5, 0.5, "no reference", transform=axes.transAxes, ha="center", color=GREY)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(ticker.FuncFormatter(decade))
        axis.set_minor_formatter(ticker.NullFormatter())
    axes.xaxis.set_major_locator(ticker.LogLocator(base=10, numticks=9))
    axes.yaxis.set_major_locator(ticker.FixedLocator([10.0 ** k for k in range(-30, 31, 3)]))


def set_ranges(axes, rows):
    errors = [max(error, 1e-16) for row in rows for error in row.errors.values()]
    floors = [floor for row in rows for floor in row.floors.values()]
    times = [time for row in rows for time in row.times]
    low, high = min(errors + floors), max(errors)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(min(times) / 1.6, max(times) * 1.6)
    axes.set_ylim(10 ** (math.floor(math.log10(low)) - 0.3),
                  10 ** (math.ceil(math.log10(high)) + 2))


def add_legend(picture, series):
    handles = [pyplot.Line2D([], [], label=name, mfc=style(name)["color"], **style(name))
               for name in samples.SERIES if name in series]
    handles += [pyplot.Line2D([], [], ls="", marker="D", ms=3.4, mfc="white", mec=GREY,
                              label="open: wrong folds"),
                pyplot.Line2D([], [], ls="", marker="x", ms=4.4, color=GREY, label="wrong folds"),
                pyplot.Line2D([], [], ls="", marker="X", ms=4.4, color="black", label="failed")]
    picture.legend(handles=handles, loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.0),
                   columnspacing=1.6, handlelength=2.4)


def draw(chosen):
    """Rows: scenes; columns: force, approach, folds, curve."""
    rows = samples.scenes(chosen)
    height = 74 + 116 * len(rows)
    picture, grid = pyplot.subplots(len(rows), len(samples.FIELDS), squeeze=False, sharex=True,
                                    sharey=True, figsize=(680 / 96, height / 96))
    set_ranges(grid[0][0], chosen)
    for line, scene in zip(grid, rows):
        here = samples.of(chosen, scene)
        for axes, field in zip(line, samples.FIELDS):
            frame(axes, field, here)
            for series in samples.SERIES:
                drawn = samples.of(here, scene, series)
                if drawn:
                    draw_series(axes, field, drawn)
            draw_failures(axes, field, here)
            axes.set_title(LABELS[field], fontsize=8.3, loc="right", pad=3)
        line[0].set_ylabel(samples.scene_name(scene) + "\nerror")
    for axes in grid[-1]:
        axes.set_xlabel("seconds")
    add_legend(picture, {sample.series for sample in chosen})
    picture.subplots_adjust(left=0.095, right=0.99, top=1 - 56 / height, bottom=34 / height,
                            wspace=0.08, hspace=0.2)
    return picture


def caption(case, chosen):
    repeats = max(len(sample.times) for sample in chosen)
    failed = sum(sample.failed for sample in chosen)
    wrong = sum(sample.misfit and not sample.failed for sample in chosen)
    text = ("Error of the pull-off force and of its approach, largest error of the approach of all folds, "
            "and largest distance of the curve along its normal, against processor time: the median "
            f"of {count(repeats, 'solve')}, with a bar from the smallest to "
            "the largest. Rings and triangles with 63, 125, 251, 501 and 1001 nodes; panels with "
            "tolerances 1e-3 to 1e-9. Shaded: below the uncertainty of the reference. Open markers: "
            "the solve found spurious folds or missed some; its folds then have no error "
            "and are drawn at the upper edge, as are failed solves. ")
    text += f"Of {len(chosen)} solves, {wrong or 'none'} found wrong folds and {failed or 'none'} failed."
    return Markup("{}").format(text)


def make(case):
    """The figures; empty if the case has nothing to draw."""
    found = samples.read(case)
    figures = []
    for name, title, wavy in PARTS:
        chosen = [sample for sample in found if bool(sample.scene[1]) == wavy]
        if not any(sample.errors and sample.seconds for sample in chosen):
            continue
        identifier = f"{SCRIPT}-{name}"
        figures.append(Figure(
            identifier, "", title, rendered(draw, chosen, name=identifier, label=title),
            caption(case, chosen), [], case.record["command"]))
    return figures
