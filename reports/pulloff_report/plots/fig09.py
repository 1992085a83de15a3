"""Figure 9: gap and traction against the radius at pull-off."""

from markupsafe import Markup

from .. import gnuplot, svg
from ..words import listing, plain, value_of
from .figure import BLACK, BLUE, GREEN, VERMILLION, Figure, failures

NUMBER = "9"
TITLE = "Gap and traction at pull-off"

# Tabor parameter, amplitude, colour and dashes of the scenes the paper shows.
SHOWN = [(0.15, 1.0, BLACK, 1), (0.67, 1.0, BLUE, 3), (5.0, 1.0, VERMILLION, 4), (5.0, 10.0, GREEN, 2)]
RADII = (0.0, 65.0)          # range of r/ε
GAPS = (-1.0, 22.0)          # range of H


def point_of(case, tabor, amplitude):
    for point in case.points:
        if (value_of(point, "tabor"), value_of(point, "amplitude")) == (tabor, amplitude):
            return point if point.get("profile") else None
    return None


def make(case, references):
    del references
    gaps, tractions, labels, colours, dashes, said = [], [], [], [], [], []
    for tabor, amplitude, colour, dash in SHOWN:
        point = point_of(case, tabor, amplitude)
        if point is None:
            continue
        table = case.profile(point)
        radius = table.numbers("radius")
        gaps.append([(float(a), float(b)) for a, b in zip(radius, table.numbers("gap"))])
        tractions.append([(float(a), float(b)) for a, b in zip(radius, table.numbers("traction"))])
        labels.append(f"μ = {plain(tabor)}, A† = {plain(amplitude)}")
        colours.append(colour)
        dashes.append(dash)
        said.append(contact(labels[-1], point["contact"]))
    low = min(min(row[1] for row in block) for block in tractions)
    parameters = {"count": len(labels), "label": labels, "colour": colours, "dash": dashes,
                  "r_min": RADII[0], "r_max": RADII[1], "gap_min": GAPS[0], "gap_max": GAPS[1],
                  "figure_height": 410, "traction_min": 1.15 * low, "traction_max": -1.6 * low}
    drawn = gnuplot.draw("fig09", parameters, {"gap": gaps, "traction": tractions})
    text = Markup("Gap H (above) and traction P = pμε/w (below) against r/ε at pull-off; λ† = 20, "
                  "R† = 100, half-space cut at r = R. Radii in ε where the traction is compressive (H &lt; 0), "
                  "and where the surfaces are in contact (the gap is smaller than at the largest tension): {}. A groove is "
                  "a gap between two contact annuli.").format("; ".join(said))
    label = "Gap and traction against the radius at pull-off for four scenes"
    return Figure("fig09", NUMBER, TITLE, Markup(svg.embeddable(drawn, "fig09", label)), text,
                  failures(case), case.record["command"])


def rings(found, name):
    """Annuli as text."""
    found_rings = [f"{ring['inner']:.4g} to {ring['outer']:.4g}" for ring in found[name]]
    return listing(found_rings) if found_rings else "nowhere"


def contact(label, found):
    """The contact of a scene, in words."""
    grooves = found["grooves"]
    return (f"{label}: compressed at {rings(found, 'compressed')}, in contact at {rings(found, 'held')}, "
            f"{grooves or 'no'} groove{'' if grooves == 1 else 's'}")
