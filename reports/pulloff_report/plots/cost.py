"""What an equilibrium costs: time against nodes and against the number of waves, and the rates beside those of the machine."""

from markupsafe import Markup

from .. import gnuplot, samples, svg
from ..cost import PARTS
from ..words import count, fixed, plain, scientific
from .figure import Figure, log_range

WAYS = ("hierarchical", "dense")
PART_NAMES = {"product": "product", "factors": "factors", "solve": "solve"}
FIT_FROM = {"hierarchical": 1000, "dense": 500}  # nodes; below, the parts that do not grow with the nodes matter
WAVES_FROM = 1.0                                 # waves in contact; with fewer it is a contact without waves
GIGA = 1e9


def of_way(document, way):
    """(nodes, measurements) of every mesh that was measured in this way."""
    return [(mesh["nodes"], mesh[way]) for mesh in document["meshes"] if mesh[way]]


def exponent(rows, least):
    """The exponent of the fit to rows (x, y) with x of at least `least`: None for fewer than three."""
    used = [row for row in rows if row[0] >= least]
    return samples.slope(used) if len(used) > 2 else None


def equilibrium(document, way):
    return [(nodes, found["seconds"]) for nodes, found in of_way(document, way)]


def part_rows(document, way, part):
    return [(nodes, found[part]["seconds"]) for nodes, found in of_way(document, way)]


def trace_rows(document):
    return [(mesh["nodes"], mesh["trace"]["seconds"] / mesh["trace"]["points"]) for mesh in document["meshes"]]


def wave_rows(document, value):
    return [(found["waves"], value(found["trace"])) for found in document["waves"]]


