"""Fits of force curves: values that are known are found without a start, for soft samples (doc/examples/fit.py has a stiff one);
what is turned is turned back; tables in several forms; what is refused."""

import json
import pathlib
import subprocess
import sys

import numpy as np
import pytest

from pulloff import fit

PROGRAM = None
STIFF = 30.0, 2.0, [0.08, 0.3, 5.0, 4.3, 0.25]      # radius, nm; stiffness, nN/nm; w, range, E*, zeros
SPHERE = 45.0, np.inf, [0.05, 0.5, 0.0617, 2.0, 0.1]  # mu = 6.2; the contact radius reaches 0.63 of the radius
SOFT = 45.0, np.inf, [0.05, 1.0, 1.58e-3, 104.0, -0.2]  # mu = 36


def parts_of(case, greatest, sphere=False):
    radius, stiffness, values = case
    work, eps, modulus = values[:3]
    tabor = (radius * work**2 / (modulus**2 * eps**3)) ** (1 / 3)
    return fit.Model(radius, stiffness, greatest, tolerance=1e-8, sphere=sphere).parts(tabor, np.array(values))


def measured(case, noise, spacing, farthest, greatest, seed=1, sphere=False):
    """Positions, and forces of both ways."""
    apart, contact = parts_of(case, greatest, sphere)
    random = np.random.default_rng(seed)
    z = np.arange(farthest, np.interp(greatest, contact[1], contact[0]), spacing) + spacing * random.random()
    ways = [np.where(z <= apart[0][-1], np.interp(z, *apart), np.interp(z, *contact)),
            np.where(z >= contact[0][0], np.interp(z, *contact), np.interp(z, *apart))]
    return z, *(way + noise * random.standard_normal(len(z)) for way in ways)


def write(path, z, into, out, head="z_nm,force_nN", form="{:.6f},{:.8f}"):
    rows = [form.format(*row) for row in (*zip(z, into), *zip(z[::-1], out[::-1]))]
    path.write_text("\n".join([head, *rows]) + "\n")
    return path


def check(found, case, within=4.0):
    assert found.chi2 < 1.4
    assert np.all(np.abs(found.values - case[2]) < within * found.errors)


def test_soft_sample():
    """JKR holds, and the range follows from the jump into contact alone."""
    z, into, out = measured(SOFT, 0.05, 0.7, -300, 2)
    curve = fit.curve_of(z, into, z, out)
    found = fit.fit_curve(curve, *SOFT[:2])
    check(found, SOFT)
    assert found.values[0] == pytest.approx(SOFT[2][0], rel=0.02)
    jkr = fit.fit_theory("JKR", curve, *SOFT[:2])
    assert jkr.values[0] == pytest.approx(SOFT[2][0], rel=0.01) and jkr.values[2] == pytest.approx(SOFT[2][2], rel=0.01)
    lines = "\n".join(fit.report(curve, found, [jkr, fit.fit_theory("DMT", curve, *SOFT[:2])], SOFT[0]))
    assert "the model is a paraboloid" in lines and "none: JKR fits the part in contact as well as the full law" in lines


def test_soft_sphere_itself():
    """A tip of 45 nm in a soft sample is in contact with the whole of it. The paraboloid then gives w 44 % low and a range of 0.06 nm, and the
    sphere is found from there: its start with that range had a Tabor parameter beyond the bounds. The fit took 114 solves, as branches were
    solved for each derivative and again for values that differed by less than their errors."""
    z, into, out = measured(SOFT, 0.05, 0.7, -300, 2, sphere=True)
    fit.solved.cache_clear()
    found, flat = fit.fit_shapes(fit.curve_of(z, into, z, out), *SOFT[:2])
    check(found, SOFT)
    assert found.sphere and found.values[0] == pytest.approx(SOFT[2][0], rel=0.01) and found.contact_radius > 0.98 * SOFT[0]
    assert flat.values[0] == pytest.approx(0.56 * SOFT[2][0], rel=0.02)
    assert fit.solved.cache_info().misses < 60


