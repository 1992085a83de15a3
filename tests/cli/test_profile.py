"""Profiles, waves and coupling from the command line and in cases: equal scenes that are written in different ways, input that is
refused, tables, SI units, and references that are of one profile only."""

import bz2
import gzip
import lzma
import math
import pathlib
import re
import tarfile

import pytest
from conftest import ROOT, agree, document, expect, run

ANY = "sphere or power:C,n or cone:t or punch:b,R or truncated:b,R or exact_sphere:R or hyperboloid:t,b; a table of radii and gaps by "
OPTION, KEY = ANY + "--profile-file", ANY + "profile_file"
WAVE = "expected A,L: amplitude and wavelength, two numbers > 0"
SI = " --from-physical --modulus-pa 2e9 --work-j-per-m2 0.05 --distance-m 3e-10"


def waves(first, last):
    return "".join(f" --wave 1,{length}" for length in range(first, last + 1))


@pytest.mark.parametrize("code, message, words", [
    (2, "--profile is wedge: expected " + OPTION, "solve --profile wedge"),
    (2, "--profile is power:0.05: expected " + OPTION, "solve --profile power:0.05"),
    (2, "--profile is cone:0.3,2: expected " + OPTION, "solve --profile cone:0.3,2"),
    (2, "--profile is sphere:3: expected " + OPTION, "solve --profile sphere:3"),
    (2, "--power-n is not given: the profile power needs it", "solve --profile power --power-c 0.05"),
    (2, "--power-n is 0.5: expected a number from 1 to 40", "solve --profile power:1,0.5"),
    (2, "--punch-b is -1: expected a finite number > 0", "solve --profile punch:-1,3"),
    (2, "--exact-sphere-r is -3: expected a finite number > 0", "solve --profile exact_sphere:-3"),
    (2, "--hyperboloid-b is not given: the profile hyperboloid needs it", "solve --profile hyperboloid --hyperboloid-t 1"),
    (2, "--cone-t is 0: expected a finite number > 0", "solve --profile cone --cone-t 0"),
    (2, "--power-c is 3: expected it with the profile power, not cone", "solve --profile cone:1 --power-c 3"),
    (2, "--punch-b is 3: expected it with the profile punch, not sphere", "solve --punch-b 3"),
    (2, "--table-scale is 2: expected it beside the file of a profile", "solve --table-scale 2"),
    (2, "--wave is 1: " + WAVE, "solve --wave 1"),
    (2, "--wave is -1,20: " + WAVE, "solve --wave -1,20"),
    (2, "--wave is 1,0: " + WAVE, "solve --wave 1,0"),
    (2, "--wave is 1,10: expected at most 8 waves", "solve" + waves(2, 10)),
    (2, "--wave is *;1@10: expected at most 8 waves, with that of the amplitude", "solve --amplitude 1 --wavelength 9" + waves(3, 10)),
    (2, "--coupling is 1: expected only one of --tabor and --coupling", "solve --coupling 1 --tabor 1"),
    (2, "--coupling is -1: expected a finite number >= 0", "solve --coupling -1"),
    (2, "*profile*", "theory guduru --profile cone:0.3 --amplitude 1 --wavelength 9"),
    # waves finer than the memory of any machine carries are refused at once
    (3, "the solve failed: the finest mesh needs * nodes or more and * GB of memory, and there are * GB: expected longer waves, *",
     "solve --wave 0.1,1e-7"),
    (2, "--coupling is 0.1: expected only one of --tabor and --coupling", "follow --key coupling --from 0.1 --to 1 --tabor 1"),
    (2, "--cone-t is 1: expected it with the profile cone, not power", "follow --key cone-t --from 1 --to 2 --profile power:1,2"),
    (2, "--key is profile: *", "follow --key profile --from 1 --to 2"),
    (2, "--profile-file is empty: expected the name of a file", "solve --profile-file ''"),
    (2, "*--radius-m is missing: expected *", "solve --from-physical --modulus-pa 1e9 --work-j-per-m2 0.05 --distance-m 3e-10"),
    (2, "*--coupling is 1: expected it to be left out, *", "solve --from-physical --coupling 1"),
    (4, "nowhere.csv*", "solve --profile-file nowhere.csv"),
    (4, "nowhere.csv*", "follow --key tabor --from 1 --to 2 --profile-file nowhere.csv")])
def test_wrong_command_lines(code, message, words):
    expect(code, "pulloff: " + message, words)


SPHERE = [(r, r * r / 200) for r in (60 * k / 99 for k in range(100))]


def table(name, rows, unit=1.0):
    pathlib.Path(name).write_text("r,gap\n" + "".join(f"{r * unit!r},{f * unit!r}\n" for r, f in rows))


