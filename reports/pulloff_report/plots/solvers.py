"""Error against run time of this program and of the external solvers of the run."""

from markupsafe import Markup
from matplotlib import pyplot, ticker

from .. import samples, solvers
from ..words import count
from .figure import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILLION, Figure, log_range
from .precision import FAILED_AT, decade, rendered

SCRIPT = "solvers"
TITLE = "Error against run time of all solvers"
LOOKS = tuple(zip((VERMILLION, BLUE, ORANGE, PURPLE, SKY, BLACK), ("o", "^", "D", "v", "P", "h")))
COLUMNS = 2
LEGEND_COLUMNS = 5


def styles(rows):
    """Colour and marker of each solver, this program first."""
    others = [name for name in dict.fromkeys(row.name for row in rows) if name != solvers.OURS]
    found = {solvers.OURS: (GREEN, "s")}
    for place, name in enumerate(others):
        found[name] = LOOKS[place % len(LOOKS)]
    return {name: {"color": colour, "marker": marker, "lw": 0.9, "ms": 3.8, "mew": 0.8}
            for name, (colour, marker) in found.items()}


def draw_solver(axes, rows, style):
    """A line through the solves from coarse to fine, with a bar from the smallest to the largest time."""
    good = [row for row in rows if row.usable]
    axes.plot([row.seconds for row in good], [max(row.error, 1e-16) for row in good], **style)
    for row in good:
        axes.plot([min(row.times), max(row.times)], [max(row.error, 1e-16)] * 2, "-", lw=0.7, color=style["color"])
    for place, _ in enumerate(row for row in rows if row.failed):
        axes.plot([0.965 - 0.035 * place], [FAILED_AT], marker=style["marker"], ls="", ms=4.4, mfc="white",
                  mec=style["color"], transform=axes.transAxes, clip_on=False)


def draw(rows):
    scenes = samples.scenes(rows)
    lines = -(-len(scenes) // COLUMNS)
    looks = styles([row for row in rows if not row.wrong])
    top = 28 + 16 * -(-(len(looks) + 1) // LEGEND_COLUMNS)
    height = 26 + top + 190 * lines
    picture, grid = pyplot.subplots(lines, COLUMNS, squeeze=False, sharex=True, sharey=True,
                                    figsize=(680 / 96, height / 96))
    cells = [axes for line in grid for axes in line]
    drawn = [row for row in rows if row.usable]
    low, high = log_range([row.error for row in drawn])
    for axes, scene in zip(cells, scenes):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_ylim(low / 2, high * 20)
        axes.xaxis.set_major_formatter(ticker.FuncFormatter(decade))
        axes.yaxis.set_major_formatter(ticker.FuncFormatter(decade))
        axes.minorticks_off()
        axes.set_title(samples.scene_name(scene), loc="left", fontsize=8.3, pad=3)
        for name, style in looks.items():
            draw_solver(axes, [row for row in samples.of(rows, scene) if row.name == name], style)
    for axes in cells[len(scenes):]:
        axes.set_visible(False)
    for line in grid:
        line[0].set_ylabel("relative error")
    for axes in grid[-1]:
        axes.set_xlabel("processor time of a solve, seconds")
    handles = [pyplot.Line2D([], [], label=name, **style) for name, style in looks.items()]
    handles.append(pyplot.Line2D([], [], ls="", marker="o", mfc="white", mec=GREY, ms=4.4, label="open, at the edge: no result"))
    picture.legend(handles=handles, loc="upper center", ncol=min(len(handles), LEGEND_COLUMNS), bbox_to_anchor=(0.5, 1.0))
    picture.subplots_adjust(left=0.085, right=0.985, top=1 - top / height, bottom=36 / height, wspace=0.06, hspace=0.2)
    return picture


def caption(rows):
    rounds = max(len(row.times) for row in rows)
    failed = sum(row.failed for row in rows)
    return Markup("{}").format(
        "Relative error of the pull-off force against processor time, the median of "
        f"{count(rounds, 'round')}, or of fewer if they took more than a tenth of a second, with a bar from the smallest to the largest. The lines join the values of the knob of each "
        "solver, and the tolerances of this program. The processor time of an external solver is that of its process beyond "
        f"its start. {failed or 'None'} of {count(len(rows), 'solve')} gave no result.")


def make(rows, command):
    """The figure; None if there is nothing to draw."""
    if not any(row.usable for row in rows):
        return None
    return Figure(SCRIPT, "", TITLE, rendered(draw, rows, name=SCRIPT, label=TITLE), caption(rows), [], command)
