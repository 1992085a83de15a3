"""Compares a loose and a tight solution of a scene, to test the errors that the loose one states.

The tight solution states an error, too. A stated error of the loose solution *holds* if the sum of the difference and
the error of the tight solution does not exceed it. It is *violated* if the difference exceeds the sum of both stated
errors. Otherwise it is *open*: the tight solution is not accurate enough to decide."""

import math
from dataclasses import dataclass, field

# Two special points farther apart than twice this, in the plane of approach/eps and load/(pi w R), are not the same
# point. Half and twice the value gave the same pairs in 300 scenes. Loads of profiles without a radius, in pi w eps,
# are divided by the pull-off force.
APART = 0.05
ROUNDING = 1e-14         # relative error of a difference of two printed numbers


@dataclass
class Finding:
    """One number of the loose solution."""
    quantity: str
    where: str
    stated: float            # NaN: no error is stated
    difference: float
    own: float               # error of the tight solution

    @property
    def verdict(self):
        if not self.difference <= self.stated + self.own:
            return "unstated" if math.isnan(self.stated) else "violated"
        return "held" if self.difference + self.own <= self.stated else "open"

    @property
    def ratio(self):
        """The stated error divided by the true one. If `is_bound`, a lower bound of it."""
        return self.stated / max(self.difference, self.own)

    @property
    def is_bound(self):
        return self.difference < self.own


@dataclass
class Comparison:
    """The comparison of one scene."""
    findings: list = field(default_factory=list)
    missing: list = field(default_factory=list)     # folds and extrema of the tight solution alone, as text
    added: list = field(default_factory=list)       # those of the loose solution alone
    faint: int = 0                                  # number of those of either that are below the stated errors
    ended_apart: bool = False                       # one trace is longer: compared up to the earlier end
    beyond: bool = False                            # and found a deeper minimum there
    tie: bool = False                               # two minima are equally deep within the stated errors
    undecided: bool = False                         # a crest at the threshold of contact: two radii are stated

    @property
    def violations(self):
        return ([f"{f.quantity}: stated {f.stated:.3g}, off by {f.difference:.3g}{f.where}"
                 for f in self.findings if f.verdict == "violated"]
                + [f"missing {text}" for text in self.missing] + [f"added {text}" for text in self.added])


def value(document, key):
    """A number of a JSON object; NaN if it is null or missing."""
    found = document.get(key)
    return math.nan if found is None else float(found)


def special_points(document, name):
    sphere = document.get("input", {}).get("profile", "sphere") == "sphere"
    unit = 1.0 if sphere else document["pull_off"]["force"]
    return sorted(({**mark, "shown": mark["load"] / unit} for mark in document[name]),
                  key=lambda mark: mark["position"])


def after(document, name, start):
    """The special points that a trace from the approach `start` meets. The first points along the branch, of all kinds,
    are left out as long as their approach is below `start`. Later the branch may return to such approaches."""
    met = [mark["position"] for mark in document["folds"] + document["extrema"] if mark["approach"] >= start]
    return [mark for mark in special_points(document, name) if met and mark["position"] >= min(met)]


def unmet(pairs, side):
    """The index from which on the pairs have a member of this side alone."""
    first = len(pairs)
    while first and not pairs[first - 1][1 - side]:
        first -= 1
    return first


def falls(document):
    """Whether the approach falls at the end of a trace: a search by effort may end behind a maximum of the approach."""
    last = max(document["folds"], key=lambda mark: mark["position"], default={"kind": None})
    return (document.get("ended") or {}).get("why") == "searched" and last["kind"] == "jump_in"