def spoilt(row):
    """The first lines of the sphere, with this one in place of the fifth row."""
    table("wrong.csv", SPHERE[:20])
    lines = pathlib.Path("wrong.csv").read_text().splitlines(True)
    pathlib.Path("wrong.csv").write_text("".join(lines[:5] + [row + "\n"] + lines[6:]))


@pytest.mark.parametrize("rows, unit, message, more", [
    (SPHERE[:7], 1, " 7 rows are too few for a profile: expected at least 8", ""),
    (SPHERE[:20] + [SPHERE[18]] + SPHERE[20:], 1, "22: r is 10.9*: expected more than in the row before", ""),
    (SPHERE[1:], 3e-10, "2: the first r is 1.8*e-10: expected 0", SI),
    (SPHERE[1:], 1, "2: the first r is 0.6*: expected 0", ""),
    ([(r, min(f, 3.0)) for r, f in SPHERE], 1,
     "101: the last gap, less that on the axis, is 3: expected more than in the row before, and more than 0", ""),
    ([(10.0 * k, 5.0 * k * k * (k % 2)) for k in range(9)] + [(90.0, 900.0)], 1,
     "*: without this row the gap changes; the change, in epsilon, is *", "")])
def test_wrong_tables(rows, unit, message, more):
    table("wrong.csv", rows, unit)
    expect(4, "pulloff: wrong.csv:" + message, "solve --profile-file wrong.csv" + more)


def test_tables_that_are_not_numbers():
    wrong = pathlib.Path("wrong.csv")
    wrong.write_text("".join(f"{k},{k * k}\n" for k in range(20)))
    expect(4, "pulloff: wrong.csv:1: the column 1 is named 0: expected a line with the names of the columns before the rows",
           "solve --profile-file wrong.csv")
    with tarfile.open(ROOT / "tests/fuzz/corpus/profile.tar") as corpus:
        wrong.write_bytes(corpus.extractfile("falls_at_the_end").read().split(b"%%")[0])
    expect(4, "pulloff: wrong.csv:26: the slope of the spline at the last r is 0: expected more than 0*", "solve --profile-file wrong.csv")
    for bad in "nan", "x":
        spoilt("1.0," + bad)
        expect(4, f"pulloff: wrong.csv:6: *{bad}*", "solve --profile-file wrong.csv")
    table("sphere.csv", SPHERE)
    expect(2, "pulloff: --profile-file is sphere.csv: expected only one of --profile and --profile-file",
           "solve --profile cone:1 --profile-file sphere.csv")


BODY = [(3.0 * k, 0.045 * k * k) for k in range(21)]


def written(separator=",", mark=".", names=("r", "gap"), rows=None, before="", after="", end="\n"):
    """A table of the body in one of the forms of other programs."""
    cells = rows or [[repr(r), repr(g)] for r, g in BODY]
    lines = [separator.join(names)] + [separator.join(c.replace(".", mark) for c in row) for row in cells]
    return before + "".join(line + end for line in lines) + after


