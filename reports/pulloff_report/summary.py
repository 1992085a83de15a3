"""The first page: how the run stands, as one sentence and a table of cases by verdict."""

from .records import VERDICTS
from .words import count, date


def status(run):
    """(kind, headline, explanation) of the whole run."""
    checks = run.checks()
    within = sum(check["verdict"] == "within" for check in checks)
    outside = sum(check["verdict"] == "outside" for check in checks)
    silent = len(checks) - within - outside
    failed = sum(len(case.failed_points()) for case in run.cases)
    if not checks:
        return "open", "No check was made", "The cases of this run compare nothing."
    if outside:
        return ("outside", f"{outside} of {count(len(checks), 'check')} outside the tolerance",
                f"{within} within, {silent} without a result.")
    if silent or failed:
        parts = [count(silent, "check") + " without a result"] if silent else []
        parts += [count(failed, "solve") + " failed"] if failed else []
        return "open", " and ".join(parts), f"The other {within} checks are within their tolerance."
    return ("within", f"All {count(len(checks), 'check')} within their tolerance",
            "Every number below is set beside a reference it did not come from.")


def rows(run):
    """One row a case: counts by verdict, the worst error, the time."""
    made = []
    for case in run.cases:
        made.append({"case": case, "counts": {name: case.count(name) for name in VERDICTS},
                     "silent": case.count("no_result") + case.count("missing_reference"),
                     "total": len(case.checks), "worst": case.worst(),
                     "points": len(case.points), "failed": len(case.failed_points()),
                     "seconds": case.record.get("seconds")})
    return made


def totals(made):
    worst = [row["worst"] for row in made if row["worst"] is not None]
    return {"counts": {name: sum(row["counts"][name] for row in made) for name in VERDICTS},
            "silent": sum(row["silent"] for row in made),
            "total": sum(row["total"] for row in made), "worst": max(worst) if worst else None,
            "points": sum(row["points"] for row in made),
            "failed": sum(row["failed"] for row in made),
            "seconds": sum(row["seconds"] or 0 for row in made)}


def facts(run):
    """(version, date) of the run: the newest record speaks."""
    newest = max(run.cases, key=lambda case: str(case.record["environment"].get("date", "")))
    return {"version": newest.record["versions"].get("pulloff", ""),
            "date": date(str(newest.record["environment"].get("date", ""))),
            "processor": newest.record["environment"].get("processor", ""),
            "system": newest.record["environment"].get("system", "")}
