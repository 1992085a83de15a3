"""The digest of a JSON document of pulloff."""
import hashlib
import json
import struct

SKIPPED = {"schema", "digest", "reason", "seconds", "condition", "bordered_condition", "error_over_tolerance"}


def lines(value, path=""):
    if isinstance(value, dict):
        for key in sorted(value, key=str.encode):
            if key not in SKIPPED and not (key in ("input", "work", "physical", "interpolation", "assumes", "parabola") and isinstance(value[key], dict)):
                yield from lines(value[key], f"{path}/{key}")
    elif isinstance(value, list):
        for place, item in enumerate(value):
            yield from lines(item, f"{path}/{place}")
    elif isinstance(value, (bool, type(None))):
        yield f"{path}={json.dumps(value)}\n"
    elif isinstance(value, str):
        yield f"{path}={value}\n"
    else:
        yield f"{path}={struct.pack('>d', value + 0.0).hex()}\n"


def digest(document):
    return hashlib.sha256("".join(lines(document)).encode()).hexdigest()[:16]