NUMBERED = [[str(k), repr(r), repr(g)] for k, (r, g) in enumerate(BODY)]
SPOTS = [[repr(r), repr(g), ""] for r, g in BODY]
FORMS = {
    "semicolons": written(";"), "european": written(";", ","), "tabs": written("\t"), "tabs and decimal commas": written("\t", ","),
    "blanks": written(" "), "several blanks": written("   "), "blanks and decimal commas": written("  ", ","),
    "fixed width": "".join(f"{a:>12}{b:>20}   \n" for a, b in [("r", "gap"), *BODY]),
    "quoted decimal commas": written(rows=[[f'"{c!r}"'.replace(".", ",") for c in row] for row in BODY]),
    "CR": written(end="\r"), "CR LF": written(end="\r\n"), "CR and semicolons": written(";", ",", end="\r"),
    "no last newline": written().rstrip("\n"), "semicolons, no last newline": written(";").rstrip("\n"),
    "UTF-16 LE": written().encode("utf-16"), "UTF-16 BE": b"\xfe\xff" + written().encode("utf-16-be"),
    "UTF-16, European, CR LF": written(";", ",", end="\r\n").encode("utf-16"),
    "UTF-16, tabs, text before": written("\t", before="Höhe in µm 😀\n").encode("utf-16"),
    "byte order mark": "\ufeff" + written(";", ","), "byte order mark of a plain table": "\ufeff" + written(),
    "quoted names": written(names=('"r"', ' "gap"')), "blanks around commas": written(separator=" ,  ", end="\t\n"),
    "blank lines at the end": written(end="\r\n", after="\r\n  \r\n"),
    "pandas": written(names=("", "r", "gap"), rows=NUMBERED), "pandas, European": written(";", ",", names=("", "r", "gap"), rows=NUMBERED),
    "savetxt": written(names=("# r", "gap")), "savetxt, blanks": written(" ", names=("#r", "gap")),
    "savetxt, header and footer": written(" ", names=("# r", "gap"), before="# made by a script\n# a, b\n", after="# end\n"),
    "text before": written(before="Scan Parameters\nLength,1500.0 um\n\nScan Data\n"),
    "pairs before": written(before="Parameter,Value\nLength,1500\nWidth,20.5\n\n"),
    "a sentence before": written(before="The gap and r gap of a tip\nr and gap\n"),
    "text in Latin-1 before": written(";", ",", before="L\xe4nge;1500 \xb5m\n").encode("latin-1"),
    "comments before": written(before="# Instrument X\n# Time: 10:00\n# Time: 10:05\n"),
    "separator at the end": written(";", names=("r", "gap", ""), rows=SPOTS), "only of rows": written(";", rows=SPOTS),
    "other columns": written("\t", ",", names=("time", "gap", "note", "r"), rows=[["1.5", g, "a b", r] for r, g in [
        (repr(r), repr(g)) for r, g in BODY]]),
    "exponents": written(";", ",", rows=[[f"{r:.17E}", f"{g:.17e}"] for r, g in BODY]),
    "CR and CR LF": written().replace("\n", "\r", 9).replace("\n", "\r\n"), "CR, and LF at the end": written(end="\r")[:-1] + "\n",
    "no-break and thin spaces": written("\u2009").replace("\n6.0", "\n\u00a06.0\u202f"), "in a plain table": written().replace("\n6.0", "\n\u00a06.0"),
    "columns of a spreadsheet to the right": written(";", ",", names=("r", "gap", "", "", ""), rows=[[*row, "", "", ""] for row in SPOTS]),
    # a row that is commented out was data if the table was not plain, and its comma a decimal comma
    "comments between rows": written(";").replace("\n6.0;", "\n# 5.0;9,9\n6.0;"), "in a plain table too": written().replace("\n6.0,", "\n#5.0,9\n6.0,"),
    # digits beyond the 63rd were left out, and with them the exponent
    "long numbers": written(";", ",", rows=[[f"{r!r}{'0' * 90}e+0", f"{g!r}{'0' * 90}"] for r, g in BODY[:1]] + [
        [f"{r * 10:.70f}e-1", repr(g)] for r, g in BODY[1:]]),
    "a minus of typesetters": written(";", ",", names=("x", "r", "gap"), rows=[["\u22121.5", *row[1:]] for row in NUMBERED])}


def without(value, *keys):
    """A document without the members of these names."""
    if isinstance(value, dict):
        return {key: without(item, *keys) for key, item in value.items() if key not in keys}
    return [without(item, *keys) for item in value] if isinstance(value, list) else value


def solved(name):
    """The document of a solve, to the last bit, without its times and what names the bytes of the file."""
    return without(document("solve --tabor 0 --profile-file", name), "sha256", "digest", "seconds", "profile_file")


def test_tables_as_instruments_write_them():
    """One body in many forms has one result. Messages pointed elsewhere: to the number of cells, a NUL byte, a truncated file."""
    pathlib.Path("plain.csv").write_text(written())
    expected = solved("plain.csv")
    for name, text in FORMS.items():
        pathlib.Path("form.txt").write_bytes(text if isinstance(text, bytes) else text.encode())
        assert solved("form.txt") == expected, name
    assert len(FORMS) > 25


