"""The command lines of the generators. One option selects the action."""

import argparse
import os
import sys
import time
from pathlib import Path

STORED = Path(__file__).resolve().parent.parent


def options(document):
    """A parser with --sample and --write, and the group of these options, of which exactly one must be given."""
    parser = argparse.ArgumentParser(description=document.split("\n\n")[0])
    group = parser.add_mutually_exclusive_group(required=True)
    group.add_argument("--sample", action="store_true",
                       help="recompute a sample, compare (exit 1 on disagreement)")
    group.add_argument("--write", metavar="DIR", nargs="?", type=Path, const=STORED,
                       help="regenerate the tables (in DIR)")
    return parser, group


def notes():
    """A function that prints the progress, with the seconds since this call."""
    begin = time.time()

    def note(text):
        print(f"{time.time() - begin:7.0f} s  {text}", file=sys.stderr, flush=True)

    return note


def run(act, arguments, failure=ValueError):
    """Calls act(arguments) and returns the exit code: 1, with a message of one line, if a number or a
    file is wrong. `failure` is a further exception type that reports this."""
    try:
        act(arguments)
    except (ValueError, OSError, failure) as problem:
        print(f"{os.path.basename(sys.argv[0])}: {problem}", file=sys.stderr)
        return 1
    return 0


def act_on_scenes(arguments, scenes, show, sample, write):
    """Does what --list, --scene, --sample or --write requests. Given: the scenes of the tables, and the
    functions show(scene), sample(folder of the stored tables) and write(folder)."""
    if arguments.list:
        print("\n".join(" ".join(scene) for scene in scenes))
    elif arguments.scene:
        show(arguments.scene)
    elif arguments.sample:
        sample(STORED)
        print("sample agrees with the stored tables")
    else:
        write(arguments.write)
