"""./reproduce in a folder with substitute programs: which options it refuses, which parts it runs, and how it reports its steps."""

import os
import re
import shutil
import signal
import subprocess
import time

import pytest
from conftest import ROOT

# The substitute programs write their arguments to a file. The first case fails if a certain file exists.
PROGRAM = """#!/bin/sh
echo "$*" >>asked
case $1 in run | verify) ;; *) exit 0 ;; esac
echo 'a verdict'
echo '3/8 solves, 5 s elapsed, about 2 min 10 s remaining (fig03 tabor=1)' >&2
sleep "$(cat slow 2>/dev/null || echo 0)"
exit "$(cat code 2>/dev/null || echo 0)"
"""
ASKED = 'import os, sys\nprint("{}", *sys.argv[1:], file=open("asked", "a"))\n'
CLAIMS = ASKED.format("claims") + """print("made-claim 1.57 reproduced")
sys.exit(int(open("judged").read()) if os.path.exists("judged") else 0)
"""
LIST = """get.a = { case = "timing", when = { tabor = 1 }, at = "pull_off.force" }
get.b = { case = "fig03", at = "folds.#" }
get.c = { case = "timing", at = "folds.#" }
"""
FILES = {"build/src/cli/pulloff": PROGRAM, "build/tests/cost/measure_cost": '#!/bin/sh\necho "cost $*" >>asked\n', "bin/meson": "#!/bin/sh\n",
         "tests/mutation/run.py": ASKED.format("faults"), "reports/claims/run.py": CLAIMS, "reports/make_sheet.py": ASKED.format("sheet"),
         "reports/rate/judge.py": ASKED.format("rows") + 'print("judged rows")\n', "reports/papers/wavy_sphere/claims.toml": LIST,
         "reports/live/build.sh": '#!/bin/sh\necho "page $*" >>asked\nmkdir -p build/live\necho page >build/live/live.html\n',
         "build/build.ninja": "", "build/meson-private/coredata.dat": "",
         **{f"reports/figures/fig{figure}.gp": "" for figure in ("03", "05", "06")},
         **{f"cases/{file}.yaml": f'name: {name}\nfigure: "{figure}"\nsuites: [{suites}] # which\n' for file, name, figure, suites in (
             ("fig03", "fig03", 3, "smoke, paper"), ("fig06", "fig06", 6, "paper"), ("fig06_paper", "fig06_paper", 6, "paper"),
             ("precise", "timing", "", "precision"))}}
ALL = "verify --suite paper,precision,extreme,general --output build/run"
REPORT = "report .*"


class Tree:
    """The source tree of substitutes."""

    def __init__(self, folder):
        self.folder = folder.resolve()
        for name, text in FILES.items():
            self.write(name, text)
        shutil.copy(ROOT / "reproduce", self.folder)
        shutil.copytree(ROOT / "tools", self.folder / "tools")
        self.write("build/source-tree", f"{self.folder}\n")
        self.environment = os.environ | {"PATH": f"{self.folder}/bin:{os.environ['PATH']}"}

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def run(self, code, *words):
        """./reproduce with these words; the exit code must be this one. Its output, and in `asked` what the programs were asked."""
        (self.folder / "asked").unlink(missing_ok=True)
        self.done = subprocess.run(["./reproduce", *words], capture_output=True, text=True, cwd=self.folder, env=self.environment)
        assert self.done.returncode == code, self.done
        return self.done

    def only(self, code, parts, *words):
        return self.run(code, "--no-install", *(["--only", parts] if parts else []), *words)

    @property
    def asked(self):
        path = self.folder / "asked"
        return path.read_text().splitlines() if path.exists() else []

    def check(self, *patterns):
        """Each pattern is what a program was asked; with ! before it none was."""
        for pattern in patterns:
            assert any(re.fullmatch(pattern.removeprefix("!"), line) for line in self.asked) != pattern.startswith("!"), (pattern, self.asked)

    def has(self, *patterns):
        for pattern in patterns:
            assert re.search(f"^{pattern}$", self.done.stdout + self.done.stderr, re.M), (pattern, self.done)


@pytest.fixture
def tree(tmp_path):
    return Tree(tmp_path / "tree")


KNOWN = "expected claims, faults, cost, solvers, live or one of fig03, fig05, fig06, fig06_paper, paper, precision, smoke, timing"


