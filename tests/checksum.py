#!/usr/bin/python3
"""The checksum of a record or a shard (doc/json.md#checksums): checksum.py FILE... gives altered files the right one."""

import hashlib
import json
import pathlib
import sys

BEGIN, END = '{\n  "checksum": "', '",\n'


def line_of(document):
    """A document as a line of a store, with its checksum."""
    plain = json.dumps({key: value for key, value in document.items() if key != "checksum"}, separators=(",", ":")) + "\n"
    return '{"checksum":"' + hashlib.sha256(plain.encode()).hexdigest() + '",' + plain.removeprefix("{")


def text_of(document):
    """A document as a file with its checksum."""
    plain = json.dumps({key: value for key, value in document.items() if key != "checksum"}, indent=2) + "\n"
    return BEGIN + hashlib.sha256(plain.encode()).hexdigest() + END + plain.removeprefix("{\n")


def write(path, document):
    pathlib.Path(path).write_text(text_of(document), encoding="utf-8")


def main():
    for name in sys.argv[1:]:
        write(name, json.loads(pathlib.Path(name).read_text(encoding="utf-8")))


if __name__ == "__main__":
    main()
