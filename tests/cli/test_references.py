"""pulloff list --references prints the tables, their numbers of rows and the cases that use them, as in the files; and tables of
published values that may be missing: their checks are left out, the plan says so, and the checks are made once the file exists."""

import pathlib
import re

import pytest
from conftest import ROOT, edit, expect, load, seal


@pytest.fixture
def tree(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))


def uses_of_tables():
    """The cases that name each table in their checks."""
    uses = {}
    for path in sorted((ROOT / "cases").glob("*.yaml")):
        text = path.read_text()
        section = re.search(r"^checks:\n((?:[ #].*\n|\n|- .*\n)*)", text, re.M)
        for name in re.findall(r'reference: *"?([^,}\s#"]+)', section[1] if section else ""):
            uses.setdefault(name, set()).add(re.search(r"^name: *(\S+)", text, re.M)[1])
    return uses


def tables_of_the_tree():
    """Kind and number of rows of each table."""
    tables = {}
    for path in [path for inner in ("", "published", "sheet") for path in (ROOT / "reference" / inner).glob("*.csv")]:
        lines = path.read_text().splitlines()
        head = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# ") and ": " in line)
        tables[str(path.relative_to(ROOT))] = head["kind"], sum(not line.startswith("#") for line in lines) - 1
    return tables


@pytest.mark.once
def test_the_list_agrees_with_the_files(tree):
    uses, tables = uses_of_tables(), tables_of_the_tree()
    text = {line.split()[0]: line.split() for line in expect(0, "", "list --references").out.splitlines()}
    listed = expect(0, "", "list --references --json").json["references"]
    assert {entry["table"] for entry in listed} == set(tables) and sum(map(len, uses.values())) > 20
    for entry in listed:
        name = entry["table"]
        assert entry["intact"] and entry["in_index"], entry
        assert (entry["kind"], entry["rows"]) == tables[name] and entry["cases"] == sorted(uses.get(name, ())), entry
        kind, rows, cases, state = text[name][1:5]
        assert (kind, int(rows)) == tables[name] and state == "intact", text[name]
        shown = [] if cases == "-" else cases.split(",")
        assert shown == entry["cases"][:len(shown)] and (shown or not entry["cases"]), (text[name], entry)


@pytest.mark.once
def test_every_row_of_the_general_table_is_a_scene(tree):
    rows = tables_of_the_tree()["reference/general_pull_off.csv"][1]
    planned = expect(0, "", "plan general").has(f"compare pull_off_force with reference/general_pull_off.csv at {rows} of {rows} points")
    assert planned.count("has no value") == 0


@pytest.mark.once
def test_the_mie_law_3_9_is_compared_with_tables_of_lennard_jones(tree):
    pathlib.Path("mie.yaml").write_text("""name: mie
title: The Lennard-Jones law by its powers
suites: [smoke]
scene: {law: "mie:3,9", radius: 100, outer_radius: inf, scheme: panel, tabor: 1}
want: [pull_off]
checks:
  - {quantity: pull_off_force, reference: reference/feng_pull_off.csv, tolerance: 1e-6, kind: abs, because: the same law}
""")
    expect(0, "mie: *", "verify mie.yaml --output out").has("1 check passes")


MARKERS, RECORD = "reference/published/markers.csv", "run/curve/record.json"


@pytest.fixture
def curve(data):
    """The smooth sphere of Tabor parameter 1, with a check against somebody's markers."""
    (data.folder / "reference/published").mkdir()
    data.table("reference/table.csv", "tabor,force,approach", "1,1.6707,-0.8734")
    return data.case("curve", f"""
name: curve
title: A smooth sphere and somebody's markers
suites: [smoke]
scene: {{tabor: 1, radius: 100, outer_radius: inf, scheme: triangle, nodes: 101}}
want: [pull_off]
checks:
  - {{quantity: pull_off_force, reference: reference/table.csv, tolerance: 1e-2, kind: abs, because: hundred elements}}
  - quantity: curve
    reference: {MARKERS}
    stand_in: reference/table.csv
    tolerance: 0.05
    kind: abs
    because: read off a figure
""")


def mark(data, *points, kind="published", uncertainty="0.02"):
    """Writes markers in arbitrary order."""
    table = data.table(MARKERS, "tabor,index,approach,load,uncertainty", *(f"1,1,{point},{uncertainty}" for point in points))
    edit(table, "# kind: oracle", f"# kind: {kind}")
    seal(table)
    return table


def verify(code, message="*"):
    return expect(code, message, "verify --verbose curve --output run")


def test_a_published_table_that_is_missing(curve):
    planned = expect(0, "", "plan curve").has("no curves: neither")
    assert f"leave out curve against {MARKERS}: the file does not exist; its stand-in is reference/table.csv" in planned.out
    assert verify(0).count("^curve ") == 1
    assert load(RECORD)["left_out"] == [{"quantity": "curve", "reference": MARKERS, "stand_in": "reference/table.csv"}]


def test_a_published_table_that_is_there(data, curve):
    """Markers at the pull-off, at the fold jump_in, farther out, and beyond the start of the computed branch, not sorted along the
    branch. The first two lie on the curve, see Figure 3."""
    table = mark(data, "-0.8734,-1.6707", "-1.629,-0.681", "-1.9,-0.397", "-2.5,-0.21", "-0.87,-1.66")
    verify(0).has("^curve  *curve .*published *within")
    assert "4 points compared, 1 beyond the ends" in pathlib.Path(RECORD).read_text() and load(RECORD)["left_out"] == []
    expect(0, "", "list --references").has(f"^{MARKERS}  *published  *5  *curve ")
    mark(data, "-0.8734,-1.6707", "-1.5,-0.681")
    verify(1).has("^curve  *curve .*published *outside")
    assert "largest distance near approach -1.5, load -0.681" in pathlib.Path(RECORD).read_text()
    edit(table, "-1.5,-0.681", "-1.629,-0.681")
    verify(4, f"pulloff: {MARKERS}:10: sha256 is *")
    table.unlink()
    assert verify(0).count("^curve ") == 1, "the check is left out again"


@pytest.mark.parametrize("code, message, kind, uncertainty", [
    (4, f"{MARKERS}:3: kind is oracle: expected published, *", "oracle", "0.02"),
    (2, "cases/curve.yaml:11: checks[2].tolerance is 0.05: expected at least 0.2, *", "published", "0.2")])
def test_wrong_published_tables(data, curve, code, message, kind, uncertainty):
    mark(data, "-0.8734,-1.6707", kind=kind, uncertainty=uncertainty)
    expect(code, "pulloff: " + message, "plan curve")


@pytest.mark.parametrize("message, old, new", [
    ("10: checks[2].stand_in is reference/other.csv: expected the reference of another check, *", "stand_in: reference/table", "stand_in: reference/other"),
    ("9: checks[2].reference is bradley: expected the path of a CSV file, *", f"reference: {MARKERS}", "reference: bradley")])
def test_wrong_stand_ins(curve, message, old, new):
    edit(curve, old, new)
    expect(2, "pulloff: cases/curve.yaml:" + message, "plan curve")