@pytest.mark.parametrize("message, words", [
    ("unknown option --frobnicate", ["--frobnicate"]), ("--jobs needs a number", ["--jobs"]),
    ("--jobs is -2: expected a whole number", ["--jobs", "-2"]), ("--jobs is empty: expected a whole number", ["--jobs", ""]),
    ("--only needs the name of a part", ["--only"]), ("--only needs the name of a part", ["--only", ""]),
    (f"--only is fig99: {KNOWN}", ["--only", "fig99"]), (f"--only is fig: {KNOWN}", ["--only", "fig03,fig"]),
    ("--data needs the name of a folder", ["--only", "rate", "--data"]), ("--data is /none: no such folder", ["--only", "rate", "--data", "/none"]),
    ("--data has no effect without --only rate", ["--only", "cost", "--data", "/"])])
def test_refused(tree, message, words):
    if "rate" in words:
        tree.write("cases/rate_wavy.yaml", "name: rate_wavy\nsuites: [rate]\n")
    assert tree.run(2, *words).stderr == f"reproduce: {message} (see ./reproduce --help)\n"
    assert not tree.asked and not (tree.folder / "build/log").exists()


def test_all_parts(tree):
    assert all(f"\n  {option}" in tree.run(0, "--help").stdout for option in ("--only", "--fresh", "--verbose", "--jobs", "--no-install"))
    printed = tree.only(0, "").stdout.splitlines()
    tree.check(ALL, "faults --reuse --build build", "claims --program build/src/cli/pulloff --run build/run --brief",
               "report --run build/run --output build/report", "sheet --output build/report")
    assert len(tree.asked) == 5 and printed[-3:-1] == ["made-claim 1.57 reproduced", "a verdict"]
    tree.has(r"\[4/7\] Running the cases  *[0-9.]* s", r"\[7/7\] Writing the report  *[0-9.]* s")
    kept = (tree.folder / "build/log/reproduce.seconds").read_text().splitlines()
    assert sorted(line.split("\t")[0] for line in kept) == ["Building", "Judging the claims", "Planting faults", "Running the cases", "Writing the report"]
    tree.only(0, "", "--verbose")
    tree.check(ALL + " --verbose", "!claims .*--brief")
    tree.write("build/claims/kept", "")
    tree.only(0, "", "--fresh", "--jobs", "3")
    assert not (tree.folder / "build/claims").exists()
    tree.check(ALL + " --jobs 3 --fresh", "faults --build build --jobs 3", "report --run build/run --output build/report --fresh")


@pytest.mark.parametrize("parts, asked, steps", [
    ("fig06,timing", ["verify fig06 fig06_paper timing --output build/run", REPORT, "!faults.*", "!claims.*"], r"\[5/5\] Writing the report .*"),
    ("fig3,smoke", ["verify fig03 fig03 --output build/run"], ""), ("fig05", [REPORT, "!verify.*"], ""),
    # --only claims runs the cases whose results the claims use.
    ("claims", ["verify fig03 timing --output build/run", "claims --program build/src/cli/pulloff --run build/run --brief", REPORT, "!faults.*",
                "!.*solver.*", "!cost.*", "!page.*"], "made-claim 1.57 reproduced"),
    ("faults,claims", ["verify fig03 timing --output build/run", "faults --reuse --build build"], r"\[7/7\] Writing the report .*"),
    ("cost", ["cost build/cost/cost.json", REPORT, "!verify.*"], ""),
    # The example solvers are asked only if it is asked for.
    ("solvers", ["run smoke fig03_paper fig04_paper --fresh --output build/run",
                 "run smoke --solver reference/solvers/newton.yaml .*--solver reference/solvers/paper.yaml@251 .* --output build/run",
                 "run fig03_paper --points 0-3 --solver reference/solvers/newton.yaml .*--solver reference/solvers/wrong.yaml --output build/run",
                 "run fig04_paper --points 0,6,11,15,19,21 --solver reference/solvers/newton.yaml .* --output build/run",
                 "run solver_times --solver reference/solvers/wrong.yaml --output build/run",
                 "run solver_times --points 0-11 --solver pulloff .*--solver reference/solvers/paper.yaml@251 --solver reference/solvers/copson.yaml@1 "
                 "--output build/run", "run solver_times --solver pulloff .*--solver reference/solvers/paper.yaml@251 --output build/run", REPORT,
                 "!faults.*", "!claims.*"], r"\[6/6\] Writing the report .*")])
def test_parts(tree, parts, asked, steps):
    tree.write("build/run/fig03/record.json", "")
    tree.write("build/run/solvers/newton/record.json", "")
    tree.only(0, parts, *(["--fresh"] if parts == "solvers" else []))
    tree.check(*asked)
    tree.has(*([steps] if steps else []))
    assert (tree.folder / "build/run/solvers").exists() != (parts == "solvers"), "records of solvers are made again"


