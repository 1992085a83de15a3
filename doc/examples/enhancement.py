"""The pull-off force of a wavy sphere against the amplitude of the waves, for three Tabor parameters, beside the envelope of
the JKR theory (Kesari and Lew, Eq 24). Usage: enhancement.py FIGURE"""
import sys

import numpy as np
from matplotlib import pyplot

import pulloff

WAVELENGTH = 20.0
amplitude = np.geomspace(0.05, 8, 24)
figure, axes = pyplot.subplots(figsize=(5.4, 3.2), constrained_layout=True)
for tabor, colour in ((1, "tab:blue"), (2, "tab:orange"), (5, "tab:red")):
    smooth = pulloff.solve(tabor=tabor).pull_off.force
    series = pulloff.follow("amplitude", amplitude, tabor=tabor, wavelength=WAVELENGTH, preload_load=1, tolerance=1e-4)
    gain = np.array([one.pull_off.force / smooth for one in series])
    jkr = [pulloff.theory("kesari-lew", tabor=tabor, amplitude=a, wavelength=WAVELENGTH)["pull_off_force"] / 1.5 for a in amplitude]
    axes.semilogx(amplitude, gain, color=colour, label=f"μ = {tabor}")
    axes.semilogx(amplitude, jkr, ":", color=colour, linewidth=0.9)
    print(f"tabor {tabor}: greatest force {gain.max():.3f} times that of the smooth sphere, at amplitude {amplitude[gain.argmax()]:.2f}")
axes.set(xlabel="amplitude / ε", ylabel="force / that of the smooth sphere", ylim=(0, 6))
axes.legend(frameon=False)
figure.savefig(sys.argv[1], dpi=90)
