"""Line scans: axis, tilt, noise and gaps of bodies that are known, at random; the forms in which instruments write; the force of the
mean and of the sides; what is refused."""

import csv
import math
import random

import pytest
from conftest import expect, run

WAVES = 0.04, 4.3  # um


def gap(r, radius, wavy=True):
    """A paraboloid with a wave, um."""
    return r * r / (2 * radius) + (WAVES[0] * (1 - math.cos(2 * math.pi * r / WAVES[1])) if wavy else 0)


def scan(seed, wavy=True, tilt=None, noise=None, rows=None):
    """Positions in um and heights in nm of a body, and what they were made of."""
    of = random.Random(seed)
    body = {"radius": of.uniform(15, 60), "axis": of.uniform(-1.5, 1.5), "tilt": of.uniform(-0.01, 0.01) if tilt is None else tilt,
            "noise": of.uniform(0.05, 1) if noise is None else noise}
    count = rows or of.randrange(300, 900)
    left, right = of.uniform(-24, -16), of.uniform(16, 24)
    x = [round(left + k * round((right - left) / count, 4), 4) for k in range(count)]
    z = [321 + 1e3 * (body["tilt"] * (at - body["axis"]) - gap(at - body["axis"], body["radius"], wavy)) + of.gauss(0, body["noise"])
         for at in x]
    return x, z, body


def write(path, x, z, head="x_um,z_nm", separator=",", comma=False, encoding="utf-8", before=""):
    rows = [f"{a:.6f}{separator}{b:.6f}" for a, b in zip(x, z)]
    text = "\n".join([head] + [row.replace(".", ",") if comma else row for row in rows]) + "\n"
    path.write_bytes((before + text).encode(encoding))
    return path


def table(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return rows[0], [tuple(map(float, row)) for row in rows[1:]]


def numbers(out, line, *words):
    """The numbers after words of a line."""
    text = next(part for part in out.splitlines() if part.startswith(line))
    return [float(text.split(word)[1].split()[0].rstrip(",;:")) for word in words]


@pytest.mark.parametrize("seed", range(12))
def test_known_body(tmp_path, seed):
    x, z, body = scan(seed)
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, z)} --output {tmp_path / 't.csv'}").out
    spacing = x[1] - x[0]
    assert numbers(out, "apex", "= ")[0] == pytest.approx(body["axis"], abs=0.26 * spacing + 0.05 * body["noise"])
    assert "removed: the sides do not tell one" in out or numbers(out, "tilt", "tilt ")[0] == pytest.approx(
        body["tilt"], abs=2e-4 + spacing / 4 / body["radius"] + 2e-3 * body["noise"])
    assert numbers(out, "noise", "height ")[0] == pytest.approx(body["noise"], rel=0.2)
    names, rows = table(tmp_path / "t.csv")
    assert names == ["r_um", "gap_nm"] and rows[0] == (0, 0)
    off = [g - 1e3 * gap(r, body["radius"]) for r, g in rows[1:]]
    mean = sum(off) / len(off)  # the noise on the axis, which the smoothing takes away
    spread = math.sqrt(sum((o - mean) ** 2 for o in off) / len(off))
    displaced = 1e3 * WAVES[0] * (math.pi * spacing / 2 / WAVES[1]) ** 2  # by the axis among the rows
    assert spread < 1.25 * body["noise"] / math.sqrt(2) + displaced
    assert abs(mean) < 5 * body["noise"] + displaced


@pytest.mark.parametrize("seed", range(4))
def test_tilt_of_a_parabola_is_not_told(tmp_path, seed):
    x, z, body = scan(seed, wavy=False, tilt=0.005)
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, z)} --output {tmp_path / 't.csv'}").out
    assert "tilt     none removed: the sides do not tell one" in out
    assert numbers(out, "apex", "= ")[0] == pytest.approx(body["axis"] + 0.005 * body["radius"], abs=0.1)
    assert numbers(out, "parabola", "radius ")[0] == pytest.approx(body["radius"], rel=2e-3)


