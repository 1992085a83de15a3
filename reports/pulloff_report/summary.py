"""The first page: how the run stands, as one sentence and a table of cases by verdict."""

from .records import PASSING, SILENT, VERDICTS
from .claims import of_paper
from .words import CHECK_VERDICTS, CLAIM_VERDICTS, VERDICT_WORDS, count, date, listing


FAILING = tuple(name for name in VERDICTS if name not in PASSING + SILENT)
TOLD = ("improved", "slack")


def told(run):
    """What passes and is to be seen: "1 improved, 2 slack", or nothing."""
    counts = ((sum(case.count(name) for case in run.cases), name) for name in TOLD)
    return ", ".join(f"{number} {VERDICT_WORDS[name]}" for number, name in counts if number)


def failures(run):
    """"2 outside, 1 regressed": the failing checks by verdict."""
    counts = ((sum(case.count(name) for case in run.cases), name) for name in FAILING)
    return ", ".join(f"{number} {VERDICT_WORDS[name]}" for number, name in counts if number)


def status(run):
    """(kind, headline, explanation) of the whole run."""
    checks = run.checks()
    passing = sum(case.count(*PASSING) for case in run.cases)
    failing = sum(case.count(*FAILING) for case in run.cases)
    silent = len(checks) - passing - failing
    failed = sum(len(case.failed_points()) for case in run.cases)
    seen = f" ({told(run)})" if told(run) else ""
    if not checks:
        return "open", "No check was made", "The cases of this run compare nothing."
    if failing:
        only_outside = failing == sum(case.count("outside") for case in run.cases)
        return ("outside", f"{failing} of {count(len(checks), 'check')} "
                + ("outside the tolerance" if only_outside else f"failed: {failures(run)}"),
                f"{passing} within{seen}, {silent} without a result.")
    if silent or failed:
        parts = [count(silent, "check") + " without a result"] if silent else []
        parts += [count(failed, "solve") + " failed"] if failed else []
        return ("open", " and ".join(parts),
                f"The other {passing} checks are within their tolerance{seen}.")
    return ("within", f"All {count(len(checks), 'check')} within their tolerance",
            f"Every number below is set beside a reference it did not come from{seen}."
            if not any(check["ledger"] == "pin" for check in checks) else
            "Every number below is set beside a reference it did not come from, or, where the ledger "
            f"says pin, beside what this program gave when it was last accepted{seen}.")


def rows(run):
    """One row a case: counts by verdict, the worst error, the time."""
    made = []
    for case in run.cases:
        made.append({"case": case, "passing": case.count(*PASSING), "failing": case.count(*FAILING),
                     "silent": case.count(*SILENT),
                     "told": sum(case.count(name) for name in TOLD),
                     "total": len(case.checks), "worst": case.worst(),
                     "points": len(case.points), "failed": len(case.failed_points()),
                     "seconds": case.record.get("seconds")})
    return made


def totals(made):
    worst = [row["worst"] for row in made if row["worst"] is not None]
    sums = {name: sum(row[name] for row in made)
            for name in ("passing", "failing", "silent", "told", "total", "points", "failed")}
    return dict(sums, worst=max(worst) if worst else None,
                seconds=sum(row["seconds"] or 0 for row in made))


def facts(run):
    """(version, date) of the run: the newest record speaks."""
    newest = max(run.cases, key=lambda case: str(case.record["environment"].get("date", "")))
    return {"version": newest.record["versions"].get("pulloff", ""),
            "date": date(str(newest.record["environment"].get("date", ""))),
            "processor": newest.record["environment"].get("processor", ""),
            "system": newest.record["environment"].get("system", "")}


def claims(judged):
    """How the claims of the paper fare, in a sentence; nothing where they were not judged."""
    if not judged:
        return ""
    counts = judged["counts"]
    told = [f"{counts[name]} {text}" for name, text in CLAIM_VERDICTS.items() if counts.get(name)]
    checks = [f"{count(counts[name], 'implementation check')} {text.split()[-1]}" for name, text in CHECK_VERDICTS.items()
              if counts.get(name)]
    beside = f" Beside them: {listing(checks)}." if checks else ""
    return f"{count(len(of_paper(judged)), 'statement')} of the paper: {listing(told)}.{beside}"
