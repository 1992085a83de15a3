"""As tests/library/solve_json.c, by the Python module."""

import json
import sys

import pulloff

words = sys.argv[1:]
name = words[1] if words[0] == "theory" else None
keys = dict(zip(*[iter(words[2 if name else 0:])] * 2))
document = pulloff.theory(name, **keys) if name else pulloff.solve(**keys).document
print(json.dumps(document, indent=2))
