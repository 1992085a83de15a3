"""Wrong reference tables (damaged rows and headers: tests/harness/test_base.c): the message is one line with file and line. The
exit code is 4 if the table is unreadable or damaged, and 2 if the case needs a column or a row that the table does not have."""

import os
import pathlib

import pytest
from conftest import edit, expect, seal

TABLE = "reference/table.csv"


def refused(good, code, message):
    expect(code, f"pulloff: {message}", "verify good --output out")
    assert not os.path.exists("out/good")


def test_a_table_that_is_no_file(good):
    table = good.folder / TABLE
    table.unlink()
    refused(good, 4, "*/reference/table.csv cannot be opened: No such file or directory")
    table.mkdir()
    refused(good, 4, "*/reference/table.csv cannot be read: Is a directory")


CHECKSUM = f"{TABLE}:10: sha256 is *: expected *, the digest of all other lines*"


@pytest.mark.parametrize("message, old, new", [
    (f"{TABLE} is not a text file: it contains a NUL byte*", "# what", "\0# what"),
    (CHECKSUM, "0,2,0", "0,2.1,0"), (CHECKSUM, "# uncertainty: 0", "# uncertainty: 1"),
    (f"{TABLE}:10: the header units is missing: expected *", "# units: those of the harness\n", ""),
    (f"{TABLE}:5: the header units is empty", "# units: those of the harness", "# units:")])
def test_tables_without_their_checksum(good, message, old, new):
    edit(good.folder / TABLE, old, new)
    refused(good, 4, message)


@pytest.mark.parametrize("code, message, rows", [
    (4, f"{TABLE}:11: the column force is missing", ["tabor,approach", "0,0"]),
    (4, f"{TABLE}:13: the row has 4 cells: expected 3, separated by commas (decimal commas need another separator)",
     ["tabor,force,approach", "0,2,0", "1,2,3,4"]),
    *((4, f"{TABLE}:12: force is {value}: expected a finite number", ["tabor,force,approach", f"0,{value},0"]) for value in ("two", "nan")),
    (4, f"{TABLE}:12: tabor is -1: expected a finite number >= 0", ["tabor,force,approach", "-1,2,0"]),
    (4, f"{TABLE}:13: a second row for the same scene: expected one", ["tabor,force,approach", "0,2,0", "0,2,0"]),
    (2, "cases/good.yaml:15: checks[1].tolerance is 1e-9: expected at least 1e-06, *",
     ["tabor,force,approach,force_uncertainty", "0,2,0,1e-6"])])
def test_wrong_rows(good, code, message, rows):
    good.table(TABLE, *rows)
    refused(good, code, message)


def test_a_kind_that_is_unknown(good):
    edit(good.folder / TABLE, "# kind: oracle", "# kind: rumour")
    seal(good.folder / TABLE)
    refused(good, 4, f"{TABLE}:3: kind is rumour: expected oracle or published")


@pytest.mark.parametrize("kind", ["rel", "ulp"])
@pytest.mark.parametrize("message, quantity, columns, row", [
    ("0", "pull_off_approach", "tabor,force,approach", "0,2,0"),
    ("2 with an uncertainty of 3", "pull_off_force", "tabor,force,approach,force_uncertainty", "0,2,0,3"),
    ("0", "hysteresis_loss", "tabor,energy_lost,uncertainty", "0,0,0"),
    ("0", "extrema", "tabor,kind,approach,load,uncertainty", "0,minimum,0,-2,0"),
    ("0", "jumps", "tabor,phase,approach,load_before,load_after,energy_lost,uncertainty", "0,loading,1,2,0,3,0")])
def test_tolerances_relative_to_zero(good, kind, message, quantity, columns, row):
    """A tolerance relative to a value that is 0, or 0 within its uncertainty, was "inf times the tolerance" of a wrong program. It is
    an error of the case: with every kind of value, and units in the last place are relative, too."""
    good.table(TABLE, columns, row)
    edit(good.file, "pull_off_force", quantity, "kind: abs", f"kind: {kind}")
    expect(2, f"pulloff: cases/good.yaml:15: checks[1].kind is {kind}, but {TABLE} has the value {message}, to which no tolerance can be "
              f"relative: expected kind: abs, with a tolerance in the unit of {quantity}", "plan good")