def test_forms_give_one_table(tmp_path):
    """Separators, decimal commas, encodings, units, order of the rows and the direction of heights change nothing."""
    x, z, _ = scan(3, noise=0.3, rows=400)
    low = [-height for height in z]
    forms = [write(tmp_path / "0.csv", x, z),
             write(tmp_path / "1.csv", x, z, "Position [µm];Höhe [nm]", ";", True, "utf-16", "Messung vom 3.4.2026\nGerät: X\n"),
             write(tmp_path / "2.csv", x[::-1], z[::-1], "x (um)\tz (nm)", "\t"),
             write(tmp_path / "3.csv", x, low, "x/μm  depth/nm", "  "),
             write(tmp_path / "4.txt", x, z, "  Profile 1\n  x          y\n  [µm]       [nm]", "    "),
             write(tmp_path / "5.csv", x, z, "Länge (µm);Höhe (nm)", ";", True, "latin-1"),
             write(tmp_path / "7.csv", x, z, "1. lateral (um),2nd height (nm)"),  # names that begin with a digit are no row
             write(tmp_path / "6.csv", x, z, "x;z;x;z\n(um);(nm);(um);(nm)", ";")]
    lines = forms[-1].read_text().splitlines()  # two curves side by side, the second one shorter
    forms[-1].write_text("\n".join(lines[:2] + [f"{row};{row if k < 50 else ';'}" for k, row in enumerate(lines[2:])]) + "\n")
    made = []
    for form in forms:
        expect(0, "", f"profile {form} --output {tmp_path / 't.csv'}")
        made.append(table(tmp_path / "t.csv"))
    assert all(other == made[0] for other in made[1:])
    for bare in (write(tmp_path / "b.txt", x, z, "", " "), write(tmp_path / "c.txt", x, z, "Scan 12\nspeed 2 um/s\n", "\t")):
        expect(0, "", f"profile {bare} --units um,nm --output {tmp_path / 't.csv'}")
        assert table(tmp_path / "t.csv") == made[0]
    bare.write_text("\n".join(["1 2"] * 40 + ["x z", "um nm"]) + "\n")  # names and units below the rows hid all rows
    expect(4, "*:41: column 1 is x: expected a finite number", f"profile {bare} --units um,nm")
    metres = write(tmp_path / "m.csv", x, [height * 1e-3 for height in z], "lateral,height")
    expect(0, "", f"profile {metres} --units um,um --output {tmp_path / 't.csv'}")
    names, rows = table(tmp_path / "t.csv")
    assert names == ["r_um", "gap_um"]
    assert all(a[0] == b[0] and a[1] == pytest.approx(1e3 * b[1], abs=2e-3) for a, b in zip(made[0][1], rows))


def test_rows_that_are_not_heights_or_equidistant(tmp_path):
    x, z, body = scan(5, noise=0.1, rows=700)
    keep = [k for k in range(len(x)) if k % 3 or k % 5]
    path = write(tmp_path / "s.csv", [x[k] for k in keep], [z[k] for k in keep])
    path.write_text(path.read_text().replace("\n", "\n1.23456,nan\n2.3456,BAD\n", 1))
    out = expect(0, "", f"profile {path} --output {tmp_path / 't.csv'}").out
    assert "2 rows without a height are left out" in out and "joined by straight lines" in out
    assert numbers(out, "apex", "= ")[0] == pytest.approx(body["axis"], abs=0.05)
    of = random.Random(9)
    places = sorted(of.uniform(-20, 20) for _ in range(800))  # noise is not amplified between rows that are near to each other
    path = write(tmp_path / "r.csv", places, [-1e3 * gap(at, 25, False) + of.gauss(0, 1) for at in places])
    expect(0, "", f"profile {path} --output {tmp_path / 't.csv'}")
    off = [g - 1e3 * gap(r, 25, False) for r, g in table(tmp_path / "t.csv")[1]]
    mean = sum(off) / len(off)
    assert math.sqrt(sum((o - mean) ** 2 for o in off) / len(off)) < 1


@pytest.mark.parametrize("flat, axis, tilt", [(6, 0, 0), (12, 0.6, 0), (6, 0.3, 0.05), (12, -0.4, 0.02), (0, 0.5, 0)])
def test_truncated_tips(tmp_path, flat, axis, tilt):
    """The highest point of a flat is noise, and of a tilted one its edge: neither is the axis."""
    of = random.Random(flat)
    x = [round(-20 + 0.25 * k, 4) for k in range(161)]
    z = [1e3 * (tilt * at - max((at - axis) ** 2 - flat**2, 0) / 50) + of.gauss(0, 1) for at in x]
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, z)} --output {tmp_path / 't.csv'}").out
    assert numbers(out, "apex", "= ")[0] == pytest.approx(axis, abs=0.13)
    assert "more than noise" not in out


def test_warnings(tmp_path):
    """Waves that the rows do not resolve are not smoothed away without a word; outliers are said; an unknown uncertainty is not 0."""
    x = [round(-20 + 0.25 * k, 4) for k in range(161)]
    of = random.Random(1)
    waves = [-1e3 * (at**2 / 50 + 0.005 * (1 - math.cos(2 * math.pi * at))) + of.gauss(0, 0.1) for at in x]
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, waves)} --output {tmp_path / 't.csv'}").out
    assert "warning  the sides agree better than the noise" in out and "--smooth" not in out
    spike = [-1e3 * at**2 / 50 + of.gauss(0, 1) + 3000 * (at == -10) for at in x]
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, spike)} --output {tmp_path / 't.csv'}").out
    assert "warning  far from the smooth curve: 1 of the rows, the first at x = -10 um" in out