def slower(document):
    """nodes -> time of a dense equilibrium over that of a compressed one: the power law through the measured ratios."""
    rows = [(mesh["nodes"], mesh["dense"]["seconds"] / mesh["hierarchical"]["seconds"]) for mesh in document["meshes"]
            if mesh["dense"] and mesh["nodes"] >= FIT_FROM["dense"]]
    if len(rows) < 3:
        return None
    power_of_nodes = samples.slope(rows)
    nodes, ratio = rows[len(rows) // 2]
    return lambda n: ratio * (n / nodes) ** power_of_nodes


def dense_waves(document):
    """Rows (waves, seconds): what the solves would take with dense matrices, by the ratio of the equilibria at the largest
    number of nodes; dense matrices are not taken to be faster."""
    ratio = slower(document)
    return [] if ratio is None else wave_rows(document, lambda trace: trace["seconds"] * max(1.0, ratio(trace["nodes"])))


def exponents(document):
    """Name -> exponent of every fit."""
    found = {way: exponent(equilibrium(document, way), FIT_FROM[way]) for way in WAYS}
    for way in WAYS:
        for part in PARTS:
            found[f"{way} {part}"] = exponent(part_rows(document, way, part), FIT_FROM[way])
    found["trace"] = exponent(trace_rows(document), FIT_FROM["hierarchical"])
    for name, value in (("solve", lambda trace: trace["seconds"]), ("points", lambda trace: trace["points"]),
                        ("nodes", lambda trace: trace["factorized_nodes"])):
        found[f"waves {name}"] = exponent(wave_rows(document, value), WAVES_FROM)
    found["waves dense"] = exponent(dense_waves(document), WAVES_FROM)
    return found


def rates(document):
    """(part, way, operations a byte, operations a second) on the largest mesh that was measured both ways."""
    both = [mesh for mesh in document["meshes"] if mesh["dense"]]
    if not both:
        return [], 0
    mesh = max(both, key=lambda each: each["nodes"])
    return [(part, way, mesh[way][part]["flops"] / mesh[way][part]["bytes"],
             mesh[way][part]["flops"] / mesh[way][part]["seconds"]) for way in WAYS for part in PARTS], mesh["nodes"]


def roof(machine, part, way, intensity):
    """The rate that the machine allows: single precision for dense factors and solves, double precision otherwise."""
    single = way == "dense" and part != "product"
    return min(machine["flops_single" if single else "flops_double"], intensity * machine["bytes"])


def power(value):
    return "–" if value is None else fixed(value, 2)


def scene_words(document):
    return "μ = {tabor:g}, A† = {amplitude:g}, λ† = {wavelength:g}".format(**document["scene"])


def nodes_figure(document):
    data = {"equilibrium": [equilibrium(document, way) for way in WAYS] + [trace_rows(document)],
            "parts": [part_rows(document, way, part) for way in WAYS for part in PARTS]}
    nodes = [mesh["nodes"] for mesh in document["meshes"]]
    ranges = [log_range([value for block in data[name] for _, value in block]) for name in ("equilibrium", "parts")]
    drawn = gnuplot.draw("cost", {
        "figure_height": 300, "x_low": 0.8 * min(nodes), "x_high": 1.3 * max(nodes), "low": [low for low, _ in ranges],
        "high": [high for _, high in ranges], "part": [PART_NAMES[part] for part in PARTS]}, data)
    fit = exponents(document)
    caption = Markup(
        "(a) Processor time of one equilibrium: the factors of the Jacobian, the correction of a state 10<sup>−3</sup>ε of "
        "approach away, and the tangent, on the same mesh with compressed and with dense matrices; and the time of a trace "
        "over its number of equilibria, which includes new meshes and special points. (b) The parts: a product with the "
        "influence matrix, the factors, a solve with them; filled: compressed, open: dense. Scenes {} on a surface that "
        "ends where the initial gap is 40ε, R† from {} to {}, from Δ† = −4 to −2. Exponents of the number of nodes, "
        "compressed from {} nodes on: equilibrium {}, trace {}, product {}, factors {}, solve {}; dense from {} nodes on: "
        "{}, product {}, factors {}, solve {}.").format(
            scene_words(document), plain(min(mesh["radius"] for mesh in document["meshes"])),
            scientific(max(mesh["radius"] for mesh in document["meshes"]), 1), FIT_FROM["hierarchical"],
            power(fit["hierarchical"]), power(fit["trace"]), *(power(fit[f"hierarchical {part}"]) for part in PARTS),
            FIT_FROM["dense"], power(fit["dense"]), *(power(fit[f"dense {part}"]) for part in PARTS))
    return Figure("cost-nodes", None, "Time of an equilibrium against the number of nodes",
                  Markup(svg.embeddable(drawn, "cost-nodes", "Time of an equilibrium and of its parts against the nodes")),
                  caption)


def limits_figure(document):
    found, nodes = rates(document)
    machine = document["machine"]
    data = {"waves": [wave_rows(document, value) for value in (
                lambda trace: trace["seconds"], lambda trace: trace["points"] / 1000,
                lambda trace: trace["factorized_nodes"] / 1000)] + [dense_waves(document)],
            "rates": [[(intensity, rate / GIGA) for part, way, intensity, rate in found if (part, way) == (each, kind)]
                      for kind in WAYS for each in PARTS]}
    drawn = gnuplot.draw("cost_limits", {
        "figure_height": 300, "x_low": 0.7 * min(each["waves"] for each in document["waves"]),
        "x_high": 1.4 * max(each["waves"] for each in document["waves"]),
        "part": [PART_NAMES[part] for part in PARTS], "peak": machine["flops_double"] / GIGA,
        "peak_single": machine["flops_single"] / GIGA, "memory": machine["bytes"] / GIGA}, data)
    fit = exponents(document)
    caption = Markup(
        "(a) The whole solve of wavy spheres, {}, R† from {} to {}, against the number of wavelengths in the contact radius"
        " at pull-off. Dashed: what dense matrices are expected to take: the time multiplied by the ratio of dense and "
        "compressed equilibria of the figure above, at the largest number of nodes. Exponents from {} on: time {}, with "
        "dense matrices {}, equilibria {}, nodes {}. (b) Operations a second of the parts of an equilibrium with {} against"
        " operations for each byte of matrix; filled: compressed, open: dense. The lines are what the machine does: {} GB/s"
        " from memory, and products of matrices of order 768 in double and in single precision, {} and {} Gflop/s. Dense "
        "factors and solves are in single precision.").format(
            scene_words(document), plain(min(each["radius"] for each in document["waves"])),
            plain(max(each["radius"] for each in document["waves"])), count(int(WAVES_FROM), "wavelength"),
            power(fit["waves solve"]), power(fit["waves dense"]), power(fit["waves points"]), power(fit["waves nodes"]),
            count(nodes, "node"), fixed(machine["bytes"] / GIGA, 1), fixed(machine["flops_double"] / GIGA, 0),
            fixed(machine["flops_single"] / GIGA, 0))
    return Figure("cost-limits", None, "Cost against the number of waves, and the rates beside those of the machine",
                  Markup(svg.embeddable(drawn, "cost-limits",
                                        "Time against the number of waves; rates of the parts and of the machine")),
                  caption)


def make(document):
    return [nodes_figure(document), limits_figure(document)]
