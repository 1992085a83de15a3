"""The first page: the sentences of the paper, then the counts (the physics, the bookkeeping), the speed, the extreme scenes, when and
how it was computed."""

import re

from markupsafe import Markup

from . import samples
from .claims import contradicted, of_paper
from .records import NO_VERDICT, PASSING, VERDICTS
from .words import (CHECK_VERDICTS, VERDICT_WORDS, count, date, listing, lower_first, plain, quantity, ratio, scientific,
                    signed, sweep_label, value_of)

FAILING = tuple(name for name in VERDICTS if name not in PASSING + NO_VERDICT)
NOTABLE = ("slack",)              # verdicts that pass and are counted separately
MOST_FAILURES = 6                 # failing checks named on the first page
# References that are this program itself: such a check is bookkeeping.
OURSELVES = ("traced", "every_scene")
# Error estimates that a solve states with its pull-off, by the quantity they belong to.
ESTIMATES = {"pull_off_force": "error_estimate", "pull_off_approach": "approach_error_estimate"}
HOLDING = ("reproduced", "within_reading")
FOUND = {"depends": ("depends on a choice that the paper leaves open", "depend on a choice that the paper leaves open"),
         "contradicted": ("is contradicted", "are contradicted"), "not_testable": ("cannot be tested",) * 2,
         "no_result": ("has no result", "have no result")}
PROGRAM = {"pulloff": "pulloff", "compiler": "compiler", "gsl": "GSL", "openblas": "OpenBLAS", "lapacke": "LAPACKE"}
EXTREMES = ("tabor", "amplitude", "wavelength", "radius")   # parameters whose ranges the first page states


def is_physics(check):
    """Whether a check compares with something that this program did not compute."""
    return check.get("reference") not in OURSELVES


def paper(judged):
    """The statements of the paper: how many hold under every convention and preload, then how many as they are read."""
    counts, robust, total = judged["counts"], judged["robust"], len(of_paper(judged))
    holding = sum(counts.get(name, 0) for name in HOLDING)
    others = [f"{counts[name]} {text[counts[name] != 1]}" for name, text in FOUND.items() if counts.get(name)]
    text = f"Read by one convention, {count(holding, 'statement holds', 'statements hold')}" + (f"; {listing(others)}" if others else "") + "."
    if robust["moved"]:
        text += f" With half or twice the accuracy of the convention, {count(robust['moved'], 'verdict moves', 'verdicts move')}."
    return {"kind": "paper", "name": "The paper", "link": "claims", "link_text": "claims of the paper",
            "headline": f"{robust['holds_always']} of {count(total, 'statement')} hold under every convention of reading" + (
                " and every preload that the numbers of the paper admit" if judged["preloads"] else ""),
            "text": text, "preload": preload(judged), "sentences": judged["sentences"], "failures": [], "more": 0}


def span(values, digits=3):
    """"9.3", "0.08 to 0.14"."""
    ends = [signed(f"{value:.{digits}g}") for value in (min(values), max(values))]
    return ends[0] if ends[0] == ends[1] else " to ".join(ends)


def needed(survey):
    """The approaches at which a surveyed number of the paper is reproduced: "Δ† = 9 to 19", "Δ† of 5.7 and more"."""
    tried = sorted((part["approach"], part["holds"]["once"]) for part in survey["tried"] if part["approach"] is not None)
    holding = [approach for approach, holds in tried if holds]
    if not holding:
        return "no approach tried"
    if holding[-1] == tried[-1][0]:
        return f"Δ† of {holding[0]:g} and more"
    return f"Δ† = {holding[0]:g}" + (f" to {holding[-1]:g}" if len(holding) > 1 else "")


