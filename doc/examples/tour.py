# %% [markdown]
# # A tour of the Python module
# Each cell can be run on its own in an editor that knows `# %%` cells, or the file as a whole:
#
#     python3 tour.py [FIGURE.svg]

# %% One scene: a sphere with waves of amplitude 1 and wavelength 20 (epsilon)
import sys

import numpy as np

import pulloff

scene = pulloff.Scene(tabor=3, amplitude=1, wavelength=20)
result = scene.solve(want="curve")
p = result.pull_off
print(f"pull-off force {p.force:.7f} +- {p.force_error:.0e} pi w R at approach {p.approach:.6f} epsilon")
for fold in result.folds[:2]:
    print(f"{fold['kind']} at approach {fold['approach']:.6f}, load {fold['load']:.6f}")

# %% The branch: its stable part at given approach; the load is the derivative of the energy
curve = result.curve
stable = curve["unstable_modes"] == 0
print(f"{len(curve)} points, {np.count_nonzero(stable)} of them stable; "
      f"least load {curve['load'].min():.6f} pi w R")
work = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
print(f"the energy changes by {curve['energy'][-1] - curve['energy'][0]:.2f}, the integral of the load is "
      f"{work(curve['load'], curve['approach']):.2f}")

# %% A series: the smooth sphere from the rigid to the JKR limit
tabor = np.geomspace(0.05, 5, 21)
force = np.array([one.pull_off.force for one in pulloff.follow("tabor", tabor)])
jkr = pulloff.theory("jkr", tabor=5)["pull_off_force"]
print(f"from {force[0]:.4f} (Bradley: 2) to {force[-1]:.4f} (JKR: {jkr:g}) pi w R")

# %% SI units: a polymer tip of radius 100 nm
tip = pulloff.Scene.physical(modulus=2e9, work=0.05, distance=3e-10, radius=1e-7)
loop = tip.solve(want=["hysteresis", "profile"])
cycle = loop["hysteresis"]["displacement_control"]
print(f"pull-off force {1e9 * loop.pull_off.force * tip.units.force:.4f} nN; "
      f"energy lost {cycle['energy_lost'] * tip.units.force * tip.units.length:.3e} J in {len(cycle['jumps'])} jumps")
print(f"greatest tension {-1e-6 * tip.units.traction * loop.profile['traction'].min():.1f} MPa")

# %% Wrong input says what was expected
try:
    pulloff.solve(tabor=-1)
except pulloff.Error as error:
    print(error)

# %% A figure, if a file is named
if len(sys.argv) > 1:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
    left.plot(curve["approach"], np.where(stable, curve["load"], np.nan), "k", label="stable")
    left.plot(curve["approach"], np.where(stable, np.nan, curve["load"]), "k:", linewidth=0.8, label="unstable")
    left.set(xlabel="approach / ε", ylabel="load / πwR")
    left.legend(frameon=False)
    right.semilogx(tabor, force, "k")
    right.set(xlabel="Tabor parameter", ylabel="pull-off force / πwR")
    figure.savefig(sys.argv[1])
