"""Wrong usage: the message is one line that names the mistake, and the exit code is 2. The help of every verb has an example."""

import pytest
from conftest import expect

VERBS = "solve compare follow theory contact-law profile fit plot list plan run merge verify explain bless conform seal report".split()


def test_help():
    assert expect(0, "", "--help").out == expect(0, "", "-h").out and expect(0, "", "--version").out
    for verb in VERBS:
        said = expect(0, "", f"{verb} --help").has(f"^Example: pulloff {verb}")
        assert max(map(len, said.out.splitlines())) <= 100
        for words in "-h", "word -h":
            assert expect(0, "", f"{verb} {words}").out == said.out
        expect(2, f"pulloff: unknown option --frobnicate of {verb} (see pulloff {verb} --help)", f"{verb} --frobnicate")
        expect(2, f"pulloff: --help=3 of {verb} has a value: expected --help without one (see pulloff {verb} --help)", f"{verb} word --help=3")


def test_options_beside_operands():
    """Operands before options, letters with a value attached, values of options that take none, and beginnings of several options:
    "run smoke -j2" ended with "unknown option smoke"."""
    for given in "-q2", "word -q 2", "word other -qx":
        expect(2, "pulloff: unknown option -q of run (see pulloff run --help)", f"run {given}")
    for verb in "run", "verify", "explain", "bless":
        for given in "-jx word", "-j x word", "word -jx", "word --jobs=x", "word --job x":
            expect(2, "pulloff: --jobs is x: expected a whole number, 0 for all cores", f"{verb} {given}")
        expect(2, f"pulloff: the option -j of {verb} needs a value (see pulloff {verb} --help)", f"{verb} word -j")
    expect(2, "pulloff: no case is named word: *", "run word -j2")


# A word that is close to a known one: the message ends with the known one.
SLIPS = [(f"*; did you mean {known}?", words) for words, known in (
    ("slove", "solve"), ("solve --amplitud 3", "--amplitude"), ("solve --outer_radius 3", "--outer-radius"), ("solve --pre 3", "--preload"),
    ("solve --want curve,histeresis", "hysteresis"), ("solve --law morze:2", "morse"), ("solve --scheme pannel", "panel"),
    ("theory jrk", "jkr"), ("theory DMT", "dmt"), ("compare --theory mauguis", "maugis"), ("run fig4", "fig04"),
    ("run --suite papr", "paper"), ("follow --key tabr", "tabor"))]
POINTS = "expected A-B or one number, counted from 0, or several with commas"
SUITES = "extreme, general, paper, precision, random, rate, smoke, solvers, theories"
USAGE = [
    ("no verb is given: expected solve, compare, follow, theory, contact-law, profile, fit, plot, list, plan, run, merge, verify, explain, *", ""),
    ("unknown verb dance: expected solve, compare, follow, theory, contact-law, profile, fit, plot, list, *", "dance"),
    ("unknown option --frobnicate=3 of run (see pulloff run --help)", "run word other --frobnicate=3"),
    ("unknown option -j of list (see pulloff list --help)", "list word -j2"),
    ("--out of solve is the beginning of several options: expected one of --outer-radius, --outer-radius-m*", "solve --out 3"),
    *((f"--tabor is {value or 'empty'}: expected a finite number >= 0", f"solve --tabor '{value}'") for value in ("abc", "nan", "")),
    ("the option --tabor of solve needs a value (see pulloff solve --help)", "solve --tabor"),
    ("--radius is -3: expected a finite number > 0", "solve --radius -3"),
    ("--outer-radius is nan: expected a finite number > 0, or inf", "solve --outer-radius nan"),
    ("--scheme is square: expected ring, triangle or panel", "solve --scheme square"),
    ("--grading is steep: expected uniform or graded", "solve --grading steep"),
    *((f"--nodes is {value}: expected a whole number > 0", f"solve --nodes {value}") for value in ("2.5", "-7")),
    ("*nodes*expected*", "solve --scheme ring --nodes 999999999999"),
    *((f"--{key} is {value}: expected it with the scheme ring or triangle, not panel", f"solve --{key} {value}")
      for key, value in (("nodes", "101"), ("grading", "graded"))),
    ("--tolerance is 1e-5: expected it with the scheme panel, not ring", "solve --tolerance 1e-5 --scheme ring"),
    ("--tolerance is 1e-11: expected 1e-10 to 0.01", "solve --tolerance 1e-11"),
    ("--nodes is 2501: expected 8 to 2500", "solve --scheme triangle --nodes 2501"),
    *((f"--want is {value}: expected any of curve, profile, hysteresis*", f"solve --want {value}") for value in ("sugar", "curve,")),
    ("--wavelength is missing: expected it beside --amplitude", "solve --amplitude 1"),
    ("*--approach-end*", "solve --approach-start 1 --approach-end 0"),
    ("unexpected argument leftover of solve (see pulloff solve --help)", "solve --tabor 0 leftover"),
    ("plan needs the name of a case*", "plan"),
    ("--jobs is -1: expected a whole number, 0 for all cores", "run --jobs -1"),
    *((f"--points is {value}: {POINTS}", f"run --points {value}") for value in ("5-3", "5-", "few")),
    ("--points is 0,*: expected at most 64 of A-B or one number", f"run --points {','.join(map(str, range(65)))}"),
    ("no case is named absent: *", f"run absent --points {','.join(map(str, range(64)))}"),
    ("--points begins at 6: expected less than 6, the number of points of smoke", "run smoke --points 6"),
    ("--time-limit is 0: expected a finite number > 0", "run --time-limit 0"),
    *((f"{option} is empty: expected {what}", f"{words} {option} ''") for option, what, words in (
        ("--output", "the name of a folder", "run"), ("--suite", "names of suites", "run"), ("--output", "the name of a folder", "report"),
        ("--run", "the name of a folder", "report"), ("--junit", "the name of a file", "verify smoke"),
        *((option, "the name of a file", "solve --tabor 0") for option in ("--curve", "--profile", "--profile-csv", "--staircase")))),
    (f"no case belongs to the suite dessert: expected one of {SUITES}", "run --suite smoke,dessert"),
    ("unexpected argument smoke of list*", "list smoke")]


@pytest.mark.parametrize("message, words", SLIPS + USAGE, ids=range(len(SLIPS + USAGE)))
def test_wrong_usage(message, words):
    expect(2, f"pulloff: {message}", words)
