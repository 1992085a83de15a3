"""The contact laws and rigid bodies of the adhesion sheet in mpmath: the second route, beside the intervals of balls/.

JKR and Maugis-Dugdale are those of any profile (jkr_profiles.py, maugis_profiles.py), by quadrature over the slope of
the profile; lowest loads and approaches are roots of difference quotients; works are differences of energies or
integrals of polynomials through states. Rigid loads are quadratures of the pressure. The parameters of a problem are
texts of decimal numbers; each function returns {quantity: number}.
"""

from mpmath import chebyt, cos, cot, diff, inf, mp, mpf, nstr, pi, quad, radians, sqrt

from jkr_profiles import Profile, jkr
from maugis_profiles import maugis

DIGITS = 30                # carried here
SPARE = 8                  # of them not in roots; difference quotients carry more digits, of roots too


def root(function, low, high):
    """A root between two numbers of different signs: false position, the weight of an end that stays is halved."""
    below, above = function(low), function(high)
    if below * above > 0:
        raise ValueError(f"no change of sign between {nstr(low, 10)} and {nstr(high, 10)}")
    last, tolerance = low, mpf(10) ** (SPARE - mp.dps)
    while True:
        x = high - above * (high - low) / (above - below)
        value = function(x)
        if abs(x - last) <= tolerance * abs(x) or value == 0:
            return x
        last = x
        if value * above < 0:
            low, below = high, above
        else:
            below /= 2
        high, above = x, value


def bracket(function, low, high, steps=60):
    """The greatest part of [low, high], in equal ratios, over which the function changes its sign."""
    points = [low * (high / low) ** (mpf(i) / steps) for i in range(steps, -1, -1)]
    kept, mp.dps = mp.dps, 15
    try:
        signs = [function(x) > 0 for x in points]
    finally:
        mp.dps = kept
    first = next(i for i in range(steps) if signs[i] != signs[i + 1])
    return points[first + 1], points[first]


def slope_of(state, index):
    """The derivative of approach (index 0) or load (1) by the contact radius."""
    return lambda a: diff(lambda x: state(x)[index], a)


# ------------------------------------------------------------------------------------ JKR theory

def jkr_energy(profile, coupling, a, approach):
    """Elastic energy E* int_0^a (D - g)^2 dx less the energy of adhesion pi w a^2, with g from the slope."""
    kept, mp.dps = mp.dps, 22
    try:
        square = quad(lambda x: (approach - profile.g_of_slope(x)) ** 2, [0, a / 2, a])
    finally:
        mp.dps = kept
    return square / coupling - pi * a * a


def jkr_states(words, coupling, high):
    """The quantities of a JKR contact in the units of jkr_profiles.py with loads in w epsilon."""
    profile, k = Profile(words, "-", "-"), mpf(coupling)

    def state(a):
        approach, load = jkr(profile, k, a, closed=False)
        return approach, load * pi

    def at(function):
        return root(function, *bracket(function, high / 500, high))

    result, ends = {}, {}
    for name, function in (("pull_off", slope_of(state, 1)), ("grips", slope_of(state, 0)),
                           ("zero_load", lambda a: state(a)[1])):
        a = at(function)
        ends[name] = a, *state(a)
        result[f"{name}_radius"], result[f"{name}_approach"] = ends[name][:2]
        if name != "zero_load":
            result[f"{name}_force"] = -ends[name][2]
    energies = [jkr_energy(profile, k, *ends[name][:2]) for name in ("grips", "zero_load")]
    result["work_to_separate"] = energies[0] - energies[1]
    return result, state


def contact_modulus(p, *bodies):
    """E* of bodies whose parameters end with these texts."""
    return 1 / sum((1 - mpf(p[f"nu{i}"]) ** 2) / mpf(p[f"E{i}"]) for i in bodies)


def law_jkr(p):
    """Two spheres: lengths in um and the load in w times 1 um."""
    modulus, unit = contact_modulus(p, 1, 2), mpf(10) ** -6
    work = mpf(p["gamma1"]) + mpf(p["gamma2"]) - mpf(p["gamma12"])
    radius = 1 / (1 / mpf(p["R1"]) + 1 / mpf(p["R2"]))
    sphere = f"power:{nstr(unit / (2 * radius), 40)};2"
    found, state = jkr_states(sphere, work / (modulus * unit), radius / unit)
    target = mpf(p["D1"]) / unit
    a = root(lambda a: state(a)[0] - target, *bracket(lambda a: state(a)[0] - target, mpf(1), radius / unit))
    scale = {"force": work * unit, "separate": work * unit ** 2}
    result = {name: value * scale.get(name.split("_")[-1], unit) for name, value in found.items()}
    result["load_at_approach"] = state(a)[1] * work * unit
    return result


