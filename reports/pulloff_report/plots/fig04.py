"""Figure 4: pull-off force and approach at pull-off of a smooth sphere against the Tabor parameter."""

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import MINUS, plain, scientific, value_of
from .figure import Figure, checks_of, failures, log_range, tolerance_of

NUMBER = "4"
TITLE = "Pull-off of a smooth sphere against the Tabor parameter"
PANELS = (("pull_off_force", "force", 1.0, "force"),
          ("pull_off_approach", "approach", -1.0, "approach"))
PULL_OFF = "feng_pull_off.csv"
PUBLISHED = "published/feng_fig4.csv"   # Feng's own points, when somebody has digitised them


def rows_of(references, name, field, sign):
    """(μ, value) of a table of pull-offs, in order; none while the file is absent."""
    table = references.table(name)
    return [] if table is None else sorted(
        zip(table.numbers("tabor").tolist(), (sign * table.numbers(field)).tolist()))


def panel(case, references, quantity, field, sign):
    """Computed and reference rows (μ, value), residual rows (μ, |difference|, uncertainty)."""
    computed, residuals, tolerances = [], [], []
    reference = rows_of(references, PULL_OFF, field, sign)
    for point in sorted(case.points, key=lambda item: value_of(item, "tabor") or 0):
        tabor = value_of(point, "tabor")
        if tabor is None or not point.get("pull_off"):
            continue
        computed.append((tabor, sign * point["pull_off"][field]))
        for check in checks_of(case, point, quantity)[:1]:
            if check["error"] is not None:
                residuals.append((tabor, max(abs(check["error"]), 1e-16)))
            tolerances.append((tabor, tolerance_of(check)))
    return computed, reference, residuals, tolerances


def tolerance_rows(tolerances):
    return [(tabor, value) for tabor, value in tolerances if value]


def make(case, references):
    data, parameters, said = {}, {}, []
    for quantity, field, sign, name in PANELS:
        computed, reference, residuals, tolerances = panel(case, references, quantity, field, sign)
        limit = tolerance_rows(tolerances)
        crosses = rows_of(references, PUBLISHED, field, sign)
        data[name] = [computed, reference, residuals, limit, crosses]
        low, high = log_range([row[1] for row in residuals + limit])
        parameters.update({f"{name}_low": low, f"{name}_high": high,
                           f"{name}_reference": len(reference), f"{name}_limits": len(limit),
                           f"{name}_crosses": len(crosses),
                           f"{name}_tolerance": limit[0][1] if limit else 0.0})
        if residuals:
            tabor, worst = max(residuals, key=lambda row: row[1])
            said.append((name, tabor, worst))
    drawn = gnuplot.draw("fig04", parameters, data)
    label = "Pull-off force and minus the approach at pull-off against the Tabor parameter"
    return Figure("fig04", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig04", label)),
                  caption(data, said), remarks(case, references), case.record["command"])


def caption(data, said):
    text = Markup("(a) Pull-off force |W̄| and (b) approach {}Δ† at pull-off against the Tabor "
                  "parameter μ. Red squares: this program.").format(MINUS)
    if data["force"][1]:
        text += Markup(" Blue asterisks: Feng’s problem solved independently (see the note on "
                       "Feng’s points).")
    if data["force"][4]:
        text += Markup(" Crosses: Feng’s own points, read off a figure.")
    if said:
        parts = [Markup("{} for the {} (μ = {})").format(scientific(worst), name, plain(tabor))
                 for name, tabor, worst in said]
        text += Markup(" Strips: magnitude of the difference; at most {}.").format(
            Markup(" and ").join(parts))
    return text


def remarks(case, references):
    told = failures(case)
    if not references.has(PULL_OFF):
        told.append(f"The reference values ({PULL_OFF}) are absent, so no asterisks are shown.")
    return told
