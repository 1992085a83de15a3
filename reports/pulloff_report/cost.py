"""Reads what equilibria cost on this machine (see tests/cost/README.md)."""

import os

from .records import demand, read_judgement

SCHEMA = "pulloff-cost/1"
PLACE = os.path.join("cost", "cost.json")  # beside the run's folder

NUMBER = (int, float)
DOCUMENT = {"scene": dict, "machine": dict, "meshes": list, "waves": list}
MACHINE = {"flops_double": NUMBER, "flops_single": NUMBER, "bytes": NUMBER, "library": str}
SCENE = {"tabor": NUMBER, "amplitude": NUMBER, "wavelength": NUMBER}
TRACE = {"seconds": NUMBER, "points": int, "newton_iterations": int, "factorizations": int, "nodes": int,
         "factorized_nodes": int}
MESH = {"radius": NUMBER, "nodes": int, "trace": dict, "hierarchical": dict, "dense": (dict, type(None))}
WAY = {"seconds": NUMBER, "newton_iterations": int, "active": int, "product": dict, "factors": dict, "solve": dict}
TIMED = {"seconds": NUMBER, "flops": NUMBER, "bytes": NUMBER}
WAVES = {"radius": NUMBER, "waves": NUMBER, "trace": dict}
PARTS = ("product", "factors", "solve")


def beside(run):
    """The path of the document that belongs to a run."""
    return os.path.join(os.path.dirname(os.path.abspath(run)), PLACE)


def demand_way(way, path, where):
    demand(way, WAY, path, where)
    for part in PARTS:
        demand(way[part], TIMED, path, f"{where}.{part}")


def read(path):
    """The document, or None when there is no such file."""
    document = read_judgement(path, SCHEMA)
    if document is None:
        return None
    demand(document, DOCUMENT, path, "")
    demand(document["machine"], MACHINE, path, "machine")
    demand(document["scene"], SCENE, path, "scene")
    for place, mesh in enumerate(document["meshes"]):
        demand(mesh, MESH, path, f"meshes[{place}]")
        demand(mesh["trace"], TRACE, path, f"meshes[{place}].trace")
        demand_way(mesh["hierarchical"], path, f"meshes[{place}].hierarchical")
        if mesh["dense"]:
            demand_way(mesh["dense"], path, f"meshes[{place}].dense")
    for place, waves in enumerate(document["waves"]):
        demand(waves, WAVES, path, f"waves[{place}]")
        demand(waves["trace"], TRACE, path, f"waves[{place}].trace")
    return document
