"""Numbers, symbols and names as the report writes them."""

import math
import re

from markupsafe import Markup

MINUS = "\u2212"
THIN = "\u202f"  # narrow, and no line breaks at it

# Swept and scene keys -> the paper's letters.
SYMBOLS = {"tabor": "μ", "nodes": "N", "amplitude": "A†", "wavelength": "λ†", "radius": "R†",
           "outer_radius": "r†max", "approach_start": "from Δ†", "approach_end": "to Δ†"}

QUANTITIES = {
    "pull_off_force": "Pull-off force |W̄|",
    "pull_off_approach": "Approach at pull-off Δ†",
    "contact_radius": "Contact radius at pull-off, in ε",
    "residual": "Residual of the discrete equations",
    "moved_force": "Pull-off force when inputs move by a last bit, relative change",
    "energy_defect": "Energy gained less work done, over the range of the energy",
    "reverse_trace": "Folds on the way back, difference over the error estimates",
    "fold_count": "Number of folds",
    "fold_approach": "Approach at a fold Δ†",
    "fold_load": "Load at a fold W̄",
    "extremum_count": "Number of extrema of the load",
    "extremum_approach": "Approach at an extremum of the load Δ†",
    "extremum_load": "Load at its extremum W̄",
    "hysteresis_force": "Greatest tension met in unloading |W̄|",
    "hysteresis_approach": "Approach at the greatest tension met in unloading Δ†",
    "hysteresis_loss": "Energy lost in loading and unloading, in πwRε",
    "jump_count": "Number of jumps in loading and unloading",
    "jump_approach": "Approach at a jump Δ†",
    "jump_load_before": "Load before a jump W̄",
    "jump_load_after": "Load after a jump W̄",
    "jump_energy_lost": "Energy lost in a jump, in πwRε",
    "curve": "Loading curve, distance normal to the curve",
    "work_points": "Work: equilibria",
    "work_newton_iterations": "Work: Newton iterations",
    "work_factorizations": "Work: factorisations",
    "work_kernel_evaluations": "Work: evaluations of the kernel",
    "work_nodes": "Work: nodes",
}

VERDICT_WORDS = {"within": "within", "outside": "outside", "no_result": "no result",
                 "missing_reference": "no reference", "improved": "improved",
                 "regressed": "regressed", "moved": "moved", "wrong_and_frozen": "wrong and frozen",
                 "slack": "slack", "failed": "failed"}
VERDICT_SIGNS = {"within": "✓", "outside": "✗", "no_result": "∅", "missing_reference": "?",
                 "improved": "✓", "regressed": "✗", "moved": "✗", "wrong_and_frozen": "✗",
                 "slack": "✓", "failed": "∅"}
VERDICT_MEANINGS = {
    "improved": "the pin moved towards every oracle, or there is less work: to be blessed",
    "regressed": "the pin moved away from an oracle, or there is more work",
    "moved": "the pin moved, and no oracle says whether for the better",
    "wrong_and_frozen": "the oracle fails while the pin holds",
    "slack": "within, but the tolerance is over a thousand times the largest error it met"}
CLAIM_VERDICTS = {"reproduced": "reproduced", "within_reading": "reproduced within reading accuracy",
                  "depends": "dependent on a choice that the paper leaves open", "contradicted": "contradicted",
                  "not_testable": "not testable", "no_result": "no result"}
# Comparisons that say nothing of the paper: both sides of them are this project's.
CHECK_VERDICTS = {"checked": "implementation check passed", "check_failed": "implementation check failed"}
CHOICE_WORDS = {"reproduced": "holds", "within_reading": "holds within reading accuracy", "contradicted": "does not hold",
                "no_result": "no result"}
CLAIM_SIGNS = {"reproduced": "✓", "within_reading": "≈", "depends": "◐", "contradicted": "✗", "not_testable": "–",
               "no_result": "∅", "checked": "=", "check_failed": "≠"}
LEDGERS = {"oracle": "exact or many digits, by an independent route",
           "published": "published value, with its uncertainty",
           "pin": "this program's own last accepted value, to notice change"}


def signed(text):
    """A hyphen at the front of a number made a minus sign."""
    return text.replace("-", MINUS)


def plain(value):
    """A number as short as it reads back, in words for what is no number."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        return "∞" if value == math.inf else signed(f"{value:.12g}")
    return str(value)


def decimals_for(tolerance):
    """Decimals that show two digits of the tolerance; None when it tells nothing."""
    if not tolerance or not math.isfinite(tolerance) or tolerance <= 0:
        return None
    return min(max(1 - math.floor(math.log10(tolerance)), 0), 14)


def fixed(value, decimals):
    """A number with so many decimals, or in short when their number is unknown."""
    if value is None or not isinstance(value, (int, float)):
        return plain(value)
    if decimals is None or (value != 0 and abs(value) < 10.0 ** -decimals):
        return scientific(value, 3)
    return signed(f"{value:.{decimals}f}")


def scientific(value, digits=2):
    """1.2 × 10⁻⁵ as HTML; small exponents are written out."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return plain(value)
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    if -3 < int(exponent) < 4:
        return signed(f"{value:.{max(digits - 1 - int(exponent), 0)}f}")
    return Markup(f"{signed(mantissa)}{THIN}×{THIN}10<sup>{signed(str(int(exponent)))}</sup>")


def ratio(value):
    """An error in units of its tolerance: few digits, since only its size matters."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    return scientific(value, 2) if value < 0.001 else signed(f"{value:.3g}")


def seconds(value):
    """A duration with the digits one cares for."""
    if value is None:
        return "–"
    if value < 0.0995:
        return f"{1000 * value:.3g} ms"
    if value < 100:
        return f"{value:.3g} s"
    minutes = int(value // 60)
    return f"{minutes} min {value - 60 * minutes:.0f} s"


def date(text):
    """2026-01-02T10:00:00Z in a reader's spelling; anything else as it is."""
    found = re.fullmatch(r"(\d{4}-\d\d-\d\d)T(\d\d:\d\d)(:\d\d)?Z", text)
    return f"{found.group(1)} {found.group(2)} UTC" if found else text


def symbol(key):
    return SYMBOLS.get(key, key.replace("_", " "))


def quantity(name):
    return QUANTITIES.get(name, name.replace("_", " ").capitalize())


def sweep_label(point):
    """"μ = 1, N = 500" from the swept values of a point, or its own label when it sweeps nothing."""
    if point is None:
        return "whole case"
    sweep = point["sweep"]
    if not sweep:
        return point["label"] or "single point"
    parts = []
    for key, value in sweep.items():
        if isinstance(value, str):
            parts.append(value)
        else:
            parts.append(f"{symbol(key)} = {plain(value)}")
    return ", ".join(parts)


def value_of(point, key):
    """A swept value of a point, or that of its scene."""
    if key in point["sweep"]:
        return point["sweep"][key]
    return (point.get("input") or {}).get(key)


def count(number, singular, plural=None):
    return f"{number} {singular if number == 1 else plural or singular + 's'}"


def listing(items):
    """a, b and c"""
    items = list(items)
    return " and ".join([", ".join(items[:-1]), items[-1]] if len(items) > 1 else items)
