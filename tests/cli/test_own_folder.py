"""The section of doc/cases.md on a case folder of one's own: its commands, one after the other, in an empty folder. And pulloff seal."""

import codecs
import os
import pathlib
import re
import shutil
import subprocess

import conftest
import pytest
from conftest import ROOT, edit, expect

ALL = "seal --what a --source b --kind oracle --method c --units d --uncertainty 0"
FINITE = "expected a finite number"


def test_the_commands_of_the_page(monkeypatch):
    os.mkdir("bin")
    os.symlink(conftest.PROGRAM, "bin/pulloff")
    monkeypatch.setenv("PATH", os.path.abspath("bin") + ":" + os.environ["PATH"])
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    section = (ROOT / "doc/cases.md").read_text().partition("\n## A case folder of your own\n")[2]
    commands = "".join(re.findall("^```sh\n(.*?)^```$", section, re.M | re.S))
    assert commands.count("pulloff") > 8
    done = subprocess.run(["sh", "-e"], input=commands, capture_output=True, text=True)
    assert done.returncode == 0, done
    for line in ("my/data/tip.csv lacks 6 headers: expected the options --what, --source, --kind, --method, --units, --uncertainty",
                 "^my/data/tip.csv is sealed", "^tips +4 +0 +0", "2 of 2 results are identical to the last bit", r"^measured +1 +0 +0",
                 "^rigid:tips .*coverage 1/2 points, 2/4 checks", "rigid:tips pull_off_force, tabor=0.1: outside"):
        assert re.search(line, done.stdout + done.stderr, re.M), (line, done)
    assert pathlib.Path("verdicts.xml").read_text().count("<testcase ") == 5 and os.path.getsize("my/pins/tips.csv")
    # The solver of the page without its repeats.
    edit("my/rigid.py", 'range(asked["repeats"])', "range(1)")
    expect(1, "", "conform my/rigid.yaml").has("^wrong +repeats: 1 answers to a request of 2 repeats")


@pytest.mark.parametrize("recipe", ["gitlab-ci", "verify"])
def test_recipes_keep_what_they_write(recipe):
    """The recipe for GitHub wrote the verdicts for its viewer and did not keep them."""
    lines = (ROOT / f"doc/examples/ci/{recipe}.yml").read_text().splitlines()
    rest = "\n".join(line for line in lines if "pulloff verify" not in line)
    assert any(re.search("pulloff verify .* --output verdicts --junit verdicts.xml", line) for line in lines)
    assert re.search(r"(paths: \[|^ *)verdicts\]?($|,)", rest, re.M) and "verdicts.xml" in rest


@pytest.mark.parametrize("code, message, words", [
    (2, "seal needs the names of tables (see pulloff seal --help)", "seal"), (4, "absent.csv cannot be opened: *", "seal absent.csv"),
    (2, "--what has several lines or a control character: expected one line", "seal --what 'a\nb' bare.csv")])
def test_wrong_usage(code, message, words):
    expect(code, "pulloff: " + message, words)


def test_foreign_tables():
    """Line ends and the byte order mark are removed. A European table was refused by the number of its cells, and one in UTF-16 by its
    byte \\xff, as those with a checksum are read strictly."""
    table = pathlib.Path("foreign.csv")
    table.write_bytes(codecs.BOM_UTF8 + b"tabor,force\r\n1,1.67\r\n2,1.58")
    expect(0, "", f"{ALL} foreign.csv")
    sealed = table.read_bytes()
    assert b"\r" not in sealed and sealed.endswith(b"\n2,1.58\n") and sealed.startswith(b"#")
    expect(0, "", "seal foreign.csv")
    assert table.read_bytes() == sealed, "a second time nothing changes"
    edit(table, "1.58", "1.59")
    expect(0, "", "seal --what other foreign.csv")
    assert "\n# what: other\n" in "\n" + table.read_text()
    for encoding in "utf-8", "utf-16":
        table.write_text("Instrument;X\ntabor;force;note\n0,5;1,75;\"a, b\"\n1;1,67;c\n", encoding=encoding)
        expect(0, "", f"{ALL} foreign.csv")
        text = table.read_text()
        assert text.endswith('\ntabor,force,note\n0.5,1.75,"a, b"\n1,1.67,c\n') and "# line 1: Instrument;X" in text.splitlines()


@pytest.mark.parametrize("message, rows", [
    ("", "tabor,force 1,1.67,3"),
    # Cells that are no numbers in a column of numbers were sealed, and found once a check read them.
    *((f" {column} is {value}: {FINITE}", rows) for column, value, rows in (
        ("force", "nan", "tabor,force 1,nan"), ("force", "two", "tabor,force 1,two"), ("force_nN", "inf", "tabor,force_nN 1,inf"),
        ("mass", "nan", "tabor,force,mass 1,2,3 2,3,nan"), ("mass", "x", "tabor,force,mass 1,2,x 2,3,4"),
        ("force_uncertainty", "-", "tabor,force,force_uncertainty 1,2,-"), ("load", "text", "kind,approach,load jump_in,1,text"))),
    (f" tabor is soft: {FINITE} >= 0", "tabor,force soft,1")])
def test_tables_that_are_refused(message, rows):
    pathlib.Path("numbers.csv").write_text(rows.replace(" ", "\n") + "\n")
    before = pathlib.Path("numbers.csv").read_bytes()
    expect(4, f"pulloff: numbers.csv:*:{message or '*'}", f"{ALL} numbers.csv")
    assert pathlib.Path("numbers.csv").read_bytes() == before and len(os.listdir()) == 1


def test_tables_that_are_sealed():
    pathlib.Path("numbers.csv").write_text("tabor,outer_radius,kind,name,force,note_load\n1,inf,jump_in,a tip,1.67,inf\n2,7,jump_out,b,1.6,-\n")
    expect(0, "", f"{ALL} numbers.csv")
    for table in (ROOT / "reference").glob("*.csv"):
        shutil.copy(table, ".")
    expect(0, "", "seal", *pathlib.Path().glob("*.csv"))


def test_a_table_without_headers():
    pathlib.Path("bare.csv").write_text("tabor,force\n1,1.67\n")
    pathlib.Path("case.yaml").write_text("""name: bare
title: A table without headers
suites: [own]
scene: {tabor: 1, radius: 100, outer_radius: inf, scheme: panel}
want: [pull_off]
checks: [{quantity: pull_off_force, reference: bare.csv, tolerance: 1, kind: abs, because: b}]
""")
    expect(4, "pulloff: bare.csv:1: 10 headers are missing: expected lines *: ...* above for what, source, kind, method, units, uncertainty, "
              "generator, command, date, sha256; pulloff seal adds them", "verify case.yaml")
