"""The notation of the report: numbers, symbols, names of quantities and verdicts."""

import math
import os
import re

from markupsafe import Markup

MINUS = "\u2212"
THIN = "\u202f"  # narrow no-break space

# Scene keys -> symbols of the paper.
SYMBOLS = {"tabor": "μ", "nodes": "N", "amplitude": "A†", "wavelength": "λ†", "radius": "R†",
           "outer_radius": "r†max", "coupling": "w/(E*ε)", "approach_start": "from Δ†", "approach_end": "to Δ†"}

SPELLED = ("law", "profile", "profile_file")  # keys whose value is a name with parameters

QUANTITIES = {
    "pull_off_force": "Pull-off force |W̄|",
    "pull_off_approach": "Approach at pull-off Δ†",
    "contact_radius": "Contact radius at pull-off, in ε",
    "residual": "Residual of the discrete equations",
    "moved_force": "Change of the pull-off force when inputs change by their last bit, relative to the error estimates",
    "energy_defect": "Energy gained minus work done, relative to the range of the energy",
    "reverse_trace": "Folds of the reverse trace, difference relative to the error estimates",
    "fold_count": "Number of folds",
    "fold_approach": "Approach at a fold Δ†",
    "fold_load": "Load at a fold W̄",
    "extremum_count": "Number of extrema of the load",
    "extremum_approach": "Approach at an extremum of the load Δ†",
    "extremum_load": "Load at an extremum W̄",
    "hysteresis_force": "Largest tension in unloading |W̄|",
    "hysteresis_approach": "Approach at the largest tension in unloading Δ†",
    "hysteresis_loss": "Energy lost in loading and unloading, in πwRε",
    "jump_count": "Number of jumps in loading and unloading",
    "jump_approach": "Approach at a jump Δ†",
    "jump_load_before": "Load before a jump W̄",
    "jump_load_after": "Load after a jump W̄",
    "jump_energy_lost": "Energy lost in a jump, in πwRε",
    "curve": "Loading curve, distance along its normal",
}

VERDICT_WORDS = {"within": "within", "outside": "outside", "no_result": "no result", "missing_reference": "no reference",
                 "slack": "slack", "not_reachable": "not reachable", "failed": "failed"}
VERDICT_SIGNS = {"within": "✓", "outside": "✗", "no_result": "∅", "missing_reference": "?", "slack": "✓", "not_reachable": "–", "failed": "∅"}
VERDICT_MEANINGS = {
    "slack": "within the tolerance, which is more than a thousand times the largest error"}
CLAIM_VERDICTS = {"reproduced": "reproduced", "within_reading": "reproduced within reading accuracy",
                  "depends": "dependent on a choice that the paper leaves open", "contradicted": "contradicted",
                  "not_testable": "not testable", "no_result": "no result"}
# Comparisons of two results of this project, which say nothing about the paper.
CHECK_VERDICTS = {"checked": "implementation check passed", "check_failed": "implementation check failed"}
# Verdicts on a sentence of the abstract or the conclusions: sign and words.
SENTENCE_VERDICTS = {"robust": ("✓", "holds"), "as_read": ("≈", "holds as read"), "in_part": ("◐", "holds in part"),
                     "fails": ("✗", "does not hold"), "untested": ("–", "not tested")}
CHOICE_WORDS = {"reproduced": "holds", "within_reading": "holds within reading accuracy", "contradicted": "does not hold",
                "no_result": "no result"}
CLAIM_SIGNS = {"reproduced": "✓", "within_reading": "≈", "depends": "◐", "contradicted": "✗", "not_testable": "–",
               "no_result": "∅", "checked": "=", "check_failed": "≠"}
LEDGERS = {"oracle": "an exact or highly accurate value from an independent computation",
           "published": "a published value with its uncertainty"}


def printable(text):
    """A text with a space for each control character that XML cannot contain."""
    return re.sub("[\0-\x08\x0b-\x1f\x7f\ufffe\uffff]", " ", text)


def signed(text):
    """A number with its hyphens replaced by minus signs."""
    return text.replace("-", MINUS)


def plain(value):
    """A number with up to 12 digits; other values as text."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        return "∞" if value == math.inf else signed(f"{value:.12g}")
    return str(value)


def decimals_for(tolerance):
    """Decimals that show two digits of the tolerance; None without a usable tolerance."""
    if not tolerance or not math.isfinite(tolerance) or tolerance <= 0:
        return None
    return min(max(1 - math.floor(math.log10(tolerance)), 0), 14)


def fixed(value, decimals):
    """A number with this many decimals; in scientific notation if their number is unknown or too small."""
    if value is None or not isinstance(value, (int, float)):
        return plain(value)
    if decimals is None or (value != 0 and abs(value) < 10.0 ** -decimals):
        return scientific(value, 3)
    return signed(f"{value:.{decimals}f}")


def scientific(value, digits=2):
    """A number as 1.2 × 10⁻⁵ in HTML; as a decimal fraction if the exponent is small."""
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
    """An error relative to its tolerance, with few digits."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    return scientific(value, 2) if value < 0.001 else signed(f"{value:.3g}")


def seconds(value):
    """A duration with three digits, or in minutes and seconds."""
    if value is None:
        return "–"
    if value < 0.0995:
        return f"{1000 * value:.3g} ms"
    if value < 100:
        return f"{value:.3g} s"
    minutes = int(value // 60)
    return f"{minutes} min {value - 60 * minutes:.0f} s"


def date(text):
    """2026-01-02T10:00:00Z as 2026-01-02 10:00 UTC; other text unchanged."""
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
    unused = {"nodes", "grading"} if value_of(point, "scheme") == "panel" else {"tolerance"}
    if sweep.get("amplitude") == 0:
        unused |= {"wavelength"} | ({"amplitude"} if "wavelength" in sweep else set())
    parts = []
    for key, value in sweep.items():
        if value is None or key in unused or key == "tabor" and "coupling" in sweep or value == "table":
            continue   # not used, or said by another key
        if key in SPELLED:
            parts.append(spelled(point, key))
        elif value == "inf":
            parts.append(f"{symbol(key)} = ∞")
        elif isinstance(value, str):
            parts.append(value)
        else:
            parts.append(f"{symbol(key)} = {plain(value)}")
    return ", ".join(parts) or point["label"]


def spelled(point, key):
    """A law, a profile or its file with their parameters: "mie (4, 10)", "cone (0.3)", "cone.csv"."""
    scene = point["input"]
    name = scene[key]
    if key == "profile_file":
        return os.path.basename(name)
    parameters = [plain(value) for parameter, value in scene.items()
                  if parameter.startswith(f"{name}_") and value is not None and parameter != "table_scale"]
    return f"{name} ({', '.join(parameters)})" if parameters else name


def value_of(point, key):
    """The value of a key in the sweep of a point, or in its scene."""
    if key in point["sweep"]:
        return point["sweep"][key]
    return (point.get("input") or {}).get(key)


def count(number, singular, plural=None):
    return f"{number} {singular if number == 1 else plural or singular + 's'}"


def lower_first(text):
    """The text with a small first letter, to be used within a sentence."""
    return text[:1].lower() + text[1:]


def listing(items):
    """a, b and c: HTML, in which plain texts are escaped, if one of them is HTML; otherwise a plain text."""
    items = list(items)
    kind = Markup if any(isinstance(item, Markup) for item in items) else str
    return kind(" and ").join([kind(", ").join(items[:-1]), items[-1]] if len(items) > 1 else items)