def met_by_both(lists, documents):
    """The lists of pairs without the special points at their ends that one trace met beyond the end of the other. Among
    the points that remain at the end of the lists, the first one beyond the end of the other trace, in the direction in
    which its approach changes there, and all later ones of any kind, are those that the other trace has not met."""
    for side in (0, 1):
        rest = [(pairs, unmet(pairs, side)) for pairs in lists]
        other = documents[1 - side]
        ahead = -1.0 if falls(other) else 1.0
        beyond = min((pair[side]["position"] for pairs, first in rest for pair in pairs[first:]
                      if ahead * pair[side]["approach"] > ahead * value(other, "end")), default=math.inf)
        lists = [pairs[:first] + [pair for pair in pairs[first:] if pair[side]["position"] < beyond]
                 for pairs, first in rest]
    return lists


def common(loose, tight):
    """Pairs of folds, and of extrema, on the part of the branch that both traces cover; None stands for a missing
    one."""
    lists = [align(after(loose, name, value(tight, "start")), after(tight, name, value(loose, "start")))
             for name in ("folds", "extrema")]
    return met_by_both(lists, (loose, tight))


def distance(one, other):
    if one["kind"] != other["kind"]:
        return math.inf
    return math.hypot(one["approach"] - other["approach"], one["shown"] - other["shown"])


def align(ours, theirs):
    """Pairs (one, other) in order, with the least sum of distances. None stands for a missing point; a point without a
    partner counts APART."""
    if len(ours) == len(theirs) and all(distance(*pair) < APART for pair in zip(ours, theirs)):
        return list(zip(ours, theirs))
    rows, columns = len(ours), len(theirs)
    cost = [[APART * (i + j) if not i or not j else math.inf for j in range(columns + 1)] for i in range(rows + 1)]
    for i in range(1, rows + 1):
        for j in range(1, columns + 1):
            cost[i][j] = min(cost[i - 1][j - 1] + distance(ours[i - 1], theirs[j - 1]),
                             cost[i - 1][j] + APART, cost[i][j - 1] + APART)
    pairs, i, j = [], rows, columns
    while i or j:
        if i and j and cost[i][j] == cost[i - 1][j - 1] + distance(ours[i - 1], theirs[j - 1]):
            i, j = i - 1, j - 1
            pairs.append((ours[i], theirs[j]))
        elif i and cost[i][j] == cost[i - 1][j] + APART:
            i -= 1
            pairs.append((ours[i], None))
        else:
            j -= 1
            pairs.append((None, theirs[j]))
    return pairs[::-1]


def radius_difference(ours, theirs, comparison):
    """The difference of two contact radii. If a crest is at the threshold of contact within the error, a solution
    states both radii, and either may be correct."""
    radii = [value(ours, "contact_radius")]
    if ours.get("contact_radius_other") is not None:
        radii.append(value(ours, "contact_radius_other"))
        comparison.undecided = True
    truths = [value(theirs, "contact_radius")]
    if theirs.get("contact_radius_other") is not None:
        truths.append(value(theirs, "contact_radius_other"))
    return min(abs(a - b) for a in radii for b in truths)


def add(comparison, quantity, where, stated, difference, own, size):
    own = (0.0 if math.isnan(own) else own) + ROUNDING * abs(size)
    comparison.findings.append(Finding(quantity, where, stated, difference, own))


def add_radius(comparison, quantity, where, ours, theirs):
    """Compares the contact radii, unless neither solution has a contact."""
    difference = radius_difference(ours, theirs, comparison)
    if difference or ours["contact_radius"]:
        add(comparison, quantity, where, value(ours, "contact_radius_error_estimate"), difference,
            value(theirs, "contact_radius_error_estimate"), theirs["contact_radius"])


def add_pairs(comparison, name, pairs):
    """Approach, load and contact radius of folds or extrema."""
    for ours, theirs in pairs:
        if not ours or not theirs:
            continue
        where = f" ({ours['kind']} at approach {ours['approach']:.7g}, load {ours['load']:.7g})"
        for quantity, key, error in (("approach", "approach", "error_estimate"),
                                     ("load", "load", "load_error_estimate")):
            add(comparison, f"{name} {quantity}", where, value(ours, error), abs(ours[key] - theirs[key]),
                value(theirs, error), theirs[key])
        add_radius(comparison, f"{name} contact radius", where, ours, theirs)


