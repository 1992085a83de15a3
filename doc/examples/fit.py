# %% [markdown]
# # From a force curve to the work of adhesion
# An AFM moves the base of its cantilever and reads the deflection. Here such a measurement is made by the program from
# known values, with noise and unknown zeros, and the values are found again by least squares: the work of adhesion w, the
# range ε of the attraction, the modulus E* and the two zeros, with standard errors. The same data are then read with the
# theories JKR, DMT and Maugis-Dugdale.
#
#     python3 fit.py [FIGURE.svg]

# %% The instrument, and the values that shall be found
import functools
import sys

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import least_squares

import pulloff

RADIUS, STIFFNESS = 30.0, 2.0                  # nm; nN/nm = N/m, of the cantilever
NOISE, SPACING, DEEPEST = 0.02, 0.1, 12.0      # nm: of the deflection; of the samples; greatest position of the base
NAMES = ["w, J/m2", "range, nm", "E*, GPa", "z0, nm", "d0, nm"]
TOLERANCES = {"solver": 1e-5, "truth": 1e-9}
TRUE = np.array([0.08, 0.3, 5.0, 4.321, 0.123])  # 1 J/m2 = 1 nN/nm, 1 GPa = 1 nN/nm2


# %% The branch of all smooth spheres with one Tabor parameter, from one solve; lengths in ε and loads in πwR
@functools.lru_cache(maxsize=64)
def branch(model, tabor):
    if model in TOLERANCES:
        curve = pulloff.solve(tabor=tabor, want="curve", approach_start=-80, approach_end=8, tolerance=TOLERANCES[model]).curve
        at = curve["position"]
        dense = np.interp(np.linspace(0, len(at) - 1, 16 * len(at)), np.arange(len(at)), at)
        return [CubicHermiteSpline(at, curve[name], curve[name + "_rate"])(dense) for name in ("approach", "load")]
    a, deep = np.linspace(0.01, 2.6, 600), tabor * (9 * np.pi**2 / 16) ** (1 / 3)  # units of Maugis, JCIS 150, 243 (1992)
    if model == "JKR":
        return deep * (a**2 - 2 / 3 * np.sqrt(6 * a)), a**3 - np.sqrt(6 * a**3)
    if model == "DMT":
        return deep * a**2, a**3 - 2
    m, tension = 1 + np.geomspace(1e3, 1e-4, 1200), 1.0264004785593346 * 2 * (9 / (16 * np.pi)) ** (1 / 3) * tabor
    root, angle = np.sqrt(m**2 - 1), np.arccos(1 / m)
    p, q = tension / 2 * (root + (m**2 - 2) * angle), 4 / 3 * tension**2 * (root * angle - m + 1)
    a = (np.sqrt(q**2 + 4 * p) - q) / (2 * p)  # p a^2 + q a = 1
    return deep * (a**2 - 4 / 3 * tension * a * root), a**3 - tension * a**2 * (root + m**2 * angle)


def parts(model, values):
    """The two stable parts of the curve as the instrument sees them, position of the base and deflection in nm: apart, up
    to the jump into contact, and in contact, from the jump out of it. In between the spring makes the states unstable."""
    work, distance, modulus, zero_z, zero_d = values
    approach, load = branch(model, (RADIUS * work**2 / (modulus**2 * distance**3)) ** (1 / 3))
    deflection = np.pi * work * RADIUS * load / STIFFNESS
    position = distance * approach + deflection
    last = np.flatnonzero(np.diff(position) < 0)
    jump_in, jump_out = (last[0], last[-1] + 1) if len(last) else (0, 0)
    return [(position[part] + zero_z, deflection[part] + zero_d) for part in (slice(jump_in + 1), slice(jump_out, None))]


# %% The measurement: base towards the sample and back
def measure(seed):
    random = np.random.default_rng(seed)
    down = np.arange(-18.0, DEEPEST, SPACING) + SPACING * random.random() + TRUE[3]
    apart, contact = parts("truth", TRUE)
    into = np.where(down <= apart[0][-1], np.interp(down, *apart), np.interp(down, *contact))
    out = np.where(down >= contact[0][0], np.interp(down, *contact), np.interp(down, *apart))
    return down, *(deflection + NOISE * random.standard_normal(len(down)) for deflection in (into, out))


# %% What is compared
# A jump moves with the parameters, and a point that is on the other side of it has another deflection: residuals at given
# positions would be discontinuous. The measured jumps say to which part a point belongs, the part is continued with its
# last deflection beyond its end, and the positions of the jumps are residuals of their own. They are known to the spacing
# of the samples, and the points beside them, where the curve is vertical, are left out.
def split(z, into, out, beside=3):
    jump_in, jump_out = np.argmax(-np.diff(into)), np.argmax(np.diff(out[::-1]))
    jump_out = len(z) - 2 - jump_out
    far = np.r_[z[:jump_in - beside], z[:jump_out - beside]], np.r_[into[:jump_in - beside], out[:jump_out - beside]]
    near = np.r_[z[jump_in + 1:], z[jump_out + 1 + beside:]], np.r_[into[jump_in + 1:], out[jump_out + 1 + beside:]]
    return far, near, (z[jump_in:jump_in + 2].mean(), z[jump_out:jump_out + 2].mean())


