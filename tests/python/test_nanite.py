"""The fit model for nanite and PyJibe: loaded as nanite loads a file, with its checks, and fitted by lmfit, which nanite uses."""

import importlib
import inspect
import pathlib
import sys
import warnings

import lmfit
import numpy as np
import pytest

import pulloff
from pulloff import nanite_model

REQUIRED = ["get_parameter_defaults", "model_doc", "model_key", "model_name", "parameter_keys", "parameter_names", "parameter_units",
            "valid_axes_x", "valid_axes_y"]


def load(path):
    """nanite.model.load_model_from_file, if nanite is there; otherwise what it does and checks (nanite 3.7, logic.py and core.py)."""
    try:
        return importlib.import_module("nanite.model").load_model_from_file(path)
    except ImportError:
        pass
    sys.path.insert(-1, str(pathlib.Path(path).parent))
    try:
        module = importlib.import_module(pathlib.Path(path).stem)
    finally:
        sys.path.remove(str(pathlib.Path(path).parent))
    assert all(hasattr(module, name) for name in REQUIRED)
    assert len(module.parameter_keys) == len(module.parameter_names) == len(module.parameter_units) == len(set(module.parameter_names))
    assert module.parameter_keys == list(module.get_parameter_defaults())
    assert module.parameter_keys == list(inspect.signature(module.model_func).parameters)[1:]
    module.model = lambda params, delta: module.model_func(delta=delta, **params.valuesdict())
    return module


def test_fit_by_nanite():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = load(nanite_model.__file__)
    truth = {"E": 1.2e6, "R": 45e-9, "w": 0.05, "contact_point": 3e-7, "baseline": 1e-10}
    made = model.get_parameter_defaults()
    for key, value in truth.items():
        made[key].value = value
    position = np.linspace(1.5e-7, 8e-7, 400)
    force = model.model(made, position) + 1e-10 * np.random.default_rng(1).standard_normal(400)
    start = model.get_parameter_defaults()
    for key, value in {"E": 2e6, "R": 45e-9, "w": 0.03, "contact_point": 2.7e-7}.items():
        start[key].value = value
    found = lmfit.minimize(model.residual, start, args=(position, force, 5e-7))
    for key in ("E", "w", "contact_point", "baseline"):
        assert abs(found.params[key].value - truth[key]) < 4 * found.params[key].stderr
    assert found.params["w"].stderr < 0.005 * truth["w"]


@pytest.mark.parametrize("modulus, work, distance, radius", [(1.2e6, 0.05, 1e-9, 45e-9), (3e9, 0.05, 1e-9, 45e-9), (3e3, 1e-4, 5e-9, 5e-6)])
@pytest.mark.parametrize("retract", [0, 1])
def test_force_of_the_solver(modulus, work, distance, radius, retract):
    """Tabor parameters 0.2 to 35, at Poisson's ratio 1/2; not beside a fold, where the force is a root."""
    tabor = (radius * (work * 0.75 / modulus) ** 2 / distance**3) ** (1 / 3)
    curve = pulloff.solve(tabor=tabor, want="curve", preload_load=3, approach_start=-60 - 2 * tabor, tolerance=1e-7).curve
    approach, force = curve["approach"], curve["load"]
    falls = np.flatnonzero(np.diff(approach) < 0)
    if len(falls):
        part, fold = (slice(falls[-1] + 1, None), falls[-1] + 1) if retract else (slice(falls[0] + 1), falls[0])
        away = np.abs(approach[part] - approach[fold]) > 1e-3 * np.ptp(approach)
        approach, force = approach[part][away], force[part][away]
    assert len(approach) > 10
    found = nanite_model.adhesive_paraboloid(-distance * approach, modulus, radius, 0.5, work, distance, retract) / (np.pi * work * radius)
    assert np.max(np.abs(found - force)) < 1e-4


if __name__ == "__main__":
    sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", __file__]))
