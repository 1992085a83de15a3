"""The problem law-jkr of the adhesion sheet with LAMMPS: two particles with `pair_style granular`, contact `jkr`.

The particles are held and moved apart in steps; after each the force is printed. LAMMPS gives no contact radius. Its surface
energy is w/2, and its moduli are those that give E* of the problem. The second particle moves from the greatest approach
downwards, because contact exists below approach 0 only if there was contact before.
"""

import resource
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from numpy.polynomial import Chebyshev

PROGRAM = "lmp"
SCAN, NODES, ROUNDS = 400, 14, 4     # steps of a scan; nodes of a polynomial; rounds that locate the end of contact
SCRIPT = """units si
atom_style sphere
boundary f f f
newton off
neighbor 1e-7 bin
comm_modify vel yes
region box block -1e-4 1e-4 -1e-4 1e-4 -1e-4 1e-4
create_box 2 box
create_atoms 1 single 0 0 0
create_atoms 2 single 0 0 {first:.17e}
set type 1 diameter {one:.17e}
set type 2 diameter {two:.17e}
set group all density 1000
pair_style granular
pair_coeff * * jkr {young:.17e} 0 {poisson} {surface:.17e} tangential linear_nohistory 0 0 damping velocity
timestep 1e-12
neigh_modify delay 1000000 every 1 check no
group second type 2
compute force second reduce sum fz
variable away equal {away}
variable zero equal 0.0
fix hold second move variable NULL NULL v_away NULL NULL v_zero
thermo 1
thermo_style custom step c_force
thermo_modify lost ignore format float %.17g
run {count}
"""


class NotAsked(Exception):
    """The program has no such problem."""


def found():
    return shutil.which(PROGRAM) is not None


def version():
    text = subprocess.run([PROGRAM, "-h"], check=True, capture_output=True, text=True).stdout
    return "LAMMPS " + next(line for line in text.splitlines() if "Simulator" in line).split(" - ", 1)[1].strip()


class Contact:
    """Forces at approaches, of two spheres."""

    def __init__(self, p):
        self.diameters = 2.0 * p["R1"], 2.0 * p["R2"]
        self.work = p["gamma1"] + p["gamma2"] - p["gamma12"]
        self.modulus = 1.0 / sum((1.0 - p[f"nu{i}"]**2) / p[f"E{i}"] for i in (1, 2))
        self.poisson = 0.3
        self.touching = 0.5 * sum(self.diameters)

    def loads(self, approaches):
        """Loads (compressive > 0) at decreasing approaches."""
        moves = self.start - np.asarray(approaches)
        away = " + ".join(f"(step == {i + 1})*{move:.17e}" for i, move in enumerate(moves))
        text = SCRIPT.format(first=self.touching - self.start, one=self.diameters[0], two=self.diameters[1],
                             young=2.0 * self.modulus * (1.0 - self.poisson**2), surface=0.5 * self.work, poisson=self.poisson,
                             away=away.replace(" ", ""), count=len(moves))
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "in.jkr").write_text(text)
            done = subprocess.run([PROGRAM, "-in", "in.jkr", "-log", "none"], cwd=folder, check=False, capture_output=True, text=True)
        rows = [line.split() for line in done.stdout.splitlines() if line.strip() and line.split()[0].isdigit()]
        found = {int(row[0]): float(row[1]) for row in rows if len(row) == 2}
        if len(found) != len(moves) + 1:
            raise RuntimeError("LAMMPS: " + next((line for line in done.stdout.splitlines() if "ERROR" in line), done.stderr))
        return np.array([found[i + 1] for i in range(len(moves))])

    start = 5e-7           # approach from which the particles are moved apart


def around(contact, middle, span):
    """The load near an approach as a polynomial."""
    nodes = middle + span * np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
    return Chebyshev.fit(nodes, contact.loads(nodes), NODES - 1, [middle - span, middle + span])


def root(polynomial, middle):
    return min((x.real for x in polynomial.roots() if abs(x.imag) < 1e-6 * abs(middle)), key=lambda x: abs(x - middle))


def end_of_contact(contact, last, beyond):
    """The lowest approach with contact, between one with and one without it."""
    for _ in range(ROUNDS):
        at = np.linspace(last, beyond, SCAN)
        held = np.flatnonzero(contact.loads(at) != 0.0)[-1]
        last, beyond = at[held], at[min(held + 1, SCAN - 1)]
    return last


def solve(problem):
    """The answers to law-jkr, and the seconds of processor time."""
    if problem["id"] != "law-jkr":
        raise NotAsked
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    p = {key: float(value) for key, value in problem["parameters"].items()}
    contact = Contact(p)
    scan = np.linspace(4.5e-7, -4.5e-7, SCAN)
    loads = contact.loads(scan)
    held = np.flatnonzero(loads != 0.0)[-1]
    lowest, zero = scan[np.argmin(loads)], scan[np.flatnonzero(loads > 0.0)[-1]]
    end = end_of_contact(contact, scan[held], scan[held + 1])
    # contact may end where the load is lowest
    lowest = end if np.argmin(loads) == held else root(around(contact, lowest, 0.25 * (lowest - end)).deriv(), lowest)
    zero = root(around(contact, zero, 2e-8), zero)
    # near the end the load changes with the root of the distance
    x, weights = np.polynomial.legendre.leggauss(40)
    length = np.sqrt(zero - end)
    s = 0.5 * length * (1.0 - x)
    work = -np.sum(0.5 * length * weights * 2.0 * s * contact.loads(end + s**2))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    answers = {"pull_off_force": -contact.loads([lowest])[0], "pull_off_approach": lowest,
               "grips_force": -contact.loads([end])[0], "grips_approach": end, "zero_load_approach": zero,
               "load_at_approach": contact.loads([p["D1"]])[0], "work_to_separate": work}
    return answers, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