def residuals(model, values, data):
    """Of the part apart, of that in contact, and of the jumps in and out, each divided by its standard deviation."""
    far, near, jumps = data
    apart, contact = parts(model, values)
    return [(np.interp(far[0], *apart) - far[1]) / NOISE, (np.interp(near[0], *contact) - near[1]) / NOISE,
            (np.array([apart[0][-1], contact[0][0]]) - jumps) / (SPACING / np.sqrt(12))]


# %% The fit
def fit(data, guess, model="solver", use=lambda found: found, free=range(5)):
    """Least squares from a guess. `use` chooses among the residuals, `free` the parameters. Returns the values and their
    covariance. Lengths and moduli are scaled by the guess and the zeros by 1 nm, so that all unknowns are near 1."""
    free = list(free)
    unit = np.where(np.arange(5) < 3, guess, 1.0)

    def values(x):
        whole = np.array(guess, dtype=float)
        whole[free] += unit[free] * (x - 1)
        return whole

    found = least_squares(lambda x: np.concatenate(use(residuals(model, values(x), data))), np.ones(len(free)),
                          bounds=(np.where(np.array(free) < 3, 0.2, -np.inf), np.where(np.array(free) < 3, 5, np.inf)),
                          diff_step=1e-3, x_scale="jac")
    covariance = np.full((5, 5), np.nan)
    covariance[np.ix_(free, free)] = np.linalg.inv(found.jac.T @ found.jac) * np.outer(unit[free], unit[free])
    return values(found.x), covariance, 2 * found.cost, len(found.fun)


def guess(random, z, into, out):
    """Values that are up to 30 % off, and zeros read off the curve: the deflection far away, and the position at which the
    way out crosses it."""
    zero = np.median(into[:30])
    return np.r_[TRUE[:3] * random.uniform(0.7, 1.3, 3), z[np.flatnonzero(out > zero + 0.1)[0]], zero]


# %% One measurement, evaluated
def row(name, numbers, rest=""):
    print(f"{name:28}" + "".join(" " * 11 if np.isnan(number) else f"{number:11.4f}" for number in numbers) + rest)


measured = measure(seed=33)
data, start = split(*measured), guess(np.random.default_rng(33), *measured)
found, covariance, squares, count = fit(data, start)
error = np.sqrt(np.diag(covariance))
print(" " * 28 + "".join(f"{name:>11}" for name in NAMES) + "  chi2/n")
for name, numbers in (("true", TRUE), ("guess", start)):
    row(name, numbers)
row("found", found, f"{squares / count:8.2f}")
row("standard error", error)

# %% What is determined, and by what: correlations, and standard errors without some of the data
for name, line in zip(NAMES, covariance / np.outer(error, error)):
    row("correlation, " + name, line)
for name, use in (("without the jumps", slice(2)), ("without the part apart", slice(1, 3)), ("contact alone", slice(1, 2))):
    row("error " + name, np.sqrt(np.diag(fit(data, found, use=lambda residuals: residuals[use])[1])))

# %% The same data read with theories, which have no attraction before the contact
# They get the part in contact and the jump out of it, and the zero of the deflection from the part apart.
flat, theories = np.r_[start[:4], np.median(data[0][1][:30])], {}
for model, free in (("JKR", (0, 2, 3)), ("DMT", (0, 2, 3)), ("Maugis", (0, 1, 2, 3))):
    theories[model], spread, squares, count = fit(data, flat, model, lambda found: [found[1], found[2][1:]], free)
    row(model, np.where(np.isin(range(5), (*free, 4)), theories[model], np.nan), f"{squares / count:8.2f}")
    row("standard error", np.sqrt(np.diag(spread)))

# %% The figure; a file is written if one is named
from matplotlib import pyplot

figure, plots = pyplot.subplots(1, 2, figsize=(7.2, 2.9), constrained_layout=True)
for axes in plots:
    for z, d, colour, label in ((measured[0], measured[1], "tab:blue", "towards"), (measured[0], measured[2], "tab:orange", "back")):
        axes.plot(z - d, STIFFNESS * d, ".", color=colour, markersize=2, label="measured, " + label)
    for model, values, style in (("solver", found, "k-"), *zip(theories, theories.values(), ("r--", "g:", "m-."))):
        for part, name in zip(parts(model, values), (None, model.replace("solver", "pulloff"))):
            axes.plot(part[0] - part[1], STIFFNESS * part[1], style, linewidth=0.9, label=name)
    axes.set(xlabel="base less deflection / nm", ylabel="force / nN")
plots[0].set(xlim=(2, 6), ylim=(-15, 24))
plots[0].legend(frameon=False, fontsize=7)
plots[1].set(xlim=(-1, 4.5), ylim=(-1.1, 0.5), title="before the contact")
if sys.argv[1:] and sys.argv[1].endswith((".svg", ".png")):
    figure.savefig(sys.argv[1], dpi=90)
