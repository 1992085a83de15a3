"""Staircases: the pull-off force that a test measures against the preload."""

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import plain, value_of
from .figure import Figure, failures

NUMBER = None
TITLE = "Pull-off force against preload"
CONTROLS = (("displacement_control", "approach"), ("load_control", "load"))
BEYOND = 1.15  # end of the axis, relative to the beginning of the last step


def stairs(found, axis, end):
    """Rows (preload, force) of a staircase up to the end of the axis.

    Between two steps that are not adjacent, the load falls towards a minimum while the approach increases, and the test
    measures the tension at reversal; a straight line is drawn there.
    """
    rows = []
    for step in found["steps"]:
        begin, until = step["preload"][axis], end if step["open"] else step["until"][axis]
        if begin is None:   # in load control the bodies come into contact at zero load
            begin = 0.0
        rows += [(begin, step["force"]), (max(begin, min(until, end)), step["force"])]
    if rows and rows[-1][0] < end:
        rows.append((end, rows[-1][1]))
    return [row for row in rows if row[0] <= end]


def last_preload(found, axis):
    return max((step["preload"][axis] or 0.0 for step in found["steps"]), default=0.0)


def make(case, references):
    del references
    points = [point for point in case.points if point.get("staircase")]
    data, ends, lowest, tops = {"solver": [], "jkr": []}, [], [], []
    for control, axis in CONTROLS:
        for point in points:
            both = point["staircase"][control], (point["staircase"]["jkr"] or {}).get(control, {"steps": []})
            ends.append(BEYOND * max(last_preload(found, axis) for found in both))
            for name, found in zip(("solver", "jkr"), both):
                data[name].append(stairs(found, axis, ends[-1]))
            lowest.append(min(row[0] for name in data for row in data[name][-1]))
            tops.append(max(row[1] for name in data for row in data[name][-1]))
    drawn = gnuplot.draw("staircase", {
        "scene_count": len(points), "title_text": [title(point) for point in points], "end": ends, "begin": lowest,
        "top": [1.12 * value for value in tops], "figure_height": 470}, data)
    label = "Pull-off force against the largest approach and the largest load before unloading, with the JKR theory"
    return Figure("staircase", NUMBER, TITLE, Markup(svg.embeddable(drawn, "staircase", label)),
                  caption(points), failures(case), case.record["command"])


def title(point):
    keys = (("μ", "tabor"), ("A†", "amplitude"), ("λ†", "wavelength"), ("R†", "radius"))
    return ", ".join(f"{name} = {plain(value_of(point, key))}" for name, key in keys)


def caption(points):
    text = Markup("The pull-off force |W̄| that a test measures against the preload. Top: displacement control, against the "
                  "largest approach Δ†; bottom: load control, against the largest load W̄. A step begins where "
                  "loading jumps at a fold or passes a minimum of the load; the force is constant between two such preloads. Red: computed; "
                  "dashed: the JKR theory (Eq 5), whose contacts have no grooves.")
    for number, point in enumerate(points, 1):
        steps = point["staircase"]["displacement_control"]["steps"]
        text += f" ({number}) " + "; ".join(
            f"{step['force']:.5g} from Δ† = {plain(round(step['preload']['approach'], 3))}" for step in steps)
        text += "; no harder preload gives more." if point["pull_off_any"]["complete"] else "."
    return text
