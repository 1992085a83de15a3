"""Runs the detectors of a planted fault: cases, reference tables and tests."""

import os
import re
import resource
import signal
import subprocess
import threading

from plant import HERE, SOURCE, Stale, read_entries

KINDS = ("case", "table", "test")
PULLOFF = "src/cli/pulloff"
NOT_OK = re.compile(r"^not ok \d+ - \S+ ([^/ ]+)/([^/ ]+)", re.MULTILINE)

# Limit of the processor time of a detector: this multiple of its time without a fault, plus these seconds. A fault may
# make the solver very slow; this is distinguished from being caught. The limit of the elapsed time is a multiple of the
# limit of the processor time, for loaded machines.
SLOWER, LONGER, FIRST_LIMIT, WALL = 8, 2, 120, 10

RUNNING = set()  # the process groups that are running


def stop_all():
    """Ends the running processes and their children."""
    for group in list(RUNNING):
        try:
            os.killpg(group, signal.SIGKILL)
        except ProcessLookupError:
            pass


def read_detectors(path):
    detectors = read_entries(path)
    for detector in detectors:
        ways = sum(key in detector for key in ("verify", "program", "script"))
        if detector["kind"] not in KINDS or ways != 1 or "title" not in detector or \
                "verify" in detector and "only" in detector:
            raise Stale(f"{path}: {detector['name']} is not as tests/mutation/README.md says")
    return detectors


def program_of(detector):
    """The program that a detector runs, by its name in the build."""
    return detector.get("program", PULLOFF)


def command(detector, program, place):
    if "verify" in detector:
        return [program, "verify", *detector["verify"], "--tap", "--fresh", "--jobs", "1",
                "--output", os.path.join(place, "run")]
    if "script" in detector:
        script = os.path.join(SOURCE, "tests", detector["script"])
        if script.endswith(".py"):
            only = ["-k", " or ".join(detector["only"])] if "only" in detector else []
            return ["/usr/bin/python3", "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *only, script, "--program", program]
        return ["sh", script, program]
    return [program]


def catches(detector, code, output):
    """What made the detector fail: a list of oracle, pin, no_result, test, refused; empty if it passed."""
    found = set()
    if "verify" in detector:
        for quantity, reference in NOT_OK.findall(output):
            found.add("pin" if reference == "pin" else "no_result" if quantity == "solve" else "oracle")
        if code and not found:
            found.add("refused")
    elif code:
        found.add("test")
    return sorted(found)


def wait(process, seconds):
    """Waits for a process, and kills it and its children if it runs for longer than `seconds`. Returns its exit code
    (None if it was killed or exceeded its processor time), and the processor time of it and its children."""
    killed = threading.Event()

    def kill():
        killed.set()
        os.killpg(process.pid, signal.SIGKILL)
    timer = threading.Timer(seconds, kill)
    timer.start()
    _, status, usage = os.wait4(process.pid, 0)
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    late = killed.is_set() or process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return None if late else process.returncode, usage.ru_utime + usage.ru_stime


def execute(words, log, environment, folder, limit):
    """Runs a command with at most `limit` seconds of processor time. Returns its exit code (None if it was stopped),
    the processor time, and its output, which is also in the file `log`."""
    os.makedirs(os.path.dirname(log), exist_ok=True)
    with open(log, "w+", encoding="utf-8", errors="replace") as stream:
        process = subprocess.Popen(words, stdout=stream, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   env=environment, cwd=folder, start_new_session=True)
        RUNNING.add(process.pid)
        # the hard limit stays unchanged, because a test may set its own limits
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (round(limit), resource.RLIM_INFINITY))
        code, seconds = wait(process, WALL * limit)
        RUNNING.discard(process.pid)
        stream.seek(0)
        return code, seconds, stream.read()


def parts(detector):
    """The values of RUN_TESTS with which a detector is run, one after the other until one run fails: a fault can make each test slow."""
    return detector.get("only", [""]) if "program" in detector else [""]


def run(detector, program, place, baseline=None):
    """Runs a detector on a program, each part with a limit of its processor time that follows from the cell without a fault, `baseline`.
    Returns a cell of the matrix; `by` is empty if it passed."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", PULLOFF_DATA=SOURCE)
    if "script" in detector:
        del environment["PULLOFF_DATA"]  # scripts set their own
    cell = {"by": [], "failing": 0, "parts": {}}
    for part in parts(detector):
        if part:
            environment["RUN_TESTS"] = part
        log = os.path.join(place, detector["name"] + part + ".log")
        limit = limit_of(baseline["parts"][part]) if baseline else FIRST_LIMIT
        code, seconds, output = execute(command(detector, program, place), log, environment, HERE, limit)
        cell["parts"][part] = seconds
        cell["failing"] = len(NOT_OK.findall(output))
        cell["by"] = ["timeout"] if code is None else catches(detector, code, output)
        if cell["by"]:
            break
    cell["seconds"] = round(sum(cell["parts"].values()), 3)
    return cell


def limit_of(seconds):
    """The limit of the processor time of what takes so long without a fault."""
    return SLOWER * seconds + LONGER
