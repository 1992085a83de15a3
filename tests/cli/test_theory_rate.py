"""pulloff theory persson-brener, a viscoelastic body without a solve, beside an evaluation that shares nothing with the program:
the work of adhesion by the integral that defines it, over the frequencies, with the complex modulus of the material; and the
path of the contact edge as an ordinary differential equation in time."""

import json
import math

import numpy as np
import pytest
from conftest import document, expect
from scipy.integrate import quad, solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

BODY = "time,modulus\n0.02,6\n0.5,3\ninf,1\n"
PEAK = 16 / (9 * math.sqrt(3))  # of the Lennard-Jones law, w/epsilon


def length(coupling):
    """That of the edge: 8 times 1/(pi c s^2), with the greatest tension s of the law."""
    return 8 / (math.pi * coupling * PEAK**2)


def loss_of(material):
    """k, and Im J(omega)/omega over the relaxed compliance as a function of ln omega."""
    name, _, rest = material.partition(":")
    if name == "prony":  # of the complex modulus, not of the retardation times that the program computes
        def modulus(y):
            return 1 + sum(e * 1j * y * t / (1 + 1j * y * t) for t, e in ((0.02, 6), (0.5, 3)))
        return 0.1, lambda s: -(1 / modulus(math.exp(s))).imag / math.exp(s)
    k, n = [*map(float, rest.split(",")), None][:2]
    if name == "sls":
        return k, lambda s: (1 - k) / (1 + math.exp(2 * s))

    def of_spectrum(s):
        def part(u):  # tau = exp(u)
            return math.exp((n + 1) * u - math.exp(u)) / (1 + math.exp(2 * (s + u)))
        return (1 - k) / math.gamma(n) * quad(part, -40 / n, 4.5, points=sorted({min(max(-s, -39 / n), 4.4), 0.0}),
                                              epsabs=1e-14, epsrel=1e-11, limit=400)[0]

    at = np.linspace(-60, 45, 2000)
    spline = CubicSpline(at, [math.log(of_spectrum(s)) for s in at])
    return k, lambda s: math.exp(spline(s))


def work(loss, x):
    """Gamma/w: 1 less the integral up to the frequency 1/x of the edge, inverted."""
    top = -math.log(x)

    def part(s):  # of ln omega
        return math.sqrt(-math.expm1(2 * (s - top))) * loss(s) * math.exp(s)
    return 1 / (1 - 2 / math.pi * quad(part, top - 40, top, points=[top - 20, top - 5, top - 1], epsabs=1e-13, epsrel=1e-11, limit=400)[0])


def greatest(material, tabor, speed, preload):
    """The greatest tension of a sphere with R = 100."""
    k, loss = loss_of(material)
    radius, c = 100, tabor**1.5 / 10
    x = np.exp(np.linspace(9, -9, 90))
    gain = np.array([work(loss, one) for one in x])
    # v from Gamma: both go over many decades
    law = CubicSpline(np.log((gain - 1) / (1 / k - gain)), np.log(gain / (2 * math.pi * x) * length(c)))

    def approach(a, gamma=1.0):
        return a * a / radius - math.sqrt(2 * math.pi * a * c * gamma)
    begin = brentq(lambda a: approach(a) - preload, (math.pi * c * radius**2 / 8) ** (1 / 3), 1e3)

    def edge(t, a):
        gamma = (a[0] ** 2 / radius - (preload - speed * t)) ** 2 / (2 * math.pi * a[0] * c)
        if gamma <= gain[0]:
            return [0.0]  # slower than 1e-4 of the speeds that matter
        return [-math.exp(law(math.log((min(gamma, gain[-1]) - 1) / (1 / k - min(gamma, gain[-1])))))]

    def end(_, a):
        return a[0] - 5
    end.terminal = True
    last = (preload + 40) / speed
    path = solve_ivp(edge, (0, last), [begin], method="LSODA", rtol=1e-9, atol=1e-9, events=end, max_step=last / 3000)
    a, pull = path.y[0], path.y[0] ** 2 / radius - (preload - speed * path.t)
    return (2 * a * pull / (math.pi * c * radius) - 4 * a**3 / (3 * math.pi * c * radius**2)).max()


def words_of(material, folder):
    (folder / "body.csv").write_text(BODY)
    return f"--viscoelastic {material.replace('prony:', f'prony:{folder}/')}"


@pytest.mark.parametrize("material, speed", [("sls:0.1", 1), ("sls:0.02", 100), ("gamma:0.1,0.6", 3), ("prony:body.csv", 0.3),
                                             ("prony:body.csv", 30)])
