"""Whether a claim can fail: the numbers it was judged by are moved, and the answer must change.

Every source is moved by itself, up and down: multiplied and divided by 1 plus the amount, a list as a whole and each of
its items alone; a count is moved by one, or by the whole part of the amount. The amount is stated by the claim (off_by) or
derived from its accuracy or interval."""

import math

import formula
import judge

LARGEST_DERIVED = 0.101  # a claim that holds and would need a larger move has to state it, with its reason
MARGIN = 1.5           # the derived move goes so much farther than to the end of what passes
STEPS = tuple(2 ** (-place / 2) for place in range(14))
MOST_ITEMS = 1000      # longer lists are moved as a whole only


def derived(part):
    """The relative move that must change the answer: from the accuracy, the interval, or the difference; in units for a count."""
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
    """Whether a source counts, as `folds.#` does."""
    return source.get("count", source.get("at", "").endswith("#"))


def moved(got, move):
    """What was got, moved as a whole; then, of a list, each item alone."""
    if not isinstance(got, list):
        yield move(got)
        return
    yield [move(item) for item in got]
    for place in range(len(got) if 1 < len(got) <= MOST_ITEMS else 0):
        yield got[:place] + [move(got[place])] + got[place + 1:]


def moves(source, got, amount):
    """Every value that a source is moved to: up and down, by the amount and by parts of it."""
    if is_count(source):
        for step in range(1, max(1, math.floor(amount)) + 1):
            yield from moved(got, lambda item, step=step: item + step)
            yield from moved(got, lambda item, step=step: item - step)
        return
    for step in STEPS:
        yield from moved(got, lambda item, step=step: item * (1 + amount * step))
        yield from moved(got, lambda item, step=step: item / (1 + amount * step))


def unmoved(choice, values, amount, limits, accuracy):
    """The names of the sources that can be off by the amount without any change of the answer."""
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
