"""Parts of a report that are kept for the next one: drawings and typefaces, by the checksum of all that they are made from."""

import hashlib
import os
import shutil
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
NAME = ".report-kept"

_folder = None      # None: nothing is kept
_is_new = False
_reads = True
_begun = 0.0


def begin(output, fresh=False):
    """Keeps parts in the folder of the report. fresh: makes all parts again."""
    global _folder, _is_new, _reads, _begun
    folder = os.path.join(output, NAME)
    is_new = not os.path.isdir(folder)
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError:
        return
    _folder, _is_new, _reads, _begun = folder, is_new, not fresh, time.time()


def end(made=True):
    """Removes the parts that the report does not have, and those of a first report that was not made."""
    global _folder
    if _folder and _is_new and not made:
        shutil.rmtree(_folder, ignore_errors=True)
    elif _folder and made:
        for name in os.listdir(_folder):
            path = os.path.join(_folder, name)
            if os.stat(path).st_mtime < _begun - 2.0:   # file systems may round times
                os.unlink(path)
    _folder = None


def part(made_from, make):
    """The bytes that make() returns. made_from: strings and bytes that determine them."""
    if _folder is None:
        return make()
    digest = hashlib.sha256(sys.version.encode())
    for one in made_from:
        data = one if isinstance(one, bytes) else one.encode()
        digest.update(f"{len(data)} ".encode() + data)
    path = os.path.join(_folder, digest.hexdigest())
    try:
        if _reads:
            with open(path, "rb") as stream:
                data = stream.read()
            os.utime(path)
            return data
    except OSError:
        pass
    data = make()
    write(path, data)
    return data


def write(path, data):
    """Writes a part. One that cannot be written is made again for the next report."""
    try:
        handle, beside = tempfile.mkstemp(dir=_folder)
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.replace(beside, path)
    except OSError:
        pass


def files(folder, names=None):
    """The names and contents of files of a folder, as something that a part is made from."""
    found = []
    for name in sorted(os.listdir(folder)) if names is None else names:
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, "rb") as stream:
                found += [name, stream.read()]
    return found


def programs(*modules):
    """The source of this package and of these modules of plots."""
    return files(HERE, [name for name in sorted(os.listdir(HERE)) if name.endswith(".py")]) + files(
        os.path.join(HERE, "plots"), ["figure.py", *(f"{name}.py" for name in modules)])