@pytest.mark.parametrize("message, text", [
    ("2: the row has 4 cells: expected 2, separated by commas (decimal commas need another separator)", written(",", ",")),
    ("5: the row has 1 cell: expected 2, separated by semicolons", written(";").replace("9.0;", "9.0,")),
    ("4: 6,0 has a decimal comma, and 0.0 on line 2 a decimal point: expected the same in all rows", written(";").replace("6.0;", "6,0;")),
    ("3: 1,500 has a decimal comma or a comma between thousands, and no other number shows which: expected decimal points",
     written(";", rows=[["0", "0"], *[[f"{k},500", f"{k * k},250"] for k in range(1, 20)]])),
    (" is text in UTF-32: expected UTF-8 or UTF-16", written().encode("utf-32")),
    (" is not a text file: it contains a NUL byte, as UTF-16 without a byte order mark does: expected UTF-8", written().encode("utf-16-le")),
    *((f" is {what}*: expected a table in text, with separators", data) for what, data in (
        ("compressed by gzip", gzip.compress(written().encode())), ("compressed by bzip2", bz2.compress(written().encode())),
        ("compressed by xz", lzma.compress(written().encode())), ("a ZIP archive, as those of .xlsx", b"PK\3\4" + bytes(30)),
        ("an array of NumPy", b"\x93NUMPY\1\0"), ("an HDF5 file", b"\x89HDF\r\n\x1a\n"), ("a workbook", b"\xd0\xcf\x11\xe0\xa1\xb1"),
        ("a PDF document", b"%PDF-1.7\n"), ("a PNG image", b"\x89PNG\r\n\x1a\n"), ("a JPEG image", b"\xff\xd8\xff\xe0"),
        ("a MAT-file", b"MATLAB 5.0 MAT-file, Platform"))),
    (" is text in UTF-16 with an odd number of bytes: the file is truncated", written().encode("utf-16")[:-1]),
    ("1: of the columns r and gap, with or without a unit (r_um, gap_nm), both are missing in this line of names, which are separated by "
     "semicolons: radius | height", written(";", names=("radius", "height"))),
    ("1: of the columns r and gap, *, gap is missing in this line of names, which are separated by tabs: r | height", written("\t", names=("r", "height"))),
    ("1: the column 1 is named 0.0: expected a line with the names of the columns before the rows", written()[6:]),
    ("6: gap is 0.72 nm: expected a finite number; a unit or other text follows the number", written(";").replace("0.72", "0.72 nm")),
    ("22: gap is 1.234,5: expected a finite number; it has marks or blanks between thousands", written(";", ",").replace(";18,0", ";1.234,5")),
    ("1: the byte \\x80 is a control character or not UTF-8: expected text", b"r;gap;\x80\n" + written(";").encode()[6:]),
    ("2: r is um: expected a finite number; units belong in the names of the columns, as in r_um", written().replace("gap\n", "gap\num,kg\n")),
    ("6: gap is 1  500.5: expected a finite number; it has marks or blanks between thousands", written(";").replace("0.72", "1\u00a0500.5")),
    ("1: column 2 has no name", written(";", names=("r", "", "gap"), rows=[[r, "1", g] for _, r, g in NUMBERED])),
    ("23: the last line has no newline: the file is truncated", "# sha256: 0\n" + written()[:-1]),
    ("1: the columns are r_um and gap: expected a unit in both names, or in none", written(names=("r_um", "gap"))),
    ("1: the column gap is given in several units: expected one", written(names=("r_m", "gap_nm", "gap_m"), rows=NUMBERED)),
    (" the names of the columns have units of length, and lengths of this scene are in epsilon: expected a scene in SI units *",
     written(names=("r_nm", "gap_nm")))])
def test_tables_in_forms_that_are_refused(message, text):
    pathlib.Path("form.txt").write_bytes(text if isinstance(text, bytes) else text.encode())
    expect(4, "pulloff: form.txt:" + message if message[0] != " " or "names of" in message else "pulloff: form.txt" + message,
           "solve --coupling 0.1 --profile-file form.txt")


def test_units_in_the_names_of_columns():
    """Units are those of the columns, whatever the other; a scale beside them is refused; the printed command repeats the scene."""
    ball = [(r * 3e-10, g * 3e-10) for r, g in BODY]
    pathlib.Path("metres.csv").write_text(written(rows=[[repr(r), repr(g)] for r, g in ball]))
    words = "--radius-m 3e-8" + SI + " --profile-file "
    expected = document("solve " + words + "metres.csv")
    named = {"r_um,gap_nm": (1e6, 1e9), "r (µm),gap [nm]": (1e6, 1e9), "r/nm,gap/pm": (1e9, 1e12), "r_\u03bcm,gap_m": (1e6, 1.0),
             "r_mm,gap_um": (1e3, 1e6)}
    for names, (a, b) in named.items():
        pathlib.Path("units.csv").write_text(names + "\n" + "".join(f"{r * a!r},{g * b!r}\n" for r, g in ball))
        found = document("solve " + words + "units.csv")
        near(found, expected)
        assert math.isclose(found["physical"]["pull_off"]["force_n"], expected["physical"]["pull_off"]["force_n"], rel_tol=1e-9), names
    expect(2, "pulloff: --table-scale is 1e-9: expected it to be left out, as the names of the columns have units",
           "solve --table-scale 1e-9 " + words + "units.csv")


@pytest.mark.parametrize("given", ["--coupling 0.07", "--coupling 0.0833333333333333", "--tabor 0.3"])
def test_the_command_in_a_table_repeats_the_solve(given):
    expect(0, "", f"solve {given} --profile cone:0.5 --want preload --staircase first.csv")
    first = pathlib.Path("first.csv").read_text()
    command = re.search(r"^# command: pulloff (.*)$", first, re.M)[1]
    expect(0, "", command, "--staircase", "second.csv")
    assert pathlib.Path("second.csv").read_text() == first
    if given == "--coupling 0.07":
        assert command.startswith("solve --coupling 0.07 --outer-radius inf ")


CUT = "solve --tabor 1.385 --radius 100 --outer-radius 50 "


def near(a, b, times=1):
    """Whether two pull-offs differ by at most so many times the sum of their stated errors."""
    agree(a["pull_off"], b["pull_off"], "force", times=times)
    agree(a["pull_off"], b["pull_off"], "approach", "approach_error_estimate", times)


