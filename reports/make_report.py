#!/usr/bin/python3
"""Writes the report of a run, report.html and report.pdf, from its records. It computes no physics."""

import argparse
import base64
import contextlib
import gc
import gzip
import hashlib
import json
import os
import re
import sys
import tempfile
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from pulloff_report.errors import BAD_FILE, ReportError  # noqa: E402

OUTPUTS = ("report.html", "report.pdf")
KEY = ".report-key"  # the checksum of all inputs of the report beside it
# Errors by a value of a wrong kind in a record, which has its checksum: of another version, or edited.
UNUSABLE = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def arguments(words):
    parser = argparse.ArgumentParser(
        prog="make_report.py", description=__doc__,
        epilog="example: make_report.py --run build/run --output build/report")
    parser.add_argument("--run", required=True, metavar="DIR", help="folder of the run's records")
    parser.add_argument("--output", required=True, metavar="DIR",
                        help="folder for report.html and report.pdf")
    parser.add_argument("--reference", default=os.path.join(SOURCE, "reference"), metavar="DIR",
                        help="folder of the reference data (default: that beside the folder of this program)")
    parser.add_argument("--faults", metavar="FILE",
                        help="matrix of planted faults (default: mutation/matrix.json beside the run)")
    parser.add_argument("--claims", metavar="FILE",
                        help="judged claims of the paper (default: claims/claims.json beside the run)")
    parser.add_argument("--cost", metavar="FILE",
                        help="measured cost of equilibria (default: cost/cost.json beside the run)")
    parser.add_argument("--rate", metavar="FILE",
                        help="judged table of viscoelastic pull-offs (default: rate/table.json beside the run)")
    parser.add_argument("--fresh", action="store_true",
                        help="write the report again even if no input has changed")
    return parser.parse_args(words)


def content_key(beside, *folders):
    """sha256 of all inputs of a report: faults, claims, cost and tests, records, reference data, and the source of this program."""
    digest = hashlib.sha256((sys.version + json.dumps(beside)).encode())
    for folder in folders + (os.path.dirname(os.path.abspath(__file__)),):
        for place, inner, names in os.walk(folder):
            inner[:] = sorted(name for name in inner if name != "__pycache__")
            for name in sorted(names):
                if not name.endswith((".json", ".csv", ".py", ".gp", ".html", ".css", ".js")):
                    continue
                path = os.path.join(place, name)
                with open(path, "rb") as stream:
                    data = stream.read()
                digest.update(f"{os.path.relpath(path, folder)} {len(data)}\n".encode())
                digest.update(data)
    return digest.hexdigest()


def is_current(folder, key):
    """Whether the folder has a report that was made from the inputs with this key."""
    if not all(os.path.isfile(os.path.join(folder, name)) for name in OUTPUTS):
        return False
    try:
        with open(os.path.join(folder, KEY), encoding="ascii") as stream:
            return stream.read() == key
    except (OSError, UnicodeDecodeError):
        return False


def write_all(folder, files):
    """Writes every file under a temporary name, then renames them all, so that no file is left incomplete."""
    beside = []
    try:
        os.makedirs(folder, exist_ok=True)
        for name, data in files.items():
            handle, path = tempfile.mkstemp(prefix="." + name + ".", dir=folder)
            beside.append(path)
            with os.fdopen(handle, "wb") as stream:
                stream.write(data)
                stream.flush()
                os.fsync(stream.fileno())
            os.chmod(path, 0o644)
        for path, name in zip(list(beside), files):
            os.replace(path, os.path.join(folder, name))
            beside.remove(path)
    except OSError as error:
        raise ReportError(f"{error.filename or folder}: {error.strerror}") from error
    finally:
        for path in beside:
            os.unlink(path)


def live_figures(path):
    """The names of the figures whose scenes the page with the solver has (reports/live); None without such a page."""
    try:
        with open(path, encoding="utf-8") as stream:
            found = re.search('id="records">(.*?)</script>', stream.read())
        return list(json.loads(gzip.decompress(base64.b64decode(found[1]))))
    except (OSError, ValueError, TypeError):
        return None


@contextlib.contextmanager
def refusing(run):
    """Makes an error by a value of a wrong kind one line that names the run, the error, and the line of this program that met it."""
    try:
        yield
    except UNUSABLE as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        raise ReportError(f"{run}: a record, or a file beside it, has a value that cannot be shown: {' '.join(str(error).split())[:200]} "
                          f"({os.path.basename(place.filename)}:{place.lineno}: {place.line}); pulloff run writes a record again") from error


def make(wanted):
    try:
        from pulloff_report import claims, cost, faults, gnuplot, page, rate, records, references, tree, tree_tests
        import weasyprint  # noqa: F401
    except ImportError as error:
        raise ReportError(f"Python module {error.name} is missing: install numpy, scipy, "
                          "matplotlib, jinja2 and weasyprint") from error
    gnuplot.require()
    run = records.Run(wanted.run)
    # What lies beside a run is about the cases of the paper: a run of other cases does not show it.
    matrix, judged, measured, rows, tested = (
        module.read(path or (module.beside(wanted.run) if run.is_of_paper else None)) for module, path in (
            (faults, wanted.faults), (claims, wanted.claims), (cost, wanted.cost), (rate, wanted.rate),
            (tree_tests, None)))
    live = live_figures(os.path.join(wanted.output, "live.html"))
    program = os.path.join(os.path.dirname(os.path.abspath(wanted.run)), "src", "cli", "pulloff")
    identity = tree.identity(SOURCE, program if os.path.isfile(program) else None)
    key = content_key([matrix, judged, measured, rows, tested, live, identity], wanted.run, wanted.reference)
    if not wanted.fresh and is_current(wanted.output, key):
        print(f"kept: the report in {wanted.output} is up to date")
        return
    with refusing(wanted.run):
        content = page.contents(run, references.References(wanted.reference), matrix, judged, measured, tested, rows)
        html, pdf = page.forms(dict(content, live=live, identity=tree.words(identity)))
    write_all(wanted.output, {"report.html": html, "report.pdf": pdf, KEY: key.encode("ascii")})
    print(f"made: {os.path.join(wanted.output, 'report.html')} and report.pdf")


def main(words):
    wanted = arguments(words)
    gc.disable()  # almost nothing that is made here is dropped before the end; without collections it takes a sixth less time
    try:
        make(wanted)
    except ReportError as error:
        print(f"pulloff report: {error}", file=sys.stderr)
        return error.code
    except OSError as error:
        print(f"pulloff report: {error.filename}: {error.strerror}", file=sys.stderr)
        return BAD_FILE
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
