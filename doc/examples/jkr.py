from math import pi, sqrt

radius = 1 / (1 / 8e-6 + 1 / 12e-6)
modulus = 1 / ((1 - 0.49**2) / 2e6 + (1 - 0.45**2) / 5e6)     # E* of both bodies
work = 0.022 + 0.035 - 0.004                                  # w, not a surface energy


def state(a):
    """Approach and load at the contact radius a."""
    return a * a / radius - sqrt(2 * pi * work * a / modulus), 4 * modulus * a**3 / (3 * radius) - sqrt(8 * pi * work * modulus * a**3)


a0 = (9 * pi * work * radius**2 / (2 * modulus)) ** (1 / 3)   # without load
a1, a2 = a0 / 4 ** (1 / 3), a0 / 36 ** (1 / 3)                # at pull-off: fixed load, fixed grips
print("problem,quantity,value")
for name, value in [("zero_load_radius", a0), ("zero_load_approach", state(a0)[0]), ("pull_off_force", -state(a1)[1]),
                    ("pull_off_radius", a1), ("pull_off_approach", state(a1)[0]), ("grips_force", -state(a2)[1]),
                    ("grips_radius", a2), ("grips_approach", state(a2)[0])]:
    print(f"law-jkr,{name},{value!r}")
