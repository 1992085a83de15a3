"""A fit model for nanite and PyJibe: a paraboloid on an elastic half-space, with adhesion by the Lennard-Jones law.

    nanite.model.load_model_from_file(pulloff.nanite_model.__file__, register=True)      (PyJibe: preferences, extensions)

The force on the way out of contact ("retract") or into it ("approach", `retract` = 0) against the position of the tip. Numbers are in SI
units. The range of the attraction hardly matters on the way out of soft samples; it is held unless it is set free. lmfit, which nanite
needs, and SciPy are needed.
"""

import functools

import lmfit
import numpy as np

from pulloff import fit

NODES = 2**0.25  # ratio of the Tabor parameters at which branches are computed


@functools.lru_cache(maxsize=1024)
def node(k, load):
    """The branch at the Tabor parameter NODES^k: the stable part apart and that in contact, approach over eps mu and load over pi w R, and
    the approach at which each ends at a fold, nan without folds."""
    approach, force = fit.branch(NODES**k, load, 1e-6)[:2]
    approach = approach / NODES**k
    falls = np.flatnonzero(np.diff(approach) < 0)
    if not len(falls):
        return [(approach, force, np.nan)] * 2
    apart, contact = slice(falls[0] + 1), slice(falls[-1] + 1, None)
    return [(approach[apart], force[apart], approach[falls[0]]), (approach[contact], force[contact], approach[falls[-1] + 1])]


def force_at(x, tabor, load, retract):
    """Load over pi w R at approaches x over eps mu: by cubic interpolation between the branches of four Tabor parameters, with the folds
    one above the other, so that minimizers find a smooth function."""
    t = np.log(tabor) / np.log(NODES)
    first = int(np.floor(t)) - 1
    nodes = range(first, first + 4)
    shares = [np.prod([(t - j) / (k - j) for j in nodes if j != k]) for k in nodes]
    parts = [node(k, load) for k in nodes]
    folds = [sum(share * part[way][2] for share, part in zip(shares, parts)) for way in (0, 1)]

    def of(way):
        shift = [0.0 if np.isnan(folds[way]) else part[way][2] - folds[way] for part in parts]
        return sum(share * np.interp(x + by, part[way][0], part[way][1]) for share, part, by in zip(shares, parts, shift))
    return np.where(x >= folds[1] if retract > 0.5 else ~(x <= folds[0]), of(1), of(0))


def get_parameter_defaults():
    """The parameters, in the order of model_func."""
    parameters = lmfit.Parameters()
    parameters.add("E", value=1e6, min=1.0)
    parameters.add("R", value=50e-9, min=0, vary=False)
    parameters.add("nu", value=0.5, min=0, max=0.5, vary=False)
    parameters.add("w", value=0.05, min=1e-6)
    parameters.add("distance", value=1e-9, min=1e-11, vary=False)
    parameters.add("retract", value=1, min=0, max=1, vary=False)
    parameters.add("contact_point", value=0)
    parameters.add("baseline", value=0)
    return parameters


def adhesive_paraboloid(delta, E, R, nu, w, distance=1e-9, retract=1, contact_point=0, baseline=0):
    r"""Adhesive contact of a paraboloid, by the solver of pulloff

    The surfaces attract each other by the Lennard-Jones law, of which JKR and DMT are the limits for large and small Tabor parameters
    :math:`(R w^2 / E^{*2} \epsilon^3)^{1/3}`.

    Parameters
    ----------
    delta: 1d ndarray
        Position of the tip [m], which decreases towards the sample
    E: float
        Young's modulus of the sample [N/m²], if the tip is rigid
    R: float
        Tip radius [m]
    nu: float
        Poisson's ratio of the sample
    w: float
        Work of adhesion [J/m²]
    distance: float
        Range of the attraction [m], the distance at which the surfaces are in equilibrium
    retract: float
        1: on the way out of contact, 0: on the way into it
    contact_point: float
        Position at which the undeformed surfaces would be in equilibrium [m]
    baseline: float
        Force offset [N]

    Returns
    -------
    F: float
        Force [N], negative where the tip is pulled
    """
    modulus = E / (1 - nu**2)
    jkr = (R * (w / modulus) ** 2) ** (1 / 3)  # eps mu
    approach = contact_point - np.asarray(delta, dtype=float)
    hertz = 4 / 3 * modulus * np.sqrt(R) * max(approach.max(), 0.0) ** 1.5  # more than with adhesion
    load = 2.0 ** np.ceil(np.log2(max(hertz / (np.pi * w * R), 0.25)))
    return np.pi * w * R * force_at(approach / jkr, jkr / distance, load, retract) + baseline


def residual(params, delta, force, weight_cp=False):
    """Measured less computed forces. Samples near the contact point have full weight: adhesion is there."""
    return force - adhesive_paraboloid(delta, **params.valuesdict())


model_doc = adhesive_paraboloid.__doc__
model_func = adhesive_paraboloid
model_key = "pulloff_para"
model_name = "adhesive paraboloid, Lennard-Jones (pulloff)"
parameter_keys = ["E", "R", "nu", "w", "distance", "retract", "contact_point", "baseline"]
parameter_names = ["Young's Modulus", "Tip Radius", "Poisson's Ratio", "Work of Adhesion", "Range of Attraction", "Way Out of Contact",
                   "Contact Point", "Force Baseline"]
parameter_units = ["Pa", "m", "", "J/m²", "m", "", "m", "N"]
valid_axes_x = ["tip position"]
valid_axes_y = ["force"]