def test_no_report_of_nothing(tree):
    """A part that is no case makes what it is about, and no report, if there is no record of a case: a report of nothing was a failure with
    status 4, after the page or the matrix of faults had been made."""
    tree.only(0, "faults")
    tree.check("faults --reuse --build build", "!" + REPORT)
    tree.has("No report, because build/run has no record of a case: .*", r"\[4/4\] Planting faults .*")
    tree.write("build/run/fig03/record.json", "")
    tree.only(0, "faults")
    tree.check(REPORT, "!verify.*")


def test_published_rows(tree):
    """They are judged if their folder is given, and only then."""
    tree.write("cases/rate_wavy.yaml", "name: rate_wavy\nsuites: [rate]\n")
    tree.only(0, "rate")
    tree.check("verify rate_wavy --output build/run", "!rows.*")
    tree.only(0, "rate", "--data", "/usr", "--jobs", "3")
    tree.check("rows build/src/cli/pulloff /usr build/rate --jobs 3")
    tree.has("judged rows")


def test_the_page_with_the_solver(tree):
    """It is made if it is asked for; once it exists, with every report, and before it."""
    tree.write("build/run/fig03/record.json", "")
    page = tree.folder / "build/report/live.html"
    for part in "live", "cost":
        tree.only(0, part)
        assert [line.split()[0] for line in tree.asked if not line.startswith("cost")] == ["page", "report", "sheet"] and page.stat().st_size
        tree.check("page --no-install")
    shutil.rmtree(tree.folder / "build/run/fig03")
    page.unlink()
    tree.only(0, "live")
    tree.check("!" + REPORT)
    tree.has("Page: build/report/live.html")


@pytest.mark.parametrize("file, code, ends, is_reported, line", [
    *(("code", code, code, True, rf"\[.*Running the cases .*\(status {code}, see build/log/reproduce.log\)") for code in (1, 3)),
    ("code", 130, 130, False, ".*interrupted; finished points are kept: run the command again to continue.*"), ("code", 2, 4, False, ".*"),
    *(("judged", code, 0, True, ".*") for code in (1, 3)), ("judged", 2, 4, False, ".*the claims could not be judged.*")])
def test_failures(tree, file, code, ends, is_reported, line):
    """They are reported, and the exit code states them."""
    tree.write(file, str(code))
    tree.only(ends, "fig03" if file == "code" else "")
    tree.has(line)
    tree.check(("" if is_reported else "!") + REPORT)


def test_progress(tree):
    """A line at intervals, with the progress of the step and the durations of the later steps in the last run. Durations are kept only for
    complete runs, because parts take less time."""
    steps = tree.folder / "tools/steps.sh"
    steps.write_text(re.sub("(?m)^plain_interval=.*", "plain_interval=1", steps.read_text()))
    tree.write("build/log/reproduce.seconds", "Planting faults\t20\nJudging the claims\t11\nWriting the report\t7\n")
    tree.write("slow", "2.5")
    tree.only(0, "")  # 130 s of this step, 38 s of the later steps
    tree.has(r"\[4/7\] Running the cases: 3/8 solves, [1-4] s since the start, about 2 min 48 s left")
    tree.only(0, "fig03")  # and 15 s of the report
    tree.has(r"\[4/5\] Running the cases: 3/8 solves, [1-4] s since the start, about 2 min 25 s left")
    if shutil.which("script"):
        done = subprocess.run(["script", "-qec", "./reproduce --no-install", "/dev/null"], stdin=subprocess.DEVNULL, capture_output=True,
                              cwd=tree.folder, env=tree.environment)
        assert b"\r[4/7] Running the cases: 3/8 solves, " in done.stdout
    tree.write("slow", "0")
    tree.write("bin/meson", "#!/bin/sh\nsleep 2.5\n")
    tree.only(0, "fig03")
    tree.has(r"\[3/5\] Building, [0-9]* s since the start")
    tree.only(0, "fig05")  # the duration of the report is known
    tree.has(r"\[3/4\] Building, [0-9]* s since the start, about .* left")


def test_an_interruption(tree):
    """The run ends, no report is written, and no more progress is printed."""
    tree.write("slow", "20")
    with subprocess.Popen(["./reproduce", "--no-install"], cwd=tree.folder, env=tree.environment, start_new_session=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL)) as process:
        time.sleep(2)
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate()
    assert process.returncode == 130 and "interrupted; finished points are kept" in said
    tree.check("!" + REPORT)