def test_soft_errors_by_differences():
    """The standard errors are those that derivatives by branches of tighter tolerance give, from both sides."""
    z, into, out = measured(SOFT, 0.05, 0.7, -300, 2, sphere=True)
    curve = fit.curve_of(z, into, z, out)
    near = fit.Fit("solver", 85.0, np.array([0.0281, 0.0611, 1.685e-3, 80.3, -0.204]), np.eye(5), 9.9, 1.0, 1, 30.5)
    found = fit.fit_sphere(curve, *SOFT[:2], near)
    miss = fit.misfit(fit.Model(*SOFT[:2], curve.greatest, tolerance=1e-6, sphere=True), curve, fit.split(curve))
    x = np.array([*np.log([found.values[0], found.tabor * found.values[1], found.tabor]), *found.values[3:], 0.0])
    steps = np.array([0.003, 0.01, 0.01, 0.01, 0.002])
    jacobian = np.array([(miss(x + step) - miss(x - step)) / (2 * max(step)) for step in np.diag([*steps, 0])[:5]]).T
    turn = np.eye(5)
    turn[1], turn[2] = [0, 1, -1, 0, 0], [1, -1.5, 0, 0, 0]
    spread = np.sqrt(np.diag(turn @ np.linalg.inv(jacobian.T @ jacobian) @ turn.T))
    assert np.sqrt(np.diag(found.covariance)) == pytest.approx(spread, rel=0.04)


def test_soft_loop_of_the_program(tmp_path):
    """The loop of a soft sphere, without noise, has many rows beside the jumps, where the force is steep: a fit ended at w = 0.0506 and a
    range of 1.04 nm with the warning that the law does not describe the data."""
    words = ("--from-physical --modulus-pa 1.58e6 --work-j-per-m2 0.05 --distance-m 1e-9 --radius-m 4.5e-8 --preload-load-n 2e-9 "
             "--profile exact_sphere:4.5e-8")
    subprocess.run([PROGRAM, "solve", *words.split(), "--loop", tmp_path / "loop.csv"], check=True, capture_output=True)
    curve = fit.read_curve(tmp_path / "loop.csv")
    found, _ = fit.fit_shapes(curve, *SOFT[:2])
    assert found.sphere and found.chi2 < 0.01
    truth = np.array([0.05, 1.0, 1.58e-3, 0.0, 0.0])
    assert np.all(np.abs(found.values - truth) < found.errors)
    assert np.all(found.errors[:3] < np.array([1e-3, 0.02, 1e-3]) * truth[:3])


def test_sloping_baseline():
    """A drift of the deflection that is linear in the position is recognised by itself, fitted, and changes no other value beyond its
    error; the branch of the model ends nearer to the sample than the data. A level baseline has no slope."""
    slope, values = 3e-3, np.array(STIFF[2])
    z, into, out = measured(STIFF, 0.04, 0.1, -60, 9)
    level = fit.curve_of(z, into, z, out)
    curve = fit.curve_of(z, into + slope * z, z, out + slope * z)
    plain, found = fit.fit_curve(level, *STIFF[:2]), fit.fit_curve(curve, *STIFF[:2])
    assert plain.slope == 0 and np.isnan(plain.slope_error)
    assert abs(found.slope - slope) < 4 * found.slope_error < 1e-3
    values[4] += slope * curve.reference
    check(found, (*STIFF[:2], values))
    assert np.all(np.abs(found.values[:4] - plain.values[:4]) < 2 * plain.errors[:4])
    assert np.all(found.errors[:3] < 2 * plain.errors[:3])
    line = next(line for line in fit.report(curve.levelled(found.slope), found, [fit.fit_theory("JKR", curve.levelled(found.slope), *STIFF[:2])], STIFF[0])
                if line.startswith("baseline"))
    assert float(line.split()[2]) == pytest.approx(1e3 * found.slope, rel=1e-3) and line.split()[5] == "nN/um"
    ignored = fit.fit_curve(curve, *STIFF[:2], False)
    assert ignored.slope == 0 and ignored.chi2 > 1.5 * found.chi2


def test_sphere_itself(tmp_path):
    """Where the contact is large, the values of the sphere are found; those of the paraboloid are off by many errors."""
    z, into, out = measured(SPHERE, 0.05, 0.1, -30, 10, sphere=True)
    curve = fit.curve_of(z, into, z, out)
    full, other = fit.fit_shapes(curve, *SPHERE[:2])
    check(full, SPHERE)
    assert full.sphere and not other.sphere and full.contact_radius > 0.6 * SPHERE[0]
    assert other.values[0] < SPHERE[2][0] - 20 * other.errors[0] and other.chi2 > full.chi2 + 0.1
    lines = fit.report(curve, full, [fit.fit_theory("JKR", curve, *SPHERE[:2])], SPHERE[0], other)
    [shape] = [line for line in lines if line.startswith("shape")]
    assert "the sphere itself is fitted; with the paraboloid w would change by -6" in shape
    assert fit.shape_of(other, full, SPHERE[0]).count("the paraboloid is fitted; with the sphere itself w would change by +6")
    assert [one["shape"] for one in fit.document(curve, full, [], other)["fits"]] == ["sphere", "paraboloid"]


