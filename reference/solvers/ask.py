"""The protocol pulloff-ask/1 for solvers in Python: reads the request, writes an answer a line.

    ask.serve(solve)     solve(scene, point) returns the members of an answer ("pull_off": {...}, ...)

The scene has the keys of the request as numbers, and amplitude 0 where there is none. An exception Unsupported gives
that status, any other one the status failed.
"""

import json
import math
import sys
import time


class Unsupported(Exception):
    """The scene is not one that the solver knows."""


def number(value):
    return float(value) if isinstance(value, (int, float)) or value in ("inf", "-inf") else value


def plain(value):
    """JSON has no NaN and no infinities, and numpy's numbers are not those of json."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
        value = value.tolist() if hasattr(value, "tolist") else value
        return [plain(item) for item in value] if isinstance(value, (list, tuple)) else plain(value)
    if isinstance(value, float) and not math.isfinite(value):
        return None if math.isnan(value) else "inf" if value > 0 else "-inf"
    return value


def answer(solve, point):
    known = {"tabor", "amplitude", "wavelength", "radius", "outer_radius"}
    scene = {"amplitude": 0.0, "wavelength": 1.0} | {key: number(value) for key, value in point["scene"].items()}
    begin = time.perf_counter()
    try:
        if set(scene) - known:
            raise Unsupported(f"the keys {sorted(set(scene) - known)} are not known here")
        found = {"status": "ok"} | solve(scene, point)
    except Unsupported as why:
        found = {"status": "unsupported", "reason": str(why)}
    except Exception as why:  # noqa: BLE001 # whatever went wrong is the reason
        found = {"status": "failed", "reason": f"{type(why).__name__}: {why}"}
    return found | {"seconds": {"solve": time.perf_counter() - begin}}


def serve(solve):
    request_file, response_file = sys.argv[1:3]
    with open(request_file, encoding="utf-8") as stream:
        request = json.load(stream)
    with open(response_file, "w", encoding="utf-8") as stream:
        for point in request["points"]:
            for repeat in range(1, request["repeats"] + 1):
                found = {"id": point["id"], "repeat": repeat} | answer(solve, point)
                stream.write(json.dumps(plain(found), allow_nan=False) + "\n")
                stream.flush()
