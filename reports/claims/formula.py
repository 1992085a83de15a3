"""Evaluates the formulas of the list of claims: arithmetic on named numbers and lists, no other Python."""

import ast
import math
import operator

import scipy.interpolate
import scipy.special

OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
             ast.Pow: operator.pow, ast.USub: operator.neg}


def pick(values, where, low, high):
    """The values whose place lies between low and high."""
    return [value for value, place in zip(values, where, strict=True) if low <= place <= high]


def where(extreme, values, places):
    """The place of the largest (max) or smallest (min) of the values."""
    return extreme(zip(values, places, strict=True))[1]


def through(values, places):
    """The cubic spline through values at places, in ascending order of the places."""
    places, values = zip(*sorted(dict(zip(places, values, strict=True)).items()))
    return scipy.interpolate.CubicSpline(places, values)


def located(extreme, values, places, low, high):
    """(value, place) of the largest (max) or smallest (min) value between two places, those included, of the cubic spline
    through the values. Beyond the first and the last place there are no values."""
    curve = through(values, places)
    low, high = max(low, curve.x[0]), min(high, curve.x[-1])
    if low > high:
        raise ValueError("there are no values between the two places")
    stationary = curve.derivative().roots(extrapolate=False)
    return extreme((float(curve(place)), float(place)) for place in [low, high, *(at for at in stationary if low < at < high)])


def ratios(above, below):
    """The elements of one list divided by those of another."""
    return [a / b for a, b in zip(above, below, strict=True)]


def differences(above, below):
    """The elements of one list minus those of another."""
    return [a - b for a, b in zip(above, below, strict=True)]


def greatest_at(values, places):
    """The largest value at each place, in ascending order of the places."""
    found = {}
    for value, place in zip(values, places, strict=True):
        found[place] = max(value, found.get(place, value))
    return [found[place] for place in sorted(found)]


def worst(values, expected):
    """The value that is farthest from the expected one."""
    return max(values, key=lambda value: abs(value - expected))


def farthest(x, y, line_x, line_y, width, height):
    """The largest distance of a point (x, y) from a polyline, in a figure of this width and height."""
    def apart(here, begin, end):
        step = [b - a for a, b in zip(begin, end)]
        length = sum(part * part for part in step)
        way = sum((a - b) * part for a, b, part in zip(here, begin, step)) / length if length else 0
        return math.hypot(*(a - b - min(max(way, 0), 1) * part for a, b, part in zip(here, begin, step)))

    points, line = ([(a / width, b / height) for a, b in zip(*pair, strict=True)] for pair in ((x, y), (line_x, line_y)))
    return max(min(apart(point, *ends) for ends in zip(line, line[1:])) for point in points)


def crossing(x, y, level):
    """The first x at which y rises to the level, by linear interpolation."""
    for before, after in zip(range(len(x) - 1), range(1, len(x))):
        if y[before] < level <= y[after]:
            return x[before] + (x[after] - x[before]) * (level - y[before]) / (y[after] - y[before])
    raise ValueError("the level is not crossed")


# The elliptic integrals have the modulus as argument, as in the paper; H is the Struve function.
FUNCTIONS = {"sqrt": math.sqrt, "cos": math.cos, "sin": math.sin, "log10": math.log10,
             "max": max, "min": min,
             "worst": worst, "farthest": farthest, "pick": pick, "ratios": ratios,
             "differences": differences, "scaled": lambda values, factor: [value * factor for value in values],
             "greatest_at": greatest_at, "distinct": lambda values: sorted(set(values)), "crossing": crossing,
             "highest": lambda *given: located(max, *given)[0], "lowest": lambda *given: located(min, *given)[0],
             "place_of_lowest": lambda *given: located(min, *given)[1], "logs": lambda values: [math.log10(value) for value in values],
             "below": lambda values, level: sum(value < level for value in values),
             "where_greatest": lambda values, places: where(max, values, places),
             "where_least": lambda values, places: where(min, values, places),
             "last": lambda values, *number: values[-number[0]:] if number else values[-1], "first": lambda values: values[0],
             "joined": lambda begin, values: [begin, *values], "total": math.fsum,
             "K": lambda k: float(scipy.special.ellipk(k * k)), "E": lambda k: float(scipy.special.ellipe(k * k)),
             "sum": None, "least": None,  # sum(j, first, last, term of j): see evaluate
             "H": lambda order, x: float(scipy.special.struve(order, x))}
CONSTANTS = {"pi": math.pi}
OVER = {"sum": math.fsum, "least": min}  # over the terms for all integers from the first to the last


class FormulaError(Exception):
    """An error in a formula, described in one line."""


def parse(text):
    """The syntax tree of a formula. Raises a FormulaError for an unknown element."""
    try:
        tree = ast.parse(text, mode="eval").body
    except SyntaxError as error:
        raise FormulaError(f"{text!r}: {error.msg}") from error
    check(tree, text)
    return tree


def check(tree, text):
    if isinstance(tree, ast.Constant) and type(tree.value) in (int, float) or isinstance(tree, ast.Name):
        return
    if isinstance(tree, (ast.BinOp, ast.UnaryOp)) and type(tree.op) in OPERATORS:
        parts = [tree.left, tree.right] if isinstance(tree, ast.BinOp) else [tree.operand]
    elif isinstance(tree, ast.Call) and isinstance(tree.func, ast.Name) and tree.func.id in FUNCTIONS and not tree.keywords:
        parts = tree.args
        if tree.func.id in OVER and not (len(parts) == 4 and isinstance(parts[0], ast.Name)):
            raise FormulaError(f"{text!r}: expected {tree.func.id}(name, first, last, term)")
    else:
        raise FormulaError(f"{text!r}: {ast.unparse(tree)} is neither a number, a name, arithmetic nor one of "
                           + ", ".join(FUNCTIONS))
    for part in parts:
        check(part, text)


def names(text):
    """The names in a formula, except constants and functions."""
    tree = parse(text)
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    called = {id(node.func) for node in calls}
    counters = {node.args[0].id for node in calls if node.func.id in OVER}
    return {node.id for node in ast.walk(tree)
            if isinstance(node, ast.Name) and id(node) not in called} - counters - set(CONSTANTS)


def evaluate(text, values):
    """The value of a formula. Raises a FormulaError if it has none, for instance after a division by zero."""
    known = {**CONSTANTS, **values}

    def over(gather, name, first, last, term):
        terms = []
        for place in range(round(number(first)), round(number(last)) + 1):
            known[name.id] = place
            terms.append(number(term))
        return gather(terms)

    def number(tree):
        if isinstance(tree, ast.Constant):
            return tree.value
        if isinstance(tree, ast.Name):
            return known[tree.id]
        if isinstance(tree, ast.BinOp):
            return OPERATORS[type(tree.op)](number(tree.left), number(tree.right))
        if isinstance(tree, ast.UnaryOp):
            return OPERATORS[type(tree.op)](number(tree.operand))
        if tree.func.id in OVER:
            return over(OVER[tree.func.id], *tree.args)
        return FUNCTIONS[tree.func.id](*map(number, tree.args))

    try:
        found = float(number(parse(text)))
    except KeyError as error:
        raise FormulaError(f"{text!r}: {error.args[0]} is not known") from error
    except (TypeError, ValueError, ArithmeticError, IndexError) as error:
        raise FormulaError(f"{text!r}: {error}") from error
    if not math.isfinite(found):
        raise FormulaError(f"{text!r}: not a finite number")
    return found
