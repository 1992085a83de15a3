"""What the command lines here share: one option says what is to be done."""

import argparse
import os
import sys
import time
from pathlib import Path

STORED = Path(__file__).resolve().parent.parent


def options(document):
    """A parser with --sample and --write, and their group, of which one is to be given."""
    parser = argparse.ArgumentParser(description=document.split("\n\n")[0])
    group = parser.add_mutually_exclusive_group(required=True)
    group.add_argument("--sample", action="store_true",
                       help="recompute a sample, compare (exit 1 on disagreement)")
    group.add_argument("--write", metavar="DIR", nargs="?", type=Path, const=STORED,
                       help="regenerate the tables (in DIR)")
    return parser, group


def notes():
    """A function that notes how far the work is, with the seconds since now."""
    begin = time.time()

    def note(text):
        print(f"{time.time() - begin:7.0f} s  {text}", file=sys.stderr, flush=True)

    return note


def run(act, arguments, failure=ValueError):
    """Calls act(arguments). The exit code: 1, with one line, when a number or a file is not as it
    should be; `failure` is one more exception that says so."""
    try:
        act(arguments)
    except (ValueError, OSError, failure) as problem:
        print(f"{os.path.basename(sys.argv[0])}: {problem}", file=sys.stderr)
        return 1
    return 0


def act_on_scenes(arguments, scenes, show, sample, write):
    """What one of --list, --scene, --sample and --write asks for. Given: the scenes of the tables, and
    functions of a scene, of the folder of the stored tables, and of a folder."""
    if arguments.list:
        print("\n".join(" ".join(scene) for scene in scenes))
    elif arguments.scene:
        show(arguments.scene)
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored tables")
    else:
        write(arguments.write)