def test_curve_without_hysteresis():
    """Force against approach at mu = 0.6 is steep, and has no jump."""
    case = 50.0, np.inf, [0.02, 1.0, 0.3, 2.0, 0.1]
    z, into, out = measured(case, 0.002, 0.1, -20, 3)
    curve = fit.curve_of(z, into, z, out)
    assert curve.jumps() == [None, None]
    check(fit.fit_curve(curve, *case[:2]), case)


def test_forms_of_tables(tmp_path):
    """Directions, signs, columns and separators give the values of the plain table."""
    z, into, out = measured(STIFF, 0.04, 0.1, -20, 9)
    plain = fit.read_curve(write(tmp_path / "a.csv", z, into, out))
    deflection = fit.read_curve(write(tmp_path / "b.csv", z, into / 2, out / 2, "Piezo [nm];Deflection [nm]", "{:.6f};{:.8f}"), stiffness=2.0)
    turned = fit.read_curve(write(tmp_path / "c.txt", -1e-3 * z, -1e3 * into, -1e3 * out, "z_um\tforce_pN", "{:.9f}\t{:.5f}"))
    path = tmp_path / "d.csv"
    path.write_text("measured in air\nz_nm;in_nN;out_nN\n" + "".join(f"{a:.6f};{b:.8f};{c:.8f}\n".replace(".", ",") for a, b, c in zip(z, into, out)))
    three = fit.read_curve(path)
    units = fit.read_curve(write(tmp_path / "e.txt", 1e-9 * z, 1e-9 * into, 1e-9 * out, "Curve 1\nz  force\n[m]  [N]", "{:.15f}  {:.17f}"))
    bare = fit.read_curve(write(tmp_path / "f.txt", z, into, out, "", "{:.6f} {:.8f}"), units=["nm", "nN"])
    path.write_bytes(("z (\u00b5m);Kraft (nN)\nR\u00fcckweg\n" + "".join(f"{a * 1e-3:.9f};{b:.8f}\n" for a, b in (*zip(z, into), *zip(z[::-1], out[::-1])))).encode("latin-1"))
    latin = fit.read_curve(path)
    for other in (deflection, turned, three, units, bare, latin):
        for way in ("into", "out"):
            for mine, its in zip(getattr(plain, way), getattr(other, way)):
                assert np.allclose(mine, its, rtol=0, atol=2e-6)
    assert len(turned.notes) == 2 and not plain.notes


@pytest.mark.parametrize("modulus, work, greatest", [(5e9, 0.08, "8e-9"), (1.7e9, 0.05, "5e-9")])
def test_loop_of_the_program(tmp_path, modulus, work, greatest):
    """The table of solve --loop is a curve without noise. The second one was refused, as its way out begins where the attraction is above
    the noise, and then fitted with one row apart among those in contact."""
    words = (f"--from-physical --modulus-pa {modulus} --work-j-per-m2 {work} --distance-m 3e-10 --radius-m 3e-8 --preload-load-n {greatest} "
             "--stiffness-n-per-m 2")
    subprocess.run([PROGRAM, "solve", *words.split(), "--loop", tmp_path / "loop.csv"], check=True, capture_output=True)
    done = subprocess.run([PROGRAM, "fit", tmp_path / "loop.csv", "--radius-m", "3e-8", "--stiffness-n-per-m", "2", "--json"],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)["fits"][0]
    assert found["model"] == "full_law"
    for key, value in (("work_j_per_m2", work), ("distance_m", 3e-10), ("modulus_pa", modulus)):
        assert found[key] == pytest.approx(value, rel=1e-3)


