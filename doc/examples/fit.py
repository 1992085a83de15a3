# %% [markdown]
# # From a force curve to the work of adhesion
# An AFM moves the base of its cantilever and reads the deflection. Here such a measurement is made by the program from
# known values, with noise and unknown zeros, and `pulloff.fit` finds the values again: the work of adhesion w, the range ε
# of the attraction, the modulus E* and the two zeros, with standard errors; then by JKR, DMT and Maugis-Dugdale.
#
#     python3 fit.py [FIGURE.svg]

# %% The instrument, and the values that shall be found
import sys

import numpy as np

from pulloff import fit

RADIUS, STIFFNESS = 30.0, 2.0                    # nm; nN/nm = N/m, of the cantilever
NOISE, SPACING, FARTHEST, DEEPEST = 0.04, 0.1, -20.0, 9.0  # nN; nm: between samples, least and greatest position of the base
TRUE = np.array([0.08, 0.3, 5.0, 4.321, 0.25])   # w, nN/nm; range, nm; E*, nN/nm2; zeros, nm and nN (1 J/m2 = 1 nN/nm)


# %% The measurement: base towards the sample and back
# For a real one, `curve = fit.read_curve("curve.csv", stiffness=STIFFNESS)` reads a table with units at the end of the names of its
# columns; `pulloff fit curve.csv --radius-m 30e-9 --stiffness-n-per-m 2` does all of this page in one command.
def measure(seed):
    random = np.random.default_rng(seed)
    work, distance, modulus = TRUE[:3]
    tabor = (RADIUS * work**2 / (modulus**2 * distance**3)) ** (1 / 3)
    apart, contact = fit.Model(RADIUS, STIFFNESS, 100.0, tolerance=1e-9).parts(tabor, TRUE)
    z = np.arange(FARTHEST, DEEPEST, SPACING) + SPACING * random.random()
    into = np.where(z <= apart[0][-1], np.interp(z, *apart), np.interp(z, *contact))
    out = np.where(z >= contact[0][0], np.interp(z, *contact), np.interp(z, *apart))
    return fit.curve_of(z, into + NOISE * random.standard_normal(len(z)), z, out + NOISE * random.standard_normal(len(z)))


curve = measure(seed=33)

# %% The fit, and what three theories make of the part in contact
found = fit.fit_curve(curve, RADIUS, STIFFNESS)
theories = [fit.fit_theory(name, curve, RADIUS, STIFFNESS) for name in ("JKR", "DMT", "Maugis")]
print("\n".join(fit.report(curve, found, theories, RADIUS)))
for theory in theories:
    print(f"{theory.model}: w is wrong by {theory.values[0] / TRUE[0] - 1:+.1%}")

# %% What is determined, and by what: correlations of w, range, E* and the two zeros
error = np.sqrt(np.diag(found.covariance))
print(np.array2string(found.covariance / np.outer(error, error), precision=2, suppress_small=True))

# %% The figure; a file is written if one is named
if sys.argv[1:] and sys.argv[1].endswith((".svg", ".png")):
    fit.draw(sys.argv[1], curve, (found, *theories), RADIUS, STIFFNESS)
