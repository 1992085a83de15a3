"""What an equilibrium costs: against the nodes, against the waves, and beside what the machine does."""

from . import Section
from ..cost import PARTS
from ..plots import cost

ABSENT = "the cost of an equilibrium (./reproduce --only cost)"


def rate_rows(document):
    """The parts on the largest mesh that was measured both ways, with their share of what the machine allows."""
    found, _ = cost.rates(document)
    return [{"part": cost.PART_NAMES[part], "way": "compressed" if way == "hierarchical" else "dense", "intensity": intensity,
             "rate": rate / cost.GIGA, "roof": cost.roof(document["machine"], part, way, intensity) / cost.GIGA,
             "share": rate / cost.roof(document["machine"], part, way, intensity)} for part, way, intensity, rate in found]


def mesh_rows(document):
    return [{"mesh": mesh, "trace": mesh["trace"]["seconds"] / mesh["trace"]["points"],
             "ways": [mesh[way] for way in cost.WAYS]} for mesh in document["meshes"]]


def crossover(document):
    """The smallest number of nodes from which on the compressed equilibrium is faster than the dense one; None: there is none."""
    found = None
    for mesh in sorted((mesh for mesh in document["meshes"] if mesh["dense"]), key=lambda mesh: -mesh["nodes"]):
        if mesh["hierarchical"]["seconds"] >= mesh["dense"]["seconds"]:
            break
        found = mesh["nodes"]
    return found


def build(source):
    document = source.cost
    data = {}
    if document:
        both = [mesh for mesh in document["meshes"] if mesh["dense"]]
        rows = rate_rows(document)
        data = {"document": document, "figures": cost.make(document), "rates": rows, "meshes": mesh_rows(document),
                "crossover": crossover(document), "parts": PARTS, "both": max(both, key=lambda mesh: mesh["nodes"], default=None),
                "factors": {row["way"]: row for row in rows if row["part"] == cost.PART_NAMES["factors"]}}
    return Section("cost", "Cost of an equilibrium", "cost.html", data, absent="" if document else ABSENT)
