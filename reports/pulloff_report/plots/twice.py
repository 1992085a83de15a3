"""Functions for the figures that are computed twice: with panels, and with the discretisation of the paper."""

import math

from markupsafe import Markup

from ..words import plain, scientific, value_of

PAPER = "triangles on 501 equally spaced nodes, half-space cut at r = R"
# The load of Eq 9 between a rigid sphere and the half-space beyond r = R, which the cut leaves out: in πwR, R† = 100, Δ† = 0.
CUT = 8 / 3 / (1 + 100 / 2) ** 2
CUT_WORDS = ("dashed: 1.0 × 10⁻³, the traction beyond r = R, which the cut leaves out; the difference at this level is the cut, "
             "and not the discretisation")


def rows(case, keys):
    """Key values -> (force, approach) of the solved points of a case; empty without a case."""
    return {key: (point["pull_off"]["force"], point["pull_off"]["approach"]) for key, point in solved(case, keys)}


def solved(case, keys):
    """(key values, point) of the solved points of a case."""
    for point in case.points if case else []:
        if point["status"] == "ok" and point.get("pull_off"):
            yield tuple(value_of(point, key) for key in keys), point


def match(found, key):
    """The entry of `found` whose key equals this one up to rounding, or None."""
    for other, value in found.items():
        if all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-300) for a, b in zip(key, other)):
            return value
    return None


def differences(case, keys, relative=False):
    """Key values -> |force with the paper's discretisation - force with panels|."""
    truth, found = rows(case, keys), {}
    for key, (force, _) in rows(case.companion, keys).items():
        other = match(truth, key)
        if other:
            found[key] = max(abs(force - other[0]) / (other[0] if relative else 1.0), 1e-16)
    return found


def table_blocks(table, by, x, y):
    """One block of rows (x, y) for each distinct combination of the columns `by`, in order of appearance."""
    if table is None:
        return {}
    blocks = {}
    for row in zip(*(table.numbers(name) for name in [*by, x, y])):
        blocks.setdefault(tuple(float(v) for v in row[:len(by)]), []).append(
            (float(row[-2]), float(row[-1])))
    return blocks


def how(case):
    """The discretisation of a case, for its caption."""
    point = case.points[0]["input"]
    domain = point["outer_radius"]
    where = ("on the unbounded half-space" if domain == "inf"
             else f"on a half-space cut at r = {plain(domain)} ε")
    if point["scheme"] == "panel":
        return Markup("panels at tolerance {} {}").format(scientific(point["tolerance"], 1), where)
    return f"{point['scheme']}s on {point['nodes']} nodes {where}"


def failed(case):
    """The unsolved points, one sentence for each reason."""
    made = {}
    for point in case.unsolved_points():
        made.setdefault(point["status"].replace("_", " "), []).append(point["label"])
    return [f"Not solved ({reason}), {len(labels)} of {len(case.points)}: {'; '.join(labels)}."
            for reason, labels in made.items()]


def remarks(case, tell=failed):
    """Sentences on unsolved points, worded by `tell`, and on a missing case with the paper's discretisation."""
    made = tell(case)
    if case.companion is None:
        made.append(f"This run has no record of {case.name}_paper, so the difference from the paper’s "
                    "discretisation is not drawn.")
    else:
        made += [f"With the paper’s discretisation: {line}" for line in tell(case.companion)]
    return made
