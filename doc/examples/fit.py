# %% [markdown]
# # From a force curve to the work of adhesion
# An AFM moves the base of its cantilever and reads the deflection. Here such a measurement is made by the program from
# known values, with noise and unknown zeros, and the values are found again by least squares: the work of adhesion w, the
# range ε of the attraction, the modulus E* and the two zeros, with standard errors; then by JKR, DMT and Maugis-Dugdale.
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
NOMINAL = 0.35, 6.2                            # range and E* to start from: what a data sheet says, up to 30 % off


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
# For a real one three arrays in nm replace `measure(seed=33)`: equidistant positions of the base, growing towards the sample,
# and there the deflections in and out, positive when the tip is pushed away from the sample. RADIUS, STIFFNESS, NOISE,
# SPACING and NOMINAL are then its own, `guess` reads the rest off the curve, and TRUE is only printed.
def measure(seed):  # from 11 nm before the jump out of contact
    random = np.random.default_rng(seed)
    apart, contact = parts("truth", TRUE)
    down = np.arange(np.floor(contact[0][0] - TRUE[3]) - 11, DEEPEST, SPACING) + SPACING * random.random() + TRUE[3]
    into = np.where(down <= apart[0][-1], np.interp(down, *apart), np.interp(down, *contact))
    out = np.where(down >= contact[0][0], np.interp(down, *contact), np.interp(down, *apart))
    return down, *(deflection + NOISE * random.standard_normal(len(down)) for deflection in (into, out))


# %% What is compared
# A jump moves with the parameters, and a point that is on the other side of it has another deflection: residuals at given
# positions would be discontinuous. The measured jumps say to which part a point belongs, the part is continued with its
# last deflection beyond its end, and the positions of the jumps are residuals of their own. They are known to the spacing
# of the samples, and the points beside them, where the curve is vertical, are left out.
def split(z, into, out, beside=3):
    jump_in, jump_out = np.argmax(-np.diff(into)), len(z) - 2 - np.argmax(np.diff(out[::-1]))
    far = np.r_[z[:jump_in - beside], z[:jump_out - beside]], np.r_[into[:jump_in - beside], out[:jump_out - beside]]
    near = np.r_[z[jump_in + 1:], z[jump_out + 1 + beside:]], np.r_[into[jump_in + 1:], out[jump_out + 1 + beside:]]
    return far, near, (z[jump_in:jump_in + 2].mean(), z[jump_out:jump_out + 2].mean())


def residuals(model, values, data):
    """Of the part apart, of that in contact, and of the jumps in and out, each divided by its standard deviation."""
    (far, near, jumps), (apart, contact) = data, parts(model, values)
    return [(np.interp(far[0], *apart) - far[1]) / NOISE, (np.interp(near[0], *contact) - near[1]) / NOISE,
            (np.array([apart[0][-1], contact[0][0]]) - jumps) / (SPACING / np.sqrt(12))]


# %% The fit
def fit(data, guess, model="solver", use=lambda found: found, free=range(5)):
    """Least squares from a guess. `use` chooses among the residuals, `free` the parameters. Returns the values and their
    covariance. Lengths and moduli are scaled by the guess and the zeros by 1 nm, so that all unknowns are near 1."""
    free, unit = np.array(free), np.where(np.arange(5) < 3, guess, 1.0)
    values = lambda x: guess + unit * ((x - 1) @ np.eye(5)[free])
    found = least_squares(lambda x: np.concatenate(use(residuals(model, values(x), data))), np.ones(len(free)),
                          bounds=(np.where(free < 3, 0.2, -np.inf), np.where(free < 3, 5, np.inf)), diff_step=1e-3, x_scale="jac")
    covariance = np.full((5, 5), np.nan)
    covariance[np.ix_(free, free)] = np.linalg.inv(found.jac.T @ found.jac) * np.outer(unit[free], unit[free])
    return values(found.x), covariance, 2 * found.cost, len(found.fun)


def guess(nominal, z, into, out):
    """Zeros by the deflection far away and where the way out crosses it, w by a pull-off force between JKR's and DMT's."""
    zero = np.median(into[:30])
    return np.r_[STIFFNESS * (zero - out.min()) / (1.75 * np.pi * RADIUS), nominal, z[out > zero + 5 * NOISE][0], zero]


# %% One measurement, evaluated
def row(name, numbers, rest=""):
    print(f"{name:28}" + "".join(" " * 11 if np.isnan(number) else f"{number:11.4f}" for number in numbers) + rest)


measured = measure(seed=33)
data, start = split(*measured), guess(NOMINAL, *measured)
found, covariance, squares, count = fit(data, start)
apart, contact = parts("solver", found)
if squares > 2 * count or not measured[0][0] < contact[0][0] < apart[0][-1] < measured[0][-1]:
    sys.exit(f"no fit: chi2/n = {squares / count:.2f}, jumps at {apart[0][-1]:.2f} and {contact[0][0]:.2f} nm, data from "
             f"{measured[0][0]:.2f} to {measured[0][-1]:.2f} nm: are both jumps in the data, and is NOMINAL near?")
error = np.sqrt(np.diag(covariance))
print(" " * 28 + "".join(f"{name:>11}" for name in NAMES) + "  chi2/n")
row("true", TRUE)
row("guess", start)
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
    for d, colour, label in zip(measured[1:], ("tab:blue", "tab:orange"), ("towards", "back")):
        axes.plot(measured[0] - d, STIFFNESS * d, ".", color=colour, markersize=2, label="measured, " + label)
    for model, values, style in (("solver", found, "k-"), *zip(theories, theories.values(), ("r--", "g:", "m-."))):
        for part, name in zip(parts(model, values), (None, model.replace("solver", "pulloff"))):
            axes.plot(part[0] - part[1], STIFFNESS * part[1], style, linewidth=0.9, label=name)
    axes.set(xlabel="base less deflection / nm", ylabel="force / nN")
jump, depth = apart[0][-1] - apart[1][-1], STIFFNESS * (found[4] - apart[1][-1])  # where the tip jumps in; attraction there
plots[0].set(xlim=(jump - 4 * found[1], (measured[0] - measured[2]).max() + 3 * found[1]),
             ylim=(STIFFNESS * (measured[2].min() - 1), STIFFNESS * (measured[2].max() + 1)))
plots[0].legend(frameon=False, fontsize=7)
plots[1].set(xlim=found[3] - found[4] + np.array([5.5 * (jump - found[3] + found[4]), found[1]]),
             ylim=STIFFNESS * found[4] + depth * np.array([-1.15, 0.25]), title="before the contact")
if sys.argv[1:] and sys.argv[1].endswith((".svg", ".png")):
    figure.savefig(sys.argv[1], dpi=90)
