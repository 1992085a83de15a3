"""Case files outside the data folder: every command that is printed for such a case works when it is pasted into a shell, and no such case
replaces another case."""

import os
import pathlib
import re
import shutil
import subprocess

import conftest
import pytest
from conftest import expect, load, run


def write(path, name, nodes):
    """A case whose check fails."""
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(path).write_text(f"""name: {name}
title: A tip of one's own
suites: [smoke]
scene: {{tabor: 0, radius: 93, outer_radius: inf, scheme: ring}}
sweep: [{{key: nodes, values: [{nodes}]}}]
want: [pull_off]
lines:
  - {{name: smooth, theory: jkr, sweep: [{{key: tabor, values: [3]}}]}}
checks:
  - {{quantity: pull_off_force, reference: reference/wrong.csv, tolerance: 0.1, kind: abs, because: it fails}}
""")


@pytest.fixture
def own(good, monkeypatch):
    """The data folder below the present one, and the program in PATH."""
    shutil.move(good.folder, "data")
    good.folder = pathlib.Path("data").resolve()
    monkeypatch.setenv("PULLOFF_DATA", str(good.folder))
    good.table("reference/wrong.csv", "tabor,force,approach", "0,3,0")
    os.mkdir("bin")
    os.symlink(conftest.PROGRAM, "bin/pulloff")
    monkeypatch.setenv("PATH", os.path.abspath("bin") + ":" + os.environ["PATH"])
    return good


def commands(folder, *printed):
    """All commands in the record of a case, in the files beside it, and in what was printed of it."""
    record = load(f"{folder}/record.json")
    text = "\n".join([*printed, pathlib.Path(folder, "line-smooth.csv").read_text(), *record["plan"],
                      *(check["note"] for check in record["checks"])])
    found = [record["command"], *(check["command"] for check in record["checks"]),
             *re.findall(r"pulloff (?:run|verify|bless|explain) .*?(?= --reason TEXT|\)?$)", text, re.M)]
    return sorted({line + (" --reason tried" if "pulloff bless" in line else "") for line in found})


@pytest.mark.parametrize("path", ["cases/mine.yaml",  # which once was taken for a case of the data folder
                                  "my tips/it's \"so\" & $HOME.yaml", "größe/überall.yaml", 8 * (10 * "a" + "/") + "tip.yaml", "/at/a/place.yaml"])