@pytest.fixture(scope="module")
def sphere():
    return document(CUT)


def test_a_sphere_written_in_other_ways(sphere):
    near(document(CUT + "--profile sphere"), sphere, 0)
    for words in ("--profile power:0.005,2", "--profile 'power:0.005;2'", "--power-n 2 --power-c 0.005 --profile power"):
        near(document(CUT + words), sphere)
    assert sphere["input"]["profile"] == "sphere" and sphere["input"]["waves"] is None


def test_a_sphere_as_a_table(sphere):
    table("sphere.csv", SPHERE)
    table("doubled.csv", SPHERE, 0.5)
    found = document(CUT + "--profile-file sphere.csv")
    near(found, sphere)
    near(document(CUT + "--table-scale 2 --profile-file doubled.csv"), found)
    t = found["profile_table"]
    assert t["rows"] == 100 and abs(t["end_radius"] - 60) < 1e-12 and abs(t["exponent"] - 2) < 1e-9
    assert t["uncertainty"] < 1e-12 and len(t["sha256"]) == 64 and "profile_table" not in sphere
    assert found["input"]["profile"] == "table" and found["input"]["profile_file"] == "sphere.csv"
    assert found["input"]["table_scale"] == 1 and sphere["input"]["table_scale"] is None
    printed = expect(0, "", CUT + "--profile-file sphere.csv").out
    assert "100 rows to radius 60, beyond which the gap is continued as r^2" in printed


def test_waves():
    """One wave is amplitude and wavelength, in the last bit; two waves of equal length add their amplitudes."""
    wavy = document(CUT + "--amplitude 0.3 --wavelength 11")
    near(document(CUT + "--wave 0.3,11"), wavy, 0)
    assert wavy["input"]["waves"] == "0.3@11"
    near(document(CUT + "--wave 0.1,11 --wave 0.2,11"), wavy)


def test_coupling_and_radius(sphere):
    """The coupling is the Tabor parameter of the radius, whatever the order; the radius of another profile is 1."""
    near(document("solve --outer-radius 50 --coupling", repr((1.385 ** 3 / 100) ** 0.5)), sphere)
    cone = document("solve --coupling 0.05 --profile cone:0.3")
    assert cone["input"]["radius"] == 1 and cone["input"]["load_unit"] == "pi w epsilon"
    assert abs(cone["input"]["tabor"] ** 1.5 - 0.05) < 1e-15
    ten = [document("solve " + words) for words in ("--radius 10 --coupling 0.05 --profile cone:0.3",
                                                    "--profile cone --cone-t 0.3 --coupling 0.05 --radius 10")]
    assert all(d["input"]["load_unit"] == "pi w R" and d["input"]["radius"] == 10 for d in ten)
    assert abs(10 * ten[0]["pull_off"]["force"] / cone["pull_off"]["force"] - 1) < 1e-5
    assert sphere["input"]["load_unit"] == "pi w R"
    assert "in pi w epsilon;" in expect(0, "", "solve --profile cone:0.3").out


def test_si_units():
    """Lengths are in metres, C in m^(1-n)."""
    table("metres.csv", SPHERE, 3e-10)
    words = "solve --radius-m 3e-8 --outer-radius-m 1.5e-8" + SI
    ball = document(words)
    for more in (" --profile power:1.6666666666666666e7,2", " --profile-file metres.csv",
                 " --profile power --power-n 2 --power-c 1.6666666666666666e7"):
        other = document(words + more)
        near(other, ball)
        assert abs(other["physical"]["pull_off"]["force_n"] / ball["physical"]["pull_off"]["force_n"] - 1) < 1e-8
    punch = document("solve --profile punch:1.5e-9,6e-9 --wave 3e-11,3e-9" + SI)
    i = punch["input"]
    assert abs(i["punch_b"] - 5) < 1e-12 and abs(i["punch_r"] - 20) < 1e-12 and i["radius"] == 1
    assert abs(i["amplitude"] - 0.1) < 1e-12 and abs(i["wavelength"] - 10) < 1e-12
    assert punch["physical"]["input"]["profile"] == "punch:1.5e-9,6e-9"
    assert abs(punch["physical"]["units"]["force_n"] - math.pi * 0.05 * 3e-10) < 1e-25


def test_profile_still_names_the_file_of_gap_and_traction_if_it_is_a_path():
    expect(0, "", CUT + "--profile gap.csv --profile power:0.005,2")
    expect(0, "", CUT + "--profile-csv again")
    assert pathlib.Path("gap.csv").read_text().count("\n") > 20 and pathlib.Path("again").exists()


# Cases: the keys, paths relative to the case file, and the content of a table as part of what was solved.

