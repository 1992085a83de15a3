"""Full disks, folders that cannot be created, missing programs, pipes, links: the exit code is 4, the message is one line, no file is
written in part, and no earlier file is lost. A result is printed although a file beside it cannot be written."""

import os
import pathlib
import shutil
import stat
import subprocess

import conftest
import pytest
from conftest import expect, load, run, words_of

RESULT = "^pull-off force 2 at approach"
SOLVE = "solve --tabor 0"


@pytest.mark.parametrize("words", [SOLVE, SOLVE + " --json", "list", "--help", SOLVE + " --curve -"])
def test_a_full_device(good, words):
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = subprocess.run(words_of(words), stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 4 and "No space left on device" in done.stderr
    assert done.stderr.count("\n") == 1 or "--curve" in words  # the result, too


@pytest.mark.parametrize("message, words", [
    ("the folder file cannot be created: file: Not a directory", "run --output file"),
    ("the folder file/run cannot be created: file*: Not a directory", "run --output file/run"),
    ("blocked/good/points.jsonl cannot be read: Not a directory", "run --output blocked")])
def test_folders(good, message, words):
    pathlib.Path("file").write_text("")
    os.mkdir("blocked")
    pathlib.Path("blocked/good").write_text("")
    expect(4, "pulloff: " + message, words)
    assert os.path.isfile("blocked/good")


@pytest.mark.parametrize("file", ["nowhere/curve.csv", "/dev/full", "."])
def test_the_result_is_there_when_a_file_is_not(file):
    expect(4, f"pulloff: {file} cannot be written: *", f"{SOLVE} --curve {file}").has(RESULT)
    expect(4, f"pulloff: {file} cannot be written: *", f"{SOLVE} --profile {file} --curve curve.csv")
    assert "\nposition," in pathlib.Path("curve.csv").read_text()
    expect(4, f"pulloff: {file} cannot be written: *", f"{SOLVE} --curve {file} --json").has('"force": 2.0')


def test_verdicts_that_cannot_be_written(good):
    ended = expect(4, None, "verify good --junit nowhere/out.xml --tap").has("^ok 1 ")
    assert "pulloff: nowhere/out.xml cannot be written: " in ended.err


@pytest.mark.parametrize("option", ["--curve", "--profile-csv", "--staircase"])
def test_standard_output_as_a_file(option):
    """The file - is standard output; the result is then on standard error."""
    ended = run(f"{SOLVE} {option} -")
    expect(0, "", f"{SOLVE} {option} file.csv")
    assert ended.code == 0 and ended.out == pathlib.Path("file.csv").read_text() and "\npull-off force 2 at" in ended.err
    expect(2, "pulloff: standard output is asked for twice: *", f"{SOLVE} {option} - --json")
    expect(2, "pulloff: standard output is asked for twice: *", f"{SOLVE} --curve - --profile-csv -")
    assert not os.path.exists("-")


@pytest.mark.skipif(os.getuid() != 0, reason="needs root, and the right to mount")
def test_a_disk_that_fills_up(good):
    os.mkdir("small")
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k,mode=700", "tmpfs", "small"], capture_output=True).returncode:
        pytest.skip("no right to mount")
    try:
        expect(0, "*", "run --output small/run")
        kept = pathlib.Path("small/run/good/record.json").read_bytes()
        with open("small/filler", "wb", 0) as filler, pytest.raises(OSError):
            while True:
                filler.write(bytes(4096))
        expect(4, "pulloff: small/run/good/* cannot be written: No space left on device", "run --output small/run --fresh")
        assert pathlib.Path("small/run/good/record.json").read_bytes() == kept and not list(pathlib.Path("small/run/good").glob("*.part-*"))
    finally:
        subprocess.run(["umount", "small"], check=True)


def write_body(path):
    pathlib.Path(path).write_text("r,gap\n" + "".join(f"{3 * k},{0.045 * k * k}\n" for k in range(21)))


def test_named_pipes(good):
    """A named pipe that no other program has opened was waited for, without end, and signals did not end it."""
    for name in "pipe", "other":
        os.mkfifo(name)
    lonely = "is a pipe that no program has opened for writing in 5 s: expected a file, or a pipe with a writer, which is read once"
    waiting = [subprocess.Popen(words_of(words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
               for words in (SOLVE + " --profile-file pipe", "run ./other --output run")]
    for process, name in zip(waiting, ("pipe", "./other")):
        said = process.communicate()[1]
        assert (process.returncode, said) == (4, f"pulloff: {name} {lonely}\n")
    expect(4, "pulloff: pipe cannot be written: no program has opened it for reading", SOLVE + " --curve pipe")
    # A pipe with a writer is a file.
    write_body("table.csv")
    with subprocess.Popen("sleep 1; cat table.csv >pipe", shell=True):
        piped = expect(0, "", SOLVE + " --profile-file pipe").out
    assert [line for line in expect(0, "", SOLVE + " --profile-file table.csv").out.splitlines() if "pull-off" in line][0] in piped


@pytest.mark.parametrize("words", ["solve --coupling 0.1+-0.01", "follow --key coupling --from 0.1 --to 0.2 --points 3"])
def test_a_table_from_standard_input(words):
    """It is not read again: follow and uncertain inputs make several scenes of it."""
    write_body("table.csv")
    digests = [next(line for line in ended.out.splitlines() if "digest" in line) for ended in (
        expect(0, "", words + " --profile-file table.csv"),
        run(words + " --profile-file /dev/stdin", input=pathlib.Path("table.csv").read_text()))]
    assert digests[0] == digests[1]


def test_a_damaged_record_is_written_again(good):
    expect(0, "*good: 1 point, 1 check: within", "run --output run")
    pathlib.Path("run/good/record.json").write_text('{"schema": ')
    assert run("run --output run").err.splitlines() == [
        "good: the record or a table beside it was altered or damaged; the stored results are intact, and it is written again",
        "good: 1 point, 1 check: within (kept)"]
    assert load("run/good/record.json")["verdict"] == "within"


def test_links():
    """Links to a file, to a link, to a file that does not exist, and to itself."""
    os.mkdir("folder")
    old = pathlib.Path("folder/old.csv")
    old.write_text("old\n")
    old.chmod(0o600)
    for target, link in (("folder/old.csv", "one"), ("one", "two"), ("new.csv", "folder/three"), ("loop", "loop")):
        os.symlink(target, link)
    expect(0, "", SOLVE + " --curve two")
    assert os.path.islink("one") and os.path.islink("two") and "\nposition," in old.read_text()
    assert stat.S_IMODE(old.stat().st_mode) == 0o600
    expect(0, "", SOLVE + " --curve folder/three")
    assert os.path.islink("folder/three") and os.path.isfile("folder/new.csv")
    expect(4, "pulloff: loop cannot be written: Too many levels of symbolic links", SOLVE + " --curve loop")
    assert not list(pathlib.Path().rglob("*.part-*"))


@pytest.mark.parametrize("lengths", ["--radius 1e-7", "--amplitude 1e-9 --wavelength 2e-8"])
def test_lengths_in_metres_are_remarked(lengths):
    expect(0, "pulloff: warning: --* epsilon, which looks like metres: for SI units, use --from-physical and --*-m",
           f"{SOLVE} --preload-load 1 {lengths}")
    expect(0, "", SOLVE + " --radius 0.02")
    expect(0, "", "solve --from-physical --modulus-pa inf --work-j-per-m2 0.05 --distance-m 3e-10 --radius-m 1e-7")


def test_what_a_report_needs(good, monkeypatch):
    """The report, if a script, the records or a program is missing."""
    expect(0, "*", "run --output run")
    (good.folder / "reports").mkdir()
    expect(4, "pulloff: */reports/make_report.py does not exist: expected *", "report --run run")
    (good.folder / "reports/make_report.py").write_text("import sys\nprint(sys.argv[1:])\nsys.exit(3)\n")
    expect(4, "pulloff: elsewhere does not exist: expected the records of a run (see pulloff run --help)", "report --run elsewhere")
    os.mkdir("bin")
    monkeypatch.setattr(conftest, "PROGRAM", shutil.which(conftest.PROGRAM))
    path = os.environ["PATH"]
    monkeypatch.setenv("PATH", os.path.abspath("bin"))
    expect(4, "pulloff: gnuplot was not found: expected it in PATH, to draw the figures", "report --run run")
    monkeypatch.setenv("PULLOFF_PYTHON", os.path.abspath("bin/python"))
    expect(4, "pulloff: */bin/python was not found: expected Python, which writes the report", "report --run run")
    monkeypatch.delenv("PULLOFF_PYTHON")
    pathlib.Path("bin/gnuplot").write_text("#!/bin/sh\n")
    os.chmod("bin/gnuplot", 0o755)
    monkeypatch.setenv("PATH", os.path.abspath("bin") + ":" + path)
    expect(3, "", "report --run run --output report").has("'--run', 'run', '--output', 'report'")