def text_of(mark):
    return f"{mark['kind']} at approach {mark['approach']:.7g}, load {mark['load']:.7g}"


def add_unpaired(comparison, loose, name, pairs):
    """Folds and extrema appear in pairs. If the two members of a pair differ by less than the largest stated error of
    such a number, the branch cannot be distinguished from one without them."""
    key, error = ("approach", "error_estimate") if name == "fold" else ("load", "load_error_estimate")
    stated = [value(mark, error) for mark in loose["folds"] + loose["extrema"]]
    visible = max((e for e in stated if not math.isnan(e)), default=0.0)
    for side, found in ((0, comparison.added), (1, comparison.missing)):
        alone = [pair[side] for pair in pairs if not pair[1 - side]]
        while alone:
            mark = alone.pop(0)
            partner = alone[0] if alone and alone[0]["kind"] != mark["kind"] else None
            if partner:
                alone.pop(0)
            if partner and abs(partner[key] - mark[key]) <= visible:
                comparison.faint += 2
            else:
                found.extend(text_of(one) for one in (mark, partner) if one)


def deepest(marks):
    return min((mark for mark in marks if mark["kind"] == "minimum"), key=lambda mark: mark["load"], default=None)


def errors_of(document, mark):
    """The pull-off with its stated errors if it is at this minimum, otherwise the minimum: name -> number."""
    best = document["pull_off"]
    if best["approach"] == mark["approach"] and -best["force"] == mark["load"]:
        return dict(mark, load_error=value(best, "error_estimate"),
                    approach_error=value(best, "approach_error_estimate"),
                    contact_radius=best["contact_radius"], contact_radius_other=best.get("contact_radius_other"),
                    contact_radius_error_estimate=best.get("contact_radius_error_estimate"))
    return dict(mark, load_error=value(mark, "load_error_estimate"), approach_error=value(mark, "error_estimate"))


def add_pull_off(comparison, loose, tight, pairs):
    """Compares the deepest minimum on the part of the branch that both traces cover. Its approach and contact radius
    are compared with the same minimum of the tight solution, even if another one is as deep within the errors."""
    ours = deepest(mine for mine, _ in pairs if mine)
    theirs = deepest(other for _, other in pairs if other)
    if not ours or not theirs:
        return
    comparison.beyond = (loose["pull_off"]["force"] > -ours["load"] or tight["pull_off"]["force"] > -theirs["load"])
    partner = next(other for mine, other in pairs if mine is ours)
    ours, best = errors_of(loose, ours), errors_of(tight, theirs)
    where = f" (at approach {ours['approach']:.7g})"
    add(comparison, "force", where, ours["load_error"], abs(ours["load"] - best["load"]), best["load_error"],
        best["load"])
    if comparison.findings[-1].verdict == "violated":
        return
    if partner and partner is not theirs:
        comparison.tie = True
        best = errors_of(tight, partner)
    add(comparison, "approach", where, ours["approach_error"], abs(ours["approach"] - best["approach"]),
        best["approach_error"], best["approach"])
    add_radius(comparison, "contact radius", where, ours, best)


def compare(loose, tight):
    """Compares two documents of `pulloff solve --json` with status ok and a pull-off."""
    comparison = Comparison()
    counts = []
    lists = common(loose, tight)
    for name, key, pairs in (("fold", "folds", lists[0]), ("extremum", "extrema", lists[1])):
        met = [sum(1 for pair in pairs if pair[side]) for side in (0, 1)]
        counts.append(met[0] < len(loose[key]) or met[1] < len(tight[key]))
        add_pairs(comparison, name, pairs)
        add_unpaired(comparison, loose, name, pairs)
        if key == "extrema":
            add_pull_off(comparison, loose, tight, pairs)
    comparison.ended_apart = any(counts)
    return comparison