def with_scene(good, *lines, radius=True):
    """The case with these lines in its scene, and the table tip.csv beside it."""
    table(good.folder / "cases/tip.csv", SPHERE)
    path = good.folder / "cases/good.yaml"
    text = path.read_text().replace("  amplitude: 0\n", "").replace("  tabor: 0\n", "  tabor: 0\n" + "".join(
        f"  {line}\n" for line in reversed(lines)))
    path.write_text(text if radius else text.replace("  radius: 100\n", ""))
    return path


@pytest.mark.parametrize("code, message, lines", [
    (2, "profile is wedge: expected " + KEY, ["profile: wedge"]),
    (2, "waves is 1@: expected A@L*", ["waves: 1@"]),
    (2, "coupling is 1: expected only one of tabor and coupling", ["coupling: 1"]),
    (2, "waves is 1@20: expected only waves, or amplitude and wavelength", ["waves: 1@20", "amplitude: 2", "wavelength: 3"]),
    (4, "profile_file: */cases/nowhere.csv*", ["profile_file: nowhere.csv"]),
    (2, "profile_file is tip.csv: expected only one of profile and profile_file", ["profile: cone:1", "profile_file: tip.csv"])])
def test_wrong_cases(good, code, message, lines):
    with_scene(good, *lines)
    expect(code, "pulloff: cases/good.yaml:*: scene." + message, "plan good")


def test_another_profile_has_no_reference(good):
    with_scene(good, "profile: cone:0.3")
    assert expect(1, "*outside*", "verify good --output run --verbose").count("missing_reference")


@pytest.mark.parametrize("verdict, lines", [
    ("within", ["profile: sphere", "radius: 1e2"]),
    ("within", ["profile: power:0.005,2"]),
    ("missing_reference", ["profile: power:0.005,2.5"]),
    ("missing_reference", ["profile: power:0.005,2", "radius: 10"]),
    ("missing_reference", ["profile: power:0.005,2", "waves: 0.1@8"]),
    ("outside", ["profile: power:0.005,2", "waves: 0.1@9"])])
def test_the_rigid_pull_off_against_a_table_of_all_profiles(good, verdict, lines):
    """Loads of other profiles are in pi w epsilon."""
    with_scene(good, *lines, radius=False)
    good.table("reference/table.csv", "tabor,profile,waves,radius,force,approach", "0,cone:0.3,-,-,7,0", "0,power:0.005;2,-,-,200,0",
               "0,power:0.005;2,0.1@9,-,8,0", "0,sphere,-,100,2,0")
    ended = run("verify good --output run --verbose")
    assert verdict in ended.out + ended.err


@pytest.mark.once
def test_the_content_of_a_table_is_part_of_what_was_solved_and_its_path_is_not(good):
    case = with_scene(good, "profile_file: tip.csv")
    expect(0, "*outside", "run good --output run")
    expect(0, "*outside (kept)", "run good --output run")
    tip = good.folder / "cases/tip.csv"
    tip.write_text(re.sub(r"(?m)^0.6060606060606061,.*", "0.6060606060606061,0.0019", tip.read_text()))
    expect(0, "*outside", "run good --output run")
    record = pathlib.Path("run/good/record.json").read_text()
    assert '"profile_table"' in record
    assert re.search('"command": "pulloff solve .*--profile-file tip.csv ', record), "the table relative to the case file"
    assert '"profile_file": "tip.csv"' in record
    case.write_text(re.sub(r"(?m)^want: .*", "want: [pull_off, curve]", case.read_text()))
    expect(0, "*", f"run {case} --output elsewhere")
    assert any("--profile-file tip.csv " in path.read_text() for path in pathlib.Path("elsewhere/good").glob("curve-*.csv"))


@pytest.mark.parametrize("option", ["curve", "profile-csv", "staircase"])
def test_the_command_of_a_table_repeats_it(option):
    given = "--profile-approach -1.5" if option == "profile-csv" else ""
    expect(0, "", f"solve --tabor 0.3 --amplitude 0.4 --wavelength 12 --outer-radius 40 --scheme triangle --nodes 61 {given} "
                  f"--{option} a.csv")
    made = pathlib.Path("a.csv").read_text()
    if given:
        [approach] = re.findall("^# what: gap and traction over the radius at approach (.*)$", made, re.M)
        assert abs(float(approach) + 1.5) < 1e-9
    [command] = re.findall("^# command: pulloff (.*)$", made, re.M)
    expect(0, "", f"{command} --{option} b.csv")
    assert pathlib.Path("b.csv").read_text() == made