def test_units_in_a_line_of_their_own(tmp_path):
    """Also in tables of profiles."""
    x, z, _ = scan(2)
    path = write(tmp_path / "s.csv", x, z, "µm;nm", ";", before="x;z\n")
    out = expect(0, "", f"profile {path} --output {tmp_path / 't.csv'}").out
    assert "x (um)" in out.replace("µ", "u") and table(tmp_path / "t.csv")[0] == ["r_um", "gap_nm"]
    body = {"r_um,gap_nm": "name.csv", "r,gap\n[um],[nm]": "below.csv"}
    scene = "--from-physical --modulus-pa 3e9 --work-j-per-m2 0.05 --distance-m 1e-9"
    forces = []
    for head, name in body.items():
        path = write(tmp_path / name, [0.1 * k for k in range(60)], [0.2 * k * k for k in range(60)], head)
        forces.append(expect(0, "", f"solve {scene} --profile-file {path} --json").json["physical"]["pull_off"]["force_n"])
    assert forces[0] == forces[1]


def test_force_of_mean_and_sides(tmp_path):
    """That of the body, and of bodies with the curvatures of the sides."""
    x, z, _ = scan(7, wavy=False, tilt=0.0, noise=0.05, rows=500)
    scene = "--from-physical --modulus-pa 3e9 --work-j-per-m2 0.05 --distance-m 1e-9"
    axis = 0.37
    heights = [-1e3 * (at - axis) ** 2 / 2 / (20 if at > axis else 25) + 0.05 * random.Random(k).gauss(0, 1) for k, at in enumerate(x)]
    out = expect(0, "", f"profile {write(tmp_path / 's.csv', x, heights)} --output {tmp_path / 't.csv'} {scene}").out
    mean, = numbers(out, "force", "force ")
    left, right, apart = numbers(out, "         of the left", "left side alone ", "right side alone ", "uncertain by ")
    for force, radius in ((mean, 2 / (1 / 20e-6 + 1 / 25e-6)), (left, 25e-6), (right, 20e-6)):
        smooth = expect(0, "", f"solve {scene} --radius-m {radius:.9g} --json").json["physical"]["pull_off"]["force_n"]
        assert force * 1e-6 == pytest.approx(smooth, rel=0.02)
    assert apart == pytest.approx(abs(left - right) / 2, rel=0.05)
    assert (tmp_path / "t.left.csv").exists() and (tmp_path / "t.right.csv").exists()


@pytest.mark.parametrize("message, words", [
    ("pulloff: no scan is named: expected the name of a file", "profile"),
    ("*there is no column foo: expected one of the 2", "profile s.csv --columns x_um,foo"),
    ("*columns is x: expected two names or numbers, X,Z", "profile s.csv --columns x"),
    ("*units is um,kg: expected two of m, mm, um, nm or pm with a comma between", "profile s.csv --units um,kg"),
    ("pulloff: end is 99: expected a radius up to *", "profile s.csv --end 99"),
    ("*the lowest part is at x = *, the end of the scan: *", "profile s.csv --apex lowest"),
    ("*apex is top: expected highest or lowest*", "profile s.csv --apex top"),
    ("*side is middle: expected both, left or right*", "profile s.csv --side middle"),
    ("pulloff: a force needs --output, the file of the table", "profile s.csv --coupling 1"),
    ("pulloff: --side is left: a force is computed of both", "profile s.csv --side left --output t.csv --coupling 1"),
    ("pulloff: --output is s.csv: expected another file than the scan", "profile s.csv --output s.csv"),
    ("pulloff: the columns x and z have no units: expected --units", "profile none.csv --output t.csv --from-physical --modulus-pa 1e9 "
     "--work-j-per-m2 0.1 --distance-m 1e-9"),
    ("*one has a unit at the end of its name: expected *", "profile half.csv"),
    ("*12 rows with a height are too few: expected at least 32", "profile few.csv"),
])
def test_messages(tmp_path, monkeypatch, message, words):
    monkeypatch.chdir(tmp_path)
    x, z, _ = scan(1)
    write(tmp_path / "s.csv", x, z)
    write(tmp_path / "half.csv", x, z, "x_um,height")
    write(tmp_path / "none.csv", x, z, "x,z")
    write(tmp_path / "few.csv", x[:12], z[:12])
    done = run(words)
    assert done.code in (2, 4) and done.out == ""
    expect(done.code, message, words)
