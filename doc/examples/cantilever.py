"""The force curve of an AFM tip with a wavy surface, through cantilevers of 0.2, 2 and 20 N/m: where the base stands, what
the deflection shows, and the energy that is lost in the jumps. Usage: cantilever.py FIGURE"""
import sys

import numpy as np
from matplotlib import pyplot

import pulloff

tip = pulloff.Scene.physical(modulus=5e9, work=0.08, distance=0.3e-9, radius=30e-9, amplitude=0.4e-9, wavelength=6e-9)
nm, nN = 1e9 * tip.units.length, 1e9 * tip.units.force
figure, plots = pyplot.subplots(1, 3, figsize=(8, 2.7), constrained_layout=True, sharey=True)
for stiffness, axes in zip((0.2, 2.0, 20.0), plots):
    result = tip.solve(stiffness=stiffness * nm / nN, preload_load=2 / nN, want=["curve", "hysteresis"])
    loop, curve = result["hysteresis"]["spring"], result.curve
    axes.plot(curve["approach"] * nm + curve["load"] * nN / stiffness, curve["load"] * nN, color="0.7", linewidth=0.8)
    for phase, colour in (("loading", "tab:blue"), ("unloading", "tab:orange")):
        for jump in (j for j in loop["jumps"] if j["phase"] == phase):
            ends = [jump[end] for end in ("before", "after")]
            axes.plot([e["approach"] * nm + e["load"] * nN / stiffness for e in ends], [e["load"] * nN for e in ends],
                      "o-", color=colour, markersize=3, label=phase if jump["label"] in "1a" else None)
    lost = loop["energy_lost"] * tip.units.force * tip.units.length
    print(f"{stiffness:4} N/m: pull-off {loop['pull_off']['force'] * nN:.2f} nN, {len(loop['jumps'])} jumps, {lost * 1e18:.2f} aJ lost")
    axes.set(title=f"{stiffness} N/m", xlabel="position of the base / nm")
    base = np.array([j[e]["approach"] * nm + j[e]["load"] * nN / stiffness for j in loop["jumps"] for e in ("before", "after")])
    axes.set(xlim=(base.min() - 1, base.max() + 2), ylim=(-20, 4))
plots[0].set(ylabel="force / nN")
plots[0].legend(frameon=False, loc="upper left")
figure.savefig(sys.argv[1], dpi=90)
