"""Staircases: the pull-off force that a test measures against the preload."""

import math

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import plain, value_of
from .figure import Figure, failures

NUMBER = None
TITLE = "Pull-off force against preload"
CONTROLS = (("displacement_control", "approach"), ("load_control", "load"))
BEYOND = 1.15  # end of the axis, relative to the beginning of the last step


def stairs(found, axis, end, complete):
    """Rows (preload, force) of a staircase up to the end of the axis, or up to the last preload that was reached if it is not
    known that no harder preload gives more.

    Between two steps that are not adjacent, the load falls towards a minimum while the approach increases, and the test
    measures the tension at reversal; a straight line is drawn there.
    """
    rows = []
    for step in found["steps"]:
        begin, until = step["preload"][axis], end if step["open"] and complete else step["until"][axis]
        if begin is None:   # in load control the bodies come into contact at zero load
            begin = 0.0
        rows += [(begin, step["force"]), (max(begin, min(until, end)), step["force"])]
    if rows and rows[-1][0] < end and complete:
        rows.append((end, rows[-1][1]))
    return [row for row in rows if row[0] <= end]


def last_preload(found, axis):
    return max((step["preload"][axis] or 0.0 for step in found["steps"]), default=0.0)


def make(case, references):
    del references
    return draw(case, "staircase", TITLE, title, "JKR, Eq 5")


def tick_step(begin, end):
    """A round distance between tick marks, of which about four fit."""
    least = (end - begin) / 5
    decade = 10.0 ** math.floor(math.log10(least))
    return next(factor * decade for factor in (1, 2, 5, 10) if factor * decade >= least)


def draw(case, name, heading, title_of, jkr, key_frame=1):
    """The staircases of a case, as the figure `name`: title_of gives the title of a frame, jkr names the theory."""
    points = [point for point in case.points if point.get("staircase")]
    data, ends, lowest, tops = {"solver": [], "jkr": []}, [], [], []
    for control, axis in CONTROLS:
        for point in points:
            both = point["staircase"][control], (point["staircase"]["jkr"] or {}).get(control, {"steps": []})
            ends.append(BEYOND * max(last_preload(found, axis) for found in both) or 1.0)
            for source, found in zip(("solver", "jkr"), both):
                data[source].append(stairs(found, axis, ends[-1], source == "jkr" or point["pull_off_any"]["complete"]))
            lowest.append(min(row[0] for rows in data.values() for row in rows[-1]))
            tops.append(max(row[1] for rows in data.values() for row in rows[-1]))
    titles = [in_two_lines(title_of(point)) for point in points]
    drawn = gnuplot.draw("staircase", {
        "scene_count": len(points), "title_text": [first for first, _ in titles], "title_more": [second for _, second in titles],
        "end": ends, "begin": lowest,
        "step": [tick_step(begin, end) for begin, end in zip(lowest, ends)], "jkr_text": jkr, "key_frame": key_frame,
        "top": [1.12 * value for value in tops], "figure_height": 470}, data)
    label = "Pull-off force against the largest approach and the largest load before unloading, with the JKR theory"
    return Figure(name, NUMBER, heading, Markup(svg.embeddable(drawn, name, label)),
                  caption(points, title_of, jkr), failures(case), case.record["command"])


def in_two_lines(text):
    """A title above a frame; its second half below the first, because frames are narrow."""
    parts = text.split(", ")
    middle = (len(parts) + 1) // 2
    return ", ".join(parts[:middle]) + ("," if parts[middle:] else ""), ", ".join(parts[middle:])


def title(point):
    keys = (("μ", "tabor"), ("A†", "amplitude"), ("λ†", "wavelength"), ("R†", "radius"))
    return ", ".join(f"{name} = {plain(value_of(point, key))}" for name, key in keys)


def caption(points, title_of, jkr):
    text = Markup("The pull-off force |W̄| that a test measures against the preload. Top: displacement control, against the "
                  "largest approach Δ†; bottom: load control, against the largest load W̄. A step begins where "
                  "loading jumps at a fold or passes a minimum of the load; the force is constant between two such preloads. Orange: computed; "
                  "dashed: the JKR theory{}, whose contacts have no grooves.").format(" (Eq 5)" if "Eq" in jkr else "")
    for number, point in enumerate(points, 1):
        steps = point["staircase"]["displacement_control"]["steps"]
        text += f" ({number}) " + (f"{title_of(point)}: " if title_of is not title else "") + "; ".join(
            f"{step['force']:.5g} from Δ† = {plain(round(step['preload']['approach'], 3))}" for step in steps)
        text += "; no harder preload gives more." if point["pull_off_any"]["complete"] else "."
    return text
