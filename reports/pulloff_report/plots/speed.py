"""The figure of the first page: error of the pull-off force against run time, panels and the discretisation of the paper."""

from markupsafe import Markup
from matplotlib import pyplot, ticker

from .. import samples, solvers
from .figure import BLACK, Figure
from .precision import decade, rendered, style
from .solvers import LOOKS

NAME = "speed"
TITLE = "Error against run time"
SOFTEST = 5.0        # largest Tabor parameter of the paper
DRAWN = {"panel": "pulloff, panels", "triangle uniform": "triangles on equal elements"}
OTHERS = LOOKS[:1] + LOOKS[2:]   # without the look of the triangles
PANELS = 4           # scenes that are drawn: the last ones of the case, which are the wavy and the softest smooth ones


def chosen(found):
    """The scenes that are drawn: those with 501 triangles and panels."""
    scenes = [scene for scene in samples.scenes(found) if scene[0] <= SOFTEST and samples.marked(samples.of(found, scene))
              and samples.of(found, scene, "panel")]
    return scenes[-PANELS:]


def points(rows):
    """(seconds, relative error) of solves that ended, by run time; an error counts as at least the uncertainty of the reference."""
    return sorted((row.seconds, max(row.relative, row.floors.get("force", 0) / abs(row.force), 1e-16)) for row in rows
                  if row.seconds and not row.failed and row.relative is not None)


def look(name, others=()):
    """The line or, for an external solver, the markers of a series."""
    if name in others:
        colour, marker = OTHERS[others.index(name) % len(OTHERS)]
        return {"color": colour, "marker": marker, "ls": "", "ms": 4}
    return {**style(name), "lw": 1.1, "ms": 4}


def draw_scene(axes, found, scene, others):
    here = samples.of(found, scene)
    goal = samples.marked(here)
    for series in DRAWN:
        axes.plot(*zip(*points(samples.of(here, scene, series))), **look(series))
    for label, rows in others.items():
        axes.plot([row.seconds for row in rows if row.scene == scene], [row.error for row in rows if row.scene == scene], **look(label, list(others)))
    quick = samples.quickest(samples.of(here, scene, "panel"), ["force"], goal)
    axes.plot([goal.seconds], [goal.relative], marker="o", mfc="none", mec=BLACK, ms=9, mew=1.0)
    if quick:
        axes.annotate("", (quick.seconds, goal.relative), (goal.seconds, goal.relative),
                      arrowprops={"arrowstyle": "->", "lw": 0.9, "shrinkA": 4.5, "shrinkB": 0})
        axes.text(goal.seconds / 1.4, goal.relative / 2, f"× {goal.seconds / quick.seconds:.3g}", ha="right", va="top", fontsize=8.8)
    axes.set_title(samples.scene_name(scene), fontsize=8.3, loc="left", pad=3)
    axes.set_xlabel("seconds")


def draw(found, scenes, others):
    picture, panels = pyplot.subplots(1, len(scenes), figsize=(680 / 96, 160 / 96), sharex=True, sharey=True, squeeze=False)
    panels[0][0].set(xscale="log", yscale="log")
    for axes, scene in zip(panels[0], scenes):
        draw_scene(axes, found, scene, others)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(ticker.FuncFormatter(decade))
            axis.set_minor_formatter(ticker.NullFormatter())
        axes.xaxis.set_major_locator(ticker.LogLocator(base=10, numticks=9))
        axes.yaxis.set_major_locator(ticker.FixedLocator([10.0 ** k for k in range(-30, 31, 3)]))
    low, high = panels[0][0].get_ylim()
    panels[0][0].set_ylim(low / 2, high * 3)
    panels[0][0].set_ylabel("relative error of the force")
    handles = [pyplot.Line2D([], [], label=label, **look(series)) for series, label in DRAWN.items()]
    handles.append(pyplot.Line2D([], [], ls="", marker="o", mfc="none", mec=BLACK, ms=8, label="as in the paper, 500 elements"))
    handles += [pyplot.Line2D([], [], label=label, **look(label, list(others))) for label in others]
    picture.legend(handles=handles, loc="upper center", ncol=4, bbox_to_anchor=(0.5, 1.02), columnspacing=1.6)
    lines = (len(handles) + 3) // 4
    picture.subplots_adjust(left=0.075, right=0.99, top=0.89 - 0.09 * lines, bottom=0.2, wspace=0.08)
    return picture


def make(found, run, command):
    """The figure; None if no scene has both 501 triangles and panels with errors of the force."""
    scenes = chosen([sample for sample in found if sample.relative is not None])
    if not scenes:
        return None
    others = {}
    for row in solvers.timed(run, solvers.read(run)):
        if row.name != solvers.OURS and row.usable and row.scene in scenes:
            others.setdefault(row.name, []).append(row)
    caption = Markup("Relative error of the pull-off force, from an independent solver, against processor time, for several "
                     "tolerances of the panels and numbers of triangles. Arrows: at the error of 500 elements.")
    return Figure(NAME, "", TITLE, rendered(draw, found, scenes, others, name=NAME, label=TITLE), caption, [], command)