def test_rows_of_a_jump_keep_their_order():
    """Both rows of a jump have one position, but for rounding: on the way in the first is apart, on the way out the first is in contact."""
    z = np.array([-3.0, -2.0, -1.0, np.nextafter(-1.0, -2.0), 0.0, 1.0])
    into, out = np.array([0.0, -0.1, -0.3, -3.0, -2.0, -1.0]), np.array([-1.0, -2.0, -3.0, -0.3, -0.1, 0.0])
    for last in z[2], z[3], -1.0:
        z[3] = last
        for way in fit.turned(z, into), fit.turned(z[::-1], out):
            assert way[1].tolist() == into.tolist()


def test_baseline_ends_before_the_jump():
    """Of a way with few samples before the jump, as a loop of a soft sample has it, rows in contact were taken for a slope."""
    z = np.concatenate([np.linspace(-160, -107, 6), np.linspace(-106.9, 60, 160)])
    out = np.where(z < -106.95, 0.0, np.minimum(-6.6 + 0.02 * (z + 107), 5))
    into = np.linspace(-160, 60, 70), np.zeros(70)
    into[1][50:] = -1 + 0.3 * np.arange(20)
    curve = fit.Curve(into, (z, out))
    assert curve.jumps()[1] == 5
    slope, error = curve.baseline
    assert abs(slope) < fit.CLEAR_SLOPE * error < 1e-2


@pytest.mark.parametrize("code, message, words", [
    (2, "pulloff: no curve is named: expected the name of a file", "fit"),
    (2, "pulloff: --radius-m is missing: expected the radius of the sphere, m", "fit flat.csv"),
    (2, "pulloff: --baseline is flat: expected auto, level or sloping", "fit flat.csv --radius-m 1e-8 --baseline flat"),
    (4, "pulloff: none.csv does not exist: expected a table", "fit none.csv --radius-m 1e-8"),
    (3, "pulloff: a deflection needs the stiffness of the lever", "fit lever.csv --radius-m 1e-8"),
    (3, "pulloff: no attraction above the noise on the way out", "fit flat.csv --radius-m 1e-8"),
    # It did not say where a unit stands.
    (3, "expected two or three columns with units, of a, b: at the end of a name (z_nm, force [nN]), in a line below the names, or given by --units, "
        "such as --units um,nN\n", "fit names.csv --radius-m 1e-8"),
    (3, "expected a way in and a way out", "fit one_way.csv --radius-m 1e-8"),
    (3, "the way out ends in contact", "fit ends.csv --radius-m 1e-8"),
    (3, "expected two or three columns with units", "fit flat.csv --columns 1,9 --radius-m 1e-8"),
    (3, "expected at least 20 rows of 2 numbers", "fit short.csv --radius-m 1e-8"),
    (3, "units is nm: expected one of m, mm, um", "fit flat.csv --columns 1,2 --units nm --radius-m 1e-8"),
    (3, "units is nm,kg: expected one of m, mm, um", "fit flat.csv --units nm,kg --radius-m 1e-8"),
])
def test_messages(tmp_path, code, message, words):
    z = np.linspace(0, 30, 60)
    noise = np.random.default_rng(4).standard_normal(60) * 0.01
    write(tmp_path / "flat.csv", z, 0.2 * np.maximum(z - 20, 0) + noise, 0.2 * np.maximum(z - 20, 0) - noise)
    (tmp_path / "one_way.csv").write_text("z_nm,force_nN\n" + "".join(f"{a:.4f},{b:.6f}\n" for a, b in zip(z, 0.2 * np.maximum(z - 20, 0) + noise)))
    write(tmp_path / "ends.csv", z, noise - 2.0 * (z > 20) + 0.5 * np.maximum(z - 20, 0), noise - 2.0 + 0.5 * np.maximum(z - 20, 0))
    write(tmp_path / "lever.csv", z, noise, noise, "z_nm,deflection_nm")
    write(tmp_path / "names.csv", z, noise, noise, "a,b")
    (tmp_path / "short.csv").write_text("z_nm,force_nN\n1,2\n2,3\n")
    done = subprocess.run([PROGRAM, *words.split()], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == code and message in done.stderr and not done.stdout


if __name__ == "__main__":
    PROGRAM = pathlib.Path(sys.argv[1]).resolve()
    sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", __file__, *sys.argv[2:]], plugins=[type("Program", (), {
        "pytest_collection_modifyitems": lambda self, items: [setattr(item.module, "PROGRAM", PROGRAM) for item in items]})()]))