def preload(judged):
    """The finding on the preload that the paper does not state, from the surveys; None without them."""
    shared, numbered = judged["common"], [survey for survey in judged["surveys"] if survey["claimed"] is not None]
    if not shared:
        return None
    figures = listing(survey["figure"] for survey in numbered)
    gives = listing(shared["once"])
    made = {"headline": f"The preload {gives} gives the numbers of Figures {figures}" if gives
            else f"No single preload gives the numbers of Figures {figures}", "figures": figures}
    needs = "; ".join(f"|W̄| ≈ {survey['claimed']:g} of Figure {survey['figure']} needs {needed(survey)}" for survey in numbered)
    twice = listing(shared["twice"])
    same = "With twice the accuracy there is none, either." if not twice else f"With twice the accuracy, {twice} gives all."
    text = f"{needs}. {same if not gives else ''} Of {shared['tried']} preloads tried, {shared['nearest']} comes nearest: "
    text += listing(f"{number:.3g}" for number in shared["numbers"]) + "."
    over = [(number / (1.1 * survey["claimed"]) - 1, survey["figure"]) for number, survey in zip(shared["numbers"], numbered)]
    wide, figure = max(over)
    if wide > 0 and all(number >= 0.9 * survey["claimed"] for number, survey in zip(shared["numbers"], numbered)):
        text += (f" The amplitudes of the paper are not stated; if those of Figure {figure} are more than {wide:.0%} apart, they can miss the "
                 "largest force, and this preload is possible.")
    ends = [f"for {survey['words'].partition(' for ')[2]} at A/λ = {span([part['computed'] for part in survey['tried'] if part['computed'] is not None])}"
            for survey in judged["surveys"] if survey["claimed"] is None]
    if ends:
        text += f" The preload decides where the enhancement ends: the largest force is {listing(ends)}."
    return made | {"text": text}


def named(run, checks):
    """(case, words) of the failing checks with the largest errors, and how many more there are."""
    found = sorted(((check["ratio"] or 0, case, check) for case in run.cases for check in case.checks
                    if check["verdict"] in FAILING and checks(check)), key=lambda item: -item[0])
    return [(case, f"{quantity(check['quantity'])}, {sweep_label(case.point(check.get('point')))}")
            for _, case, check in found[:MOST_FAILURES]], max(0, len(found) - MOST_FAILURES)


def physics(run):
    """The checks against references that were obtained independently, and the solves that failed."""
    checks = [check for check in run.checks() if is_physics(check)]
    passing, failing = (sum(check["verdict"] in names for check in checks) for names in (PASSING, FAILING))
    unknown, failed = len(checks) - passing - failing, sum(len(case.failed_points()) for case in run.cases)
    named_ones, more = named(run, is_physics)
    if not checks:
        headline = "No check against an independent reference was made"
    elif failing:
        headline = f"{failing} of {count(len(checks), 'check')} against independent references {'fails' if failing == 1 else 'fail'}"
    elif unknown or failed:
        headline = f"{passing} of {count(len(checks), 'check')} against independent references pass, none fails"
    else:
        headline = f"All {count(len(checks), 'check')} against independent references pass"
    lost = [f"{count(unknown, 'check')} without a result"] * bool(unknown) + [count(failed, "failed solve")] * bool(failed)
    parts = [" and ".join(lost) + "."] if lost else []
    others = sum(not is_physics(check) for check in run.checks())
    if others and checks:
        parts.append(f"With {count(others, 'repetition', 'repetitions')}, of scenes by this program itself, there are "
                     f"{count(len(checks) + others, 'check')}.")
    worst, estimate = worst_check(run), worst_estimate(run)
    if worst:
        parts.append(Markup("The largest error is {} of its {}tolerance ({}, {}, case {}).").format(
            ratio(worst["ratio"]), worst["kind"], worst["quantity"], worst["point"], worst["case"].name))
    if estimate:
        parts.append(Markup("Where an independent solution is known ({} forces and approaches), the true error is at most {} of the "
                            "stated one.").format(estimate["count"], ratio(estimate["ratio"])))
    return {"kind": "physics", "name": "Physics", "state": "failing" if failing else "unsure" if unknown or failed else "", "link": "verdicts",
            "link_text": "checks by case", "headline": headline, "text": Markup(" ").join(parts), "failures": named_ones, "more": more}


