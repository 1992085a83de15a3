"""What the figures drawn twice share: by panels, and by the discretisation of the paper."""

import math

from ..words import plain, scientific, value_of

PAPER = "triangles on 501 equally spaced nodes, the surface cut at r = R"


def rows(case, keys):
    """Key values -> (force, approach) of the solved points of a case; {} without one."""
    found = {}
    for point in case.points if case else []:
        if point["status"] == "ok" and point.get("pull_off"):
            found[tuple(value_of(point, key) for key in keys)] = (point["pull_off"]["force"],
                                                                  point["pull_off"]["approach"])
    return found


def match(found, key):
    """The entry of `found` whose key is this one to rounding, or None."""
    for other, value in found.items():
        if all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-300) for a, b in zip(key, other)):
            return value
    return None


def differences(case, keys, relative=False):
    """Key values -> |force of the paper's discretisation - force by panels|."""
    truth, found = rows(case, keys), {}
    for key, (force, _) in rows(case.companion, keys).items():
        other = match(truth, key)
        if other:
            found[key] = max(abs(force - other[0]) / (other[0] if relative else 1.0), 1e-16)
    return found


def table_blocks(table, by, x, y):
    """One block of rows (x, y) for each distinct combination of the columns `by`, in their order."""
    if table is None:
        return {}
    blocks = {}
    for row in zip(*(table.numbers(name) for name in [*by, x, y])):
        blocks.setdefault(tuple(float(v) for v in row[:len(by)]), []).append(
            (float(row[-2]), float(row[-1])))
    return blocks


def how(case):
    """How a case was computed, for its caption."""
    point = case.points[0]["input"]
    domain = point["outer_radius"]
    where = ("on the unbounded half-space" if domain == "inf"
             else f"on the surface cut at r = {plain(domain)} ε")
    if point["scheme"] == "panel":
        return f"panels to {scientific(point['tolerance'], 1)} {where}"
    return f"{point['scheme']}s on {point['nodes']} nodes {where}"


def failed(case):
    """What was not solved, in one sentence a reason however many points."""
    told = {}
    for point in case.unsolved_points():
        told.setdefault(point["status"].replace("_", " "), []).append(point["label"])
    return [f"Not solved ({reason}), {len(labels)} of {len(case.points)}: {'; '.join(labels)}."
            for reason, labels in told.items()]


def remarks(case, tell=failed):
    """What was not solved, as `tell` says it, and whether the paper's discretisation is there."""
    told = tell(case)
    if case.companion is None:
        told.append(f"This run holds no record of {case.name}_paper, so the difference to the paper’s "
                    "discretisation is not shown.")
    else:
        told += [f"By the paper’s discretisation, {line}" for line in tell(case.companion)]
    return told
