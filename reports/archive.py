#!/usr/bin/python3
"""Packs the sources, the report, the page and the records of a run into one archive, from which they can be computed again.

Usage: archive.py BUILD OUTPUT.tar.gz

The same files give the same bytes. In the unpacked folder, ./reproduce computes the results again; those with the same digests are
identical to the last bit (./reproduce --identical).
"""

import gzip
import io
import os
import sys
import tarfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from pulloff_report import tree  # noqa: E402

SOURCE = os.path.dirname(HERE)
RESULTS = {"report": (".html", ".pdf"), "run": (".json", ".csv"), "claims": ("claims.json",)}   # folders of the build: ends of names


def results(build):
    """(path, name in the archive) of the report and the records."""
    for folder, ends in RESULTS.items():
        for place, inner, names in os.walk(os.path.join(build, folder)):
            inner[:] = sorted(name for name in inner if name != "kept")
            for name in sorted(names):
                if name.endswith(ends):
                    path = os.path.join(place, name)
                    yield path, os.path.join(tree.RESULTS, os.path.relpath(path, build))


def write(output, top, entries, commit):
    """Writes entries (path, name), all under the folder `top`, without dates and owners."""
    with open(output, "wb") as stream, gzip.GzipFile(fileobj=stream, mode="wb", mtime=0, filename="") as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        def add(name, data, mode):
            entry = tarfile.TarInfo(f"{top}/{name}")
            entry.size, entry.mode = len(data), mode
            archive.addfile(entry, io.BytesIO(data))

        add(tree.COMMIT, f"{commit}\n".encode("ascii"), 0o644)
        for path, name in entries:
            with open(path, "rb") as source:
                add(name, source.read(), 0o755 if os.access(path, os.X_OK) else 0o644)


def main(given):
    if len(given) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build, output = given
    names, commit = tree.files(SOURCE), tree.commit(SOURCE)
    if not names:
        print(f"archive: {SOURCE} is neither a working copy nor an archive", file=sys.stderr)
        return 4
    found = list(results(build))
    if not any(name.endswith("report.html") for _, name in found):
        print(f"archive: there is no report in {build}/report", file=sys.stderr)
        return 4
    top = f"pulloff-{(commit or 'unknown')[:tree.DIGITS]}"
    try:
        write(output, top, [(os.path.join(SOURCE, name), name) for name in names] + found, commit)
    except OSError as error:
        print(f"archive: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    print(f"{output}: {len(names)} sources, {len(found)} results, checksum of the tree {tree.checksum(SOURCE, names)[:tree.DIGITS]}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
