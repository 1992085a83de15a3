"""The first page: what was found about the paper, how many checks pass, the largest errors, when and how it was computed."""

import re

from . import samples
from .claims import contradicted, of_paper
from .records import NO_VERDICT, PASSING, VERDICTS
from .words import CHECK_VERDICTS, VERDICT_WORDS, count, date, listing, lower_first, quantity, sweep_label

FAILING = tuple(name for name in VERDICTS if name not in PASSING + NO_VERDICT)
NOTABLE = ("improved", "slack")   # verdicts that pass and are counted separately
MOST_FAILURES = 6                 # failing checks named on the first page
# Error estimates that a solve states with its pull-off, by the quantity they belong to.
ESTIMATES = {"pull_off_force": "error_estimate", "pull_off_approach": "approach_error_estimate"}
FOUND = {"reproduced": "are reproduced", "within_reading": "are reproduced within reading accuracy",
         "depends": "depend on a choice that the paper leaves open", "contradicted": "are contradicted",
         "not_testable": "cannot be tested", "no_result": "have no result"}
PROGRAM = {"pulloff": "pulloff", "compiler": "compiler", "gsl": "GSL", "openblas": "OpenBLAS", "lapacke": "LAPACKE"}


def by_verdict(run, names):
    """"2 outside, 1 regressed": the checks with these verdicts, or an empty string."""
    counts = ((sum(case.count(name) for case in run.cases), name) for name in names)
    return ", ".join(f"{number} {VERDICT_WORDS[name]}" for number, name in counts if number)


def status(run):
    """(kind, headline, explanation) of all checks of the run."""
    total = len(run.checks())
    passing = sum(case.count(*PASSING) for case in run.cases)
    failing = sum(case.count(*FAILING) for case in run.cases)
    unknown = total - passing - failing
    failed = sum(len(case.failed_points()) for case in run.cases)
    notable = by_verdict(run, NOTABLE)
    among = f" (among them {notable})" if notable else ""
    if not total:
        return "open", "No check was made", "The cases of this run define no checks."
    if failing:
        only_outside = failing == sum(case.count("outside") for case in run.cases)
        return ("outside", f"{failing} of {count(total, 'check')} "
                + ("outside the tolerance" if only_outside else f"failed: {by_verdict(run, FAILING)}"),
                f"{count(passing, 'check')} pass{among}; {unknown} have no result.")
    if unknown or failed:
        parts = [count(unknown, "check") + " without a result"] if unknown else []
        parts += [count(failed, "solve") + " failed"] if failed else []
        return "open", " and ".join(parts), f"The other {count(passing, 'check')} pass{among}."
    return ("within", f"All {count(total, 'check')} of {count(len(run.cases), 'case')} are within their tolerance",
            f"Each computed number is compared with a reference that was obtained independently{among}."
            if not any(check["ledger"] == "pin" for check in run.checks()) else
            "Each computed number is compared with a reference that was obtained independently, or with a pin, "
            f"the value that was last accepted for a regression test{among}.")


def worst_check(run):
    """The check with the largest error relative to its tolerance, in words; None if no check has an error."""
    found = [(check["ratio"], case, check) for case in run.cases for check in case.checks if check["ratio"] is not None]
    if not found:
        return None
    ratio, case, check = max(found, key=lambda item: item[0])
    return {"ratio": ratio, "quantity": lower_first(quantity(check["quantity"])), "case": case,
            "point": sweep_label(case.point(check.get("point")))}


def worst_estimate(run):
    """The largest |error| relative to the error that the solve stated, over the panel solves whose error was measured.

    The uncertainty of the reference is added to the stated error. None without such solves.
    """
    found = []
    for case in run.cases:
        for item in case.record.get("measured", []):
            point = case.point(item["point"])
            stated = ((point or {}).get("pull_off") or {}).get(ESTIMATES.get(item["quantity"], ""))
            if stated and item["error"] is not None:
                bound = stated + (item.get("reference_uncertainty") or 0)
                found.append((abs(item["error"]) / bound, item["quantity"], samples.scene_name(samples.scene_of(point))))
    if not found:
        return None
    ratio, name, scene = max(found)
    return {"ratio": ratio, "quantity": lower_first(quantity(name)), "scene": scene, "count": len(found)}


