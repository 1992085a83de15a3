"""Tests whether a claim can fail: the verdict must change when a source number changes by a given amount.

Each source is changed separately, upwards and downwards: it is multiplied and divided by 1 plus the amount, a list as a
whole and each of its items. A count changes by one, or by the integer part of the amount. The claim states the amount
(off_by), or it is derived from the accuracy or the interval.
"""

import math

import formula
import judge

LARGEST_DERIVED = 0.101  # a claim that holds and needs a larger change must state the amount and its reason
MARGIN = 1.5           # the derived change relative to the one that reaches the end of the accepted interval
STEPS = tuple(2 ** (-place / 2) for place in range(14))
MOST_ITEMS = 1000      # longer lists are only changed as a whole


def derived(part):
    """The relative change that must change the verdict, from the accuracy, the interval or the difference; absolute for a count."""
    low, high, computed, accuracy = (part[key] for key in ("low", "high", "computed", "accuracy"))
    if judge.side(computed, low, high, accuracy):
        distance = abs(part["difference"])
        if part["counted"]:
            return distance
    elif low == high:
        distance = 2 * accuracy
    else:
        distance = accuracy + min(abs(computed - end) for end in (low, high) if math.isfinite(end))
    scale = min((abs(number) for number in (computed, low, high) if number and math.isfinite(number)), default=0)
    return MARGIN * distance / scale if scale else math.inf


def is_count(source):
    """Whether a source is a count, such as `folds.#`."""
    return source.get("count", source.get("at", "").endswith("#"))


def moved(got, move):
    """The value changed as a whole; for a list, then each item separately."""
    if not isinstance(got, list):
        yield move(got)
        return
    yield [move(item) for item in got]
    for place in range(len(got) if 1 < len(got) <= MOST_ITEMS else 0):
        yield got[:place] + [move(got[place])] + got[place + 1:]


def moves(source, got, amount):
    """All changed values of a source: upwards and downwards, by the amount and by fractions of it."""
    if is_count(source):
        for step in range(1, max(1, math.floor(amount)) + 1):
            yield from moved(got, lambda item, step=step: item + step)
            yield from moved(got, lambda item, step=step: item - step)
        return
    for step in STEPS:
        yield from moved(got, lambda item, step=step: item * (1 + amount * step))
        yield from moved(got, lambda item, step=step: item / (1 + amount * step))


def unmoved(choice, values, amount, limits, accuracy):
    """The names of the sources whose change by the amount does not change the verdict."""
    def side(changed):
        low, high = limits(changed)
        return judge.side(formula.evaluate(choice["value"], changed), low, high, accuracy)

    def changes(name):
        for value in moves(choice["get"][name], values[name], amount):
            try:
                if side({**values, name: value}) != here:
                    return True
            except formula.FormulaError:
                continue
        return False

    if not math.isfinite(amount):
        return list(choice["get"])
    here = side(values)
    return [name for name in choice["get"] if not changes(name)]