def test_printed_commands(own, path):
    """They work in the folder in which the program was started."""
    path = os.getcwd() + path if path.startswith("/") else path
    write(path, "mine", "21, 22")
    printed = [expect(code, None, f"{verb} --output out" if verb != "plan" else verb, path) for verb, code in (
        ("plan", 0), ("verify", 1), ("explain", 1), ("bless --reason refused", 1))]
    assert "pulloff explain" in printed[-1].err
    found = commands("out/mine", *(ended.out + ended.err for ended in printed))
    assert {line.split()[1] for line in found} >= {"run", "verify", "explain"}
    for line in found:
        pasted = subprocess.run(["sh", "-c", f"{line} --output again"], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        assert re.search("^mine: |checks pass|^pulloff: mine is not blessed: ", pasted.stdout + pasted.stderr, re.M), (line, pasted)
    expect(0, None, "run --shard 1/1 --output shard", path)
    expect(0, "mine: 2 points, 2 checks: outside", "merge shard --output merged")


def test_a_path_that_begins_as_an_option(own):
    write("-dash.yaml", "dash", 21)
    run("verify --output out -- -dash.yaml").has("pulloff explain ./-dash.yaml")


def test_a_case_of_the_data_folder_by_its_path(own):
    expect(0, None, "run cases/good.yaml --shard 1/1 --output ../built-in", cwd="data")
    assert '"argument": "good"' in pathlib.Path("built-in/shard-1-of-1.json").read_text()
    expect(0, "good: 1 point, 1 check: within", "merge built-in --output merged")
    expect(0, "good: 1 point, 1 check: within (kept)", "run good data/cases/good.yaml --output merged")


def test_two_cases_with_the_same_name(own):
    write("taken.yaml", "good", 21)
    for verb in "run", "verify", "plan", "explain", "run --shard 1/2 --output taken":
        expect(2, "pulloff: taken.yaml: name is good: expected another name, as cases/good.yaml has this one", f"{verb} taken.yaml")
    assert not os.path.exists("taken")
    write("one.yaml", "twin", 21)
    write("two.yaml", "twin", 22)
    expect(2, "pulloff: two.yaml: name is twin: expected another name, as one.yaml has this one", "run one.yaml two.yaml")
    # A file that is given twice is taken once, as a case that is named twice.
    outside = "twin: 1 point, 1 check: outside"
    expect(0, outside, "run one.yaml ./one.yaml --output twins")
    before = pathlib.Path("twins/twin/record.json").read_bytes()
    expect(2, "pulloff: two.yaml: name is twin: expected another name or another folder for the records, as twins/twin contains the record of "
              "one.yaml", "run two.yaml --output twins --fresh")
    assert pathlib.Path("twins/twin/record.json").read_bytes() == before
    expect(0, outside + " (kept)", "run ./one.yaml --output twins")
    os.rename("one.yaml", "renamed.yaml")
    expect(0, outside + " (kept)", "run renamed.yaml --output twins")
    expect(0, outside, "run two.yaml --output twins")
    # A wrong case file in the data folder does not affect a case outside it.
    own.case("broken", "name: [\n")
    expect(0, outside + " (kept)", "run two.yaml --output twins")
    expect(2, "pulloff: cases/broken.yaml:*", "run good --output twins")


# Text from outside: no control character in a case, a table, an argument or the name of a file reaches the terminal or ends a text early.
# Characters beyond ASCII stay readable.
RED = "\033[31m"


def is_clean(ended):
    assert all(c == "\n" or ord(c) >= 32 and not 127 <= ord(c) < 160 for c in ended.out + ended.err), ended


@pytest.mark.parametrize("line, byte", [
    (r'name: "go\0od"', r"\x00"), (r'title: "\e[31mred"', r"\x1b"), (r'title: "a title\e]0;of the window\a"', r"\x1b"),
    (r'title: "\x9b31mred"', r"\xc2"), (r'"tit\0le": text', r"\x00")])
def test_control_characters_of_a_case(good, line, byte):
    good.file.write_text(re.sub(r"(?m)^name: .*" if line[0] == "n" else r"(?m)^title: .*", lambda _: line, good.file.read_text()))
    for words in "list", "plan good", "run good":
        is_clean(expect(2, f"pulloff: cases/good.yaml:*: a text contains the control character {byte}: expected none", words))


LONG = 79 * "x"


@pytest.mark.parametrize("code, message, words", [
    (2, r"--tabor is \x1b[31m1: expected *", ["solve --tabor", RED + "1"]), (2, "--tabor is größer: expected *", ["solve --tabor", "größer"]),
    (2, r"--tabor is gr\xf6\xdfer: expected *", ["solve --tabor", os.fsdecode(b"gr\xf6\xdfer")]),
    (2, f"--tabor is {LONG}...: expected *", ["solve --tabor", LONG + "öö"]),  # cut at a character, not inside one
    (2, r"unknown verb \x1b[31m: expected *", ["", RED]), (2, r"no closed form is named \x1b[31m: expected *", ["theory", RED]),
    (2, r"unexpected argument \x1b[31m of solve *", ["solve", RED]), (2, r"unknown option --\x1b[31m *", ["solve", "--" + RED]),
    (4, r"nowhere/\x1b[31m cannot be written: *", ["solve --tabor 0 --curve", "nowhere/" + RED]), (4, r"*\x1b[31m.yaml*", ["plan", f"./{RED}.yaml"])],
    ids=range(10))
def test_control_characters_of_arguments(good, code, message, words):
    is_clean(expect(code, "pulloff: " + message, *words))


def test_characters_that_are_shown(good):
    """A table must be text, but its name may contain any character."""
    conftest.edit(good.file, "A rigid sphere", '"Kugel, glatt — größer, 球"')
    assert "größer, 球" in expect(0, "", "plan good").out
    for name in "red", RED:
        (good.folder / f"reference/{name}.csv").write_text(f"# what: {RED}red\n")
    ended = expect(4, "*", "list --references")
    assert r"red.csv:1: the byte \x1b is a control character or not UTF-8: expected text" in ended.out
    is_clean(ended)
