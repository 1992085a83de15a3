"""The adhesion sheet: its problems and values as a whole, and the score of right, wrong and missing answers."""

import csv
import importlib.util
import json
import math
import pathlib
import shutil
import subprocess
import sys

import pytest

SHEET = pathlib.Path(__file__).resolve().parents[2] / "reference" / "sheet"
FILES = ["score.py", "problems.json", "values.csv"]
MOST_DIGITS = 10

specification = importlib.util.spec_from_file_location("score", SHEET / "score.py")
score = importlib.util.module_from_spec(specification)
specification.loader.exec_module(score)
PROBLEMS = score.read_problems()["problems"]
VALUES, CHECKSUM = score.read_values()


@pytest.fixture(name="alone")
def copied_alone(tmp_path):
    """A folder with the three files, and a function that runs score.py there with the standard library only."""
    for name in FILES:
        shutil.copy(SHEET / name, tmp_path)

    def run(*words):
        return subprocess.run([sys.executable, "-I", "-S", str(tmp_path / "score.py"), *words], cwd=tmp_path,
                              capture_output=True, text=True, check=False)

    return tmp_path, run


def write_answers(path, answers):
    with open(path, "w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([("problem", "quantity", "value"), *((*key, value) for key, value in answers.items())])


def scored(alone, answers):
    """The JSON of a score of answers {(problem, quantity): value}, by problem, and by level."""
    folder, run = alone
    write_answers(folder / "answers.csv", answers)
    done = run("answers.csv", "--json")
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    return {record["problem"]: record for record in result["problems"]}, {one["level"]: one for one in result["levels"]}


def right():
    return {key: row["value"] for key, row in VALUES.items()}


# ------------------------------------------------------------------------------ the data

def test_problems_are_as_the_schema_says():
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((SHEET / "problems.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    valid = jsonschema.Draft202012Validator(schema).is_valid
    sheet = score.read_problems()
    assert valid(sheet)
    for change in (lambda p: p.pop("catches"), lambda p: p.update(more=1), lambda p: p.update(level="simple"),
                   lambda p: p["quantities"][0].pop("sign"), lambda p: p["parameters"].update(R="sphere"),
                   lambda p: p.update(title=" x")):
        altered = score.read_problems()
        change(altered["problems"][0])
        assert not valid(altered)
    assert list(sheet["levels"]) == score.LEVELS


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda problem: problem["id"])
def test_a_statement_needs_no_program(problem):
    assert "pulloff" not in problem["statement"] + problem["dimensional"]
    assert (problem["statement"] + problem["dimensional"] + problem["title"]).isascii()


def test_every_quantity_has_one_value():
    asked = [(problem["id"], quantity["name"]) for problem in PROBLEMS for quantity in problem["quantities"]]
    assert len({problem["id"] for problem in PROBLEMS}) == len(PROBLEMS)
    assert asked == list(VALUES), "the values are in the order of the problems"
    lines = [line for line in (SHEET / "values.csv").read_text().splitlines() if not line.startswith("#")]
    assert len(lines) == len(asked) + 1


@pytest.mark.parametrize("key", VALUES, ids="/".join)
def test_digits_are_those_of_the_half_width(key):
    row = VALUES[key]
    value, half_width, digits = abs(float(row["value"])), float(row["half_width"]), int(row["digits"])
    assert 0 < half_width < value
    assert digits == min(MOST_DIGITS, math.floor(-math.log10(half_width / value)))
    assert row["route_1"] and row["route_2"] and row["route_1"] != row["route_2"]


# ------------------------------------------------------------------------------ the score

def test_right_answers_have_every_digit(alone):
    records, levels = scored(alone, right())
    assert all(record["digits"] == record["certified"] for record in records.values())
    assert all(level["answered"] == level["problems"] and level["digits"] == level["certified"] for level in levels.values())


@pytest.mark.parametrize("error, digits", [(3e-3, 2.5229), (1e-6, 6.0), (-1e-6, 6.0), (2e-9, 8.699), (0.5, 0.301), (1.0, 0.0),
                                           (40.0, 0.0), (-2.0, 0.0)])
def test_relative_error(alone, error, digits):
    """The digits of one wrong quantity are those of its problem; the other problems are not touched."""
    key = ("law-cone", "pull_off_force")
    answers = right()
    answers[key] = repr(float(answers[key]) * (1 + error))
    records, _ = scored(alone, answers)
    assert records["law-cone"]["digits"] == pytest.approx(digits, abs=1e-3)
    assert records["law-cone"]["quantities"]["grips_force"] == 10
    assert records["law-jkr"]["digits"] == 10


def jkr_of_sphere(work, modulus, radius):
    """Pull-off forces and radii of JKR theory as a textbook has them."""
    return {"pull_off_force": 1.5 * math.pi * work * radius, "grips_force": 5 / 6 * math.pi * work * radius,
            "pull_off_radius": (9 * math.pi * work * radius ** 2 / (8 * modulus)) ** (1 / 3),
            "grips_radius": (math.pi * work * radius ** 2 / (8 * modulus)) ** (1 / 3),
            "zero_load_radius": (9 * math.pi * work * radius ** 2 / (2 * modulus)) ** (1 / 3)}


def two_bodies():
    """w, E* and R of the problem law-jkr, and of the mistakes that it is to find."""
    p = next(problem for problem in PROBLEMS if problem["id"] == "law-jkr")["parameters"]
    work = p["gamma1"] + p["gamma2"] - p["gamma12"]
    softness = [(1 - p[f"nu{i}"] ** 2) / p[f"E{i}"] for i in (1, 2)]
    radius = 1 / (1 / p["R1"] + 1 / p["R2"])
    return work, 1 / sum(softness), radius, p, 1 / softness[0]


def test_the_textbook_answers_jkr(alone):
    work, modulus, radius, _, _ = two_bodies()
    answers = {("law-jkr", name): repr(value) for name, value in jkr_of_sphere(work, modulus, radius).items()}
    record = scored(alone, answers)[0]["law-jkr"]
    assert all(record["quantities"][name] == 10 for _, name in answers)
    assert record["digits"] == 0 and record["answered"] == len(answers), "the other quantities are missing"


MISTAKES = {
    "half of the work": (lambda w, e, r, p, soft: jkr_of_sphere(w / 2, e, r), "pull_off_force", 0.301),
    "work in place of its double": (lambda w, e, r, p, soft: jkr_of_sphere(2 * w, e, r), "pull_off_force", 0.0),
    "without the energy of the interface": (lambda w, e, r, p, soft: jkr_of_sphere(w + p["gamma12"], e, r), "pull_off_force",
                                            -math.log10(4 / 53)),
    "modulus of one body": (lambda w, e, r, p, soft: jkr_of_sphere(w, soft, r), "zero_load_radius", 0.9575),
    "radius of one sphere": (lambda w, e, r, p, soft: jkr_of_sphere(w, e, p["R1"]), "pull_off_force", -math.log10(2 / 3)),
    "fixed load in place of fixed grips": (lambda w, e, r, p, soft: {"grips_force": 1.5 * math.pi * w * r}, "grips_force",
                                           -math.log10(0.8)),
    "(2/3) pi gamma R": (lambda w, e, r, p, soft: {"pull_off_force": 2 / 3 * math.pi * p["gamma1"] * r}, "pull_off_force", 0.0887),
    "DMT": (lambda w, e, r, p, soft: {"pull_off_force": 2 * math.pi * w * r}, "pull_off_force", 0.477),
    "the other sign": (lambda w, e, r, p, soft: {"pull_off_force": -1.5 * math.pi * w * r}, "pull_off_force", 0.0)}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_mistakes_have_the_digits_that_they_deserve(alone, mistake):
    make, quantity, digits = MISTAKES[mistake]
    answers = right()
    answers.update({("law-jkr", name): repr(value) for name, value in make(*two_bodies()).items()})
    record = scored(alone, answers)[0]["law-jkr"]
    assert record["quantities"][quantity] == pytest.approx(digits, abs=6e-3)
    assert record["digits"] <= record["quantities"][quantity] < 1.2


def test_missing_answers(alone):
    records, levels = scored(alone, {("law-dmt", "pull_off_force"): VALUES["law-dmt", "pull_off_force"]["value"],
                                     ("law-dmt", "work_to_separate"): "nan", ("law-dmt", "zero_load_radius"): "",
                                     ("law-dmt", "zero_load_approach"): "inf", ("law-dmt", "load_at_approach"): "1,5"})
    assert records["law-dmt"]["digits"] == 0 and records["law-dmt"]["answered"] == 1
    assert sum(level["answered"] for level in levels.values()) == 0
    assert sum(level["digits"] for level in levels.values()) == 0


def test_text_names_the_least_certain_quantity(alone):
    folder, run = alone
    answers = right()
    answers["law-power", "grips_approach"] = repr(float(answers["law-power", "grips_approach"]) * (1 + 1e-4))
    del answers["law-jkr", "grips_force"]
    write_answers(folder / "answers.csv", answers)
    text = run("answers.csv").stdout
    assert "law-power" in text and "grips_approach 4.0" in text
    assert "1 of 10 quantities not answered" in text
    assert text.startswith("adhesion-sheet-1  " + CHECKSUM)


@pytest.mark.parametrize("rows, message", [
    ([("law-jkr", "pull_of_force", "1")], "no quantity 'pull_of_force' of a problem 'law-jkr'"),
    ([("law-jkr", "pull_off_force", "1"), ("law-jkr", "pull_off_force", "1")], "answered twice")])
def test_misprints_are_errors(alone, rows, message):
    folder, run = alone
    with open(folder / "answers.csv", "w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([("problem", "quantity", "value"), *rows])
    done = run("answers.csv")
    assert done.returncode == 1 and message in done.stderr and done.stdout == ""


def test_a_file_of_a_spreadsheet(alone):
    """A byte order mark, ends of lines of Windows, spaces, comments, more columns and another order are no matter."""
    folder, run = alone
    lines = ["\ufeff# by a program", "seconds,value,problem,quantity", f"0.1, {VALUES['law-dmt', 'pull_off_force']['value']} , law-dmt ,pull_off_force"]
    (folder / "answers.csv").write_bytes("\r\n".join(lines).encode())
    done = run("answers.csv", "--json")
    assert done.returncode == 0, done.stderr
    record = next(one for one in json.loads(done.stdout)["problems"] if one["problem"] == "law-dmt")
    assert record["quantities"]["pull_off_force"] == 10


def test_wrong_columns_and_no_file_are_errors(alone):
    folder, run = alone
    (folder / "answers.csv").write_text("id,name,value\n")
    assert "the columns problem, quantity and value are expected" in run("answers.csv").stderr
    assert run("none.csv").returncode == 1
    assert run().returncode == 2


def test_an_altered_value_is_an_error(alone):
    folder, run = alone
    table = folder / "values.csv"
    table.write_text(table.read_text().replace("law-dmt,pull_off_force,1.8", "law-dmt,pull_off_force,1.9"))
    write_answers(folder / "answers.csv", right())
    done = run("answers.csv")
    assert done.returncode == 1 and "checksum" in done.stderr


def test_an_altered_problem_is_an_error(alone):
    folder, run = alone
    problems = folder / "problems.json"
    problems.write_text(problems.read_text().replace('"tabor": 3', '"tabor": 4', 1))
    assert run("--list").returncode == 1 and "problems.json: its checksum" in run("--list").stderr


FIRST = VALUES["law-jkr", "pull_off_force"]["value"]


@pytest.mark.parametrize("text", [f"problem,quantity,value\nlaw-jkr,pull_off_force,{FIRST}\n,,\n   \n\n",
                                  f" Problem; QUANTITY ;Value\nlaw-jkr;pull_off_force;{FIRST}\n;;\n",
                                  f"problem\tvalue\tquantity\tunit\nlaw-jkr\t{FIRST}\tpull_off_force\tN\n",
                                  f"problem,quantity,unit,value\nlaw-jkr,pull_off_force,,{FIRST}\n"])
def test_separators_headers_and_blank_lines(alone, text):
    folder, run = alone
    (folder / "answers.csv").write_text(text)
    done = run("answers.csv", "--json")
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    assert result["problems"][0]["quantities"]["pull_off_force"] == 10 and result["unread"] == []


@pytest.mark.parametrize("number", ["2.5D-05", "-6,2e-7", "nan", "inf", "1_0", "0x1p3", "1 000"])
def test_answers_that_are_no_numbers_are_listed(alone, number):
    folder, run = alone
    (folder / "answers.csv").write_text(f"# by hand\nproblem;quantity;value\n\nlaw-jkr;pull_off_force;{number}\n")
    assert f"answers.csv, line 4: '{number}' is no number" in run("answers.csv").stdout
    assert json.loads(run("answers.csv", "--json").stdout)["problems"][0]["answered"] == 0


@pytest.mark.parametrize("line, message", [("law-jkr", "line 2: 1 fields, but 4 columns"),
                                           ("law-jkr,pull_off_force,-1,2,N", "line 2: 5 fields, but 4 columns"),
                                           ("law-jkr,pull_off_force,1198,nN", "line 2: 'pull_off_force' of 'law-jkr' is asked in N, not in nN")])
def test_wrong_lines_are_errors(alone, line, message):
    folder, run = alone
    (folder / "answers.csv").write_text(f"problem,quantity,value,unit\n{line}\n")
    done = run("answers.csv")
    assert done.returncode == 1 and message in done.stderr and "Traceback" not in done.stderr


def test_another_encoding_is_an_error_with_the_name_of_the_file(alone):
    folder, run = alone
    (folder / "answers.csv").write_bytes("problem,quantity,value,Größe\n".encode("latin-1"))
    assert "answers.csv: the text is not UTF-8" in run("answers.csv").stderr


def test_verbose_has_every_quantity_and_doubts_signs(alone):
    folder, run = alone
    answers = {key: value for key, value in right().items() if key[0] == "law-dmt"}
    answers["law-dmt", "pull_off_force"] = "-" + answers["law-dmt", "pull_off_force"]
    write_answers(folder / "answers.csv", answers)
    lines = run("answers.csv", "--verbose").stdout.splitlines()
    assert all(any(line.split()[:1] == [name] for line in lines) for _, name in answers)
    assert [line.split()[0] for line in lines if line.endswith("sign?")] == ["pull_off_force"]


def test_means_of_groups_and_of_answered_problems(alone):
    folder, run = alone
    write_answers(folder / "answers.csv", {key: value for key, value in right().items() if key[0] == "rigid-wavy"})
    groups = {one["group"]: one for one in json.loads(run("answers.csv", "--json").stdout)["groups"]}
    assert groups["rigid"]["answered"] == 1 and groups["rigid"]["digits_answered"] == 10
    assert groups["rigid"]["digits"] == pytest.approx(10 / groups["rigid"]["problems"])
    assert groups["contact law"]["digits_answered"] is None


def test_a_closed_pipe_is_no_error(alone):
    folder, _ = alone
    command = f"{sys.executable} -I -S {folder / 'score.py'} --statement | true; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stderr == ""


def test_template_is_a_file_of_answers(alone):
    folder, run = alone
    (folder / "answers.csv").write_text(run("--template").stdout)
    done = run("answers.csv", "--json")
    assert done.returncode == 0 and {record["answered"] for record in json.loads(done.stdout)["problems"]} == {0}


def test_statements(alone):
    _, run = alone
    first, *others = run("--list").stdout.splitlines()
    assert first == f"adhesion-sheet-1  sha256 {CHECKSUM}" and len(others) == len(PROBLEMS)
    assert "Tabor parameter" in run("--statement").stdout
    for problem in PROBLEMS:
        text = run("--statement", problem["id"]).stdout
        assert problem["statement"] in text and all(f"{key} = {value}" in text for key, value in problem["parameters"].items())
        everything = run("--statement", problem["id"], "--all").stdout
        assert text.strip() in everything and problem["catches"] in everything and score.read_problems()["definitions"][-1] in everything
    assert run("--statement", "law-none").returncode == 1


def test_the_page_has_the_checksum():
    page = SHEET.parents[1] / "doc" / "sheet.md"
    assert f"sha256 {CHECKSUM}" in page.read_text(), "python3 reference/make/sheet.py --seal writes it"


def test_every_parameter_is_a_number_with_a_unit():
    for problem in PROBLEMS:
        assert list(problem["parameters"]) == list(problem["parameter_units"])
        assert all(isinstance(value, (int, float)) for value in problem["parameters"].values())
