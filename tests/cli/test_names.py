"""Names of folders that are not ASCII: no check is lost from a document if a text would be cut inside a character, or if
a name is not valid UTF-8, such as one written under Latin-1, or has characters that XML excludes. And the data beside a
program."""

import os
import pathlib
import shutil
import xml.dom.minidom

import conftest
import pytest
from conftest import expect, load

CHECKS = """
  - {quantity: pull_off_approach, reference: reference/table.csv, tolerance: 1, kind: abs, because: it has a closed form}
"""
# Characters of two, three and four bytes at every position relative to the cut.
LONG = [before + letter * (1 + 80 // len(letter.encode())) for before in ("", "a", "ab", "abc") for letter in "ä€😀"]


@pytest.mark.parametrize("name", LONG + ["not XML \ufffe\uffff", os.fsdecode(b"lat\344in"), os.fsdecode(b"lone\355\240\200")], ids=ascii)
def test_folder(good, name):
    case, output, kept = f"{name}/own.yaml", f"{name}/run", "own: 1 point, 2 checks: within (kept)"
    os.mkdir(name)
    text = (good.folder / "cases/good.yaml").read_text().replace("name: good", "name: own")
    pathlib.Path(case).write_text(text + CHECKS.lstrip("\n"))
    expect(0, kept.removesuffix(" (kept)"), "verify", case, "--output", output)
    assert len(load(f"{output}/own/record.json")["checks"]) == 2
    assert len(expect(0, kept, "explain --all --json", case, "--output", output).json["checks"]) == 2
    expect(0, kept, "verify --junit junit.xml", case, "--output", output)
    xml.dom.minidom.parse("junit.xml")


def test_data_beside_the_program(good, monkeypatch):
    """They were found by a link, by which find -L, grep -R and backups of the source tree did not end."""
    assert not any(path.is_symlink() for path in pathlib.Path(conftest.PROGRAM).parent.rglob("*"))
    shutil.copytree(good.folder, "moved/source")
    os.mkdir("moved/bin")
    shutil.copy(conftest.PROGRAM, "moved/bin/pulloff")
    pathlib.Path("moved/bin/data-folder.txt").write_text("../source\n")
    monkeypatch.delenv("PULLOFF_DATA")
    monkeypatch.setattr(conftest, "PROGRAM", "moved/bin/pulloff")
    assert [line.split()[0] for line in expect(0, "", "list").out.splitlines()] == ["case", "good"]