def test_an_approach_of_the_profile_before_and_beyond_the_branch():
    early = document("solve --profile-approach -7 --want profile")
    assert len(early["profile"]) > 10 and abs(early["profile_approach"] + 7) < 1e-9 and early["start"] < -7
    late = "solve --profile-approach 5"
    assert expect(0, "", late).count(r"^profile  none: the trace does not pass approach 5, see --approach-end$") == 1
    expect(2, "pulloff: late.csv is not written: the trace does not pass the approach or load of the profile, *", f"{late} --profile-csv late.csv")
    assert not pathlib.Path("late.csv").exists()
    expect(2, "pulloff: the result has no curve, profile or staircase to plot", f"plot --want profile {late.removeprefix('solve ')} a.svg")
    assert document(late + " --approach-end 6")["profile_approach"] == pytest.approx(5, abs=1e-9)


def test_the_profile_at_a_load():
    # The load falls where a crest jumps into contact under compression, so that it is 5 three times; loading at given
    # load meets the first.
    steep = "solve --tabor 3 --amplitude 6 --wavelength 30 --outer-radius 100 --want curve,profile --preload-load 8"
    found = document(steep + " --profile-load 5")
    points = found["curve"]
    [first] = [k for k in range(1, len(points)) if points[k]["load"] > 5 - 1e-8][:1]
    assert points[first - 1]["approach"] < found["profile_approach"] <= points[first]["approach"]
    assert abs(points[first]["load"] - 5) < 1e-8 and found["profile_approach"] == points[first]["approach"]
    assert any(point["load"] < 4.9 for point in points[first:])
    at = document(f"{steep} --profile-approach {found['profile_approach']!r}")
    assert len(at["profile"]) > 100 and at["profile_approach"] == pytest.approx(found["profile_approach"], abs=1e-9)
    late = "solve --profile-load 5"
    assert expect(0, "", late).count(r"^profile  none: the trace does not pass load 5, see --approach-end$") == 1
    assert document(late + " --preload-load 5")["profile"]
    expect(2, "pulloff: --profile-load is inf: expected a finite number", "solve --profile-load inf")
    expect(2, "pulloff: profile_load is 2 beside profile_approach: expected one of both", "solve --profile-load 2 --profile-approach 1")
    si = "--from-physical --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7 --modulus-pa 1e9"
    expect(2, "pulloff: --profile-load is 1: expected --profile-load-n, *", f"solve {si} --profile-load 1")
    newtons = 0.005 * math.pi * 0.05 * 1e-7
    ours = document(f"solve {si} --profile-load-n {newtons!r} --want curve")
    assert any(abs(point["load_n"] - newtons) < 1e-9 * newtons and point["approach_m"] == ours["physical"]["profile_approach_m"]
               for point in ours["physical"]["curve"])


@pytest.mark.once
def test_a_parabola_is_no_sphere_in_a_wide_contact():
    # The contact radius was 61 nm at a radius of 45 nm, and the force, 10.60 nN, stood there without a word.
    soft = "--from-physical --modulus-pa 1.58e6 --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 45e-9 --tolerance 1e-4"
    parabola = document(f"solve {soft}")["physical"]["pull_off"]
    sphere = document(f"solve {soft} --profile exact_sphere:45e-9")["physical"]["pull_off"]
    assert parabola["force_n"] == pytest.approx(10.60e-9, rel=1e-3)
    # JKR by the transform x artanh(x/R) (Sneddon), at the radius where the derivative of the load vanishes
    work, modulus, radius = 0.05, 1.58e6, 45e-9

    def load(a):
        turn = math.atanh(a / radius)
        return (modulus * ((radius**2 + a**2) * turn - radius * a) - math.sqrt(8 * math.pi * work * modulus * a**3))

    least = min(load(radius * k / 10000) for k in range(1, 9990))
    assert sphere["force_n"] == pytest.approx(-least, rel=2e-3)
    more = round(100 * (parabola["force_n"] / sphere["force_n"] - 1))
    line = f"the force of the parabola is that of the sphere +{more} %; --profile exact_sphere:4.5e-08 is the sphere"
    for verb in "solve", "compare":
        assert line in expect(0, "", f"{verb} {soft}").out
    # compare says it where its verdicts stand, which held for JKR of the parabola without a word
    said = expect(0, "", f"compare {soft}").out.splitlines()
    holds = {line.split()[0]: line.split("%")[2].split()[:2] for line in said if line.count("%") == 2 and line[:3] in ("DMT", "JKR")}
    assert holds["DMT"][0] == "no" and holds["JKR"] == ["yes", "(1)"]
    [note] = [line for line in said if line.startswith("(1) ")]
    assert "not for a sphere of this R: contact radius over R 1.35, expected at most 0.3; --profile exact_sphere:4.5e-08" in note
    assert any(line.startswith("assumptions hold (1)       JKR, Maugis-Dugdale, ") for line in said)
    for words in f"{soft} --profile exact_sphere:45e-9", "--tabor 20 --radius 10000 --tolerance 1e-4":
        assert "(1)" not in expect(0, "", f"compare {words}").out
    # the limit; at the same Tabor parameter a/R goes as the root of 1/R
    a = document("solve --tabor 20 --radius 100 --tolerance 1e-4")["pull_off"]["contact_radius"]
    for part, notes in (0.305, 1), (0.295, 0):
        assert expect(0, "", f"compare --tabor 20 --radius {100 * (a / 100 / part)**2} --tolerance 1e-4").out.count("\n(1) ") == notes
    assert "sphere   the contact" not in expect(0, "", f"solve {soft} --profile exact_sphere:45e-9").out
    assert "sphere   the contact" not in expect(0, "", "solve --tabor 1").out