def law_cone(p):
    return jkr_states(f"cone:{nstr(cot(radians(mpf(p['half_angle_degrees']))), 40)}", 1, mpf(200))[0]


def law_power(p):
    return jkr_states(f"power:{p['C']};{p['n']}", 1, mpf(20))[0]


def law_exact_sphere(p):
    return jkr_states(f"exact_sphere:{p['R']}", 1, mpf(p["R"]) * mpf("0.99"))[0]


def law_hyperboloid(p):
    return jkr_states(f"hyperboloid:{p['t']};{p['b']}", 1, mpf(60))[0]


# ------------------------------------------------------------------------- DMT and the flat punch

def law_dmt(p):
    """The load as a function of the approach, its root and its integral."""
    modulus, radius, work, unit = contact_modulus(p, 1, 2), mpf(p["R"]), mpf(p["w"]), mpf(10) ** -10

    def load(d):
        return mpf(4) / 3 * modulus * sqrt(radius) * (d * unit) ** mpf("1.5") - 2 * pi * work * radius

    zero = root(lambda d: load(d) * 10 ** 8, *bracket(load, mpf("0.1"), mpf(10)))
    return {"pull_off_force": -load(mpf(0)), "zero_load_approach": zero * unit,
            "zero_load_radius": sqrt(radius * zero * unit), "load_at_approach": load(mpf(p["D1"]) / unit),
            "work_to_separate": -quad(load, [0, zero]) * unit}


def law_flat_punch(p):
    """The energy release rate at a force is its square by the derivative of the compliance 1/(2 E* a) by the area,
    over -2."""
    modulus, radius, work = contact_modulus(p, ""), mpf(p["a"]), mpf(p["w"])

    def compliance(a):
        return 1 / (2 * modulus * a * radius)      # at a times the radius

    rate = -diff(compliance, 1) / (2 * 2 * pi * radius ** 2)
    force = sqrt(work / rate)
    approach = -force * compliance(1)
    return {"pull_off_force": force, "pull_off_approach": approach, "work_to_separate": -force * approach / 2,
            "load_at_approach": mpf(p["D1"]) / compliance(1)}


# ---------------------------------------------------------------------------------- Maugis-Dugdale

SPHERE, RADIUS, TENSION = Profile("sphere", "-", "100"), mpf(100), mpf("1.3")
NODES = 44                 # of the polynomials whose integral is the work


class Maugis:
    """States of a sphere of R = 100 with a tension of 1.3 w/epsilon, as functions of the contact radius, in the units
    of Maugis."""

    def __init__(self, number):
        self.coupling = sqrt((number / TENSION * (2 * pi / 9) ** (mpf(1) / 3)) ** 3 / RADIUS)
        stiffness = 4 / (3 * self.coupling)
        self.length = (pi * RADIUS ** 2 / stiffness) ** (mpf(1) / 3)
        self.height = (pi ** 2 * RADIUS / stiffness ** 2) ** (mpf(1) / 3)
        self.width = mpf(1)         # of the ring of tension, the last one

    def end(self, a):
        """The end of the tension, in epsilon."""
        def far(c):
            return maugis(SPHERE, self.coupling, TENSION, a, c)[2]

        low, high = self.width * mpf("0.99"), self.width * mpf("1.01")
        while far(a + low) > 0:
            low /= 2
        while far(a + high) < 0:
            high *= 2
        self.width = root(lambda width: far(a + width), low, high)
        return a + self.width

    def state(self, a):
        """(approach, load) at a contact radius."""
        a *= self.length
        approach, load, _ = maugis(SPHERE, self.coupling, TENSION, a, self.end(a), closed=False)
        return approach / self.height, load / RADIUS

    def work(self, low, high):
        """The integral of P dD between two contact radii, of the polynomials through Chebyshev nodes."""
        nodes = [cos(pi * (i + mpf(1) / 2) / NODES) for i in range(NODES)]
        states = [self.state((low + high + (low - high) * x) / 2) for x in nodes]   # from high to low
        approach, load = ([2 * sum(s[k] * chebyt(j, x) for s, x in zip(states, nodes)) / NODES for j in range(NODES)]
                          for k in (0, 1))
        approach[0] /= 2
        load[0] /= 2

        def rate(x):
            slope = diff(lambda y: sum(c * chebyt(j, y) for j, c in enumerate(approach)), x)
            return slope * sum(c * chebyt(j, x) for j, c in enumerate(load))

        return quad(rate, [-1, 1])


