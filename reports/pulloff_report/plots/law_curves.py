"""Load against approach of the smooth sphere under four laws, beside the JKR and the Maugis-Dugdale theory."""

from markupsafe import Markup

from .. import geometry, gnuplot, svg
from ..words import MINUS, listing, plain, value_of
from .figure import Figure, failures
from .laws import COLOURS, by_law, law_name

NUMBER = None
TITLE = "Load against approach under four laws"
THEORIES = ("maugis", "jkr")
MARGIN = 0.35   # of the frame beyond the folds, relative to their range


def branch(case, point):
    """Rows (−Δ†, W̄) of a computed branch."""
    table = case.curve(point)
    if table is None or table.rows < 2:
        return []
    rows = geometry.dense(-table.numbers("approach"), table.numbers("load"), table.numbers("position"))
    return [(float(x), float(y)) for x, y in rows]


def theory(case, name, tabor):
    """Rows (−Δ†, W̄) of a theory at this Tabor parameter; empty without that line."""
    table = case.line(name)
    if table is None:
        return []
    rows = zip(table.numbers("tabor").tolist(), table.numbers("approach").tolist(), table.numbers("load").tolist())
    return [(-approach, load) for mu, approach, load in rows if mu == tabor]


def jumps(points, kind, which):
    """Least and greatest approach of the first (0) or last (−1) fold of a kind; None without such folds."""
    found = [[fold["approach"] for fold in point["folds"] if fold["kind"] == kind] for point in points]
    ends = [row[which] for row in found if row]
    return (min(ends), max(ends)) if ends else None


def make(case, references):
    del references
    laws = by_law(case)
    tabors = sorted({value_of(point, "tabor") for points in laws.values() for point in points})
    data, said, windows = {"computed": [], "maugis": [], "jkr": []}, [], []
    for tabor in tabors:
        points = [next((one for one in rows if value_of(one, "tabor") == tabor), None) for rows in laws.values()]
        data["computed"] += [branch(case, point) if point else [] for point in points]
        for name in THEORIES:
            data[name].append(theory(case, name, tabor))
        there = [point for point in points if point]
        edges = [-fold["approach"] for point in there for fold in point["folds"]]
        edges += [-point["pull_off"]["approach"] for point in there]
        room = MARGIN * (max(edges) - min(edges) + 1)
        windows.append((min(edges) - 2 * room, max(edges) + room))
        said.append((tabor, jumps(there, "jump_in", 0), jumps(there, "jump_out", -1),
                     [law_name(point) for point in there if not point["folds"]],
                     sorted(point["pull_off"]["force"] for point in there)))
    drawn = gnuplot.draw("law_curves", {
        "count": len(laws), "frames": len(tabors), "name": list(laws), "colour": list(COLOURS[:len(laws)]),
        "frame_text": [f"μ = {plain(tabor)}" for tabor in tabors], "x_low": [row[0] for row in windows],
        "x_high": [row[1] for row in windows], "figure_height": 330}, data)
    label = "Load against minus the approach for four laws at two Tabor parameters"
    return Figure("law_curves", NUMBER, TITLE, Markup(svg.embeddable(drawn, "law_curves", label)), caption(said),
                  failures(case), case.record["command"])


def caption(said):
    text = Markup("Load W̄ against {}Δ† for four laws. Dashed: Maugis–Dugdale theory with the greatest tension of the Lennard-Jones law; "
                  "dotted: JKR theory.").format(MINUS)
    for tabor, into, out, without, forces in said:
        if into and out:
            text += Markup(" At μ = {}, the surfaces jump into contact at Δ† = {} to {}, and out of contact at {} to {}.").format(
                plain(tabor), *(f"{value:.2f}".replace("-", MINUS) for value in into + out))
        if without:
            text += f" There are no folds with {listing(without)}."
        text += f" The pull-off forces are {forces[0]:.3f} to {forces[-1]:.3f}."
    return text + (" Far from contact the load is that of the far field of the law, so the jump into contact depends on the law. On the "
                   "stable branch in contact the load depends the less on the law the larger μ is.")