def undulating(rows):
    return [(r, r * r / 2000 + 0.25 * (1 - math.cos(2 * math.pi * r / 100))) for r in (2010 * k / rows for k in range(rows + 1))]


@pytest.mark.parametrize("rows", [201, 4000])
def test_rigid_bodies_under_an_undulating_table(rows):
    """Beyond a gap of 4 the rest of the table was one integral in 1/r: "the quadrature of the rigid load failed at approach -10"."""
    table("wavy.csv", undulating(rows))
    found = document("solve --coupling 0 --profile-file wavy.csv")
    same = document("solve --tabor 0 --radius 1000 --amplitude 0.25 --wavelength 100")
    scale = 1000 * same["pull_off"]["force"]
    assert abs(found["pull_off"]["force"] - scale) < (2e-5 if rows == 201 else 1e-8) * scale
    assert abs(found["pull_off"]["force"] - scale) < 10 * found["interpolation"]["force"]


def test_the_far_field_of_a_table_reaches_the_rows_that_matter():
    """On the plateau at a gap of 40 much of the table attracts. The domain ended at a gap of 20, and one polynomial in 1/r stood for
    the rest: 65.6035 +- 0.41 and status ok. With so little coupling the force is that of rigid bodies but for 2e-4 at most."""
    plateau = [(r, 40 * (1 - math.exp(-9 * (r / 150) ** 2)) + 10 * (r / 150) ** 10) for r in (150 * k / 59 for k in range(60))]
    table("plateau.csv", plateau)
    found, rigid = (document(f"solve --coupling {coupling} --profile-file plateau.csv")["pull_off"] for coupling in (1e-6, 0))
    assert found["error_over_tolerance"] < 1 and abs(found["force"] - rigid["force"]) < 3e-4 + found["error_estimate"]


def test_a_table_of_a_cone_is_the_cone():
    """The exponent of its continuation is 1 but for rounding, and less than 1 had no equilibrium at the start of the trace."""
    slope = 98.87011186336669 / 67.17847731822704
    table("cone.csv", [(r, slope * r) for r in (67.17847731822704 * k / 1542 for k in range(1543))])
    agree(document("solve --coupling 0.02 --profile-file cone.csv")["pull_off"],
          document(f"solve --coupling 0.02 --profile cone:{slope!r}")["pull_off"], "force")


def test_an_error_above_the_tolerance_is_said():
    found = document("solve --tabor 0 --tolerance 1e-10")["pull_off"]
    assert found["error_over_tolerance"] == pytest.approx(found["error_estimate"] / (1e-10 * found["force"]), rel=1e-12)
    assert found["error_over_tolerance"] > 1
    assert expect(0, "", "solve --tabor 0 --tolerance 1e-10").count("^warning  the error of the force is 1.5 times the tolerance: expected a larger tolerance") == 1
    assert expect(0, "", "solve --tabor 0").count("^warning") == 0


def blunt(r, radius=5.0, half=math.radians(22)):
    meet = radius * math.cos(half)
    return radius - math.sqrt(radius * radius - r * r) if r < meet else radius * (1 - math.sin(half)) + (r - meet) / math.tan(half)


def test_a_tip_that_the_rows_do_not_resolve():
    """Rows every 15 units of a cone with an apex of radius 5: its force is that of the spline, and was stated with an error of 1e-8."""
    command = "solve --coupling 0.01 --profile-file tip.csv"
    table("tip.csv", [(15.0 * k, blunt(15.0 * k)) for k in range(101)])
    printed, coarse = expect(0, "", command), document(command)
    assert coarse["interpolation"]["interval"] == 1 and coarse["interpolation"]["solved"]
    assert coarse["interpolation"]["force"] > coarse["pull_off"]["force"]
    assert printed.count("^uncertain interpolation of the rows: force ") == 1
    assert printed.count("^warning  the contact at pull-off ends in interval 1 of the rows: ") == 1
    table("tip.csv", [(0.25 * k, blunt(0.25 * k)) for k in range(401)])
    fine = document(command)
    assert fine["interpolation"]["force"] < 0.02 * fine["pull_off"]["force"] and fine["interpolation"]["interval"] > 4