def law_maugis(p):
    number = mpf(p["lambda"])
    contact, result = Maugis(number), {}
    zero = root(lambda a: contact.state(a)[1], mpf(1), mpf(2))
    result["zero_load_radius"], result["zero_load_approach"] = zero, contact.state(zero)[0]
    lowest = root(slope_of(contact.state, 1), mpf("0.1"), zero)
    approach, load = contact.state(lowest)
    result.update(pull_off_radius=lowest, pull_off_approach=approach, pull_off_force=-load)
    slope = slope_of(contact.state, 0)
    if slope(mpf("0.02")) < 0:
        last = root(slope, mpf("0.02"), lowest)
        approach, load = contact.state(last)
        result.update(grips_radius=last, grips_approach=approach, grips_force=-load,
                      work_to_separate=contact.work(last, zero))
    else:
        result.update(without_contact(number, contact, zero))
    return result


def without_contact(number, contact, zero):
    """The lowest approach of states whose tension acts on r < c: the gap at the axis is greater than 0, that at c is
    w/s; the disc of tension deflects the edge by 4 s c/(pi E*), the axis by 2 s c/E* (Love 1929)."""
    k, q = contact.coupling, TENSION

    def approach(c):
        return c * c / (2 * RADIUS) - 4 * q * k * c / pi - 1 / q

    touching = root(lambda c: approach(c) + 2 * q * k * c, mpf(1) / 1000, sqrt(3 * RADIUS))
    last = root(lambda c: diff(approach, c), mpf(1) / 10 ** 6, touching)
    open_work = quad(lambda c: -q * c * c / RADIUS * diff(approach, c), [touching, last])
    return {"grips_approach": approach(last) / contact.height, "grips_force": q * last ** 2 / RADIUS,
            "work_to_separate": open_work / contact.height + contact.work(mpf(0), zero)}


# ------------------------------------------------------------------------------------ rigid bodies

def pressure(h):
    return -mpf(8) / 3 * (h ** -3 - h ** -9)


def plane_load(gap, pieces, radius):
    """(2/R) int p r dr."""
    return 2 / radius * quad(lambda r: pressure(gap(r)) * r, pieces)


def lowest_load(load, low, high):
    """(approach, load) of the minimum in a bracket."""
    approach = root(lambda d: diff(load, d), low, high)
    return approach, load(approach)


def rigid_sphere(p):
    """The tip of R = 1 on the unbounded plane."""
    def load(d):
        return plane_load(lambda r: 1 + r * r / 2 - d, [0, 1, 3, 10, inf], mpf(1))

    zero = root(load, mpf("0.1"), mpf("0.4"))
    return {"pull_off_force": -lowest_load(load, mpf("-0.2"), mpf("0.1"))[1], "load_at_approach": load(mpf(p["D1"])),
            "load_near": load(mpf(p["D2"])), "zero_load_approach": zero,
            "work_to_separate": -quad(lambda h: load(1 - h), [1 - zero, 2, 5, 20, inf])}


def rigid_truncated(p):
    b, radius = mpf(p["b"]), mpf(p["R"])

    def load(d):
        return plane_load(lambda r: 1 - d + (0 if r < b else (r * r - b * b) / (2 * radius)),
                          [0, b, b + 3, 3 * b, 10 * b, inf], radius)

    approach, least = lowest_load(load, mpf("-0.3"), mpf("-0.01"))
    return {"pull_off_force": -least, "pull_off_approach": approach, "load_at_approach": load(mpf(p["D1"]))}


def rigid_wavy(p):
    radius, amplitude, length, cut = (mpf(p[key]) for key in ("R", "A", "wavelength", "outer_radius"))
    halves = int(2 * cut / length)

    def load(d):
        return plane_load(lambda r: 1 - d + r * r / (2 * radius) + amplitude * (1 - cos(2 * pi * r / length)),
                          [length * i / 2 for i in range(halves)] + [cut], radius)

    kept, mp.dps = mp.dps, 15
    try:                   # every approach up to the repulsion at the axis
        scan = [mpf(i) / 20 for i in range(-60, 19)]
        lowest = min(scan, key=load)
    finally:
        mp.dps = kept
    approach, least = lowest_load(load, lowest - mpf(1) / 20, lowest + mpf(1) / 20)
    return {"pull_off_force": -least, "pull_off_approach": approach, "load_at_approach": load(mpf(p["D1"]))}


BY_PROBLEM = {"law-jkr": law_jkr, "law-dmt": law_dmt, "law-maugis": law_maugis, "law-cone": law_cone,
              "law-power": law_power, "law-flat-punch": law_flat_punch, "law-exact-sphere": law_exact_sphere,
              "law-hyperboloid": law_hyperboloid, "rigid-sphere": rigid_sphere, "rigid-truncated": rigid_truncated,
              "rigid-wavy": rigid_wavy}


def solve(name, parameters):
    """The quantities of a problem; law-maugis-0.1 and others are those of law-maugis."""
    kept, mp.dps = mp.dps, DIGITS
    try:
        return BY_PROBLEM["law-maugis" if name.startswith("law-maugis") else name](parameters)
    finally:
        mp.dps = kept