def test_against_the_integral_over_the_frequencies(material, speed, tmp_path):
    words = words_of(material, tmp_path)
    found = document(f"theory persson-brener --tabor 3 --preload 8 --unload-speed {speed} {words}")
    # the speed of the edge and its work of adhesion obey the law
    c = 3**1.5 / 10
    x = found["effective_work"] / (2 * math.pi * found["edge_speed"] / length(c))
    assert found["effective_work"] == pytest.approx(work(loss_of(material)[1], x), rel=1e-7)
    assert 1.01 < found["effective_work"] < 0.95 / loss_of(material)[0]
    # the state is one of JKR with this work of adhesion
    a = found["pull_off_contact_radius"]
    assert found["pull_off_approach"] == pytest.approx(a * a / 100 - math.sqrt(2 * math.pi * a * c * found["effective_work"]), rel=1e-12)
    assert found["pull_off_force"] == pytest.approx(greatest(material, 3, speed, 8), rel=4e-4)
    assert found["relaxed_force"] < found["pull_off_force"] < found["at_once_force"]


def test_the_limits_are_those_of_jkr():
    """At rest JKR of the relaxed body; at once JKR with w/k, whose greatest tension is at the preload if that makes a narrow
    contact."""
    def at(speed, preload, k=0.25):
        return document(f"theory persson-brener --tabor 4 --viscoelastic sls:{k} --unload-speed {speed} --preload {preload}")
    jkr = document("theory jkr --tabor 4")
    for preload in 3, 80:
        slow = at(0, preload)
        for name in ("force", "approach", "contact_radius"):
            assert slow[f"pull_off_{name}"] == pytest.approx(jkr[f"pull_off_{name}"], rel=1e-12), name
        assert (slow["effective_work"], slow["edge_speed"]) == (1, 0)
        assert slow["relaxed_force"] == slow["pull_off_force"]
        assert at(1e-9, preload)["pull_off_force"] == pytest.approx(1.5, rel=1e-6)
    glassy = f"theory jkr --coupling {4**1.5 / 10 / 0.25}"  # the lengths of JKR with w/k; loads in pi w R/k
    strong, fast = document(glassy), at("inf", 80)
    assert fast["pull_off_contact_radius"] == pytest.approx(strong["pull_off_contact_radius"], rel=1e-9)
    assert fast["pull_off_approach"] == pytest.approx(strong["pull_off_approach"], rel=1e-9)
    assert fast["pull_off_force"] == fast["at_once_force"] == pytest.approx(6, rel=1e-12)
    assert (fast["effective_work"], fast["edge_speed"]) == (4, None)
    assert at(1e12, 80)["pull_off_force"] == pytest.approx(6, rel=1e-6)
    narrow = at("inf", 3)
    held = document(f"{glassy} --contact-radius {narrow['reversal_contact_radius']}")
    assert narrow["reversal_approach"] == pytest.approx(3, rel=1e-12)
    assert narrow["pull_off_force"] == pytest.approx(-held["load"] * 4, rel=1e-12) and narrow["pull_off_force"] < 5.9
    assert narrow["pull_off_approach"] == pytest.approx(held["approach"], rel=1e-12)
    elastic = at(1, 80, k=1)
    assert elastic["pull_off_force"] == pytest.approx(1.5, rel=1e-7) and elastic["effective_work"] == 1


def test_no_speed_exceeds_the_force_at_once():
    """A parabola through the relaxed contact and the two states after it stated up to 1.14 times that."""
    for speed in "1e3", "5e4", "1e5", "1e6", "1e12", "1e40":
        found = document(f"theory persson-brener --tabor 3 --viscoelastic sls:0.2 --unload-speed {speed}")
        assert found["at_once_force"] == pytest.approx(7.5, rel=1e-12)
        assert 7.43 < found["pull_off_force"] < 7.5 * (1 + 1e-9), speed


@pytest.mark.parametrize("scene", ["--tabor 2 --preload 4", "--tabor 2", "--profile cone:0.3 --coupling 0.05", "--tabor 2 --law morse:2",
                                   "--tabor 3 --amplitude 0.2 --wavelength 20 --preload 3"])
def test_compare_has_the_same(scene):
    scene += " --viscoelastic gamma:0.3,0.6 --unload-speed 2"
    rows = {row["theory"]: row["force"] for row in document(f"solve {scene} --want theories --tolerance 1e-2")["theories"]}
    alone = document(f"theory persson-brener {scene}")
    for theory, name in ("persson-brener", "pull_off_force"), ("jkr-at-once", "at_once_force"), ("jkr", "relaxed_force"):
        assert alone[name] == pytest.approx(rows[theory], rel=1e-8), theory