def bookkeeping(run, same, planted, judged, tests):
    """Whether a result changed, whether a fault would be noticed, and whether the tests pass: (passing, total, words) of each."""
    checks = [check for check in run.checks() if not is_physics(check)]
    found = [(sum(check["verdict"] in PASSING for check in checks), len(checks), "repeated traces agree")]
    if same:
        found.insert(0, (same["identical"], same["compared"], "results are identical to the last bit with those of the maintainers"
                         + (f" (the largest difference is {same['largest'][0]:.2g} of the force: {same['largest'][2]}, case "
                            f"{same['largest'][1]})" if same["different"] else "")))
    if planted:
        missed = [fault["name"] for fault in planted["faults"] if not fault["caught"]]
        found.append((len(planted["faults"]) - len(missed), len(planted["faults"]), "planted faults are detected"
                      + (f" (not detected: {listing(missed)})" if missed else "")))
    if tests:
        found.append((tests["passed"], tests["total"], f"tests passed in the last run of meson here, {tests['date']}"
                      + (f" (not passed: {listing(tests['failed'])})" if tests["failed"] else "")))
    if judged:
        counts = [judged["counts"].get(name, 0) for name in CHECK_VERDICTS]
        found.append((counts[0], sum(counts), "implementation checks of the claims pass"))
    found = [entry for entry in found if entry[1]]
    if not found:
        return None
    lost = [entry for entry in found if entry[0] != entry[1]]
    named_ones, more = named(run, lambda check: not is_physics(check))
    return {"kind": "books", "name": "Bookkeeping", "link": "planted-faults", "link_text": "planted faults",
            "failures": named_ones, "more": more,
            "headline": in_words(lost or found[:1]), "text": in_words([entry for entry in found if entry not in (lost or found[:1])], ".")}


def in_words(entries, end=""):
    text = "; ".join(f"all {total} {what}" if passing == total else f"{passing} of {total} {what}" for passing, total, what in entries)
    return text[:1].upper() + text[1:] + (end if text else "")


def worst_check(run):
    """The independent check with the largest error relative to its tolerance, in words; None if no check has an error."""
    found = [(check["ratio"], case, check) for case in run.cases for check in case.checks
             if check["ratio"] is not None and is_physics(check)]
    if not found:
        return None
    largest, case, check = max(found, key=lambda item: item[0])
    return {"ratio": largest, "quantity": lower_first(quantity(check["quantity"])), "case": case,
            "kind": {"abs": "absolute ", "rel": "relative "}.get(check.get("kind"), ""),
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
    largest, name, scene = max(found)
    return {"ratio": largest, "quantity": lower_first(quantity(name)), "scene": scene, "count": len(found)}


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


def extremes(data):
    """What the section on extreme scenes found: solved scenes, ranges of their parameters, largest stated error."""
    rows = [row for table in data.get("tables", []) for row in table["rows"]]
    stated = [(row["pull_off"]["error_estimate"] / row["pull_off"]["force"], row) for row in rows
              if row["pull_off"].get("error_estimate") and row["pull_off"].get("force")]
    ranges = []
    for key in EXTREMES:
        values = [value_of(row["point"], key) for row in rows]
        values = [value for value in values if isinstance(value, (int, float)) and (value or key != "wavelength")]
        if values and min(values) < max(values):
            ranges.append((key, plain(min(values)), plain(max(values))))
    worst = max(stated, key=lambda item: item[0], default=None)
    return {"scenes": len(rows), "solved": data["solved"], "ranges": ranges,
            "worst": worst and {"relative": worst[0], "label": worst[1]["label"]}} if rows else None


def own_title(run):
    """The title of a run without a case of the paper: that of its case, or how many cases it has."""
    return run.cases[0].title if len(run.cases) == 1 else f"Report of {count(len(run.cases), 'case')}"


def build(run, data, judged=None, planted=None, same=None, tests=None):
    """All that the first page shows; `data`: what the sections show, by the identifier of the section."""
    counts = [paper(judged) if judged else None, physics(run), bookkeeping(run, same, planted, judged, tests)]
    return {"counts": [entry for entry in counts if entry], "contradicted": contradicted(judged), "facts": facts(run),
            "speed": data["precision"].get("front"), "extremes": extremes(data["extreme"]),
            "solvers": data["solvers"].get("front")}