def failures(run):
    """The failing checks with the largest errors: (case, words)."""
    found = [(check["ratio"] or 0, case, check) for case in run.cases for check in case.checks if check["verdict"] in FAILING]
    found.sort(key=lambda item: -item[0])
    return [(case, f"{quantity(check['quantity'])}, {sweep_label(case.point(check.get('point')))}")
            for _, case, check in found[:MOST_FAILURES]], max(0, len(found) - MOST_FAILURES)


def rows(run):
    """One row a case: its checks by verdict, the largest error, the time."""
    return [{"case": case, "passing": case.count(*PASSING), "failing": case.count(*FAILING),
             "unknown": case.count(*NO_VERDICT), "notable": sum(case.count(name) for name in NOTABLE),
             "total": len(case.checks), "worst": case.worst(), "points": len(case.points),
             "failed": len(case.failed_points()), "seconds": case.record.get("seconds")} for case in run.cases]


def totals(made):
    worst = [row["worst"] for row in made if row["worst"] is not None]
    sums = {name: sum(row[name] for row in made)
            for name in ("passing", "failing", "unknown", "notable", "total", "points", "failed")}
    return dict(sums, worst=max(worst) if worst else None,
                seconds=sum(row["seconds"] or 0 for row in made))


def short_version(name, text):
    """Name and version number, without build options; a name in the text replaces the given one."""
    found = re.match(r"\D*[\d.]+", text)
    short = found[0] if found else text
    return f"{name} {short}" if short[:1].isdigit() else short


def facts(run):
    """When and with what the run was computed: the environment of its newest record, the dates of all of them."""
    dates = sorted(str(case.record["environment"].get("date", "")) for case in run.cases)
    newest = max(run.cases, key=lambda case: str(case.record["environment"].get("date", "")))
    surroundings, versions = newest.record["environment"], newest.record["versions"]
    return {"version": versions.get("pulloff", ""), "dates": list(dict.fromkeys(date(text) for text in (dates[0], dates[-1]) if text)),
            "processor": surroundings.get("processor", ""), "cores": surroundings.get("cores"),
            "system": surroundings.get("system", ""),
            "program": [short_version(name, versions[key]) for key, name in PROGRAM.items() if versions.get(key)],
            "seconds": sum(case.record.get("seconds") or 0 for case in run.cases)}


def claims(judged):
    """What was found about the statements of the paper; None if they were not judged."""
    if not judged:
        return None
    counts, total = judged["counts"], len(of_paper(judged))
    wrong = contradicted(judged)
    verb = "is" if len(wrong) == 1 else "are"
    headline = (f"{len(wrong)} of {count(total, 'statement')} of the paper {verb} contradicted" if wrong
                else f"None of {count(total, 'statement')} of the paper is contradicted")
    others = [f"{counts[name]} {text}" for name, text in FOUND.items() if counts.get(name) and name != "contradicted"]
    checks = [f"{count(counts[name], 'implementation check')} {text.split()[-1]}" for name, text in CHECK_VERDICTS.items()
              if counts.get(name)]
    return {"headline": headline, "text": f"{listing(others)}." if others else "",
            "checks": f"{listing(checks)}." if checks else "", "contradicted": wrong}


def build(run, judged):
    """All that the first page shows."""
    kind, headline, text = status(run)
    named, more = failures(run)
    return {"claims": claims(judged), "facts": facts(run), "worst": worst_check(run), "estimate": worst_estimate(run),
            "failures": named, "more_failures": more, "status": {"kind": kind, "headline": headline, "text": text}}