def test_a_closed_form_that_is_zero(good):
    edit(good.file, "pull_off_force", "pull_off_approach", TABLE, "bradley", "kind: abs", "kind: rel")
    refused(good, 2, "cases/good.yaml:15: checks[1].kind is rel, but bradley has the value 0, to which *")


@pytest.mark.parametrize("code, message, row, verb", [
    (0, "*", "easy:pull_off_force", "verify"), (1, "*: outside", "easy:radius", "verify"),
    (2, "pulloff: cases/good.yaml:15: checks[1].tolerance is 1e-9: expected at least 1e-06, *", "hard.1:pull_off_force", "verify"),
    (4, f"pulloff: {TABLE}:11: no row easy:force: expected PROBLEM:QUANTITY of the columns problem and quantity", "easy:force", "plan"),
    (4, f"pulloff: {TABLE}:11: no row easy: expected *", "easy", "plan"),
    (2, f"pulloff: {TABLE}#easy:pull_off_force has one number: expected a quantity that is one, not extrema", "extrema", "plan")])
def test_rows_by_name(good, code, message, row, verb):
    """A row of a table by its name, for any scene: its columns problem, quantity, value and half_width."""
    good.table(TABLE, "problem,quantity,value,half_width", "easy,pull_off_force,2,1e-12", "easy,radius,3,1e-12", "hard.1,pull_off_force,1.9,1e-6")
    if row == "extrema":
        edit(good.file, "pull_off_force", "extrema")
        row = "easy:pull_off_force"
    edit(good.file, f"reference: {TABLE}", f'reference: "{TABLE}#{row}"')
    ended = expect(code, message, f"{verb} good" + (" --output out --tap" if verb == "verify" else ""))
    if code == 0:
        ended.has("^ok 1 - good pull_off_force/easy:pull_off_force/scene$")
        assert expect(0, "", "plan good").count("rows of") == 0, "rows of other problems are no matter"


def test_the_plan_says_which_rows_no_scene_has(good):
    good.table(TABLE, "tabor,force,approach", "0,2,0", "1,1.6,0", "2,1.5,0", "3,1.5,0", "5,1.5,0")
    expect(0, "", "plan good").has("^  no scene of the case is that of 4 of 5 rows of reference/table.csv: lines 13-16$")
    edit(good.file, "  tabor: 0\n", "", "want", "sweep: [{key: tabor, values: [0, 2, 5]}]\nwant")
    expect(0, "", "plan good").has("2 of 5 rows of reference/table.csv: lines 13, 15$")
    edit(good.file, "[0, 2, 5]", "[0, 1, 2, 3, 5]")
    assert expect(0, "", "plan good").count("rows of") == 0


def test_verdicts(good):
    """If a reference has no row for the scene, the verdict is missing_reference. It does not pass, but it is no error."""
    expect(0, "*", "verify good --output out --tap").has("^ok 1 - good pull_off_force/table/scene$")
    good.table(TABLE, "tabor,force,approach", "1,1.6,0")
    expect(1, "*", "verify good --output out").has("missing_reference")
    good.table(TABLE, "tabor,force,approach", "0,1.9,0")
    expect(1, "*", "verify good --output out --tap --junit junit.xml").has("^not ok 1 - good pull_off_force/table/scene$", "outside")
    assert '<failure message="outside: obtained 2,' in pathlib.Path("junit.xml").read_text()


def test_names_of_checks(good):
    """Checks of the same number with other tolerances have names of their own; those of other points keep theirs."""
    edit(good.file, "  tabor: 0\n", "", "want", "sweep: [{key: tabor, values: [0, 1e-6]}]\nwant")
    good.table(TABLE, "tabor,force,approach", "0,2,0", "1e-6,2,0")
    check = "  - {{quantity: {}, reference: {}, tolerance: {}, kind: abs, because: it is tried}}\n"
    good.file.write_text(good.file.read_text() + "    when: [{key: tabor, values: [0]}]\n" + check.format("pull_off_force", TABLE, "1e-8") + "".join(
        check.format("solved_share", "every_scene", tolerance) for tolerance in ("0.1", "0.2")))
    lines = expect(0, "*", "verify good --output out --tap").out.splitlines()
    number, share = "pull_off_force/table/tabor", "solved_share/every_scene"
    assert [line.split(" - good ")[1] for line in lines if line.startswith("ok")] == [
        f"{number}=0", f"{number}=0/check-2", f"{number}=1e-6", share, f"{share}/check-4"]