def test_si_units(tmp_path):
    tip = "theory persson-brener --from-physical --modulus-pa 1e6 --work-j-per-m2 0.05 --distance-m 1e-9 --radius-m 1e-6"
    found = document(f"{tip} --viscoelastic sls:0.1 --relaxation-time-s 1e-3 --unload-speed-m-per-s 1e-6 --preload-m 2e-8")
    scene = found["physical"]["input"]
    assert (scene["relaxation_time_s"], scene["unload_speed_m_per_s"]) == (1e-3, 1e-6)
    alone = document("theory persson-brener --coupling 50 --radius 1000 --viscoelastic sls:0.1 --unload-speed 1 --preload 20")
    for name in ("pull_off_force", "effective_work", "edge_speed", "at_once_force"):
        assert found[name] == pytest.approx(alone[name], rel=1e-10), name
    in_si = found["physical"]
    assert in_si["pull_off_force_n"] == pytest.approx(found["pull_off_force"] * math.pi * 0.05 * 1e-6, rel=1e-12)
    assert in_si["effective_work_j_per_m2"] == pytest.approx(found["effective_work"] * 0.05, rel=1e-12)
    printed = expect(0, "", f"{tip} --viscoelastic sls:0.1 --relaxation-time-s 1e-3 --unload-speed-m-per-s 1e-6 --preload-m 2e-8")
    assert printed.count("^edge_speed ") == 1 and printed.count("^pull_off_force .* nN$") + printed.count("^pull_off_force .* µN$") == 1
    (tmp_path / "s.csv").write_text(BODY.replace("time", "time_s"))
    assert document(f"{tip} --viscoelastic prony:{tmp_path}/s.csv --unload-speed-m-per-s 1e-9")["effective_work"] > 1.1


SOLID = "--viscoelastic sls:0.2 --unload-speed 1"


@pytest.mark.parametrize("code, message, words", [
    (2, "theory persson-brener needs --viscoelastic and --unload-speed", ""),
    (2, "theory persson-brener needs --viscoelastic and --unload-speed", "--viscoelastic sls:0.2"),
    (2, "theory persson-brener needs --viscoelastic and --unload-speed", "--unload-speed 1"),
    (2, "--viscoelastic is sls:2: expected sls:K or gamma:K,N, *", "--viscoelastic sls:2 --unload-speed 1"),
    (2, "--unload-speed is -1: expected a finite number >= 0, or inf", "--viscoelastic sls:0.2 --unload-speed -1"),
    (4, "no.csv cannot be opened: *", "--viscoelastic prony:no.csv --unload-speed 1"),
    (2, "--tabor is 0: expected a finite number > 0", f"--tabor 0 {SOLID}"),
    (2, "--preload is inf: expected a finite number", f"{SOLID} --preload inf"),
    (2, "loading to the preload, approach -3, makes no contact: expected a harder one", f"{SOLID} --preload -3"),
    (2, "--load has no effect on theory persson-brener: expected only *, --preload-load, --viscoelastic or --unload-speed",
     f"{SOLID} --load 1"),
    (2, "unknown option --load-speed of theory *", f"{SOLID} --load-speed 1"),
    (2, "theory persson-brener needs --viscoelastic and --unload-speed-m-per-s",
     "--from-physical --modulus-pa 1e6 --work-j-per-m2 0.05 --distance-m 1e-9 --radius-m 1e-6 --viscoelastic sls:0.2")])
def test_wrong_command_lines(code, message, words):
    expect(code, "pulloff: " + message, "theory persson-brener " + words)


@pytest.mark.parametrize("option", ["--viscoelastic sls:0.2", "--unload-speed 1"])
def test_other_forms_refuse_a_speed(option):
    expect(2, f"pulloff: {option.split()[0]} has no effect on theory jkr: *", f"theory jkr {option}")


def test_lines_of_a_case(tmp_path):
    """Force against speed as a line of a figure, without a solve."""
    speeds = [0, 0.1, 10]
    (tmp_path / "own.yaml").write_text(f"""name: own
title: Force against speed
suites: [own]
want: [pull_off]
scene: {{tabor: 1, radius: 100, outer_radius: .inf, scheme: panel, tolerance: 1e-2, viscoelastic: "sls:0.2", preload: 3, unload_speed: 1}}
lines:
  - {{name: theory, theory: persson-brener, sweep: [{{key: unload_speed, values: {speeds}}}]}}
""")
    expect(0, "*", f"run {tmp_path / 'own.yaml'} --output {tmp_path / 'out'}")
    record = json.loads((tmp_path / "out" / "own" / "record.json").read_text())
    text = next((tmp_path / "out" / "own").glob("*theory*.csv")).read_text().splitlines()
    table = [line.split(",") for line in text if not line.startswith("#")]
    column = table[0].index("pull_off_force")
    assert record["schema"] and [float(row[table[0].index("unload_speed")]) for row in table[1:]] == speeds
    for row, speed in zip(table[1:], speeds, strict=True):
        alone = document(f"theory persson-brener --tabor 1 --viscoelastic sls:0.2 --preload 3 --unload-speed {speed}")
        assert float(row[column]) == pytest.approx(alone["pull_off_force"], rel=1e-12)
