"""Viscoelastic spheres: the force against the speed, whether waves still help, and the published table of pull-offs."""

from . import Section
from ..plots import rate

ABSENT = "viscoelastic spheres (./reproduce --only rate)"


def build(source):
    case = {found.name: found for found in source.run.cases if "rate" in found.record["suites"]}
    data = {"figures": [], "finding": None, "table": source.rate}
    if "rate_wavy" in case:
        data["finding"] = rate.finding(case["rate_wavy"])
        data["figures"].append(rate.wavy(case["rate_wavy"]))
    if "rate_speed" in case:
        data["figures"].append(rate.speeds(case["rate_speed"]))
    return Section("rate", "Pulled slowly or fast", "rate.html", data,
                   [(f"figure-{item.id}", item.title) for item in data["figures"]],
                   absent="" if data["figures"] or source.rate else ABSENT)
