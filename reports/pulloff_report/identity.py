"""How many results are identical to the last bit with the stored ones (cases/pins/CASE.csv)."""

import math

from .words import sweep_label


def difference(force, stored):
    """The relative difference of two pull-off forces; the texts "-" and None: there is none."""
    if force is None or stored == "-":
        return 0.0 if force is None and stored == "-" else math.inf
    return abs(force - float(stored)) / abs(float(stored))


def compare(run, references):
    """The comparison of all results with a stored digest; None if there is no such result.

    `largest`: of the different results, the one whose pull-off force differs most, as (difference, case, point).
    """
    compared, different = 0, []
    for case in run.cases:
        table = references.table(f"pins/{case.name}.csv")
        # a number names the same point only as long as the scenes are those of the stored results
        other = table is not None and table.header.get("scenes") != case.record.get("scenes")
        stored = {} if table is None or other else {
            point: (digest, force) for point, digest, force in zip(*(table.columns[name] for name in (
                "point", "digest", "pull_off_force")))}
        for point in case.points:
            if point["id"] not in stored or "digest" not in point:
                continue
            digest, force = stored[point["id"]]
            compared += 1
            if digest != point["digest"]:
                different.append((difference((point.get("pull_off") or {}).get("force"), force), case.name,
                                  sweep_label(point)))
    if not compared:
        return None
    return {"compared": compared, "identical": compared - len(different), "different": len(different),
            "largest": max(different) if different else None}
