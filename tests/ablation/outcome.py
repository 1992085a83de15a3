"""What a set of results is worth: against solutions at a much tighter tolerance, and against those of the constants as
they are."""

import math
import os
import statistics
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "estimates"))
import compare                                          # noqa: E402  pylint: disable=wrong-import-position

COUNTERS = ("points", "newton_iterations", "factorizations", "kernel_evaluations")


def is_solved(document):
    """Of a line: every point has its pull-off or, where folds are followed, was not refused."""
    if "points" in document:
        return all(point["status"] == "ok" for point in document["points"])
    return document.get("status", "ok") == "ok"


def works(document):
    return [point["work"] for point in document.get("points", [document]) if "work" in point]


def cost(documents):
    """name -> sum over the documents."""
    found = [work for document in documents for work in works(document)]
    return {key: sum(work[key] for work in found) for key in COUNTERS}


# Keys of a document whose numbers are no results, or depend on where the steps of a trace are.
NO_RESULTS = {"input", "work", "diagnostics", "curve", "profile", "position", "start", "end", "ended", "until", "searched",
              "reached"}


def numbers(document, path=""):
    """(path, value) of every number that is a result, but no error estimate."""
    if isinstance(document, dict):
        for key, inner in document.items():
            if key not in NO_RESULTS and "error" not in key:
                yield from numbers(inner, f"{path}/{key}")
    elif isinstance(document, list):
        for k, inner in enumerate(document):
            yield from numbers(inner, f"{path}/{k}")
    elif isinstance(document, (int, float)) and not isinstance(document, bool):
        yield path, float(document)


def moved(document, base):
    """The largest change of a result, relative to 1 plus its size; infinite where results are lost or added."""
    ours, theirs = dict(numbers(document)), dict(numbers(base))
    if set(ours) != set(theirs):
        return math.inf
    return max((abs(ours[key] - theirs[key]) / (1.0 + abs(theirs[key])) for key in ours), default=0.0)


class Tally:
    """Sums over the set."""

    def __init__(self):
        self.errors, self.energies = [], []             # in units of the tolerance
        self.failed = self.missing = self.added = self.held = self.open = self.violated = self.changed = 0
        self.moved = 0.0

    def add_findings(self, findings):
        for finding in findings:
            verdict = finding.verdict
            self.held += verdict == "held"
            self.open += verdict == "open"
            self.violated += verdict == "violated"

    def add_solve(self, ours, truth):
        if not (ours.get("pull_off") and truth.get("pull_off")):
            self.failed += 1
            return
        comparison = compare.compare(ours, truth)
        self.missing += len(comparison.missing)
        self.added += len(comparison.added)
        self.add_findings(comparison.findings)
        self.add_error(ours, truth)
        for one, other in zip(energies(ours), energies(truth)):
            self.energies.append(abs(one - other) / (1.0 + abs(other)) / ours["input"]["tolerance"])

    def add_error(self, ours, truth):
        force, best = ours["pull_off"]["force"], truth["pull_off"]["force"]
        self.errors.append(abs(force - best) / best / ours["input"]["tolerance"])

    def add_line(self, ours, truth):
        for one, best in zip(ours["points"], truth["points"]):
            if one.get("pull_off") and best.get("pull_off"):
                self.add_error(one, best)
                stated, own = (compare.value(point["pull_off"], "error_estimate") for point in (one, best))
                self.add_findings([compare.Finding("force", "", stated, abs(one["pull_off"]["force"]
                                                                              - best["pull_off"]["force"]), own)])
                continue
            for fold, other in zip(one.get("folds") or [], best.get("folds") or []):
                lost, extra = fold["approach"] is None, other["approach"] is None
                self.missing += lost and not extra
                self.added += extra and not lost
                if not lost and not extra:
                    self.add_findings([compare.Finding("fold", "", compare.value(fold, "error_estimate"),
                                                       abs(fold["approach"] - other["approach"]),
                                                       compare.value(other, "error_estimate"))])

    def add(self, ours, base, truth):
        """Given: the document, that of the constants as they are, and the truth; None: there is none but the base."""
        self.changed += without_times(ours) != without_times(base)
        if not is_solved(ours):
            self.failed += 1
        elif truth is None:
            self.moved = max(self.moved, moved(ours, base))
        elif "points" in ours:
            self.add_line(ours, truth)
        else:
            self.add_solve(ours, truth)

    def row(self):
        """Columns of the results."""
        stated = self.held + self.open + self.violated
        return {"changed": self.changed, "failed": self.failed, "lost": self.missing, "extra": self.added,
                "median_error": f"{statistics.median(self.errors or [math.inf]):.3g}",
                "worst_error": f"{max(self.errors, default=math.inf):.3g}",
                "worst_energy": f"{max(self.energies, default=0.0):.3g}", "stated": stated, "held": self.held,
                "violated": self.violated, "moved": f"{self.moved:.2g}"}


def energies(document):
    """Energies lost, of loops and of staircases."""
    return [value for key, value in every(document) if key == "energy_lost"]


def every(document):
    """(key, number) of all objects inside, in order."""
    if isinstance(document, dict):
        for key, inner in document.items():
            if isinstance(inner, (int, float)):
                yield key, float(inner)
            yield from every(inner)
    elif isinstance(document, list):
        for inner in document:
            yield from every(inner)


def without_times(document):
    """The same document without the seconds it took."""
    if isinstance(document, dict):
        return {key: without_times(inner) for key, inner in document.items() if key != "seconds"}
    if isinstance(document, list):
        return [without_times(inner) for inner in document]
    return document
